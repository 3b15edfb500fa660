//! What the reader adds to a program that has `wgpu`: it opens a file, plans its upload, carries it out, puts a shader together and
//! draws a picture. `cargo xtask bench --only gpu_size` weighs it against `size_without`.

use barchan_wgpu::{DeviceLimits, GpuAsset, Reader, Sampling, Selection, Shader, ShaderOptions, Technique, UploadPlan};

mod size;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("the file is missing")?;
    let bytes = std::fs::read(path)?;
    let (device, queue) = size::open()?;
    let reader = Reader::open(&bytes)?;
    reader.check_bytes()?;
    let plan = UploadPlan::new(&reader, &Selection::everything(), &DeviceLimits::of(&device))?;
    let asset = pollster::block_on(GpuAsset::upload(&device, &queue, &reader, &plan))?;
    let technique = Technique::HorizonShadow;
    let options = ShaderOptions { group: 0, sampling: Sampling::Filtered, probes: true };
    let shader = Shader::compose(&plan, &[technique], &options)?;
    let probe = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: Shader::PROBE_BYTES as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    queue.write_buffer(&probe, 0, &[0; Shader::PROBE_BYTES]);
    let layout = shader.layout_entries(wgpu::ShaderStages::VERTEX_FRAGMENT);
    let entry_points = ["barchan_probe_vertex", technique.probe()];
    let entries = asset.entries(&shader, Some(&probe));
    std::hint::black_box(size::draw((&device, &queue), (shader.source(), entry_points), &layout, &entries)?);
    Ok(())
}
