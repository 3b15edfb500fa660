//! The program that `size_with` is weighed against: it draws a picture by `wgpu`, from a texture of the bytes of one file and a shader
//! of the words of another, without the reader.

mod size;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let [texels, shader] = [1, 2].map(|argument| std::env::args().nth(argument).ok_or("two files are needed"));
    let (texels, shader) = (std::fs::read(texels?)?, std::fs::read_to_string(shader?)?);
    let (device, queue) = size::open()?;
    let scopes = [wgpu::ErrorFilter::Validation, wgpu::ErrorFilter::OutOfMemory].map(|f| device.push_error_scope(f));
    let (texture, sampler, numbers) = (texture(&device, &queue, &texels), sampler(&device), numbers(&device, &queue));
    for scope in scopes.into_iter().rev() {
        if let Some(error) = pollster::block_on(scope.pop()) {
            return Err(error.into());
        }
    }
    let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
    let types = [
        wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering),
        wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: true },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
    ];
    let visibility = wgpu::ShaderStages::VERTEX_FRAGMENT;
    let layout =
        (0..).zip(types).map(|(binding, ty)| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None });
    let resources = [
        numbers.as_entire_binding(),
        wgpu::BindingResource::Sampler(&sampler),
        wgpu::BindingResource::TextureView(&view),
    ];
    let entries = (0..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource });
    let (layout, entries) = (layout.collect::<Vec<_>>(), entries.collect::<Vec<_>>());
    std::hint::black_box(size::draw((&device, &queue), (&shader, ["vertex", "fragment"]), &layout, &entries)?);
    Ok(())
}

fn texture(device: &wgpu::Device, queue: &wgpu::Queue, texels: &[u8]) -> wgpu::Texture {
    let width = texels.len().min(8192) as u32;
    let size = wgpu::Extent3d { width, height: 1, depth_or_array_layers: 1 };
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::R8Unorm,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(width), rows_per_image: Some(1) };
    queue.write_texture(texture.as_image_copy(), &texels[..width as usize], layout, size);
    texture
}

fn sampler(device: &wgpu::Device) -> wgpu::Sampler {
    device.create_sampler(&wgpu::SamplerDescriptor { mag_filter: wgpu::FilterMode::Linear, ..Default::default() })
}

fn numbers(device: &wgpu::Device, queue: &wgpu::Queue) -> wgpu::Buffer {
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 128,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: true,
    });
    buffer.unmap();
    queue.write_buffer(&buffer, 0, &[0; 128]);
    buffer
}
