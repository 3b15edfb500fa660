//! How things are called on the page.

use barchan_wgpu::Shape;

/// A texture, as WGSL calls it.
pub(crate) fn shape(shape: Shape) -> &'static str {
    match shape {
        Shape::D2 => "texture_2d<f32>",
        Shape::D2Array => "texture_2d_array<f32>",
        Shape::D3 => "texture_3d<f32>",
    }
}
