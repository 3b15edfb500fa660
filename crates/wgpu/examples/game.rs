//! What a game does with a baked asset: relief on a curved surface, under a sun that goes round, before a camera of its own.
//!
//! `cargo run --release -p barchan-wgpu --example game -- game.barchan` opens a window; with `-o game.png` it draws one picture and
//! needs no window, and `-t 3` is the picture after three seconds. `game.md` walks through it.

#[path = "game/output.rs"]
mod output;

use anyhow::{Context, Result, bail, ensure};
use barchan_asset::CurvatureColumn;
use barchan_wgpu::{
    DeviceLimits, GpuAsset, Reader, ReliefSearch, Selection, Shader, ShaderOptions, Technique, UploadPlan,
};
use glam::{Vec3, camera::rh};
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::*;

const SAMPLES: u32 = 4;
const DEPTH: TextureFormat = TextureFormat::Depth32Float;
/// The mesh that the asset was baked for: vertices as `Vertex` in `game.wgsl`, and of triangles a count of 3 and as many `u16`.
const MESH: &[u8] = include_bytes!("../../../samples/game.ply");
const VERTEX_BYTES: usize = 48;
const USAGE: &str = "usage: game ASSET [-o PICTURE.png] [-t SECONDS]";
const NO_FORMS: &str = "the asset has no fundamental forms; bake it with a mesh that has texture coordinates";

/// All that is drawn, on a device.
struct Game {
    device: Device,
    queue: Queue,
    pipeline: RenderPipeline,
    /// The camera and the sun.
    frame: Buffer,
    /// What `game.wgsl` binds, and what Barchan's shader does.
    groups: [BindGroup; 2],
    /// The mesh, and beside its vertices two columns of the asset.
    vertices: [Buffer; 3],
    corners: Buffer,
    form_scales: [f32; 2],
}

