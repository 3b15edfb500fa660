//! Devices, files and probes of these tests.

use barchan_asset::{
    AssetWriter, Azimuths, Codec, Encoding, HeightTable, HorizonTable, LengthUnit, TableGrid, TextureTable, Wrap,
    vectors,
};
use barchan_view::{Gpu, Probe, ProbePass};
use barchan_wgpu::{DeviceLimits, GpuAsset, Reader, Sampling, Selection, Technique, UploadError, UploadPlan};

/// A device of this machine. There is always one to be had: the message says how.
pub(crate) fn gpu() -> Gpu {
    Gpu::open().unwrap_or_else(|error| panic!("{error}"))
}

/// The same with limits of the test's own.
pub(crate) fn small_gpu(change: impl FnOnce(&mut wgpu::Limits)) -> Gpu {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default())).unwrap();
    let mut required_limits = adapter.limits();
    change(&mut required_limits);
    let descriptor = wgpu::DeviceDescriptor { required_limits, ..Default::default() };
    let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).unwrap();
    Gpu { info: adapter.get_info(), device, queue }
}

/// A published vector.
pub(crate) fn vector(name: &str) -> Vec<u8> {
    vectors::all().unwrap().into_iter().find(|vector| vector.name == name).unwrap().bytes
}

pub(crate) fn file(tables: Vec<TextureTable>, codec: Codec) -> Vec<u8> {
    let mut writer = AssetWriter::new();
    for table in tables {
        writer.add_table(table, codec).unwrap();
    }
    writer.finish().unwrap()
}

fn square(side: u32, wrap: Wrap) -> TableGrid {
    let length_unit = LengthUnit::Metre;
    TableGrid { width: side, height: side, spacing_u: 1.0, spacing_v: 1.0, length_unit, wrap_u: wrap, wrap_v: wrap }
}

pub(crate) fn heights(values: &[f32], wrap: Wrap) -> TextureTable {
    let grid = square((values.len() as f64).sqrt() as u32, wrap);
    HeightTable { grid, values }.encode(Encoding::F32).unwrap()
}

/// Elevations that differ from azimuth to azimuth and from texel to texel.
pub(crate) fn horizon(side: u32, azimuths: u32, wrap: Wrap) -> TextureTable {
    let layer = |k: u32| (0..side * side).map(move |i| 0.02 * ((k * k) % 31) as f32 + 0.002 * (i % 7) as f32);
    let values: Vec<f32> = (0..azimuths).flat_map(layer).collect();
    let azimuths = Azimuths::full_circle(azimuths);
    HorizonTable { grid: square(side, wrap), azimuths, radius: 9.0, values: &values }.encode(Encoding::F16).unwrap()
}

/// What is drawn of a file.
pub(crate) struct Drawing<'a> {
    pub(crate) selection: Selection,
    pub(crate) limits: DeviceLimits,
    pub(crate) technique: Technique,
    pub(crate) sampling: Sampling,
    pub(crate) probe: &'a Probe,
}

impl<'a> Drawing<'a> {
    /// Of everything, on a roomy device, by four loads.
    pub(crate) fn new(technique: Technique, probe: &'a Probe) -> Self {
        let limits = DeviceLimits { max_layers: 2048, ..DeviceLimits::WEBGPU };
        Self { selection: Selection::everything(), limits, technique, sampling: Sampling::Loaded, probe }
    }

    pub(crate) fn draw(&self, gpu: &Gpu, bytes: &[u8]) -> Vec<[f32; 4]> {
        let reader = Reader::open(bytes).unwrap();
        let plan = UploadPlan::new(&reader, &self.selection, &self.limits).unwrap();
        let asset = upload(gpu, bytes, &plan).unwrap();
        self.draw_asset(gpu, &plan, &asset)
    }

    pub(crate) fn draw_asset(&self, gpu: &Gpu, plan: &UploadPlan, asset: &GpuAsset) -> Vec<[f32; 4]> {
        let pass = ProbePass::new(gpu, asset, plan, &[self.technique], self.sampling).unwrap();
        pass.draw(self.probe).unwrap()
    }
}

pub(crate) fn plan(bytes: &[u8], limits: &DeviceLimits) -> UploadPlan {
    UploadPlan::new(&Reader::open(bytes).unwrap(), &Selection::everything(), limits).unwrap()
}

pub(crate) fn upload(gpu: &Gpu, bytes: &[u8], plan: &UploadPlan) -> Result<GpuAsset, UploadError> {
    let reader = Reader::open(bytes).unwrap();
    pollster::block_on(GpuAsset::upload(&gpu.device, &gpu.queue, &reader, plan))
}

/// Four places a texel of a square table.
pub(crate) fn all_over(side: u32) -> Probe {
    Probe { size: (4 * side, 4 * side), place: [-0.4; 2], step: [0.25; 2], ..Probe::default() }
}

/// The greatest difference of the first number.
pub(crate) fn apart(found: &[[f32; 4]], expected: &[[f32; 4]]) -> f32 {
    assert_eq!(found.len(), expected.len());
    assert!(found.iter().any(|pixel| pixel[0] != found[0][0]), "a picture of one number compares nothing");
    found.iter().zip(expected).map(|(a, b)| (a[0] - b[0]).abs()).fold(0.0, f32::max)
}
