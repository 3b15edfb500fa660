//! What a game does with a baked asset: relief on a curved surface, lit by a sun that goes round, before a camera of its own.
//!
//! `cargo run --release -p barchan-wgpu --example game -- game.barchan` opens a window; with `-o game.png` it draws one frame
//! without one, and with `-t 3` the frame after three seconds. `game.md` walks through it.

use std::sync::Arc;
use std::time::Instant;

use anyhow::{Context, Result, bail, ensure};
use barchan_asset::{CurvatureColumn, VertexFormat};
use barchan_wgpu::{
    DeviceLimits, GpuAsset, Reader, ReliefSearch, Selection, Shader, ShaderOptions, Technique, UploadPlan,
};
use glam::{Mat4, Vec3};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use winit::application::ApplicationHandler;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, EventLoop};
use winit::window::{Window, WindowId};

const SIZE: [u32; 2] = [960, 640];
const SAMPLES: u32 = 4;
const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// The mesh that the asset was baked for. Vertices are as `Vertex` in `game.wgsl`, triangles a count of 3 and as many `u16`.
const MESH: &[u8] = include_bytes!("../../../samples/game.ply");
const VERTEX_BYTES: usize = 48;

struct Game {
    device: wgpu::Device,
    queue: wgpu::Queue,
    pipeline: wgpu::RenderPipeline,
    frame: wgpu::Buffer,
    groups: [wgpu::BindGroup; 2],
    /// The mesh, and two columns of the asset.
    vertices: [wgpu::Buffer; 3],
    triangles: wgpu::Buffer,
    form_scales: [f32; 2],
}

