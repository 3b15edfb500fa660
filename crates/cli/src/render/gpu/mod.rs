//! `barchan render --gpu`: the same pictures by the device, and beside those of the CPU.

mod report;
mod scene;

pub(super) use scene::{ReliefScene, Scene};

use barchan_asset::Semantic;
use barchan_metrics::false_colour;
use barchan_pipeline::Table;
use barchan_shade::Picture;
use barchan_view::{Canvas, Gpu, GpuError, GpuPicture};
use barchan_wgpu::{DeviceLimits, GpuAsset, Reader, Sampling, Selection, UploadPlan};

use super::GAP_PIXELS;
use crate::args::RenderArguments;
use crate::asset_file::AssetFile;
use crate::console;
use crate::failure::{ExitStatus, Failure};
use crate::output;
use crate::png;
use report::{Comparison, Report};

/// Differences from here on, of 255, have the last colour.
const DIFFERENCE_SCALE_END: u8 = 4;

/// Draws a scene by the GPU; with `--compare` beside it what `by_cpu` draws, and how the two differ.
pub(super) fn run(
    file: &AssetFile,
    arguments: &RenderArguments,
    scene: &Scene<'_>,
    by_cpu: impl FnOnce() -> Picture,
    json: bool,
) -> Result<ExitStatus, Failure> {
    let of_gpu = |error| failure(file, &error);
    let gpu = Gpu::open().map_err(of_gpu)?;
    let drawn = draw(&gpu, file, scene).map_err(of_gpu)?;
    let mut report = Report::new(arguments, scene, &gpu.info.name, &drawn);
    let (width, height) = drawn.size;
    let mut picture = Picture { width, height, rgb: drawn.rgb };
    if arguments.compare {
        let by_cpu = by_cpu();
        let differences = differences(&by_cpu, &picture);
        report.comparison = Some(Comparison::new(&differences, DIFFERENCE_SCALE_END));
        let colour = |&difference: &u8| false_colour(f64::from(difference) / f64::from(DIFFERENCE_SCALE_END));
        let difference = Picture { width, height, rgb: differences.iter().flat_map(colour).collect() };
        picture = Picture::side_by_side(&[by_cpu, picture, difference], GAP_PIXELS);
    }
    (report.width, report.height) = (picture.width, picture.height);
    output::write_whole(&arguments.output, &png::encode(&picture)?)?;
    console::present(&report, json, Report::describe)?;
    Ok(ExitStatus::Success)
}

/// Uploads the tables that the scene needs, and no more. Texels are interpolated as the CPU twin does it.
fn draw(gpu: &Gpu, file: &AssetFile, scene: &Scene<'_>) -> Result<GpuPicture, GpuError> {
    let tables: Vec<Semantic> =
        scene.tables().into_iter().filter_map(|table: Table| Semantic::of_kind(table.kind())).collect();
    let reader = Reader::open(&file.bytes)?;
    let plan = UploadPlan::new(&reader, &Selection::tables(&tables), &DeviceLimits::of(&gpu.device))?;
    let asset = pollster::block_on(GpuAsset::upload(&gpu.device, &gpu.queue, &reader, &plan))?;
    let canvas = Canvas { gpu, asset: &asset, plan: &plan, sampling: Sampling::Loaded };
    scene.draw(&canvas)
}

/// Who must act: whoever made the file, or whoever runs the machine. The sections' checksums hold by now.
fn failure(file: &AssetFile, error: &GpuError) -> Failure {
    match error {
        GpuError::Read(_) | GpuError::Plan(_) | GpuError::Compose(_) => file.content(error),
        _ => Failure::Io(error.to_string()),
    }
}

/// By how much each pixel differs, of 255: the most of its three colours.
fn differences(one: &Picture, other: &Picture) -> Vec<u8> {
    let pixels = one.rgb.chunks_exact(3).zip(other.rgb.chunks_exact(3));
    pixels.map(|(one, other)| one.iter().zip(other).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0)).collect()
}
