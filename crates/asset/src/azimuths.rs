//! The azimuths of a directional table, and the interpolation between them.
//!
//! `formats/horizon-v1.md` is the law: a full circle is cyclic, an arc ends at both its ends.

use core::f64::consts::TAU;

/// Nearer than this to a layer, in steps, is on the layer; nearer than this to an end of an arc, in radians, is at the
/// end. About 1e-9: what f64 arithmetic on angles can cost, and no shader can see.
const SNAP: f64 = 1.0 / (1 << 30) as f64;

/// Evenly spread azimuths, layer by layer: 0 is along +u, growing counter-clockwise as seen, so that a quarter turn is
/// up the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Azimuths {
    first: f64,
    step: f64,
    count: u32,
}

impl Azimuths {
    /// `count` azimuths around the whole circle, the first along +u.
    #[must_use]
    pub fn full_circle(count: u32) -> Self {
        Self { first: 0.0, step: TAU / f64::from(count), count }
    }

    /// `count` azimuths from `first_radians`, within ±2π, to `last_radians`, less than 2π beyond; both ends are baked.
    ///
    /// One azimuth alone is an arc without length: `last_radians` is not used. What the format does not accept is
    /// refused when a descriptor is made of it.
    #[must_use]
    pub fn arc(first_radians: f64, last_radians: f64, count: u32) -> Self {
        let steps = f64::from(count.saturating_sub(1));
        let step = if steps == 0.0 { 0.0 } else { (last_radians - first_radians) / steps };
        Self { first: first_radians, step, count }
    }

    pub(crate) fn from_parts(first: f64, step: f64, count: u32) -> Self {
        Self { first, step, count }
    }

    /// How many azimuths there are.
    #[must_use]
    pub fn count(&self) -> u32 {
        self.count
    }

    /// The first azimuth in radians, within ±2π.
    #[must_use]
    pub fn first_radians(&self) -> f64 {
        self.first
    }

    /// From one azimuth to the next in radians; 0 for an arc of one azimuth.
    #[must_use]
    pub fn step_radians(&self) -> f64 {
        self.step
    }

    /// An azimuth in radians, counted on from the first.
    #[must_use]
    pub fn radians(&self, index: u32) -> f64 {
        self.first + f64::from(index) * self.step
    }

    /// Whether the last azimuth is followed by the first. Otherwise it is an arc.
    #[must_use]
    pub fn is_full_circle(&self) -> bool {
        self.first == 0.0 && self.step == TAU / f64::from(self.count)
    }

    /// Whether a file may hold these azimuths; their number is bounded elsewhere.
    pub(crate) fn is_legal(&self) -> bool {
        self.is_full_circle() || self.is_legal_arc()
    }

    fn is_legal_arc(&self) -> bool {
        let step_is_legal = if self.count == 1 { self.step == 0.0 } else { self.step > 0.0 };
        self.first.abs() <= TAU && step_is_legal && self.span() < TAU
    }

    /// From the first azimuth to the last.
    fn span(&self) -> f64 {
        self.step * f64::from(self.count.saturating_sub(1))
    }

    /// Whether an azimuth, any finite number of radians, lies between two baked ones: always on a full circle; on an
    /// arc, from end to end.
    #[must_use]
    pub fn covers(&self, azimuth_radians: f64) -> bool {
        let offset = self.offset(azimuth_radians);
        self.is_full_circle() || offset <= self.span() + SNAP || TAU - offset <= SNAP
    }

    /// The two azimuths to interpolate between and how far the second one counts, in [0, 1): value = first + weight ·
    /// (second − first). `azimuth_radians` is any finite number; turns do not count.
    ///
    /// On an azimuth (to 2⁻³⁰ of a step) the weight is 0. Beyond an arc it is the nearer end, with weight 0.
    #[must_use]
    pub fn neighbours(&self, azimuth_radians: f64) -> (u32, u32, f32) {
        let (offset, last) = (self.offset(azimuth_radians), self.count.saturating_sub(1));
        let span = self.span();
        if last == 0 {
            return (0, 0, 0.0);
        }
        if self.is_full_circle() {
            let (index, weight) = split(offset / self.step);
            // An azimuth a hair below 2π is on the last one's successor, which is the first.
            let index = index % self.count;
            return (index, (index + 1) % self.count, weight);
        }
        if offset <= span {
            let (index, weight) = split(offset / self.step);
            return if index < last { (index, index + 1, weight) } else { (last, last, 0.0) };
        }
        let nearer_end = if TAU - offset <= offset - span { 0 } else { last };
        (nearer_end, nearer_end, 0.0)
    }

    /// The azimuth nearest to any finite number of radians. None further than half a step beyond the ends of an arc, and
    /// for what is not a number.
    #[must_use]
    pub fn nearest(&self, azimuth_radians: f64) -> Option<u32> {
        let (offset, span) = (self.offset(azimuth_radians), self.span());
        let last = self.count.checked_sub(1).filter(|_| azimuth_radians.is_finite())?;
        if self.is_full_circle() || offset < span {
            // As on a circle the last half step belongs to the first azimuth again.
            return Some((offset / self.step + 0.5) as u32 % self.count);
        }
        let (beyond_last, before_first) = (offset - span, TAU - offset);
        let (nearer_end, distance) = if beyond_last <= before_first { (last, beyond_last) } else { (0, before_first) };
        (distance <= 0.5 * self.step).then_some(nearer_end)
    }

