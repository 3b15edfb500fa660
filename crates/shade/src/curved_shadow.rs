//! Shadows of relief on a curved surface, from baked points.
//!
//! A place is in shadow iff the light stands below its horizon, L′z < δ′ · |L′xy|: Koiichi Onoue, Nelson Max, Tomoyuki Nishita,
//! *Bumpmap Shadows on Curved Surfaces*. Light from below the tangent plane is not cut off: a bump behind the terminator
//! whose horizon is lower still is lit.
//!
//! # Interpolation
//!
//! The horizon's distance jumps between texels, and between azimuths. So each of the four texels around a place, in each of the
//! two azimuths beside the light's, carries its own points over to the curved surface, from its own height, and no lower than
//! the surface itself; what is interpolated is the elevation of the result, atan δ′, as [`crate::HorizonShadow`] does: on a
//! flat surface both agree. Against the oracle, on reptile skin on a ball of κ = 0.015, at places anywhere between texels: of
//! interpolated elevations 5.9 % of shadows are wrong, of sines 6.2 %, of slopes 6.3 %, and of unit vectors (1, δ′) / √(1 + δ′²),
//! which a shader has without trigonometry, 5.9 %.
//!
//! # Where the surface itself hides things
//!
//! Eq 3 is the horizon of the base surface, at a height of 0. No relief is lower than its lowest texel, so the surface
//! parallel to the base at that height is as solid, and no relief needs to stand on the base for it: the exact methods take
//! that one. The paper's take the base.
//!
//! # Limits
//!
//! The curvature at the place stands for that of all the way to the horizon, and the relief for endless. On a convex surface far
//! points sink, and it does not matter; on a concave one they rise with the square of the distance, and the search radius
//! of the map decides how far the hollow is taken to go on. On a sheet whose curvature wavers between ±0.006, 9.0 % of shadows are
//! wrong without a correction, and with three points 8.4, 8.3, 8.7 and 12.8 % for maps of radius 24, 40, 64 and 128: relief
//! for curved surfaces wants a radius of some of its own periods, and less than the surface's own.

use barchan_asset::{Azimuths, DistanceView, HeightView, HorizonView, SweptDistanceView, SweptHorizonView, TableView};

use crate::curved::{geometric_horizon, geometric_horizon_as_printed};
use crate::{Correction, StoredPoint, TangentLight, Texture};

/// How the horizon of a curved surface is found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CurvedMethod {
    /// The map as baked for a flat surface.
    Flat,
    /// Eq 2 of the one point, and eq 3 with its printed sign; concave surfaces as if they were flat.
    PaperAsPrinted,
    /// Eq 2 of the one point, on concave surfaces too, and eq 3 with its sign mended.
    Paper,
    /// The exact form of so many points, or of as many as there are: 1 is the paper's table, more are a curvature-swept one's.
    Exact(u32),
}

impl CurvedMethod {
    /// Every method that has a name, plainest first.
    pub const ALL: [Self; 6] =
        [Self::Flat, Self::PaperAsPrinted, Self::Paper, Self::Exact(1), Self::Exact(2), Self::Exact(3)];

    /// How many points of a texel and azimuth it looks at.
    #[must_use]
    pub fn points(self) -> u32 {
        match self {
            Self::Flat | Self::PaperAsPrinted | Self::Paper => 1,
            Self::Exact(points) => points.max(1),
        }
    }
}

/// Its name in studies: `flat`, `paper-as-printed`, `paper`, `exact-1`, `swept-2`, `swept-3`.
impl std::fmt::Display for CurvedMethod {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Flat => f.write_str("flat"),
            Self::PaperAsPrinted => f.write_str("paper-as-printed"),
            Self::Paper => f.write_str("paper"),
            Self::Exact(0 | 1) => f.write_str("exact-1"),
            Self::Exact(points) => write!(f, "swept-{points}"),
        }
    }
}

