//! The program behind `cargo xtask bench`: measures, writes records, the tables of MEASUREMENTS.md and the charts, and checks one
//! against the other.
//!
//! ```text
//! cargo run --release -p barchan-study --example study -- measure [--quick] [--only bench,accuracy]
//! cargo run -p barchan-study --example study -- render
//! cargo run -p barchan-study --example study -- check
//! cargo run --release -p barchan-study --example study -- pictures
//! ```

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a program for the terminal")]

mod programs;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use anyhow::{Context, Result, bail};
use barchan_bakers::Exec;
use barchan_field::{Mesh, Spacing};
use barchan_import::{HeightMapOptions, Integers, MeshOptions, read_height_map, read_mesh};
use barchan_study::bandwidth::{self, Bandwidth};
use barchan_study::report::Block;
use barchan_study::timer::Pace;
use barchan_study::{
    Machine, Record, RecordFile, Scale, Scene, Step, curvature_accuracy, curvature_interpolation, curvature_speed,
    curved_effect, curved_pictures, curved_shadow, gpu_time, gpu_upload, hemisphere_occlusion, hemisphere_paper,
    hemisphere_speed, horizon_accuracy, horizon_curvature, horizon_shadow, horizon_speed, markdown, relief_search,
    relief_start, run,
};
use clap::{Parser, Subcommand};

/// Where records are kept, from the workspace's root.
const RECORDS: &str = "crates/study/records";
/// Where a quick run leaves its own, which are worth nothing.
const QUICK_RECORDS: &str = "target/study";
/// Where the charts and the pictures are that the document shows.
const GALLERY: &str = "samples/gallery";
/// The document whose blocks are filled.
const DOCUMENT: &str = "MEASUREMENTS.md";

#[derive(Parser)]
#[command(about = "Error against run time")]
struct Arguments {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Measure, write records, print the tables and write them to MEASUREMENTS.md
    Measure {
        /// A small run: records and charts go to target/study and MEASUREMENTS.md stays as it is
        #[arg(long)]
        quick: bool,
        /// Measure only these, separated by commas
        #[arg(long, value_delimiter = ',', value_parser = Block::ALL.map(Block::name))]
        only: Vec<String>,
    },
    /// Write the tables of MEASUREMENTS.md and the charts from the records there are
    Render,
    /// Fail if the tables of MEASUREMENTS.md or the charts are not those of the records
    Check,
    /// Draw the figures of curved surfaces into the gallery
    Pictures,
}

fn main() -> ExitCode {
    let done = match Arguments::parse().task {
        Task::Measure { quick: true, only } => measure(Scale::Quick, &only),
        Task::Measure { quick: false, only } => measure(Scale::Full, &only).and_then(|()| render()),
        Task::Render => render(),
        Task::Check => check(),
        Task::Pictures => pictures(),
    };
    if let Err(error) = done {
        eprintln!("study: {error:#}");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}

/// The workspace's root, two folders above this package.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn measure(scale: Scale, only: &[String]) -> Result<()> {
    let machine = Machine::this();
    let folder = root().join(if scale == Scale::Full { RECORDS } else { QUICK_RECORDS });
    fs::create_dir_all(&folder).with_context(|| format!("{} cannot be made", folder.display()))?;
    for block in Block::ALL {
        if !only.is_empty() && only.iter().all(|name| name != block.name()) {
            continue;
        }
        eprintln!("\n> {}", block.name());
        let records = records(block, scale, machine.cores)?;
        let path = folder.join(block.name()).with_extension("csv");
        let mut file = RecordFile { machine: machine.to_string(), records };
        if let Some(previous) = read(&path)? {
            file = file.with_other_devices(&RecordFile::from_csv(&previous)?);
        }
        let csv = file.to_csv()?;
        write(&path, &csv)?;
        if scale == Scale::Quick {
            write_charts(block, Some(&csv), &folder)?;
        }
        println!("{}\n", block.render(Some(&csv))?);
    }
    Ok(())
}

