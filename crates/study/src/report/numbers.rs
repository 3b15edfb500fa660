//! Numbers as a person reads them.

/// What is not there.
pub(super) const NONE: &str = "–";

/// Three significant digits, at most three decimals: 0.012, 1.23, 12.3, 123.
pub(super) fn short(number: f64) -> String {
    let decimals = match number.abs() {
        size if size >= 100.0 => 0,
        size if size >= 10.0 => 1,
        size if size >= 1.0 => 2,
        _ => 3,
    };
    format!("{number:.decimals$}")
}

/// Degrees; what three decimals would call 0 but is not is said to be less.
pub(super) fn degrees(number: f64) -> String {
    match number.abs() {
        size if size > 0.0 && size < 0.0005 => "<0.001°".to_owned(),
        size => format!("{}°", short(size)),
    }
}

/// A part of 1 in percent; what would round to 0 but is not is said to be less.
pub(super) fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    let decimals = if percent < 10.0 { 2 } else { 1 };
    if percent > 0.0 && percent < 0.005 { "<0.01 %".to_owned() } else { format!("{percent:.decimals$} %") }
}

/// Two digits of a number that may be very small: 3.2e-4.
pub(super) fn scientific(number: f64) -> String {
    format!("{number:.1e}")
}

/// The mean; `None` of nothing.
pub(super) fn mean(numbers: &[f64]) -> Option<f64> {
    (!numbers.is_empty()).then(|| numbers.iter().sum::<f64>() / numbers.len() as f64)
}

/// Each once, in the order of the first.
pub(super) fn distinct<T: PartialEq>(items: impl IntoIterator<Item = T>) -> Vec<T> {
    items.into_iter().fold(Vec::new(), |mut known, item| {
        if !known.contains(&item) {
            known.push(item);
        }
        known
    })
}

/// A number in words, or the sign for none.
pub(super) fn or_none(number: Option<f64>, words: impl Fn(f64) -> String) -> String {
    number.map_or_else(|| NONE.to_owned(), words)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_digits_are_kept() {
        assert_eq!([0.0, 0.0123, 1.2345, 12.345, 123.45].map(short), ["0.000", "0.012", "1.23", "12.3", "123"]);
    }

    #[test]
    fn nothing_is_told_from_little() {
        assert_eq!([0.0, 1e-5, 0.25, -0.25].map(degrees), ["0.000°", "<0.001°", "0.250°", "0.250°"]);
        assert_eq!([0.0, 1e-6, 0.0123, 0.5].map(percent), ["0.00 %", "<0.01 %", "1.23 %", "50.0 %"]);
    }

    #[test]
    fn the_mean_of_nothing_is_not_zero() {
        assert_eq!((mean(&[]), mean(&[1.0, 2.0])), (None, Some(1.5)));
        assert_eq!(or_none(None, short), NONE);
    }
}
