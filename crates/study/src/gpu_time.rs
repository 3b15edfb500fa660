//! What a technique costs on a GPU, by the GPU's own clock.
//!
//! # What is timed
//!
//! The probe of each technique ([`barchan_view::TimedPass`]): one place of the table a pixel, four floats written. Probes draw what tests
//! compare: that of shadows also the horizon's elevation, which the shadow is decided by; that of relief shadow finds the relief
//! first. All are drawn in turn, round after round; pipelines and textures are made before.
//!
//! # Setting
//!
//! Horizons of 16 azimuths on terrain, lit from 20° above the plane; relief of many scales, looked at from 35° and 75° off the normal
//! and lit from 55° off it; starts are conservative. Both tables wrap, so that a larger picture sees the tile again.
//!
//! # Which GPU
//!
//! The one that wgpu opens. A software one runs on the processor: its times say how techniques compare in arithmetic, and nothing
//! of caches, bandwidth or filtering units of a real one. Records of other GPUs stay in the file.

use std::cell::RefCell;

use barchan_asset::Encoding;
use barchan_bakers::Exec;
use barchan_view::{Gpu, ProbePass, TimedPass};
use barchan_wgpu::{Sampling, Shader, ShaderOptions, Technique, UploadPlan};

use crate::gpu_cases::{self, Case};
use crate::gpu_device::Device;
use crate::gpu_files::{self, Horizons, OnGpu};
use crate::relief_method::Search;
use crate::relief_search::MAX_POLAR;
use crate::runner::Observer;
use crate::timer::{Contestant, Pace, Spread, race};
use crate::{Item, Record, Scale, Scene, StudyError, reliefs, scenes};

/// The study.
pub struct GpuTime<'a> {
    /// Texels of horizons, of relief and of its hemispheres, along each side.
    pub texels: [u32; 3],
    /// Pixels along each side of the picture on a software GPU, and on a real one, which is done with few of them too soon.
    pub pixels: [u32; 2],
    /// How relief is searched.
    pub searches: &'static [Search],
    /// How bakes run.
    pub exec: &'a Exec<'a>,
    /// How long all techniques are timed.
    pub pace: Pace,
}

/// A scene, what of it is on the GPU, and a technique.
struct Stand<'a> {
    scene: &'a Scene,
    loaded: OnGpu,
    case: Case,
}

/// The study at a scale.
#[must_use]
pub fn study<'a>(scale: Scale, exec: &'a Exec<'a>) -> GpuTime<'a> {
    let (texels, pixels, searches, seconds) = match scale {
        Scale::Full => ([512, 256, 64], [512, 2048], &Search::ALL[..], 120.0),
        // Software GPUs compile shaders for seconds.
        Scale::Quick => ([32, 32, 8], [32, 32], &[Search::Linear][..], 0.0),
    };
    GpuTime { texels, pixels, searches, exec, pace: Pace { seconds, max_rounds: 15 } }
}

/// The records of all techniques on the GPU of this machine.
///
/// # Errors
/// No GPU, or one that refuses; a bake that is refused.
pub fn measure(study: &GpuTime<'_>, observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let gpu = Gpu::open()?;
    let device = Device::of(&gpu);
    let terrain = scenes::on_the_base(scenes::by_name("fractal_terrain", study.texels[0])?)?;
    let relief = reliefs::by_name("fractal", study.texels[1])?;
    let mut stands = Vec::new();
    let horizons = Horizons::bake(&terrain, study.exec)?;
    for encoding in Encoding::ALL {
        stands.extend(stand(&gpu, &terrain, &horizons.file(encoding)?, gpu_cases::of_horizons(encoding))?);
    }
    let bytes = gpu_files::of_relief(&relief, (study.texels[2], MAX_POLAR), study.searches, study.exec)?;
    stands.extend(stand(&gpu, &relief, &bytes, gpu_cases::of_relief(study.searches))?);
    let side = study.pixels[usize::from(!device.is_software())];
    Ok(study.race(&gpu, &stands, side, observe)?.into_iter().map(|record| device.on(record)).collect())
}

