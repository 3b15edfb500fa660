//! What the reader adds to a program without `wgpu`, for an engine with a renderer of its own: it opens a file, plans its upload and
//! puts a shader together. `cargo xtask bench --only gpu_size` weighs it.

use barchan_wgpu::{DeviceLimits, Reader, Sampling, Selection, Shader, ShaderOptions, Technique, UploadPlan};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("the file is missing")?;
    let bytes = std::fs::read(path)?;
    let reader = Reader::open(&bytes)?;
    reader.check_bytes()?;
    let plan = UploadPlan::new(&reader, &Selection::everything(), &DeviceLimits::WEBGPU)?;
    let options = ShaderOptions { sampling: Sampling::Loaded, ..ShaderOptions::default() };
    let shader = Shader::compose(&plan, &[Technique::HorizonShadow], &options)?;
    std::hint::black_box((plan.parameters(), shader));
    Ok(())
}