impl Game {
    fn new(device: wgpu::Device, queue: wgpu::Queue, file: &[u8], format: wgpu::TextureFormat) -> Result<Self> {
        // What of the file is wanted, on the device.
        let reader = Reader::open(file)?;
        let forms = [CurvatureColumn::FirstForm, CurvatureColumn::SecondForm];
        let wanted = Selection::everything().with_columns(&forms);
        let plan = UploadPlan::new(&reader, &wanted, &DeviceLimits::of(&device))?;
        let asset = pollster::block_on(GpuAsset::upload(&device, &queue, &reader, &plan))?;
        // The mesh, and beside its vertices the curvature that was baked for them.
        let (mesh, corners) = read_mesh()?;
        let curvature = plan.curvature().context("the asset has no curvature: bake it with its mesh")?;
        let (baked, drawn) = (curvature.vertices as usize, mesh.len() / VERTEX_BYTES);
        ensure!(baked == drawn, "the asset was baked for a mesh of {baked} vertices, the game's has {drawn}");
        let [first, second] = forms.map(|form| curvature.column(form).zip(asset.column(form).cloned()));
        let missing = "the asset has no fundamental forms: bake it with a mesh that has texture coordinates";
        let ((first, first_buffer), (second, second_buffer)) = first.zip(second).context(missing)?;
        let buffer = |contents: &[u8], usage| {
            device.create_buffer_init(&BufferInitDescriptor { label: Some("mesh"), contents, usage })
        };
        let vertices = [buffer(mesh, wgpu::BufferUsages::VERTEX), first_buffer, second_buffer];
        let triangles = buffer(&corners, wgpu::BufferUsages::INDEX);
        let frame = buffer(&[0; 96], wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST);
        // Barchan's shader in group 1, the game's behind it in group 0.
        let techniques = [
            Technique::Relief(ReliefSearch::MaximumMip),
            Technique::CurvedShadow,
            Technique::Surface,
            Technique::Sky,
        ];
        let shader = Shader::compose(&plan, &techniques, &ShaderOptions { group: 1, ..Default::default() })?;
        let source = [shader.source(), include_str!("game.wgsl")].concat();
        let source = wgpu::ShaderSource::Wgsl(source.into());
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label: Some("game"), source });
        let frame_entry = wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let layouts = [vec![frame_entry], shader.layout_entries(wgpu::ShaderStages::VERTEX_FRAGMENT)].map(|entries| {
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries })
        });
        let bind = |layout, entries: &[wgpu::BindGroupEntry<'_>]| {
            device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries })
        };
        let frame_binding = wgpu::BindGroupEntry { binding: 0, resource: frame.as_entire_binding() };
        let groups = [bind(&layouts[0], &[frame_binding]), bind(&layouts[1], &asset.entries(&shader, None))];
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &layouts.each_ref().map(Some),
            immediate_size: 0,
        });
        let own = wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x4, 3 => Float32x2];
        let (first_form, second_form) = ([first.attribute(4)], [second.attribute(5)]);
        let buffers = [
            (VERTEX_BYTES as u64, own.as_slice()),
            (u64::from(first.format.stride()), &first_form),
            (u64::from(second.format.stride()), &second_form),
        ];
        let step_mode = wgpu::VertexStepMode::Vertex;
        let buffers = buffers
            .map(|(array_stride, attributes)| Some(wgpu::VertexBufferLayout { array_stride, step_mode, attributes }));
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("game"),
            layout: Some(&pipeline_layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("place_vertex"),
                compilation_options: Default::default(),
                buffers: &buffers,
            },
            primitive: wgpu::PrimitiveState { cull_mode: Some(wgpu::Face::Back), ..Default::default() },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Less),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: wgpu::MultisampleState { count: SAMPLES, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("shade_pixel"),
                compilation_options: Default::default(),
                targets: &[Some(format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        let form_scales = [first.scale, second.scale];
        Ok(Self { device, queue, pipeline, frame, groups, vertices, triangles, form_scales })
    }

    /// The camera goes round once a minute, the sun once in twelve seconds.
    fn draw(&self, target: &wgpu::Texture, seconds: f32) {
        let round = |turns: f32, level: f32, up: f32| {
            let (sin, cos) = (turns * std::f32::consts::TAU).sin_cos();
            Vec3::new(level * cos, level * sin, up)
        };
        let (eye, sun) = (round(seconds / 60.0 - 0.2, 400.0, 380.0), round(seconds / 12.0, 0.8, 0.6));
        let aspect = target.width() as f32 / target.height() as f32;
        let view = Mat4::look_at_rh(eye, Vec3::new(0.0, 0.0, -20.0), Vec3::Z);
        let clip_from_world = Mat4::perspective_rh(0.75, aspect, 50.0, 2000.0) * view;
        let [first, second] = self.form_scales;
        let rest = [eye.x, eye.y, eye.z, first, sun.x, sun.y, sun.z, second];
        let numbers = clip_from_world.to_cols_array().into_iter().chain(rest);
        self.queue.write_buffer(&self.frame, 0, &numbers.flat_map(f32::to_le_bytes).collect::<Vec<_>>());

        let attachment = |format| {
            let texture = self.device.create_texture(&wgpu::TextureDescriptor {
                label: None,
                size: target.size(),
                mip_level_count: 1,
                sample_count: SAMPLES,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
                view_formats: &[],
            });
            texture.create_view(&Default::default())
        };
        let (colour, depth, resolved) =
            (attachment(target.format()), attachment(DEPTH), target.create_view(&Default::default()));
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let background = wgpu::Color { r: 0.30, g: 0.38, b: 0.50, a: 1.0 };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &colour,
                depth_slice: None,
                resolve_target: Some(&resolved),
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(background), store: wgpu::StoreOp::Discard },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth,
                depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(1.0), store: wgpu::StoreOp::Discard }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        for (index, group) in (0..).zip(&self.groups) {
            pass.set_bind_group(index, group, &[]);
        }
        for (slot, buffer) in (0..).zip(&self.vertices) {
            pass.set_vertex_buffer(slot, buffer.slice(..));
        }
        pass.set_index_buffer(self.triangles.slice(..), wgpu::IndexFormat::Uint16);
        pass.draw_indexed(0..self.triangles.size() as u32 / 2, 0, 0..1);
        drop(pass);
        self.queue.submit([encoder.finish()]);
    }
}

/// The bytes of the mesh's vertices, and of its triangles' corners.
fn read_mesh() -> Result<(&'static [u8], Vec<u8>)> {
    let end = MESH.windows(11).position(|bytes| bytes == b"end_header\n").context("the mesh has no header")?;
    let header = std::str::from_utf8(&MESH[..end])?;
    let line = header.lines().find_map(|line| line.strip_prefix("element vertex ")).context("the mesh has no vertices")?;
    let vertices = VERTEX_BYTES * line.parse::<usize>()?;
    let (vertices, triangles) = MESH[end + 11..].split_at_checked(vertices).context("the mesh is cut off")?;
    Ok((vertices, triangles.chunks_exact(7).flat_map(|triangle| &triangle[1..]).copied().collect()))
}