fn stand<'a>(gpu: &Gpu, scene: &'a Scene, bytes: &[u8], cases: Vec<Case>) -> Result<Vec<Stand<'a>>, StudyError> {
    cases.into_iter().map(|case| Ok(Stand { scene, loaded: OnGpu::load(gpu, bytes, &case.tables)?, case })).collect()
}

impl GpuTime<'_> {
    /// Everyone in turn, on pictures of so many pixels along each side.
    fn race(
        &self,
        gpu: &Gpu,
        stands: &[Stand<'_>],
        side: u32,
        observe: &mut Observer<'_>,
    ) -> Result<Vec<Record>, StudyError> {
        let mut passes = Vec::new();
        for Stand { scene, loaded: OnGpu { plan, asset }, case } in stands {
            for (name, sampling) in samplings(plan, &case.techniques)? {
                passes.push((scene, case, name, ProbePass::new(gpu, asset, plan, &case.techniques, sampling)?));
            }
        }
        let looks = passes.iter().flat_map(|pass| pass.1.looks.iter().map(move |look| (pass, look)));
        let looks: Vec<_> = looks.collect();
        let laps: Vec<RefCell<Vec<Option<f64>>>> = looks.iter().map(|_| RefCell::default()).collect();
        let (mut records, mut contestants) = (Vec::new(), Vec::new());
        for (((scene, case, name, pass), (setting, probe)), laps) in looks.into_iter().zip(&laps) {
            let setting = setting.clone().with("sampling", name).with("pixels", side);
            let record = Record::new(case.name, setting, scene);
            let timed = TimedPass::new(pass, (side, side))?;
            let work = move || {
                laps.borrow_mut().push(timed.draw(probe)?);
                Ok(())
            };
            let name = format!("{} {}", record.technique, record.setting);
            contestants.push(Contestant { name, work: Box::new(work) });
            records.push(record);
        }
        let timings = race(&mut contestants, &self.pace, observe)?;
        let pixels = f64::from(side) * f64::from(side);
        let timed = records.into_iter().zip(timings).zip(&laps).map(|((record, timing), laps)| {
            // The last ones are those that the timer counts.
            let counted = laps.borrow().iter().rev().take(timing.rounds).copied().collect::<Option<Vec<f64>>>();
            let record = record.with_timing(&timing, Item::Pixel, pixels);
            record.with_gpu_time(counted.as_deref().map(Spread::of), pixels)
        });
        Ok(timed.collect())
    }
}

/// The ways to interpolate that make a difference to these techniques, and their names in records.
fn samplings(plan: &UploadPlan, techniques: &[Technique]) -> Result<Vec<(&'static str, Sampling)>, StudyError> {
    let source = |sampling| {
        Shader::compose(plan, techniques, &ShaderOptions { sampling, ..ShaderOptions::default() })
            .map(|shader| shader.source().to_owned())
    };
    if source(Sampling::Filtered)? == source(Sampling::Loaded)? {
        return Ok(vec![("loaded", Sampling::Loaded)]);
    }
    Ok(vec![("filtered", Sampling::Filtered), ("loaded", Sampling::Loaded)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_technique_is_timed_and_names_its_gpu() {
        let exec = Exec::new(1).unwrap();
        let records = measure(&study(Scale::Quick, &exec), &mut |_| ()).unwrap();
        let count = |technique| records.iter().filter(|record| record.technique == technique).count();
        // Every encoding; one point and three; a search from two starts at two angles: each at least by one way to interpolate.
        assert!(count("horizon_shadow") >= 4 && count("curved_shadow") >= 2 && count("relief") >= 4);
        for technique in ["surface", "penumbra", "sky", "aperture_cone", "relief_shadow"] {
            assert!(count(technique) >= 1, "{technique}");
        }
        for record in &records {
            let named = record.device.is_some() && record.host.is_some() && record.is_software.is_some();
            assert!(named && record.wall_ns > Some(0.0), "{record:?}");
            // What the GPU does is no more than what was waited for.
            assert!(record.gpu_ns.is_none_or(|ns| ns > 0.0) && record.gpu_ns_min <= record.wall_ns, "{record:?}");
        }
    }
}