/// What fills a file of records, on so many cores.
fn records(block: Block, scale: Scale, cores: usize) -> Result<Vec<Record>> {
    match block {
        Block::Bench => speed(scale, cores),
        Block::Accuracy => accuracy(scale, cores),
        Block::Shadow => shadow(scale, cores),
        Block::Kappa => curvature(scale, cores),
        Block::CurvedEffect => effect(scale, cores),
        Block::CurvedShadow => curved_shadows(scale, cores),
        Block::CurvatureInterpolation => curvature_between_vertices(scale, cores),
        Block::CurvatureAccuracy => curvature_of_meshes(scale, cores),
        Block::CurvatureSpeed => curvature_speeds(scale, cores),
        Block::HemispherePaper => paper(scale, cores),
        Block::ReliefSearch => searches(scale, cores),
        Block::ReliefStart => starts(scale, cores),
        Block::HemisphereOcclusion => occlusions(scale, cores),
        Block::HemisphereSpeed => Ok(hemisphere_speed::measure(&hemisphere_speed::study(scale, cores), &mut announce)?),
        Block::GpuTime => gpu_times(scale, cores),
        Block::GpuUpload => Ok(gpu_upload::measure(&gpu_upload::study(scale), &mut announce)?),
        Block::GpuSize => programs::weigh(scale),
    }
}

fn write(path: &Path, text: &str) -> Result<()> {
    fs::write(path, text).with_context(|| format!("{} cannot be written", path.display()))
}

fn write_charts(block: Block, csv: Option<&str>, folder: &Path) -> Result<()> {
    block.charts(csv)?.iter().try_for_each(|(name, svg)| write(&folder.join(name).with_extension("svg"), svg))
}

fn speed(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let (elements, rounds) = match scale {
        Scale::Full => (bandwidth::ELEMENTS, 9),
        Scale::Quick => (bandwidth::ELEMENTS >> 6, 3),
    };
    let mut threads = vec![1, cores];
    threads.dedup();
    let bandwidths: Vec<Bandwidth> =
        threads.into_iter().map(|threads| Bandwidth::measure(threads, elements, rounds)).collect();
    let mut records: Vec<Record> = bandwidths.iter().flat_map(Bandwidth::records).collect();
    for heat in horizon_speed::heats(scale, cores) {
        records.extend(horizon_speed::measure(&heat, &bandwidths, &mut announce)?);
    }
    Ok(records)
}

fn accuracy(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    let mut records = Vec::new();
    for (study, scenes) in horizon_accuracy::parts(scale, &exec, terrain(scale)?)? {
        records.extend(run(&study, &scenes, &mut announce)?);
    }
    Ok(records)
}

fn shadow(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    let (study, scenes) = horizon_shadow::parts(scale, &exec, terrain(scale)?)?;
    Ok(horizon_shadow::measure(&study, &scenes, &mut announce)?)
}

fn curvature(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    let (study, scenes) = horizon_curvature::parts(scale, &exec)?;
    Ok(run(&study, &scenes, &mut announce)?)
}

fn effect(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    let mut records = Vec::new();
    for (study, scenes) in curved_effect::parts(scale, &exec)? {
        records.extend(run(&study, &scenes, &mut announce)?);
    }
    Ok(records)
}

fn curved_shadows(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    let (study, figures) = curved_shadow::parts(scale, &exec)?;
    Ok(curved_shadow::measure(&study, &figures, &mut announce)?)
}

fn curvature_between_vertices(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    let seconds = if scale == Scale::Full { 2.0 } else { 0.01 };
    let cases = curvature_interpolation::cases(scale, &exec, &scans(scale)?)?;
    Ok(curvature_interpolation::measure(&cases, &Pace { seconds, max_rounds: 9 }, &mut announce)?)
}

fn curvature_of_meshes(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    Ok(curvature_accuracy::measure(&curvature_accuracy::parts(scale, &exec), &mut announce)?)
}

fn curvature_speeds(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let mut records = Vec::new();
    for heat in curvature_speed::heats(scale, cores)? {
        records.extend(curvature_speed::measure(&heat, &mut announce)?);
    }
    Ok(records)
}

fn paper(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    Ok(hemisphere_paper::measure(&hemisphere_paper::study(scale, &exec), &mut announce)?)
}

