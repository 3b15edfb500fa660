//! The numbers of a technique, a place a pixel.

use barchan_wgpu::{GpuAsset, Sampling, Shader, ShaderOptions, Technique, UploadPlan};

use crate::target::Target;
use crate::{Gpu, GpuError};

/// What is drawn: places on a grid under one light. `probe.wgsl` declares the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Probe {
    /// Pixels across and down.
    pub size: (u32, u32),
    /// The place of the first pixel's centre, in texels from the centre of texel (0, 0).
    pub place: [f32; 2],
    /// From a pixel to the next, in columns and rows.
    pub step: [f32; 2],
    /// A unit vector towards the light, in the frame (u, v up the picture, height).
    pub light: [f32; 3],
    /// The angular radius of its disc, in radians.
    pub angular_radius: f32,
    /// How far away the light is along the base plane, in the length unit; infinite for a sun.
    pub level_distance: f32,
    /// A unit vector towards the eye, in the frame of the table.
    pub eye: [f32; 3],
    /// By how much of its depth relief must stand before a place to shade it.
    pub tolerance: f32,
    /// E, F, G of the base.
    pub first_form: [f32; 3],
    /// e, f, g of the base.
    pub second_form: [f32; 3],
    /// Pu and Pv of the base, in axes whose third is the normal; the light of curved bases is in the same axes.
    pub along: [[f32; 3]; 2],
}

impl Default for Probe {
    /// A texel a pixel, from the first one, under the zenith, on a flat base of unit texture.
    fn default() -> Self {
        Self {
            size: (1, 1),
            place: [0.0; 2],
            step: [1.0; 2],
            light: [0.0, 0.0, 1.0],
            angular_radius: 0.0,
            level_distance: f32::INFINITY,
            eye: [0.0, 0.0, 1.0],
            tolerance: 0.0,
            first_form: [1.0, 0.0, 1.0],
            second_form: [0.0; 3],
            along: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        }
    }
}

impl Probe {
    /// The bytes of the uniform buffer.
    fn bytes(&self) -> [u8; Shader::PROBE_BYTES] {
        let with = |[x, y, z]: [f32; 3], w: f32| [x, y, z, w];
        // WGSL does not promise infinities.
        let level_distance = self.level_distance.min(f32::MAX);
        let rows = [
            [self.place[0], self.place[1], self.step[0], self.step[1]],
            with(self.light, self.angular_radius),
            with(self.eye, level_distance),
            with(self.first_form, self.tolerance),
            with(self.second_form, 0.0),
            with(self.along[0], 0.0),
            with(self.along[1], 0.0),
        ];
        let mut bytes = [0; Shader::PROBE_BYTES];
        for (word, number) in bytes.chunks_exact_mut(4).zip(rows.as_flattened()) {
            word.copy_from_slice(&number.to_le_bytes());
        }
        bytes
    }
}

/// A pipeline that draws the numbers of one technique of an asset.
#[derive(Debug)]
pub struct ProbePass<'a> {
    gpu: &'a Gpu,
    pipeline: wgpu::RenderPipeline,
    bind_group: wgpu::BindGroup,
    probe: wgpu::Buffer,
}

/// Four floats a pixel.
pub(crate) const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Float;

impl<'a> ProbePass<'a> {
    /// The pass of the first of `techniques`; the others are those it needs beside it.
    ///
    /// # Errors
    /// Techniques that the plan has no tables for, or a device that refuses the shader.
    pub fn new(
        gpu: &'a Gpu,
        asset: &GpuAsset,
        plan: &UploadPlan,
        techniques: &[Technique],
        sampling: Sampling,
    ) -> Result<Self, GpuError> {
        let shader = Shader::compose(plan, techniques, &ShaderOptions { group: 0, sampling, probes: true })?;
        let entry_point = techniques.first().map_or("", |technique| technique.probe());
        Self::of_shader(gpu, asset, &shader, "", entry_point)
    }

    /// The pass of a fragment stage in WGSL that stands behind a shader with probes, and calls what it has.
    ///
    /// # Errors
    /// A device that refuses the shader.
    pub fn of_shader(
        gpu: &'a Gpu,
        asset: &GpuAsset,
        shader: &Shader,
        more: &str,
        entry_point: &str,
    ) -> Result<Self, GpuError> {
        let source = format!("{}{more}", shader.source());
        let probe = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("probe"),
            size: Shader::PROBE_BYTES as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let (pipeline, bind_group) = gpu.checked(|device| {
            let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: None,
                entries: &shader.layout_entries(wgpu::ShaderStages::VERTEX_FRAGMENT),
            });
            let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(entry_point),
                source: wgpu::ShaderSource::Wgsl(source.into()),
            });
            let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: None,
                bind_group_layouts: &[Some(&layout)],
                immediate_size: 0,
            });
            let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some(entry_point),
                layout: Some(&pipeline_layout),
                vertex: wgpu::VertexState {
                    module: &module,
                    entry_point: Some("barchan_probe_vertex"),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    buffers: &[],
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: None,
                multisample: wgpu::MultisampleState::default(),
                fragment: Some(wgpu::FragmentState {
                    module: &module,
                    entry_point: Some(entry_point),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    targets: &[Some(FORMAT.into())],
                }),
                multiview_mask: None,
                cache: None,
            });
            let entries = asset.entries(shader, Some(&probe));
            let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: None,
                layout: &layout,
                entries: &entries,
            });
            (pipeline, bind_group)
        })?;
        Ok(Self { gpu, pipeline, bind_group, probe })
    }

    /// Draws, and reads back four numbers a pixel, row by row from the top.
    ///
    /// # Errors
    /// A device that refuses or is lost.
    pub fn draw(&self, probe: &Probe) -> Result<Vec<[f32; 4]>, GpuError> {
        self.set(probe);
        let target = self.gpu.checked(|device| {
            let target = Target::new(device, FORMAT, probe.size);
            let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            self.encode(&mut encoder, &target, None);
            target.copy(&mut encoder);
            self.gpu.queue.submit([encoder.finish()]);
            target
        })?;
        let number = |bytes: &[u8]| f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
        let pixel = |bytes: &[u8]| [0, 4, 8, 12].map(|at| number(&bytes[at..]));
        Ok(target.read(self.gpu)?.chunks_exact(16).map(pixel).collect())
    }

    /// Its device.
    pub(crate) fn gpu(&self) -> &'a Gpu {
        self.gpu
    }

    /// Sets what the next pass draws.
    pub(crate) fn set(&self, probe: &Probe) {
        self.gpu.queue.write_buffer(&self.probe, 0, &probe.bytes());
    }

    /// Draws to a target, between two timestamps where there are any.
    pub(crate) fn encode(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        target: &Target,
        timestamp_writes: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("probe"),
            color_attachments: &[Some(target.attachment())],
            timestamp_writes,
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.bind_group, &[]);
        pass.draw(0..3, 0..1);
    }
}
