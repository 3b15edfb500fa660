//! Soft shadows of a disc light on a flat base surface, without a search for blockers.
//!
//! # Theory
//!
//! A disc of angular radius α about the elevation θ, behind a horizon that is straight and level as far as the disc reaches, is
//! cut along a chord. At the distance 1 its radius is tan α, and the chord is tan(θ − ε) below its centre. Seen is the share
//!
//! > V = ½ + (t √(1 − t²) + asin t) / π,  t = clamp(tan(θ − ε) / tan α, −1, 1),
//!
//! with tan(θ − ε) = (Lz cos ε − |Lxy| sin ε) / (|Lxy| cos ε + Lz sin ε), L the unit vector towards the light, and ε the horizon's
//! elevation at the azimuth of the disc's centre: bilinear in the layer and linear between the two azimuths beside it, as in
//! [`crate::HorizonShadow`], which is the limit α → 0. Elevations fall from place to place as far as the edge is away, so the
//! penumbra is as wide as geometry says: [`DiscLight::penumbra_width`].
//!
//! A light close by, above the level distance D, is not hidden by what stands behind it. Of the eight taps, four texels in each of two
//! azimuths, those count whose horizon is nearer, d < D. With c the sum of their weights, ε the weighted mean of their
//! elevations,
//!
//! > V = 1 − c (1 − V(ε)),
//!
//! which is the sun's form where all of them block.
//!
//! # What was measured
//!
//! Against [`crate::TracedPenumbra`] of 400 rays: tiles of 128² texels of length 2, azimuths anywhere, elevations within 2α of
//! the horizon, where it matters; exact maps; RMS error of V at 500 texel centres, for K = 16, 32, 64 azimuths.
//!
//! | relief, α | this | one V per azimuth, mixed | the chord tilted |
//! |---|---|---|---|
//! | terrain, 0.27° | .518 .365 .213 | .469 .393 .295 | .517 .364 .212 |
//! | terrain, 2° | .143 .074 .033 | .199 .104 .041 | .142 .073 .031 |
//! | terrain, 5° | .054 .026 .014 | .073 .028 .012 | .053 .024 .012 |
//! | dunes, 2° | .080 .024 .013 | .135 .058 .018 | .079 .023 .011 |
//! | wall, 2° | .130 .064 .055 | .166 .084 .048 | .121 .048 .034 |
//! | half-cylinders, 2° | .063 .028 .023 | .205 .116 .043 | .056 .015 .004 |
//!
//! The largest errors on terrain are .80 .54 .20 at 2°, .33 .14 .09 at 5°, and 1 at 0.27°, where the map misses a shadow's edge.
//!
//! The chord is tilted by t / √(1 + m²), m = (ε₂ − ε₁) / (Δφ cos θ), of the two azimuths beside the light. It helps along straight
//! edges, but m jumps where the light crosses a baked azimuth, and what is seen with it; one V per azimuth does not
//! become the hard shadow as α → 0. So neither is taken. The great circle through the horizon's points at both azimuths is a
//! straight edge itself: RMS .002 on half-cylinders, .099 .030 .033 at the wall, on terrain as the others; but its hard shadow is
//! another than that of elevations.
//!
//! Between texels the horizon is only interpolated, which costs more than all of that: of terrain, K = 32, the errors are .572,
//! .313 and .194. One V for each texel, of elevations mixed in azimuth, and those interpolated: .497, .290, .187, at four times
//! the arithmetic and a hard shadow with steps.
//!
//! # Limits
//!
//! - A light hidden by a hill nearer and lower than one behind the light is taken for seen: the map knows but one point.
//!   On terrain, K = 32, lamps up to half as high over the ground as they are far; of the texels that face a lamp and have all their
//!   horizons behind it, 6 % are mostly dark where lamps of radius 1 are 20 to 80 away, 2 % at radius 4, none of 132 at radius 8,
//!   60 to 200 away. RMS over all that face it: .144, .080, .034, and .244, .169, .066 if the distance is not looked at.
//! - Level ground is its own horizon, as far away as was searched: it hides nothing of a lamp that dips into it. Lambert's cosine
//!   does.
//! - The horizon is one line from side to side of the disc: of a spike thinner than the disc, it sees an endless wall, or nothing.
//! - The base surface is flat. On a curved one [`crate::CurvedShadow`] gives elevations, but not which points are nearer than
//!   a light.
//!
//! Numbers in a table that are none are darkness; what is returned is always within 0 and 1.

