//! Textures, vertex buffers and the uniform buffer of an asset.

use barchan_asset::{Asset, CurvatureColumn, Format, SectionKind, Semantic, Wrap};

use super::UploadError;
use crate::{BindingKind, PARAMETER_BYTES, Reader, Shader, Shape, TexturePlan, UploadPlan};

/// What of an asset is on a device.
#[derive(Debug)]
pub struct GpuAsset {
    parameters: wgpu::Buffer,
    sampler: wgpu::Sampler,
    textures: Vec<(Semantic, wgpu::TextureView)>,
    columns: Vec<(CurvatureColumn, wgpu::Buffer)>,
}

impl GpuAsset {
    /// Carries out a plan. Payloads go from the file's bytes to the device without a copy of ours.
    ///
    /// # Errors
    /// A plan of another file, a compressed section that does not decode, or a device that refuses or is lost.
    pub async fn upload(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        reader: &Reader<'_>,
        plan: &UploadPlan,
    ) -> Result<Self, UploadError> {
        let asset = reader.asset();
        let textures = plan.textures().iter().map(|texture| {
            let payload = payload(&asset, texture.table.kind())?;
            Ok((texture.table, upload_texture(device, queue, texture, payload)))
        });
        let textures = textures.collect::<Result<Vec<_>, UploadError>>()?;
        let parameters = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("barchan parameters"),
            size: PARAMETER_BYTES as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        queue.write_buffer(&parameters, 0, &plan.parameters());
        let mut columns = Vec::new();
        if let Some(curvature) = plan.curvature() {
            let payload = payload(&asset, SectionKind::CURVATURE)?;
            for column in &curvature.columns {
                let buffer = device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some(column.column.name()),
                    size: column.bytes,
                    usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                });
                queue.write_buffer(&buffer, 0, &payload[column.offset as usize..][..column.bytes as usize]);
                columns.push((column.column, buffer));
            }
        }
        Ok(Self { parameters, sampler: sampler(device, plan), textures, columns })
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

    /// What a shader binds, as entries of a bind group; `probe` is the buffer of probes, for a shader that has them.
    #[must_use]
    pub fn entries<'a>(&'a self, shader: &Shader, probe: Option<&'a wgpu::Buffer>) -> Vec<wgpu::BindGroupEntry<'a>> {
        let entry = |binding: &crate::Binding| {
            let resource = match binding.kind {
                BindingKind::Parameters => self.parameters.as_entire_binding(),
                BindingKind::Sampler => wgpu::BindingResource::Sampler(&self.sampler),
                BindingKind::Texture { table, .. } => wgpu::BindingResource::TextureView(self.texture(table)?),
                BindingKind::Probe => probe?.as_entire_binding(),
            };
            Some(wgpu::BindGroupEntry { binding: binding.binding, resource })
        };
        shader.bindings().iter().filter_map(entry).collect()
    }
}

impl Shader {
    /// What it binds, as entries of a bind group layout, seen by these stages.
    #[must_use]
    pub fn layout_entries(&self, visibility: wgpu::ShaderStages) -> Vec<wgpu::BindGroupLayoutEntry> {
        let entry = |binding: &crate::Binding| {
            let uniform = |bytes: usize| wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: wgpu::BufferSize::new(bytes as u64),
            };
            let ty = match binding.kind {
                BindingKind::Parameters => uniform(PARAMETER_BYTES),
                BindingKind::Probe => uniform(Self::PROBE_BYTES),
                BindingKind::Sampler => wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
                BindingKind::Texture { shape, is_filtered, .. } => wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: is_filtered },
                    view_dimension: view_dimension(shape),
                    multisampled: false,
                },
            };
            wgpu::BindGroupLayoutEntry { binding: binding.binding, visibility, ty, count: None }
        };
        self.bindings().iter().map(entry).collect()
    }
}

/// The payload of a section.
fn payload<'a>(asset: &Asset<'a>, kind: SectionKind) -> Result<&'a [u8], UploadError> {
    asset.section(kind).and_then(|section| section.raw_payload()).ok_or(UploadError::OtherFile { kind })
}

fn upload_texture(device: &wgpu::Device, queue: &wgpu::Queue, plan: &TexturePlan, payload: &[u8]) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: plan.table.kind().name(),
        size: wgpu::Extent3d { width: plan.extent.0, height: plan.extent.1, depth_or_array_layers: plan.layers },
        mip_level_count: plan.levels,
        sample_count: 1,
        dimension: if plan.shape == Shape::D3 { wgpu::TextureDimension::D3 } else { wgpu::TextureDimension::D2 },
        format: texture_format(plan.format),
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    for copy in &plan.copies {
        let to = wgpu::TexelCopyTextureInfo {
            texture: &texture,
            mip_level: copy.level,
            origin: wgpu::Origin3d { x: 0, y: 0, z: copy.first_layer },
            aspect: wgpu::TextureAspect::All,
        };
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(copy.bytes_per_row),
            rows_per_image: Some(copy.extent.1),
        };
        let extent = wgpu::Extent3d { width: copy.extent.0, height: copy.extent.1, depth_or_array_layers: copy.layers };
        queue.write_texture(to, &payload[copy.offset as usize..][..copy.bytes as usize], layout, extent);
    }
    let dimension = Some(view_dimension(plan.shape));
    texture.create_view(&wgpu::TextureViewDescriptor { dimension, ..Default::default() })
}

/// Tables of one asset have the same edges.
fn sampler(device: &wgpu::Device, plan: &UploadPlan) -> wgpu::Sampler {
    let mode = |wrap| if wrap == Wrap::Repeat { wgpu::AddressMode::Repeat } else { wgpu::AddressMode::ClampToEdge };
    let edges = plan
        .textures()
        .first()
        .map_or((Wrap::Clamp, Wrap::Clamp), |texture| (texture.descriptor.wrap_u, texture.descriptor.wrap_v));
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("barchan"),
        address_mode_u: mode(edges.0),
        address_mode_v: mode(edges.1),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    })
}

fn view_dimension(shape: Shape) -> wgpu::TextureViewDimension {
    match shape {
        Shape::D2 => wgpu::TextureViewDimension::D2,
        Shape::D2Array => wgpu::TextureViewDimension::D2Array,
        Shape::D3 => wgpu::TextureViewDimension::D3,
    }
}

fn texture_format(format: Format) -> wgpu::TextureFormat {
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
