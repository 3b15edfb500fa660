//! The GPU's own clock.

use std::time::Instant;

use barchan_asset::{AssetWriter, Codec, Encoding, HeightTable, LengthUnit, TableGrid, Wrap};
use barchan_view::{Gpu, Probe, ProbePass, TimedPass};
use barchan_wgpu::{DeviceLimits, GpuAsset, Reader, Sampling, Selection, Technique, UploadPlan};

/// A file of a few heights.
fn file() -> Vec<u8> {
    let grid = TableGrid {
        width: 4,
        height: 4,
        spacing_u: 1.0,
        spacing_v: 1.0,
        length_unit: LengthUnit::Metre,
        wrap_u: Wrap::Repeat,
        wrap_v: Wrap::Repeat,
    };
    let values: Vec<f32> = (0..16_u8).map(f32::from).collect();
    let mut writer = AssetWriter::new();
    writer.add_table(HeightTable { grid, values: &values }.encode(Encoding::F32).unwrap(), Codec::Raw).unwrap();
    writer.finish().unwrap()
}

#[test]
fn a_pass_takes_longer_the_more_it_draws_and_no_longer_than_one_waits_for_it() {
    let gpu = Gpu::open().unwrap();
    let bytes = file();
    let reader = Reader::open(&bytes).unwrap();
    let plan = UploadPlan::new(&reader, &Selection::everything(), &DeviceLimits::of(&gpu.device)).unwrap();
    let asset = pollster::block_on(GpuAsset::upload(&gpu.device, &gpu.queue, &reader, &plan)).unwrap();
    let pass = ProbePass::new(&gpu, &asset, &plan, &[Technique::Surface], Sampling::Loaded).unwrap();
    let shortest = |side: u32| {
        let timed = TimedPass::new(&pass, (side, side)).unwrap();
        let laps = (0..5).map(|_| {
            let watch = Instant::now();
            let seconds = timed.draw(&Probe::default()).unwrap();
            // An adapter without the clock says nothing; one with it says something positive.
            assert_eq!(seconds.is_some(), gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY));
            let waited = watch.elapsed().as_secs_f64();
            seconds.inspect(|&seconds| assert!(0.0 < seconds && seconds < waited, "{seconds} s of {waited} s"))
        });
        laps.min_by(|a, b| a.partial_cmp(b).unwrap()).unwrap()
    };
    if let (Some(few), Some(many)) = (shortest(16), shortest(512)) {
        // A thousand times the pixels: what is not drawn by pixels is no match for them.
        assert!(many > 4.0 * few, "512² pixels in {many} s, 16² in {few} s");
    }
}
