//! The CPU twin's scenes as plain numbers for the device.

use barchan_pipeline::Table;
use barchan_shade::{
    BACKGROUND, DirectionalLight, HemisphereQuadrature, Palette, Pixels, ReliefStage, SHADOW_TOLERANCE, StageBase,
};
use barchan_view::{Canvas, GpuError, GpuPicture, PictureBase, PictureLight, ReliefView, SkyDirection, TopView};
use barchan_wgpu::ReliefSearch;

use crate::args::SearchName;
use crate::render::search::{BISECTIONS, STEPS};

/// What is drawn.
pub(in crate::render) enum Scene<'a> {
    /// From above under a sun.
    Sunlit { pixels: &'a Pixels, light: &'a DirectionalLight, palette: Palette },
    /// From above under an overcast sky.
    Overcast { pixels: &'a Pixels, has_bent_normal: bool, palette: Palette },
    /// Relief from a side.
    Relief(ReliefScene<'a>),
}

/// Relief from a side.
pub(in crate::render) struct ReliefScene<'a> {
    pub(in crate::render) stage: &'a ReliefStage,
    pub(in crate::render) search: SearchName,
    /// Whether rays start where a hemisphere table says.
    pub(in crate::render) from_map: bool,
    /// Nothing under an overcast sky.
    pub(in crate::render) sun: Option<DirectionalLight>,
    /// How the sky is looked for; nothing under an open one.
    pub(in crate::render) occlusion: Option<HemisphereQuadrature>,
    pub(in crate::render) palette: Palette,
}

impl Scene<'_> {
    /// The tables that are read.
    pub(super) fn tables(&self) -> Vec<Table> {
        match self {
            Self::Sunlit { .. } => vec![Table::Height, Table::Horizon],
            Self::Overcast { has_bent_normal: true, .. } => vec![Table::SkyVisibility, Table::BentNormal],
            Self::Overcast { .. } => vec![Table::SkyVisibility],
            Self::Relief(scene) => {
                let start = scene.from_map.then_some(Table::Hemisphere);
                [Some(Table::Height), scene.search.table(), start].into_iter().flatten().collect()
            }
        }
    }

    /// Draws it.
    pub(super) fn draw(&self, canvas: &Canvas<'_>) -> Result<GpuPicture, GpuError> {
        match self {
            Self::Sunlit { pixels, light, palette } => {
                canvas.sunlit(&top_view(pixels), &picture_light(&palette.exposed_for(light), Some(light)))
            }
            Self::Overcast { pixels, palette, .. } => canvas.overcast(&top_view(pixels), &picture_light(palette, None)),
            Self::Relief(scene) => scene.draw(canvas),
        }
    }
}

impl ReliefScene<'_> {
    fn draw(&self, canvas: &Canvas<'_>) -> Result<GpuPicture, GpuError> {
        let camera = &self.stage.camera;
        let rays = camera.parallel_rays().expect("the camera of a stage is orthographic");
        let (base, tile) = match self.stage.base {
            StageBase::Plane(plane) => (PictureBase::Plane, plane.chart.diagonal()),
            StageBase::Ball(ball) => (PictureBase::Sphere { radius: ball.radius as f32 }, ball.tile),
        };
        let cells = self.occlusion.iter().flat_map(|quadrature| quadrature.cells());
        let view = ReliefView {
            size: (camera.width, camera.height),
            corner: rays.corner.as_vec3().to_array(),
            across: rays.across.as_vec3().to_array(),
            down: rays.down.as_vec3().to_array(),
            eye: rays.towards_eye.as_vec3().to_array(),
            base,
            tile: tile.as_vec2().to_array(),
            search: search(self.search),
            has_sun: self.sun.is_some(),
            tolerance: SHADOW_TOLERANCE as f32,
            sky: cells
                .map(|cell| SkyDirection {
                    towards: cell.towards.as_vec3().to_array(),
                    integral: cell.integral.as_vec3().to_array(),
                })
                .collect(),
        };
        canvas.relief(&view, &picture_light(&self.palette, self.sun.as_ref()))
    }
}

fn top_view(pixels: &Pixels) -> TopView {
    let (across, down) = pixels.texels();
    TopView { size: (pixels.width, pixels.height), texels: [across as f32, down as f32] }
}

fn picture_light(palette: &Palette, sun: Option<&DirectionalLight>) -> PictureLight {
    PictureLight {
        towards: sun.map_or([0.0, 0.0, 1.0], |sun| sun.towards.as_vec3().to_array()),
        albedo: palette.albedo.as_vec3().to_array(),
        sun: palette.sun.as_vec3().to_array(),
        sky: palette.sky.as_vec3().to_array(),
        background: BACKGROUND,
    }
}

fn search(name: SearchName) -> ReliefSearch {
    match name {
        SearchName::MaximumMip => ReliefSearch::MaximumMip,
        SearchName::ConeSteps => ReliefSearch::ConeSteps,
        SearchName::RelaxedConeSteps => ReliefSearch::RelaxedConeSteps { bisections: BISECTIONS },
        SearchName::Linear => ReliefSearch::Linear { steps: STEPS, bisections: BISECTIONS },
        SearchName::ParallaxOcclusion => ReliefSearch::ParallaxOcclusion { steps: STEPS },
    }
}