use barchan_asset::{Azimuths, DistanceView, HorizonView};

use crate::curved_shadow::{MismatchedTables, bilinear, check, check_fits};
use crate::{DiscLight, Texture};

/// A disc no larger than this, at the distance 1, is a point: what f32 tells apart of angles.
const SMALLEST_DISC: f64 = 1e-6;

/// Fewer blocking taps than this darken nothing that could be seen.
const LEAST_COVERAGE: f64 = 1e-6;

/// The decoded tables of a map, for lights from anywhere: every place may see its own.
#[derive(Debug, Clone)]
pub struct Penumbra {
    azimuths: Azimuths,
    layers: Vec<Layer>,
}

/// The horizon of every texel towards one azimuth.
#[derive(Debug, Clone)]
struct Layer {
    elevation: Texture,
    distance: Texture,
}

impl Penumbra {
    /// Decodes the tables of a map.
    ///
    /// # Errors
    /// Tables that do not fit each other.
    pub fn new(horizon: &HorizonView<'_>, distance: &DistanceView<'_>) -> Result<Self, MismatchedTables> {
        let (elevations, distances) = (horizon.table(), distance.table());
        check_fits(&elevations, &distances, "distance")?;
        check(horizon.azimuths() == distance.azimuths(), "distance")?;
        let layer = |direction| Layer {
            elevation: Texture::new(&elevations, direction),
            distance: Texture::new(&distances, direction),
        };
        Ok(Self { azimuths: horizon.azimuths(), layers: (0..horizon.directions()).map(layer).collect() })
    }

    /// How much of the disc is seen from a place, 0 to 1.
    #[must_use]
    pub fn visibility(&self, place: (f64, f64), light: &DiscLight) -> f64 {
        let (first, second, weight) = self.azimuths.neighbours(light.azimuth_radians());
        let towards = |direction: u32| self.layers[direction as usize].blocking(place, light.level_distance);
        let ((c1, e1), (c2, e2), weight) = (towards(first), towards(second), f64::from(weight));
        let (coverage, elevation) = (c1 + (c2 - c1) * weight, e1 + (e2 - e1) * weight);
        let (sin, cos) = libm::sincos(elevation / coverage.max(LEAST_COVERAGE));
        let (level, height) = (light.towards.truncate().length(), light.towards.z);
        // The sine and the cosine of θ − ε; at a right angle and beyond, all of the disc is on one side.
        let (rise, run) = (height * cos - level * sin, level * cos + height * sin);
        let radius = libm::tan(light.angular_radius_radians).max(SMALLEST_DISC);
        let hidden = 1.0 - share_above(rise / (run.max(SMALLEST_DISC) * radius));
        clamp_to(0.0, 1.0 - coverage * hidden)
    }
}

impl Layer {
    /// The share of taps whose horizon is nearer than the light, and their elevations, weighted.
    fn blocking(&self, (x, y): (f64, f64), level_distance: f64) -> (f64, f64) {
        let ((elevations, within), (distances, _)) = (self.elevation.cell(x, y), self.distance.cell(x, y));
        let blocks = distances.map(|distance| distance < level_distance);
        let elevation = |tap: usize| if blocks[tap] { elevations[tap] } else { 0.0 };
        let coverage = blocks.map(|blocks| f64::from(u8::from(blocks)));
        (bilinear(coverage, within), bilinear([0, 1, 2, 3].map(elevation), within))
    }
}

/// The share of a disc above a straight line whose distance below the centre is `above` radii.
fn share_above(above: f64) -> f64 {
    let t = clamp_to(-1.0, above);
    0.5 + (t * (1.0 - t * t).sqrt() + libm::asin(t)) * std::f64::consts::FRAC_1_PI
}

/// Within `lowest` and 1; NaN is the lowest, which [`f64::clamp`] would keep.
fn clamp_to(lowest: f64, value: f64) -> f64 {
    value.max(lowest).min(1.0)
}
