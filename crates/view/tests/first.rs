//! First light.
use barchan_asset::{Asset, HeightView, HorizonView, SectionKind, Semantic};
use barchan_shade::{DirectionalLight, HorizonShadow};
use barchan_view::{Gpu, Probe, ProbePass};
use barchan_wgpu::{DeviceLimits, GpuAsset, Reader, Sampling, Selection, Technique, UploadPlan};

#[test]
fn horizons_agree_with_the_cpu() {
    let path = std::env::var("BARCHAN_FILE").unwrap();
    let bytes = std::fs::read(path).unwrap();
    let gpu = Gpu::open().unwrap();
    let reader = Reader::open(&bytes).unwrap();
    let plan = UploadPlan::new(&reader, &Selection::everything(), &DeviceLimits::of(&gpu.device)).unwrap();
    let asset = pollster::block_on(GpuAsset::upload(&gpu.device, &gpu.queue, &reader, &plan)).unwrap();
    let file = Asset::open(&bytes).unwrap();
    let section = file.section(SectionKind::HORIZON).unwrap();
    let horizon = HorizonView::new(section.texture().unwrap(), section.raw_payload().unwrap()).unwrap();
    for sampling in [Sampling::Loaded, Sampling::Filtered] {
        let pass = ProbePass::new(&gpu, &asset, &plan, &[Technique::HorizonShadow], sampling).unwrap();
        for (azimuth, elevation) in [(0.0, 10.0), (33.0, 5.0), (350.0, 20.0), (359.99, 0.0)] {
            let light = DirectionalLight::from_degrees(azimuth, elevation);
            let shadow = HorizonShadow::new(&horizon, &light);
            let probe = Probe {
                size: (300, 300),
                place: [-20.0, -13.0],
                step: [2.37, 1.91],
                light: light.towards.as_vec3().to_array(),
                ..Probe::default()
            };
            let t = std::time::Instant::now();
            let found = pass.draw(&probe).unwrap();
            let t = t.elapsed();
            let (mut worst, mut wrong) = (0.0_f64, 0);
            for (i, p) in found.iter().enumerate() {
                let (x, y) =
                    (f64::from(-20.0 + 2.37_f32 * (i % 300) as f32), f64::from(-13.0 + 1.91_f32 * (i / 300) as f32));
                worst = worst.max((f64::from(p[0]) - shadow.elevation_radians(x, y)).abs());
                wrong += usize::from((p[1] > 0.5) != shadow.in_shadow(x, y));
            }
            println!(
                "{sampling:?} {azimuth} {elevation}: worst {worst:e} rad, wrong {wrong} of {}, {t:?}",
                found.len()
            );
        }
    }
    let _ = (Semantic::Height, HeightView::new);
}
