//! Sums that do not lose small terms beside large ones.

/// Neumaier's compensated sum (*Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen*, 1974). Its error
/// does not grow with the number of terms, and the result depends on the order of the terms alone.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Sum {
    total: f64,
    lost: f64,
}

impl Sum {
    pub(crate) fn add(&mut self, term: f64) {
        let total = self.total + term;
        if total.is_finite() {
            let (large, small) = if self.total.abs() >= term.abs() { (self.total, term) } else { (term, self.total) };
            self.lost += (large - total) + small;
        }
        self.total = total;
    }

    /// Adds another sum, its rounded total first.
    pub(crate) fn merge(&mut self, other: Self) {
        self.add(other.total);
        self.lost += other.lost;
    }

    pub(crate) fn value(self) -> f64 {
        if self.total.is_finite() { self.total + self.lost } else { self.total }
    }
}

#[cfg(test)]
mod tests {
    use super::Sum;

    #[test]
    fn small_terms_survive_beside_a_large_one() {
        let mut sum = Sum::default();
        for term in [1.0, 1e100, 1.0, -1e100] {
            sum.add(term);
        }
        assert_eq!(sum.value(), 2.0);
    }

    #[test]
    fn an_infinite_term_gives_infinity_and_not_nan() {
        let mut sum = Sum::default();
        for term in [1.0, f64::INFINITY, 1.0] {
            sum.add(term);
        }
        assert_eq!(sum.value(), f64::INFINITY);
    }
}
