//! An upload plan carried out on a `wgpu::Device`.

mod bind;
mod error;
mod upload;
mod vertex;
mod words;
mod writer;

pub use error::UploadError;
pub use upload::GpuAsset;

use crate::DeviceLimits;

impl DeviceLimits {
    /// Those of a device.
    #[must_use]
    pub fn of(device: &wgpu::Device) -> Self {
        let limits = device.limits();
        Self {
            max_2d: limits.max_texture_dimension_2d,
            max_3d: limits.max_texture_dimension_3d,
            max_layers: limits.max_texture_array_layers,
            filters_float32: device.features().contains(wgpu::Features::FLOAT32_FILTERABLE),
            max_buffer: limits.max_buffer_size,
            guesses_cubes: device.adapter_info().backend == wgpu::Backend::Gl,
        }
    }
}
