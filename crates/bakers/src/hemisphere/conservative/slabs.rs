//! Slabs of depth: 255 of them, one for each value of a byte but the last.
//!
//! Slab i begins 2⁻¹⁹ below i/255 and its value is stored 2⁻²⁰ above its beginning, so that a byte, rounded down, is i exactly.

/// How many there are.
pub(super) const COUNT: usize = 255;

/// Beyond i/255.
const OFFSET: f64 = 1.0 / (1 << 19) as f64;

/// By how much what is stored is less than what is proven.
const LOWERED: f64 = 1.0 / (1 << 20) as f64;

/// By how much a depth may be too great, as it is rounded to f32, four times over.
const ROUNDING: f64 = 1.0 / (1 << 22) as f64;

/// Where a slab begins. The first one begins at 0.
pub(super) fn start(slab: usize) -> f64 {
    if slab == 0 { 0.0 } else { slab as f64 / COUNT as f64 + OFFSET }
}

/// Where a slab ends. The last one ends at 1.
pub(super) fn end(slab: usize) -> f64 {
    start(slab + 1).min(1.0)
}

/// What the table holds where no ray hits before a slab.
pub(super) fn stored(slab: usize) -> f32 {
    (start(slab) - LOWERED).max(0.0) as f32
}

/// The first slab that does not end above a depth, 0..1.
pub(super) fn first_reaching(depth: f64) -> u8 {
    let depth = depth - ROUNDING;
    // A byte is near enough to look on from.
    let near = ((depth * COUNT as f64) as usize).saturating_sub(1);
    (near..COUNT).find(|&slab| depth <= end(slab)).unwrap_or(COUNT - 1) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slabs_cover_all_depths_and_store_as_bytes() {
        assert_eq!((start(0), end(COUNT - 1)), (0.0, 1.0));
        for slab in 0..COUNT {
            assert!(start(slab) < end(slab));
            assert!(f64::from(stored(slab)) <= (start(slab) - 0.9 * LOWERED).max(0.0));
            assert_eq!((stored(slab) * 255.0).floor() as usize, slab);
        }
    }

    #[test]
    fn a_depth_is_reached_in_the_slab_that_holds_it() {
        for thousandth in 0..=1000_u16 {
            let depth = f64::from(thousandth) / 1000.0;
            let slab = usize::from(first_reaching(depth));
            assert!(start(slab) <= depth && depth <= end(slab) + ROUNDING, "{depth}");
        }
    }
}
