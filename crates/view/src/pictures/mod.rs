//! Pictures of an asset, as the CPU twin draws them: `barchan_shade`'s `Picture::lit`, `Picture::overcast` and `ReliefPixels::picture`.
//!
//! What a picture is of, its camera, its light and its colours, is plain numbers that whoever asks computes, so that both twins start
//! from the same. A shader is composed of the asset's techniques and of parts of its own (`wgsl/`), bound in a second group: pixel to
//! ray, ray to base surface, and colours to bytes by the same equations and constants. It writes two targets: colours, and numbers
//! about the pixels, for reports.
//!
//! A picture is drawn in tiles, so that its size is not bound by the device's targets, nor one draw long enough to be taken for a hang.

mod pass;
mod scene;

pub use scene::{PictureBase, PictureLight, ReliefView, SkyDirection, TopView};

use barchan_wgpu::{GpuAsset, Sampling, Shader, ShaderOptions, Technique, UploadPlan};

use crate::{Gpu, GpuError};
use pass::PicturePass;

/// An asset on a device, to be drawn.
#[derive(Debug, Clone, Copy)]
pub struct Canvas<'a> {
    /// The device.
    pub gpu: &'a Gpu,
    /// The asset.
    pub asset: &'a GpuAsset,
    /// What of it is there.
    pub plan: &'a UploadPlan,
    /// How it is interpolated.
    pub sampling: Sampling,
}

/// A picture, and what is known of its pixels; both row by row from the top.
#[derive(Debug, Clone, PartialEq)]
pub struct GpuPicture {
    /// Pixels across and down.
    pub size: (u32, u32),
    /// Three bytes of sRGB a pixel.
    pub rgb: Vec<u8>,
    /// What is seen, and nothing for the background.
    pub pixels: Vec<Option<GpuPixel>>,
}

/// What a shader says of a pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GpuPixel {
    /// What the search for it fetched: of heights, and of tables; 65535 stands for all more.
    pub fetches: (u16, u16),
    /// Whether the sun does not reach it.
    pub in_shadow: bool,
    /// Under an overcast sky the visible share of it, for relief the share that is cut off; to 16 bits.
    pub share: f32,
}

impl Canvas<'_> {
    /// From straight above, lit by the sun where the horizon lets it through; it needs heights and horizon.
    ///
    /// # Errors
    /// Tables that are not loaded, or a device that refuses or is lost.
    pub fn sunlit(&self, view: &TopView, light: &PictureLight) -> Result<GpuPicture, GpuError> {
        let parts = [include_str!("wgsl/top.wgsl"), include_str!("wgsl/top_sun.wgsl")];
        self.top(&[Technique::Surface, Technique::HorizonShadow], &parts, view, light)
    }

    /// From straight above, under an overcast sky; it needs heights and the sky's visibility, and uses bent normals.
    ///
    /// # Errors
    /// Tables that are not loaded, or a device that refuses or is lost.
    pub fn overcast(&self, view: &TopView, light: &PictureLight) -> Result<GpuPicture, GpuError> {
        let parts = [include_str!("wgsl/top.wgsl"), include_str!("wgsl/top_sky.wgsl")];
        self.top(&[Technique::Sky], &parts, view, light)
    }

    /// Relief from a side; it needs heights, and the table of its search.
    ///
    /// # Errors
    /// Tables that are not loaded, or a device that refuses or is lost.
    pub fn relief(&self, view: &ReliefView, light: &PictureLight) -> Result<GpuPicture, GpuError> {
        let base = match view.base {
            PictureBase::Plane => include_str!("wgsl/base_plane.wgsl"),
            PictureBase::Sphere { .. } => include_str!("wgsl/base_sphere.wgsl"),
        };
        let directions = format!("const PICTURE_DIRECTIONS: u32 = {}u;\n", view.sky.len());
        let sky = match view.sky.is_empty() {
            true => include_str!("wgsl/sky_open.wgsl"),
            false => include_str!("wgsl/sky_rays.wgsl"),
        };
        let techniques = [Technique::Surface, Technique::Relief(view.search), Technique::ReliefShadow];
        let shader = self.compose(&techniques)?;
        let parts = [include_str!("wgsl/relief.wgsl"), base, &directions, sky];
        let mut uniforms = vec![view.bytes()];
        if !view.sky.is_empty() {
            uniforms.push(view.sky_bytes());
        }
        PicturePass::new(self, &shader, &parts, &uniforms)?.draw(view.size, light)
    }

    fn top(
        &self,
        techniques: &[Technique],
        parts: &[&str],
        view: &TopView,
        light: &PictureLight,
    ) -> Result<GpuPicture, GpuError> {
        PicturePass::new(self, &self.compose(techniques)?, parts, &[view.bytes()])?.draw(view.size, light)
    }

    fn compose(&self, techniques: &[Technique]) -> Result<Shader, GpuError> {
        let options = ShaderOptions { group: 0, sampling: self.sampling, probes: false };
        Ok(Shader::compose(self.plan, techniques, &options)?)
    }
}
