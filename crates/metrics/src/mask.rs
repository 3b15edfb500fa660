//! Where two shadow masks disagree.

/// Texels on which a shadow mask is wrong, by the way in which it is wrong. `true` means in shadow.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct MaskDisagreement {
    /// Texels compared.
    pub total: u64,
    /// Lit in truth, dark in the mask.
    pub false_shadow: u64,
    /// Dark in truth, lit in the mask.
    pub missed_shadow: u64,
}

impl MaskDisagreement {
    /// Compares `mask` with the truth.
    ///
    /// # Panics
    ///
    /// When the slices differ in length.
    #[must_use]
    pub fn between(truth: &[bool], mask: &[bool]) -> Self {
        assert_eq!(truth.len(), mask.len(), "disagreement of masks of different lengths");
        let count =
            |wrong: fn(bool, bool) -> bool| truth.iter().zip(mask).filter(|&(&t, &m)| wrong(t, m)).count() as u64;
        Self { total: truth.len() as u64, false_shadow: count(|t, m| !t && m), missed_shadow: count(|t, m| t && !m) }
    }

    /// Adds the counts of another part.
    pub fn merge(&mut self, other: &Self) {
        self.total += other.total;
        self.false_shadow += other.false_shadow;
        self.missed_shadow += other.missed_shadow;
    }

    /// The part of all texels that are wrong, 0 … 1; 0 for none.
    #[must_use]
    pub fn rate(&self) -> f64 {
        if self.total == 0 { 0.0 } else { (self.false_shadow + self.missed_shadow) as f64 / self.total as f64 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_of_being_wrong_are_told_apart() {
        let found = MaskDisagreement::between(&[true, true, false, false, false], &[true, false, true, true, false]);
        assert_eq!(found, MaskDisagreement { total: 5, false_shadow: 2, missed_shadow: 1 });
        assert_eq!(found.rate(), 0.6);
    }

    #[test]
    fn parts_add_up_and_nothing_compared_is_nothing_wrong() {
        let mut sum = MaskDisagreement::default();
        assert_eq!(sum.rate(), 0.0);
        sum.merge(&MaskDisagreement { total: 3, false_shadow: 1, missed_shadow: 0 });
        sum.merge(&MaskDisagreement { total: 1, false_shadow: 0, missed_shadow: 1 });
        assert_eq!((sum.total, sum.rate()), (4, 0.5));
    }
}
