//! Numbers of a shader for many inputs at once: points with attributes, one a pixel, or triangles with interpolated ones.

use barchan_view::GpuError;
use barchan_wgpu::{Sampling, Shader, ShaderOptions, Technique};

use crate::support::{Loaded, gpu};

/// Pixels across a picture of points.
const WIDTH: u32 = 256;

/// What a body of WGSL makes of each input: four numbers. It sees `a`, `b` and `c`, the three vectors of an input, and returns a
/// `vec4<f32>`.
pub(crate) fn evaluate(loaded: &Loaded, body: &str, inputs: &[[[f32; 4]; 3]]) -> Vec<[f32; 4]> {
    let height = (inputs.len() as u32).div_ceil(WIDTH);
    let stages = format!(
        "
struct Evaluated {{
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) a: vec4<f32>,
    @location(1) @interpolate(flat) b: vec4<f32>,
    @location(2) @interpolate(flat) c: vec4<f32>,
}}

@vertex
fn vertices(
    @builtin(vertex_index) index: u32,
    @location(0) a: vec4<f32>,
    @location(1) b: vec4<f32>,
    @location(2) c: vec4<f32>,
) -> Evaluated {{
    let pixel = vec2<f32>(f32(index % {WIDTH}u), f32(index / {WIDTH}u));
    let share = (pixel + 0.5) / vec2<f32>({WIDTH}.0, {height}.0);
    return Evaluated(vec4<f32>(share.x * 2.0 - 1.0, 1.0 - share.y * 2.0, 0.0, 1.0), a, b, c);
}}

@fragment
fn fragments(in: Evaluated) -> @location(0) vec4<f32> {{
    let a = in.a;
    let b = in.b;
    let c = in.c;
    {body}
}}
"
    );
    let bytes: Vec<u8> = inputs.as_flattened().as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect();
    let buffer = vertex_buffer(&bytes);
    let format = wgpu::VertexFormat::Float32x4;
    let attributes = [0, 1, 2].map(|k| wgpu::VertexAttribute { format, offset: 16 * u64::from(k), shader_location: k });
    let layout =
        wgpu::VertexBufferLayout { array_stride: 48, step_mode: wgpu::VertexStepMode::Vertex, attributes: &attributes };
    let drawing = Drawing {
        stages: &stages,
        topology: wgpu::PrimitiveTopology::PointList,
        buffers: &[(layout, &buffer)],
        vertices: inputs.len() as u32,
        indices: None,
        size: (WIDTH, height),
    };
    let mut found = drawing.draw(loaded, &[Technique::CurvedShadow]).unwrap();
    found.truncate(inputs.len());
    found
}

/// A vertex or index buffer of these bytes.
pub(crate) fn vertex_buffer(bytes: &[u8]) -> wgpu::Buffer {
    let buffer = gpu().device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: bytes.len() as u64,
        usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::INDEX | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu().queue.write_buffer(&buffer, 0, bytes);
    buffer
}

/// What is drawn, by the entry points `vertices` and `fragments`.
pub(crate) struct Drawing<'a> {
    /// WGSL that stands on the parts of the techniques.
    pub(crate) stages: &'a str,
    pub(crate) topology: wgpu::PrimitiveTopology,
    pub(crate) buffers: &'a [(wgpu::VertexBufferLayout<'a>, &'a wgpu::Buffer)],
    /// How many vertices, or indices.
    pub(crate) vertices: u32,
    pub(crate) indices: Option<&'a wgpu::Buffer>,
    pub(crate) size: (u32, u32),
}

impl Drawing<'_> {
    /// Four numbers a pixel, row by row from the top; 0 where nothing was drawn.
    pub(crate) fn draw(&self, loaded: &Loaded, techniques: &[Technique]) -> Result<Vec<[f32; 4]>, GpuError> {
        let options = ShaderOptions { group: 0, sampling: Sampling::Loaded, probes: false };
        let shader = Shader::compose(&loaded.plan, techniques, &options)?;
        let (width, height) = self.size;
        let row_bytes = (16 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
        let read_back = gpu().checked(|device| {
            let (pipeline, bind_group) = self.pipeline(device, loaded, &shader);
            let target = device.create_texture(&wgpu::TextureDescriptor {
                label: None,
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: wgpu::TextureFormat::Rgba32Float,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
                view_formats: &[],
            });
            let read_back = device.create_buffer(&wgpu::BufferDescriptor {
                label: None,
                size: u64::from(row_bytes * height),
                usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
                mapped_at_creation: false,
            });
            let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            self.encode(&mut encoder, &target, &pipeline, &bind_group);
            let layout =
                wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row_bytes), rows_per_image: Some(height) };
            let to = wgpu::TexelCopyBufferInfo { buffer: &read_back, layout };
            encoder.copy_texture_to_buffer(target.as_image_copy(), to, target.size());
            gpu().queue.submit([encoder.finish()]);
            read_back
        })?;
        read_back.slice(..).map_async(wgpu::MapMode::Read, |mapped| mapped.unwrap());
        gpu().finish()?;
        let bytes = read_back.slice(..).get_mapped_range().unwrap().to_vec();
        let rows = bytes.chunks_exact(row_bytes as usize).map(|row| &row[..16 * width as usize]);
        let number = |bytes: &[u8]| f32::from_le_bytes(bytes.try_into().unwrap());
        Ok(rows
            .flat_map(|row| row.chunks_exact(16).map(|pixel| [0, 4, 8, 12].map(|k| number(&pixel[k..k + 4]))))
            .collect())
    }

    fn pipeline(
        &self,
        device: &wgpu::Device,
        loaded: &Loaded,
        shader: &Shader,
    ) -> (wgpu::RenderPipeline, wgpu::BindGroup) {
        let source = format!("{}\n{}", shader.source(), self.stages);
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(source.into()),
        });
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: None,
            entries: &shader.layout_entries(wgpu::ShaderStages::VERTEX_FRAGMENT),
        });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let buffers: Vec<_> = self.buffers.iter().map(|(layout, _)| Some(layout.clone())).collect();
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: Some(&pipeline_layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vertices"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &buffers,
            },
            primitive: wgpu::PrimitiveState { topology: self.topology, ..Default::default() },
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fragments"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(wgpu::TextureFormat::Rgba32Float.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let entries = loaded.asset.entries(shader, None);
        let group = wgpu::BindGroupDescriptor { label: None, layout: &layout, entries: &entries };
        (pipeline, device.create_bind_group(&group))
    }

    fn encode(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        target: &wgpu::Texture,
        pipeline: &wgpu::RenderPipeline,
        bind_group: &wgpu::BindGroup,
    ) {
        let view = target.create_view(&wgpu::TextureViewDescriptor::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                    store: wgpu::StoreOp::Store,
                },
            })],
            ..Default::default()
        });
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, bind_group, &[]);
        for (slot, (_, buffer)) in (0..).zip(self.buffers) {
            pass.set_vertex_buffer(slot, buffer.slice(..));
        }
        match self.indices {
            Some(indices) => {
                pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
                pass.draw_indexed(0..self.vertices, 0, 0..1);
            }
            None => pass.draw(0..self.vertices, 0..1),
        }
    }
}
