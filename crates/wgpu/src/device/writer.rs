//! Bytes on their way to a device.

use crate::TextureCopy;

/// What is handed over at once, unless a layer is more.
const PIECE_BYTES: usize = 4 << 20;

/// Writes piece by piece. `wgpu` keeps what is written in memory of its own until the device has read it: of a whole table that would
/// be as much again, fresh from the system; of pieces it is the same memory again and again.
pub(super) struct Writer<'a> {
    queue: &'a wgpu::Queue,
    /// Bytes that have been written and not handed over.
    pending: usize,
}

impl<'a> Writer<'a> {
    pub(super) fn new(queue: &'a wgpu::Queue) -> Self {
        Self { queue, pending: 0 }
    }

    /// Writes a copy's bytes to a texture.
    pub(super) fn texture(&mut self, texture: &wgpu::Texture, copy: &TextureCopy, bytes: &[u8]) {
        let (width, height) = copy.extent;
        let layer_bytes = copy.bytes_per_row as usize * height as usize;
        let at_once = (PIECE_BYTES / layer_bytes).max(1);
        for (layer, bytes) in (copy.first_layer..).step_by(at_once).zip(bytes.chunks(at_once * layer_bytes)) {
            let origin = wgpu::Origin3d { x: 0, y: 0, z: layer };
            let aspect = wgpu::TextureAspect::All;
            let to = wgpu::TexelCopyTextureInfo { texture, mip_level: copy.level, origin, aspect };
            let (bytes_per_row, rows_per_image) = (Some(copy.bytes_per_row), Some(height));
            let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row, rows_per_image };
            let depth_or_array_layers = (bytes.len() / layer_bytes) as u32;
            self.queue.write_texture(to, bytes, layout, wgpu::Extent3d { width, height, depth_or_array_layers });
            self.written(bytes.len());
        }
    }

    /// Writes all of a buffer.
    pub(super) fn buffer(&mut self, buffer: &wgpu::Buffer, bytes: &[u8]) {
        self.queue.write_buffer(buffer, 0, bytes);
        self.written(bytes.len());
    }

    /// Hands over what is left.
    pub(super) fn finish(self) {
        self.queue.submit([]);
    }

    fn written(&mut self, bytes: usize) {
        self.pending += bytes;
        if self.pending >= PIECE_BYTES {
            self.queue.submit([]);
            self.pending = 0;
        }
    }
}
