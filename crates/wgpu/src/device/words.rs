//! Our words in those of `wgpu`.

use barchan_asset::Format;

use crate::Shape;

pub(super) fn dimension(shape: Shape) -> wgpu::TextureDimension {
    match shape {
        Shape::D2 | Shape::D2Array => wgpu::TextureDimension::D2,
        Shape::D3 => wgpu::TextureDimension::D3,
    }
}

pub(super) fn view_dimension(shape: Shape) -> wgpu::TextureViewDimension {
    match shape {
        Shape::D2 => wgpu::TextureViewDimension::D2,
        Shape::D2Array => wgpu::TextureViewDimension::D2Array,
        Shape::D3 => wgpu::TextureViewDimension::D3,
    }
}

pub(super) fn texture_format(format: Format) -> wgpu::TextureFormat {
    match format {
        Format::R8Unorm => wgpu::TextureFormat::R8Unorm,
        Format::Rg8Unorm => wgpu::TextureFormat::Rg8Unorm,
        Format::Rgba8Unorm => wgpu::TextureFormat::Rgba8Unorm,
        Format::R16Float => wgpu::TextureFormat::R16Float,
        Format::Rg16Float => wgpu::TextureFormat::Rg16Float,
        Format::Rgba16Float => wgpu::TextureFormat::Rgba16Float,
        Format::R32Float => wgpu::TextureFormat::R32Float,
        Format::Rg32Float => wgpu::TextureFormat::Rg32Float,
        Format::Rgba32Float => wgpu::TextureFormat::Rgba32Float,
    }
}
