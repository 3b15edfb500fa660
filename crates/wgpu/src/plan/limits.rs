//! What a device can hold.

use barchan_asset::Semantic;

// Every WebGPU, WebGL 2 and Vulkan device samples 16 textures a stage, so all tables at once leave a game four of its own. Their
// number needs no limit here, as long as there are no more kinds.
const _: () = assert!(Semantic::ALL.len() <= 16);

/// The limits and features of a device that decide what becomes of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DeviceLimits {
    /// Texels along each side of a 2-D texture.
    pub max_2d: u32,
    /// Texels along each side of a 3-D texture.
    pub max_3d: u32,
    /// Layers of a 2-D texture.
    pub max_layers: u32,
    /// Whether 32-bit floats can be filtered. Where they cannot, shaders load the four texels.
    pub filters_float32: bool,
    /// Bytes of a buffer.
    pub max_buffer: u64,
    /// Whether a square texture of six layers, or a multiple of six, is taken for the sides of cubes, as `wgpu` does over OpenGL.
    /// Such tables become volumes.
    pub guesses_cubes: bool,
}

impl DeviceLimits {
    /// What every WebGPU device has.
    pub const WEBGPU: Self = Self {
        max_2d: 8192,
        max_3d: 2048,
        max_layers: 256,
        filters_float32: false,
        max_buffer: 1 << 28,
        guesses_cubes: false,
    };

    /// What every WebGL 2 and OpenGL ES 3 device has.
    pub const WEBGL2: Self = Self { max_2d: 2048, max_3d: 256, guesses_cubes: true, ..Self::WEBGPU };
}
