//! Textures that are drawn to and read back.

use crate::{Gpu, GpuError};

/// A texture that is drawn to, and the buffer it is read back by.
#[derive(Debug)]
pub(crate) struct Target {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
    read_back: wgpu::Buffer,
    row_bytes: usize,
    padded_row_bytes: u32,
}

impl Target {
    /// A target of so many pixels, 1 to the device's limit along each side, of a plain colour format.
    pub(crate) fn new(device: &wgpu::Device, format: wgpu::TextureFormat, (width, height): (u32, u32)) -> Self {
        let row_bytes = format.block_copy_size(None).unwrap_or(0) * width;
        let padded_row_bytes = row_bytes.next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("target"),
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let read_back = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("target"),
            size: u64::from(padded_row_bytes) * u64::from(height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Self { texture, view, read_back, row_bytes: row_bytes as usize, padded_row_bytes }
    }

    /// The target as something a pass draws to, cleared before.
    pub(crate) fn attachment(&self) -> wgpu::RenderPassColorAttachment<'_> {
        wgpu::RenderPassColorAttachment {
            view: &self.view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT), store: wgpu::StoreOp::Store },
        }
    }

    /// Copies what was drawn to the buffer.
    pub(crate) fn copy(&self, encoder: &mut wgpu::CommandEncoder) {
        let size = self.texture.size();
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(self.padded_row_bytes),
            rows_per_image: Some(size.height),
        };
        let to = wgpu::TexelCopyBufferInfo { buffer: &self.read_back, layout };
        encoder.copy_texture_to_buffer(self.texture.as_image_copy(), to, size);
    }

    /// Waits for what was copied: rows from the top, without padding.
    pub(crate) fn read(&self, gpu: &Gpu) -> Result<Vec<u8>, GpuError> {
        let padded = gpu.read(&self.read_back)?;
        let rows = padded.chunks_exact(self.padded_row_bytes as usize);
        Ok(rows.flat_map(|row| &row[..self.row_bytes]).copied().collect())
    }
}
