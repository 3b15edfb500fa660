//! A column of curvature as a vertex attribute.

use barchan_asset::VertexFormat;

use crate::ColumnPlan;

impl ColumnPlan {
    /// The attribute of its buffer, at a location of a shader: a buffer has one, at offset 0, every [`VertexFormat::stride`] bytes of
    /// [`Self::format`]. A shader may take fewer numbers of it than there are, and leave out the fourth of three halves.
    #[must_use]
    pub fn attribute(&self, shader_location: u32) -> wgpu::VertexAttribute {
        let format = match self.format {
            VertexFormat::Float16x2 => wgpu::VertexFormat::Float16x2,
            VertexFormat::Float16x4 => wgpu::VertexFormat::Float16x4,
            VertexFormat::Float32x2 => wgpu::VertexFormat::Float32x2,
            VertexFormat::Float32x3 => wgpu::VertexFormat::Float32x3,
            VertexFormat::Float32x4 => wgpu::VertexFormat::Float32x4,
            VertexFormat::Uint32 => wgpu::VertexFormat::Uint32,
        };
        wgpu::VertexAttribute { format, offset: 0, shader_location }
    }
}
