//! What a shader binds of an asset.

use super::words::view_dimension;
use crate::{Binding, BindingKind, GpuAsset, PARAMETER_BYTES, Shader};

impl GpuAsset {
    /// What a shader binds, as entries of a bind group; `probe` is the buffer of probes, for a shader that has them.
    #[must_use]
    pub fn entries<'a>(&'a self, shader: &Shader, probe: Option<&'a wgpu::Buffer>) -> Vec<wgpu::BindGroupEntry<'a>> {
        let entry = |binding: &Binding| {
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
        let entry = |binding: &Binding| {
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