/// Tables that are not of one map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "the {0} table has another size, spacing, edge or other azimuths than the horizon table; tables of one map are accepted"
)]
pub struct MismatchedTables(pub &'static str);

/// The decoded tables of a map, for lights from anywhere: on a curved surface every place sees its own azimuth.
#[derive(Debug, Clone)]
pub struct CurvedShadow {
    heights: Texture,
    /// Of each point, the layers of all azimuths.
    points: Vec<Vec<PointLayer>>,
    azimuths: Azimuths,
    lowest: f64,
    extent: (f64, f64),
}

/// One point of every texel towards one azimuth.
#[derive(Debug, Clone)]
struct PointLayer {
    slope: Texture,
    distance: Texture,
}

/// The surface under a place, towards the light.
#[derive(Debug, Clone, Copy)]
struct Ground {
    curvature: f64,
    stretch: f64,
    lowest: f64,
}

impl CurvedShadow {
    /// Decodes the tables of a map: the flat horizon, its distances, the heights, and the points of a curvature-swept horizon
    /// where there are any.
    ///
    /// # Errors
    /// Tables that do not fit each other.
    pub fn new(
        horizon: &HorizonView<'_>,
        distance: &DistanceView<'_>,
        swept: Option<(&SweptHorizonView<'_>, &SweptDistanceView<'_>)>,
        heights: &HeightView<'_>,
    ) -> Result<Self, MismatchedTables> {
        let azimuths = horizon.azimuths();
        check_fits(&horizon.table(), &heights.table(), "height")?;
        check_fits(&horizon.table(), &distance.table(), "distance")?;
        check(azimuths == distance.azimuths(), "distance")?;
        let layer = |tables: [&TableView<'_>; 2], layer| PointLayer {
            slope: Texture::map(tables[0], layer, |elevation| libm::tan(f64::from(elevation)) as f32),
            distance: Texture::new(tables[1], layer),
        };
        let directions = 0..azimuths.count();
        let flat = [&horizon.table(), &distance.table()];
        let mut points = vec![directions.clone().map(|direction| layer(flat, direction)).collect()];
        if let Some((elevations, distances)) = swept {
            let tables = [&elevations.table(), &distances.table()];
            check_fits(&horizon.table(), tables[0], "swept elevation")?;
            check_fits(&horizon.table(), tables[1], "swept distance")?;
            check(azimuths == elevations.azimuths(), "swept elevation")?;
            let same = azimuths == distances.azimuths() && elevations.candidates() == distances.candidates();
            check(same, "swept distance")?;
            let of = |point| directions.clone().map(|d| layer(tables, elevations.layer(point, d))).collect();
            points.extend((0..elevations.candidates()).map(of));
        }
        let heights_texture = Texture::new(&heights.table(), 0);
        let (spacing_u, spacing_v) = horizon.spacing();
        let extent = (f64::from(horizon.width()) * spacing_u, f64::from(horizon.height()) * spacing_v);
        let lowest = f64::from(heights_texture.range().0);
        Ok(Self { heights: heights_texture, points, azimuths, lowest, extent })
    }

    /// How long the map's own grid is along one unit of u and of v: what [`TangentLight::new`] asks for.
    #[must_use]
    pub fn extent(&self) -> (f64, f64) {
        self.extent
    }

    /// How many points there are of every texel and azimuth.
    #[must_use]
    pub fn points(&self) -> u32 {
        self.points.len() as u32
    }

    /// The elevation of the horizon towards a light above the tangent plane of a place, in radians. `curvature` is that of the
    /// base surface along the light, in 1 / length.
    #[must_use]
    pub fn elevation_radians(
        &self,
        method: CurvedMethod,
        (x, y): (f64, f64),
        light: &TangentLight,
        curvature: f64,
    ) -> f64 {
        let ground = Ground { curvature, stretch: light.stretch, lowest: self.lowest };
        let (heights, within) = self.heights.cell(x, y);
        let count = (method.points() as usize).min(self.points.len());
        let towards = |direction: u32| {
            let mut horizons = [f64::NEG_INFINITY; 4];
            for layers in &self.points[..count] {
                let layer = &layers[direction as usize];
                let ((slopes, _), (distances, _)) = (layer.slope.cell(x, y), layer.distance.cell(x, y));
                for (tap, horizon) in horizons.iter_mut().enumerate() {
                    let flat = StoredPoint { slope: slopes[tap], distance: distances[tap] };
                    *horizon = horizon.max(ground.horizon(method, flat, heights[tap]));
                }
            }
            bilinear(horizons.map(libm::atan), within)
        };
        let (first, second, weight) = self.azimuths.neighbours(light.azimuth_radians);
        let elevation = towards(first);
        if weight == 0.0 { elevation } else { elevation + (towards(second) - elevation) * f64::from(weight) }
    }

    /// Whether the light stands below the horizon of a place. A light at the zenith of a place always reaches it; straight from
    /// below, it never does.
    #[must_use]
    pub fn in_shadow(&self, method: CurvedMethod, place: (f64, f64), light: &TangentLight, curvature: f64) -> bool {
        let (sin, cos) = libm::sincos(self.elevation_radians(method, place, light, curvature));
        light.height * cos < light.level * sin
    }
}

impl Ground {
    /// The slope of the horizon by one point of a texel, and no lower than the surface.
    fn horizon(&self, method: CurvedMethod, point: StoredPoint, height: f64) -> f64 {
        let Self { curvature, stretch, lowest } = *self;
        let point = StoredPoint { slope: point.slope / stretch, distance: point.distance * stretch };
        match method {
            CurvedMethod::Flat => point.slope,
            CurvedMethod::PaperAsPrinted if curvature <= 0.0 => point.slope,
            CurvedMethod::PaperAsPrinted => {
                Correction::Paper.slope(point, curvature, height).max(geometric_horizon_as_printed(curvature, height))
            }
            CurvedMethod::Paper => {
                Correction::Paper.slope(point, curvature, height).max(geometric_horizon(curvature, height))
            }
            CurvedMethod::Exact(_) => {
                // The parallel surface through the lowest relief.
                let floor = curvature / (1.0 + curvature * lowest);
                let smooth = geometric_horizon(if floor.is_finite() { floor } else { 0.0 }, height - lowest);
                Correction::Exact.slope(point, curvature, height).max(smooth)
            }
        }
    }
}

pub(crate) fn bilinear([upper_left, upper_right, lower_left, lower_right]: [f64; 4], (right, down): (f64, f64)) -> f64 {
    let upper = upper_left + (upper_right - upper_left) * right;
    let lower = lower_left + (lower_right - lower_left) * right;
    upper + (lower - upper) * down
}

pub(crate) fn check(fits: bool, table: &'static str) -> Result<(), MismatchedTables> {
    if fits { Ok(()) } else { Err(MismatchedTables(table)) }
}

pub(crate) fn check_fits(
    horizon: &TableView<'_>,
    other: &TableView<'_>,
    name: &'static str,
) -> Result<(), MismatchedTables> {
    let (a, b) = (horizon.descriptor(), other.descriptor());
    let same = (a.width, a.height, a.spacing_u, a.spacing_v) == (b.width, b.height, b.spacing_u, b.spacing_v);
    check(same && (a.wrap_u, a.wrap_v, a.length_unit) == (b.wrap_u, b.wrap_v, b.length_unit), name)
}
