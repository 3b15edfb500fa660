//! Figures 4 to 9 of Koiichi Onoue, Nelson Max, Tomoyuki Nishita, *Bumpmap Shadows on Curved Surfaces*, rebuilt: relief on
//! curved bases.
//!
//! # What is as in the paper
//!
//! Half cylinders of 128² texels and 32 azimuths on spheres of curvature 0.015 and 0.005 per texel, reptile skin of 256² and
//! 16 on the first sphere and on a Bézier patch of 512 triangles, wind ripples on dunes.
//!
//! # What is ours
//!
//! Heights, the patch and the dunes. A texel is one length unit long where the texture lies unstretched: at
//! the equator of a sphere, about everywhere on patches. On a sphere u is longitude, and its seam is behind. The patch is
//! convex in its middle and saddle-shaped towards its corners. The paper's dunes are bases that wear ripples; here they are
//! relief as well, ripples and slip faces and all.
//!
//! # What no table knows
//!
//! A table is of the relief, and takes the base to bend on as it does at the texel. The *swell* is a base whose curvature
//! changes sign every 64 units and whose crests shade its troughs: no method sees that, and the wider a table searches, the
//! more a hollow is mistaken for a bowl. It is the limit of them all, shown beside the figures.

use barchan_bakers::swept::CurvatureRange;
use barchan_field::shapes::{Axis, CylinderBumps, Dunes, ReptileSkin, RipplePattern, Ripples};
use barchan_field::surfaces::ParametricSurface;
use barchan_field::{Edge, Grid, LengthUnit, Shape, Spacing};
use barchan_shade::{BaseSurface, FundamentalForms, Patch, Sphere, SphereChart, SurfacePoint, TangentFrame};
use glam::{DVec2, DVec3};

use crate::triangle_forms::TriangleForms;
use crate::{Scale, Scene, StudyError, scenes};

/// Cells of a patch each way, of two triangles each.
const CELLS: u32 = 16;

/// How far horizons are searched where nothing speaks against it, in length units: a tile of the cylinders.
const WIDE: f64 = 128.0;

/// Likewise where ripples are fine and bases bend differently a little farther on.
const NARROW: f64 = 32.0;

/// Azimuths of the maps of patches.
const PATCH_DIRECTIONS: u32 = 16;

/// Parts of a patch at whose corners its curvatures are looked up.
const STEPS: u32 = 32;

/// Relief on a base.
pub struct Figure {
    /// The paper's number, and what is seen.
    pub relief: Scene,
    /// Azimuths of the map.
    pub directions: u32,
    /// How far horizons are searched, in length units.
    pub radius: f64,
    /// What the relief stands on, (u, v) counting tiles of it.
    pub base: Box<dyn BaseSurface>,
    /// The part of (u, v) that is looked at.
    pub part: (DVec2, DVec2),
    /// Every curvature of that part, in 1 / length unit.
    pub range: CurvatureRange,
    /// What a run time has of the base's forms; `None` on spheres, where interpolation costs nothing.
    pub forms: Option<TriangleForms>,
}

impl Figure {
    /// The forms that a run time has at a place.
    #[must_use]
    pub fn forms_at(&self, uv: DVec2) -> FundamentalForms {
        self.forms.as_ref().map_or_else(|| self.base.forms(uv), |triangles| triangles.at(uv))
    }
}