    /// Counter-clockwise from the first azimuth, in [0, 2π).
    fn offset(&self, azimuth_radians: f64) -> f64 {
        let offset = (azimuth_radians - self.first) % TAU;
        // Adding 2π to a tiny negative number rounds to 2π itself.
        if offset < 0.0 && offset + TAU < TAU { offset + TAU } else { offset.max(0.0) }
    }
}

/// A position in steps as whole steps and a rest in [0, 1).
fn split(position: f64) -> (u32, f32) {
    let nearest = (position + 0.5) as u32;
    if (position - f64::from(nearest)).abs() <= SNAP {
        return (nearest, 0.0);
    }
    let index = position as u32;
    // As f32 a rest just below 1 would round to 1.
    (index, ((position - f64::from(index)) as f32).min(1.0_f32.next_down()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn on_a_circle_an_azimuth_lies_between_its_neighbours_and_wraps() {
        let circle = Azimuths::full_circle(8);
        assert_eq!(circle.neighbours(0.0), (0, 1, 0.0));
        assert_eq!(circle.neighbours(TAU / 8.0), (1, 2, 0.0));
        assert_eq!(circle.neighbours(TAU * 7.5 / 8.0), (7, 0, 0.5));
        assert_eq!(circle.neighbours(-TAU / 16.0), (7, 0, 0.5));
        assert_eq!(circle.neighbours(TAU.next_down()), (0, 1, 0.0));
        assert_eq!(circle.neighbours(-1e-300), (0, 1, 0.0));
        assert_eq!(circle.neighbours(5.0 * TAU), (0, 1, 0.0));
        assert_eq!(Azimuths::full_circle(1).neighbours(TAU / 3.0), (0, 0, 0.0));
        assert!(circle.covers(123.0));
    }

    #[test]
    fn an_azimuth_on_a_layer_is_that_layer_alone() {
        for count in 1..=400 {
            let arcs =
                [Azimuths::arc(-1.1, 2.3, count), Azimuths::arc(5.9, 7.7, count), Azimuths::arc(-6.0, -0.1, count)];
            for azimuths in arcs.into_iter().chain([Azimuths::full_circle(count)]) {
                assert!(azimuths.is_legal());
                for k in 0..count {
                    for turns in [-TAU, 0.0, TAU] {
                        let (index, _, weight) = azimuths.neighbours(azimuths.radians(k) + turns);
                        assert_eq!((index, weight), (k, 0.0), "{azimuths:?}");
                        assert!(azimuths.covers(azimuths.radians(k) + turns), "{azimuths:?} {k}");
                    }
                }
            }
        }
    }

    #[test]
    fn an_arc_across_zero_ends_at_both_ends() {
        let arc = Azimuths::arc(-FRAC_PI_2, FRAC_PI_2, 5);
        assert_eq!(arc.neighbours(0.0), (2, 3, 0.0));
        assert_eq!(arc.neighbours(TAU - PI / 8.0), (1, 2, 0.5));
        assert_eq!(arc.neighbours(FRAC_PI_2), (4, 4, 0.0));
        assert_eq!(arc.neighbours(FRAC_PI_2 + 0.1), (4, 4, 0.0));
        assert_eq!(arc.neighbours(PI - 0.01), (4, 4, 0.0));
        assert_eq!(arc.neighbours(PI + 0.01), (0, 0, 0.0));
        assert_eq!(arc.neighbours(-FRAC_PI_2 - 1e-12), (0, 0, 0.0));
        assert!(arc.covers(-0.3) && arc.covers(FRAC_PI_2) && !arc.covers(FRAC_PI_2 + 1e-6) && !arc.covers(PI));
    }

    #[test]
    fn the_blend_of_neighbours_is_the_azimuth_itself() {
        for azimuths in [Azimuths::full_circle(7), Azimuths::arc(-2.0, 3.0, 11), Azimuths::arc(6.0, 8.0, 2)] {
            for azimuth in (-2000..2000).map(|i| f64::from(i) * 0.01).filter(|&a| azimuths.covers(a)) {
                let (index, _, weight) = azimuths.neighbours(azimuth);
                let blended = azimuths.radians(index) + f64::from(weight) * azimuths.step_radians();
                let off = (blended - azimuth) % TAU;
                let off = off.abs().min(TAU - off.abs());
                assert!(off < 1e-6, "{azimuths:?} {azimuth}: {off}");
            }
        }
    }

    #[test]
    fn what_is_neither_circle_nor_arc_is_illegal() {
        for azimuths in [
            Azimuths::arc(0.0, TAU, 2),
            Azimuths::arc(0.0, 0.0, 3),
            Azimuths::arc(1.0, 0.5, 3),
            Azimuths::arc(TAU.next_up(), 7.0, 2),
            Azimuths::arc(f64::NAN, 1.0, 2),
            Azimuths::arc(0.0, f64::INFINITY, 2),
            Azimuths::from_parts(0.0, 0.5, 1),
        ] {
            assert!(!azimuths.is_legal(), "{azimuths:?}");
            let _ = (azimuths.neighbours(1.0), azimuths.covers(1.0), azimuths.neighbours(f64::NAN));
        }
        assert!(Azimuths::arc(1.0, 1.0, 1).is_legal());
        // Degrees at the limit stay within it.
        assert!(Azimuths::arc(360_f64.to_radians(), 700_f64.to_radians(), 2).is_legal());
        assert!(Azimuths::arc(-360_f64.to_radians(), -0.01, 9).is_legal());
    }
}
