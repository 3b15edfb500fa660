//! Textures, vertex buffers and the uniform buffer of an asset.
//!
//! All that is created comes first, and then all that is written: a device that cannot hold an asset says so before a byte is
//! copied. Both happen in error scopes, so that what the device refuses ends here and not in the game's own error handler.

use barchan_asset::{CurvatureColumn, SectionKind, Semantic, Wrap};

use super::UploadError;
use super::words::{dimension, texture_format, view_dimension};
use super::writer::Writer;
use crate::{ColumnPlan, PARAMETER_BYTES, Reader, TexturePlan, UploadPlan};

/// What of an asset is on a device.
#[derive(Debug)]
pub struct GpuAsset {
    pub(super) parameters: wgpu::Buffer,
    pub(super) sampler: wgpu::Sampler,
    textures: Vec<(Semantic, wgpu::TextureView)>,
    columns: Vec<(CurvatureColumn, wgpu::Buffer)>,
}

impl GpuAsset {
    /// Carries out a plan. What is stored raw goes from the file's bytes to the device, copied by nobody but the device's driver;
    /// what is compressed is decoded first, a section at a time.
    ///
    /// Neither waits for the device nor polls it: when it returns, all has been handed over, and whatever the game submits next
    /// finds it there.
    ///
    /// # Errors
    /// A plan of another file, a section that does not decode, or a device that refuses, has no memory left or is lost. In a browser
    /// a lost device answers as if it were not; there the game's own device-lost callback tells.
    pub async fn upload(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        reader: &Reader<'_>,
        plan: &UploadPlan,
    ) -> Result<Self, UploadError> {
        if reader.asset().identity() != plan.identity() {
            return Err(UploadError::OtherFile);
        }
        match Self::carry_out(device, queue, reader, plan).await {
            // What a lost device says of what it was asked next, or that it says nothing, tells nobody anything.
            Ok(_) | Err(UploadError::Device { .. }) if is_lost(device).await => Err(UploadError::Lost),
            result => result,
        }
    }

    async fn carry_out(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        reader: &Reader<'_>,
        plan: &UploadPlan,
    ) -> Result<Self, UploadError> {
        let (asset, textures) = checked(device, || Self::create(device, plan)).await?;
        checked(device, || asset.write(queue, &textures, reader, plan)).await??;
        Ok(asset)
    }

    /// All there is to be, nothing of it written.
    fn create(device: &wgpu::Device, plan: &UploadPlan) -> (Self, Vec<wgpu::Texture>) {
        let columns = plan.curvature().map_or(&[][..], |curvature| &curvature.columns);
        let textures: Vec<_> = plan.textures().iter().map(|plan| create_texture(device, plan)).collect();
        let views = textures.iter().zip(plan.textures()).map(|(texture, plan)| (plan.table, view(texture, plan)));
        let asset = Self {
            parameters: create_buffer(
                device,
                "barchan parameters",
                PARAMETER_BYTES as u64,
                wgpu::BufferUsages::UNIFORM,
            ),
            sampler: sampler(device, plan),
            textures: views.collect(),
            columns: columns.iter().map(|plan| (plan.column, create_column(device, plan))).collect(),
        };
        (asset, textures)
    }

    fn write(
        &self,
        queue: &wgpu::Queue,
        textures: &[wgpu::Texture],
        reader: &Reader<'_>,
        plan: &UploadPlan,
    ) -> Result<(), UploadError> {
        let mut writer = Writer::new(queue);
        for (texture, plan) in textures.iter().zip(plan.textures()) {
            let payload = reader.payload(plan.table.kind())?;
            for copy in &plan.copies {
                writer.texture(texture, copy, copy.of(&payload).ok_or(UploadError::OtherFile)?);
            }
        }
        if let Some(curvature) = plan.curvature() {
            let payload = reader.payload(SectionKind::CURVATURE)?;
            for ((_, buffer), column) in self.columns.iter().zip(&curvature.columns) {
                writer.buffer(buffer, column.of(&payload).ok_or(UploadError::OtherFile)?);
            }
        }
        writer.buffer(&self.parameters, &plan.parameters());
        writer.finish();
        Ok(())
    }

    /// The texture of a table, if it was uploaded.
    #[must_use]
    pub fn texture(&self, table: Semantic) -> Option<&wgpu::TextureView> {
        self.textures.iter().find(|(other, _)| *other == table).map(|(_, view)| view)
    }

    /// The vertex buffer of a column of curvature, if it was uploaded.
    #[must_use]
    pub fn column(&self, column: CurvatureColumn) -> Option<&wgpu::Buffer> {
        self.columns.iter().find(|(other, _)| *other == column).map(|(_, buffer)| buffer)
    }
}

/// Does something on a device, and tells afterwards what it refused. Scopes belong to a thread and stand in each other, so they are
/// closed before anything is awaited.
fn checked<T>(device: &wgpu::Device, work: impl FnOnce() -> T) -> impl Future<Output = Result<T, UploadError>> {
    let validation = device.push_error_scope(wgpu::ErrorFilter::Validation);
    let internal = device.push_error_scope(wgpu::ErrorFilter::Internal);
    let memory = device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
    let done = work();
    let (memory, internal, validation) = (memory.pop(), internal.pop(), validation.pop());
    async move {
        // Without memory the rest follows.
        if memory.await.is_some() {
            return Err(UploadError::OutOfMemory);
        }
        match validation.await.or(internal.await) {
            Some(error) => Err(UploadError::Device { reason: error.to_string() }),
            None => Ok(done),
        }
    }
}

/// A lost device reports nothing to error scopes, and its callback is the game's; but it cannot map what it creates.
async fn is_lost(device: &wgpu::Device) -> bool {
    let mapped = checked(device, || {
        let (usage, mapped_at_creation) = (wgpu::BufferUsages::COPY_SRC, true);
        let buffer = device.create_buffer(&wgpu::BufferDescriptor { label: None, size: 4, usage, mapped_at_creation });
        buffer.slice(..).get_mapped_range().is_ok()
    });
    mapped.await != Ok(true)
}

fn create_texture(device: &wgpu::Device, plan: &TexturePlan) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: plan.table.kind().name(),
        size: wgpu::Extent3d { width: plan.extent.0, height: plan.extent.1, depth_or_array_layers: plan.layers },
        mip_level_count: plan.levels,
        sample_count: 1,
        dimension: dimension(plan.shape),
        format: texture_format(plan.format),
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

fn create_column(device: &wgpu::Device, plan: &ColumnPlan) -> wgpu::Buffer {
    create_buffer(device, plan.column.name(), plan.bytes, wgpu::BufferUsages::VERTEX)
}

fn create_buffer(device: &wgpu::Device, label: &str, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
    let usage = usage | wgpu::BufferUsages::COPY_DST;
    device.create_buffer(&wgpu::BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false })
}

fn view(texture: &wgpu::Texture, plan: &TexturePlan) -> wgpu::TextureView {
    let dimension = Some(view_dimension(plan.shape));
    texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() })
}

fn sampler(device: &wgpu::Device, plan: &UploadPlan) -> wgpu::Sampler {
    let mode = |wrap| if wrap == Wrap::Repeat { wgpu::AddressMode::Repeat } else { wgpu::AddressMode::ClampToEdge };
    let (along_u, along_v) = plan.edges();
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("barchan"),
        address_mode_u: mode(along_u),
        address_mode_v: mode(along_v),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    })
}
