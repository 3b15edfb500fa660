//! A pipeline that draws a picture, and the tiles it draws it in.

use barchan_wgpu::Shader;

use super::{Canvas, GpuPicture, GpuPixel, PictureLight};
use crate::target::Target;
use crate::{Gpu, GpuError};

/// Pixels along the sides of a tile, at most: within what every device has, and a draw of a fraction of a second.
const TILE: u32 = 512;

const COLOURS: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
const NUMBERS: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Uint;

/// Draws one scene.
#[derive(Debug)]
pub(super) struct PicturePass<'a> {
    gpu: &'a Gpu,
    pipeline: wgpu::RenderPipeline,
    /// Of the asset, and of the scene.
    bind_groups: [wgpu::BindGroup; 2],
    light: wgpu::Buffer,
}

impl<'a> PicturePass<'a> {
    /// The composed shader with more parts behind it; their second group binds the light and then `uniforms`.
    pub(super) fn new(
        canvas: &Canvas<'a>,
        shader: &Shader,
        parts: &[&str],
        uniforms: &[Vec<u8>],
    ) -> Result<Self, GpuError> {
        let source = [&[shader.source(), include_str!("wgsl/picture.wgsl")], parts].concat().join("\n");
        canvas.gpu.checked(|device| {
            let light = uniform(device, PictureLight::BYTES);
            let buffers = uniforms.iter().map(|bytes| {
                let buffer = uniform(device, bytes.len());
                canvas.gpu.queue.write_buffer(&buffer, 0, bytes);
                buffer
            });
            let buffers: Vec<_> = std::iter::once(light.clone()).chain(buffers).collect();
            let stages = wgpu::ShaderStages::VERTEX_FRAGMENT;
            let of_asset = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("asset"),
                entries: &shader.layout_entries(stages),
            });
            let entries: Vec<_> = (0..).zip(&buffers).map(|(binding, _)| uniform_entry(binding, stages)).collect();
            let of_scene = device
                .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("scene"), entries: &entries });
            let asset = device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("asset"),
                layout: &of_asset,
                entries: &canvas.asset.entries(shader, None),
            });
            let bound = (0..).zip(&buffers);
            let entries: Vec<_> = bound
                .map(|(binding, buffer)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() })
                .collect();
            let scene = device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("scene"),
                layout: &of_scene,
                entries: &entries,
            });
            let pipeline = pipeline(device, &source, [&of_asset, &of_scene]);
            Self { gpu: canvas.gpu, pipeline, bind_groups: [asset, scene], light }
        })
    }

    /// The whole picture, tile by tile.
    pub(super) fn draw(&self, size: (u32, u32), light: &PictureLight) -> Result<GpuPicture, GpuError> {
        let pixels = size.0 as usize * size.1 as usize;
        let mut picture = GpuPicture { size, rgb: vec![0; 3 * pixels], pixels: vec![None; pixels] };
        for top in (0..size.1).step_by(TILE as usize) {
            for left in (0..size.0).step_by(TILE as usize) {
                let tile = (TILE.min(size.0 - left), TILE.min(size.1 - top));
                self.draw_tile((left, top), tile, light, &mut picture)?;
            }
        }
        Ok(picture)
    }

    fn draw_tile(
        &self,
        first: (u32, u32),
        tile: (u32, u32),
        light: &PictureLight,
        picture: &mut GpuPicture,
    ) -> Result<(), GpuError> {
        self.gpu.queue.write_buffer(&self.light, 0, &light.bytes(first));
        let targets = self.gpu.checked(|device| {
            let targets = [COLOURS, NUMBERS].map(|format| Target::new(device, format, tile));
            let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            self.encode(&mut encoder, &targets);
            for target in &targets {
                target.copy(&mut encoder);
            }
            self.gpu.queue.submit([encoder.finish()]);
            targets
        })?;
        let (colours, numbers) = (targets[0].read(self.gpu)?, targets[1].read(self.gpu)?);
        let seen = colours.chunks_exact(4).zip(numbers.chunks_exact(8)).map(|(colour, numbers)| {
            let number = |index: usize| u16::from_le_bytes([numbers[2 * index], numbers[2 * index + 1]]);
            let pixel = GpuPixel {
                fetches: (number(0), number(1)),
                in_shadow: number(2) != 0,
                share: f32::from(number(3)) / 65535.0,
            };
            ([colour[0], colour[1], colour[2]], (colour[3] != 0).then_some(pixel))
        });
        let place = |index: usize| {
            let (column, row) = (index % tile.0 as usize, index / tile.0 as usize);
            (first.1 as usize + row) * picture.size.0 as usize + first.0 as usize + column
        };
        for (place, (colour, pixel)) in (0..).map(place).zip(seen) {
            picture.rgb[3 * place..][..3].copy_from_slice(&colour);
            picture.pixels[place] = pixel;
        }
        Ok(())
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder, targets: &[Target]) {
        let attachments: Vec<_> = targets.iter().map(|target| Some(target.attachment())).collect();
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &attachments,
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        for (index, bind_group) in (0..).zip(&self.bind_groups) {
            pass.set_bind_group(index, bind_group, &[]);
        }
        pass.draw(0..3, 0..1);
    }
}

fn pipeline(device: &wgpu::Device, source: &str, layouts: [&wgpu::BindGroupLayout; 2]) -> wgpu::RenderPipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("picture"),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    });
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("picture"),
        bind_group_layouts: &layouts.map(Some),
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("picture"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("picture_vertex"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("picture_fragment"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(COLOURS.into()), Some(NUMBERS.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

fn uniform(device: &wgpu::Device, bytes: usize) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("scene"),
        size: bytes as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

fn uniform_entry(binding: u32, visibility: wgpu::ShaderStages) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}