fn searches(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    let (study, scenes) = relief_search::parts(scale, &exec)?;
    Ok(relief_search::measure(&study, &scenes, &mut announce)?)
}

fn starts(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    let (study, scenes) = relief_start::parts(scale, &exec)?;
    Ok(run(&study, &scenes, &mut announce)?)
}

fn occlusions(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    let (study, scenes) = hemisphere_occlusion::parts(scale, &exec)?;
    Ok(hemisphere_occlusion::measure(&study, &scenes, &mut announce)?)
}

fn gpu_times(scale: Scale, cores: usize) -> Result<Vec<Record>> {
    let exec = Exec::new(cores)?;
    Ok(gpu_time::measure(&gpu_time::study(scale, &exec), &mut announce)?)
}

/// Real terrain, as `samples/jacksboro.ron` describes it; a quick run does without.
fn terrain(scale: Scale) -> Result<Vec<Scene>> {
    if scale == Scale::Quick {
        return Ok(Vec::new());
    }
    let options =
        HeightMapOptions { integers: Integers::Raw, spacing: Spacing::new(74.0, 93.0)?, ..HeightMapOptions::default() };
    let field = read_height_map(&root().join("samples/jacksboro.png"), &options)?.field;
    Ok(vec![Scene { name: "jacksboro".to_owned(), field }])
}

/// A real scan; a quick run does without.
fn scans(scale: Scale) -> Result<Vec<(String, Mesh)>> {
    if scale == Scale::Quick {
        return Ok(Vec::new());
    }
    let imported = read_mesh(&root().join("samples/demosthenes.ply"), &MeshOptions::default())?;
    Ok(vec![("demosthenes".to_owned(), imported.mesh)])
}

fn announce(step: &Step<'_>) {
    eprintln!("  {:>3}/{} {}", step.done + 1, step.total, step.what);
}

/// The text of a file; `None` if there is none.
fn read(path: &Path) -> Result<Option<String>> {
    match fs::read_to_string(path) {
        Ok(text) => Ok(Some(text)),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error).with_context(|| format!("{} cannot be read", path.display())),
    }
}

/// The records there are of a block.
fn recorded(block: Block) -> Result<Option<String>> {
    read(&root().join(RECORDS).join(block.name()).with_extension("csv"))
}

fn document() -> Result<(PathBuf, String)> {
    let path = root().join(DOCUMENT);
    let text = fs::read_to_string(&path).with_context(|| format!("{} cannot be read", path.display()))?;
    Ok((path, text))
}

fn render() -> Result<()> {
    let (path, mut text) = document()?;
    for block in Block::ALL {
        let csv = recorded(block)?;
        text = markdown::with_block(&text, block.name(), &block.render(csv.as_deref())?)?;
        write_charts(block, csv.as_deref(), &root().join(GALLERY))?;
    }
    write(&path, &text)
}

fn pictures() -> Result<()> {
    let exec = Exec::new(0)?;
    for (name, picture) in curved_pictures::draw(Scale::Full, &exec, &mut announce)? {
        let path = root().join(GALLERY).join(name).with_extension("png");
        let format = image::ExtendedColorType::Rgb8;
        image::save_buffer(&path, &picture.rgb, picture.width, picture.height, format)
            .with_context(|| format!("{} cannot be written", path.display()))?;
    }
    Ok(())
}

fn check() -> Result<()> {
    let (_, text) = document()?;
    let mut stale = Vec::new();
    for block in Block::ALL {
        let csv = recorded(block)?;
        if markdown::block(&text, block.name())? != block.render(csv.as_deref())? {
            stale.push(format!("{DOCUMENT}'s {}", block.name()));
        }
        for (name, svg) in block.charts(csv.as_deref())? {
            let path = Path::new(GALLERY).join(name).with_extension("svg");
            if read(&root().join(&path))?.as_deref() != Some(svg.as_str()) {
                stale.push(path.display().to_string());
            }
        }
    }
    if !stale.is_empty() {
        bail!("not what the records say: {}; `cargo xtask bench --render` writes them", stale.join(", "));
    }
    Ok(())
}