/// All of them.
///
/// # Errors
/// None in practice.
pub fn all(scale: Scale) -> Result<Vec<Figure>, StudyError> {
    let coarser = match scale {
        Scale::Full => 1,
        Scale::Quick => 4,
    };
    let cylinders = Shape::CylinderBumps(CylinderBumps { height: 4.0, rows: 8, coverage: 1.0, across: Axis::U });
    let skin = Shape::ReptileSkin(ReptileSkin { scale_height: 5.0, scales_across: 12, irregularity: 0.5, seed: 3 });
    let ripples = Shape::Ripples(Ripples {
        amplitude: 0.35,
        waves_u: 44,
        waves_v: 5,
        phase: 0.0,
        pattern: RipplePattern::Oblique,
    });
    let dunes = Shape::Dunes(Dunes {
        dune_height: 18.0,
        dunes_across: 2,
        ripple_height: 0.35,
        ripples_across: 44,
        sinuosity: 0.85,
        slip_degrees: 32.0,
        seed: 7,
    });
    let relief = |name: &str, shape: &Shape, side: u32| relief(name, shape, side, coarser);
    let swell = ParametricSurface::WavySheet { amplitude: 14.0, wavelength: 256.0, size: 256.0 };
    Ok(vec![
        on_sphere(relief("4: cylinders on a sphere, κ .015", &cylinders, 128)?, 32, 0.015),
        on_sphere(relief("5: cylinders on a sphere, κ .005", &cylinders, 128)?, 32, 0.005),
        on_sphere(relief("6: reptile skin on a sphere, κ .015", &skin, 256)?, 16, 0.015),
        on_patch(relief("7: reptile skin on a Bézier patch", &skin, 256)?, WIDE, bezier()),
        on_patch(relief("8: wind ripples on a Bézier patch", &ripples, 256)?, NARROW, bezier()),
        on_patch(relief("9: rippled dunes on a Bézier patch", &dunes, 256)?, WIDE, bezier()),
        on_patch(relief("wind ripples on a swell", &ripples, 256)?, NARROW, swell),
    ])
}

/// A texel per length unit, or one of so many.
fn relief(name: &str, shape: &Shape, side: u32, coarser: u32) -> Result<Scene, StudyError> {
    let grid = Grid {
        width: side / coarser,
        height: side / coarser,
        spacing: Spacing::square(f64::from(coarser))?,
        unit: LengthUnit::SceneUnit,
        edge: Edge::Wrap,
    };
    scenes::on_the_base(Scene { name: name.to_owned(), field: shape.rasterize(grid)? })
}

/// Between 45° south and north, all round.
fn on_sphere(relief: Scene, directions: u32, curvature: f64) -> Figure {
    let grid = relief.field.grid();
    let tile = DVec2::new(grid.extent_u(), grid.extent_v());
    let sphere = Sphere { radius: 1.0 / curvature, hollow: false, chart: SphereChart::Geographic, tile };
    let corner = DVec2::new(std::f64::consts::PI, std::f64::consts::FRAC_PI_4) / (curvature * tile);
    Figure {
        relief,
        directions,
        radius: WIDE,
        base: Box::new(sphere),
        part: (-corner, corner),
        range: CurvatureRange { min: 0.0, max: curvature },
        forms: None,
    }
}

/// All of a patch but a rim, from whose bumps shadows fall over the edge.
fn on_patch(relief: Scene, radius: f64, surface: ParametricSurface) -> Figure {
    let point = move |uv: DVec2| {
        let jet = surface.jet(uv.x, uv.y);
        let frame = TangentFrame { along_u: jet.du, along_v: jet.dv, normal: jet.normal() };
        SurfacePoint { position: jet.position, frame }
    };
    let forms = move |uv: DVec2| {
        let forms = surface.jet(uv.x, uv.y).forms();
        FundamentalForms { first: forms.first, second: forms.second }
    };
    Figure {
        relief,
        directions: PATCH_DIRECTIONS,
        radius,
        base: Box::new(Patch::new(point, (DVec2::ZERO, DVec2::ONE), (false, false), 2 * CELLS)),
        part: (DVec2::splat(0.05), DVec2::splat(0.95)),
        range: range(&surface),
        forms: Some(TriangleForms::new(CELLS, forms)),
    }
}

/// Between the smallest and the largest curvature of a surface.
fn range(surface: &ParametricSurface) -> CurvatureRange {
    let mut range = CurvatureRange { min: 0.0, max: 0.0 };
    for i in 0..=STEPS {
        for j in 0..=STEPS {
            let [largest, smallest] =
                surface.jet(f64::from(i) / f64::from(STEPS), f64::from(j) / f64::from(STEPS)).curvature().principal;
            range = CurvatureRange { min: range.min.min(smallest), max: range.max.max(largest) };
        }
    }
    range
}

/// A patch about 256 units wide.
fn bezier() -> ParametricSurface {
    let rise = [[0.0, 22.0, 18.0, 4.0], [26.0, 74.0, 66.0, 20.0], [14.0, 70.0, 78.0, 30.0], [6.0, 18.0, 30.0, 8.0]];
    let control = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let (x, y) = (i as f64 - 1.5, j as f64 - 1.5);
            DVec3::new(76.0 * x + 6.0 * y, 74.0 * y - 4.0 * x, rise[i][j])
        })
    });
    ParametricSurface::BezierPatch { control }
}