impl Game {
    fn new(device: Device, queue: Queue, file: &[u8], format: TextureFormat) -> Result<Self> {
        // Of the file what is drawn, to the device.
        let reader = Reader::open(file)?;
        let forms = [CurvatureColumn::FirstForm, CurvatureColumn::SecondForm];
        let wanted = Selection::everything().with_columns(&forms);
        let plan = UploadPlan::new(&reader, &wanted, &DeviceLimits::of(&device))?;
        let asset = pollster::block_on(GpuAsset::upload(&device, &queue, &reader, &plan))?;

        // The mesh, and the columns of curvature that were baked for it.
        let (mesh, corners) = read_mesh()?;
        let curvature = plan.curvature().context("the asset has no curvature; bake it with its mesh")?;
        let (baked, drawn) = (curvature.vertices as usize, mesh.len() / VERTEX_BYTES);
        ensure!(baked == drawn, "the asset is for a mesh of {baked} vertices, the game's has {drawn}");
        let column = |form| curvature.column(form).zip(asset.column(form).cloned()).context(NO_FORMS);
        let ((first, first_form), (second, second_form)) = (column(forms[0])?, column(forms[1])?);
        let label = None;
        let buffer = |contents, usage| device.create_buffer_init(&BufferInitDescriptor { label, contents, usage });
        let vertices = [buffer(mesh, BufferUsages::VERTEX), first_form, second_form];
        let corners = buffer(&corners, BufferUsages::INDEX);
        let frame = buffer(&[0; 96], BufferUsages::UNIFORM | BufferUsages::COPY_DST);

        // What Barchan's shader is to do, bound as group 1; the game's own comes behind it, and binds group 0.
        let search = Technique::Relief(ReliefSearch::MaximumMip);
        let techniques = [search, Technique::CurvedShadow, Technique::Surface, Technique::Sky];
        let shader = Shader::compose(&plan, &techniques, &ShaderOptions { group: 1, ..Default::default() })?;
        let source = ShaderSource::Wgsl([shader.source(), include_str!("game.wgsl")].concat().into());
        let module = device.create_shader_module(ShaderModuleDescriptor { label: Some("game"), source });
        let stages = ShaderStages::VERTEX_FRAGMENT;
        let uniform = BufferBindingType::Uniform;
        let ty = BindingType::Buffer { ty: uniform, has_dynamic_offset: false, min_binding_size: None };
        let own = BindGroupLayoutEntry { binding: 0, visibility: stages, ty, count: None };
        let layouts = [vec![own], shader.layout_entries(stages)]
            .map(|entries| device.create_bind_group_layout(&BindGroupLayoutDescriptor { label, entries: &entries }));
        let own = vec![BindGroupEntry { binding: 0, resource: frame.as_entire_binding() }];
        let entries = [own, asset.entries(&shader, None)];
        let groups = [0, 1].map(|group| {
            let (layout, entries) = (&layouts[group], &entries[group]);
            device.create_bind_group(&BindGroupDescriptor { label, layout, entries })
        });

        // A pipeline like any other; the columns are vertex buffers beside the mesh's own.
        let layout = device.create_pipeline_layout(&PipelineLayoutDescriptor {
            bind_group_layouts: &layouts.each_ref().map(Some),
            ..Default::default()
        });
        let attributes = vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x4, 3 => Float32x2];
        let slots = [
            (VERTEX_BYTES as u64, attributes.as_slice()),
            (first.format.stride().into(), &[first.attribute(4)]),
            (second.format.stride().into(), &[second.attribute(5)]),
        ];
        let step_mode = VertexStepMode::Vertex;
        let buffers =
            slots.map(|(array_stride, attributes)| Some(VertexBufferLayout { array_stride, step_mode, attributes }));
        let pipeline = device.create_render_pipeline(&RenderPipelineDescriptor {
            label,
            layout: Some(&layout),
            vertex: VertexState {
                module: &module,
                entry_point: Some("place_vertex"),
                compilation_options: Default::default(),
                buffers: &buffers,
            },
            primitive: PrimitiveState { cull_mode: Some(Face::Back), ..Default::default() },
            depth_stencil: Some(DepthStencilState {
                format: DEPTH,
                depth_write_enabled: Some(true),
                depth_compare: Some(CompareFunction::Less),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: MultisampleState { count: SAMPLES, ..Default::default() },
            fragment: Some(FragmentState {
                module: &module,
                entry_point: Some("shade_pixel"),
                compilation_options: Default::default(),
                targets: &[Some(format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        Ok(Self { device, queue, pipeline, frame, groups, vertices, corners, form_scales: [first.scale, second.scale] })
    }

    /// The camera goes round once a minute, the sun once in twelve seconds.
    fn draw(&self, target: &Texture, seconds: f32) {
        let round = |turns: f32, level: f32, up: f32| {
            let (sin, cos) = (turns * std::f32::consts::TAU).sin_cos();
            Vec3::new(level * cos, level * sin, up)
        };
        let (eye, sun) = (round(seconds / 60.0 - 0.2, 470.0, 420.0), round(seconds / 12.0, 0.8, 0.6));
        let aspect = target.width() as f32 / target.height() as f32;
        let view = rh::view::look_at_mat4(eye, Vec3::new(0.0, 0.0, -20.0), Vec3::Z);
        let clip_from_world = (rh::proj::directx::perspective(0.75, aspect, 50.0, 2000.0) * view).to_cols_array();
        let [first, second] = self.form_scales;
        let rest = [eye.x, eye.y, eye.z, first, sun.x, sun.y, sun.z, second];
        let bytes: Vec<u8> = clip_from_world.into_iter().chain(rest).flat_map(f32::to_le_bytes).collect();
        self.queue.write_buffer(&self.frame, 0, &bytes);

        let [colour, depth] =
            [target.format(), DEPTH].map(|format| output::attachment(&self.device, target.size(), SAMPLES, format));
        let clear = LoadOp::Clear(Color { r: 0.30, g: 0.38, b: 0.50, a: 1.0 });
        let mut encoder = self.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_render_pass(&RenderPassDescriptor {
            color_attachments: &[Some(RenderPassColorAttachment {
                view: &colour,
                depth_slice: None,
                resolve_target: Some(&target.create_view(&Default::default())),
                ops: Operations { load: clear, store: StoreOp::Discard },
            })],
            depth_stencil_attachment: Some(RenderPassDepthStencilAttachment {
                view: &depth,
                depth_ops: Some(Operations { load: LoadOp::Clear(1.0), store: StoreOp::Discard }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        (0..).zip(&self.groups).for_each(|(index, group)| pass.set_bind_group(index, group, &[]));
        (0..).zip(&self.vertices).for_each(|(slot, buffer)| pass.set_vertex_buffer(slot, buffer.slice(..)));
        pass.set_index_buffer(self.corners.slice(..), IndexFormat::Uint16);
        pass.draw_indexed(0..self.corners.size() as u32 / 2, 0, 0..1);
        drop(pass);
        self.queue.submit([encoder.finish()]);
    }
}

/// The bytes of the mesh's vertices, and those of its triangles' corners.
fn read_mesh() -> Result<(&'static [u8], Vec<u8>)> {
    let end = MESH.windows(11).position(|bytes| bytes == b"end_header\n").context("the mesh has no header")?;
    let header = std::str::from_utf8(&MESH[..end])?;
    let count = header.lines().find_map(|line| line.strip_prefix("element vertex "));
    let bytes = VERTEX_BYTES * count.context("the mesh has no vertices")?.parse::<usize>()?;
    let (vertices, triangles) = MESH[end + 11..].split_at_checked(bytes).context("the mesh is cut off")?;
    Ok((vertices, triangles.chunks_exact(7).flat_map(|triangle| &triangle[1..]).copied().collect()))
}

fn main() -> Result<()> {
    run(std::env::args().skip(1))
}

pub(crate) fn run(mut words: impl Iterator<Item = String>) -> Result<()> {
    let (mut asset, mut picture, mut seconds) = (None, None, 0.0);
    while let Some(word) = words.next() {
        match word.as_str() {
            "-o" => picture = Some(words.next().context(USAGE)?),
            "-t" => seconds = words.next().context(USAGE)?.parse().context(USAGE)?,
            _ if asset.is_none() && !word.starts_with('-') => asset = Some(word),
            _ => bail!(USAGE),
        }
    }
    let asset = asset.context(USAGE)?;
    let file = std::fs::read(&asset).with_context(|| format!("{asset} cannot be read"))?;
    match picture {
        Some(path) => output::picture(&file, [960, 640], seconds)?.save(path).context("the picture cannot be saved"),
        None => output::window(&file, [960, 640], seconds),
    }
}
