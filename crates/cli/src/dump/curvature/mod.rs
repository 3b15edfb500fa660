//! The curvature of a mesh: a row per vertex, or the mesh in colour.

mod ply;
mod rows;

use std::path::Path;

use barchan_asset::CurvatureView;
use barchan_pipeline::{CurvaturePart, MeshFile, MeshInput, Provenance, Table, read_mesh_file};
use serde::Serialize;

use self::ply::Colouring;
use super::npy;
use crate::args::{DumpArguments, DumpFormat};
use crate::asset_file::AssetFile;
use crate::console::{self, number};
use crate::failure::{ExitStatus, Failure};
use crate::output;

#[derive(Serialize)]
struct Report {
    schema: &'static str,
    file: String,
    table: &'static str,
    output: String,
    vertices: u32,
    /// The numbers of a vertex.
    numbers: Vec<&'static str>,
    /// What is coloured, and how; `null` where nothing is.
    colouring: Option<Colouring>,
}

pub(super) fn run(file: &AssetFile, arguments: &DumpArguments, json: bool) -> Result<ExitStatus, Failure> {
    check_flags(arguments)?;
    let table = file.curvature()?;
    let view = table.view();
    let part = arguments.curvature.column.unwrap_or(CurvaturePart::Principal);
    check_present(file, &view, part)?;
    let mut colouring = None;
    let bytes = match arguments.format {
        DumpFormat::Text => rows::text(&view, part).into_bytes(),
        DumpFormat::Csv => rows::csv(&view).into_bytes(),
        DumpFormat::Npy => rows::npy(&view, part)?,
        DumpFormat::Ply => {
            let mesh = mesh(file, arguments, view.vertices())?;
            let chosen = Colouring::new(&view, arguments.curvature.by.unwrap_or_default());
            let bytes = ply::encode(&mesh.mesh, &view, &chosen);
            colouring = Some(chosen);
            bytes
        }
        DumpFormat::Png | DumpFormat::Exr => {
            let accepted = "npy, csv, text and ply show the curvature of vertices";
            return Err(Failure::Usage(format!("--format is for textures; {accepted}")));
        }
    };
    let Some(output) = &arguments.output else {
        return super::to_stdout(arguments.format, json, &bytes);
    };
    output::write_whole(output, &bytes)?;
    let report = Report {
        schema: "barchan.dump_curvature/1",
        file: file.path.display().to_string(),
        table: Table::Curvature.name(),
        output: output.display().to_string(),
        vertices: view.vertices(),
        numbers: match arguments.format {
            DumpFormat::Csv => rows::present(&view).flat_map(rows::numbers).copied().collect(),
            DumpFormat::Ply => rows::numbers(CurvaturePart::Principal).to_vec(),
            _ => rows::numbers(part).to_vec(),
        },
        colouring,
    };
    console::present(&report, json, describe)?;
    Ok(ExitStatus::Success)
}

/// Refuses flags that say nothing about what is dumped.
fn check_flags(arguments: &DumpArguments) -> Result<(), Failure> {
    let DumpArguments { format, texture, curvature, .. } = arguments;
    let is_ply = *format == DumpFormat::Ply;
    let has_column = matches!(format, DumpFormat::Npy | DumpFormat::Text);
    let refusals = [
        (texture.layer.is_some(), "--layer is for textures; curvature has vertices"),
        (texture.mip.is_some(), "--mip is for textures; curvature has vertices"),
        (curvature.column.is_some() && !has_column, "--column is for npy and text; csv has every column, ply k1 and k2"),
        (curvature.mesh.is_some() && !is_ply, "--mesh is for --format ply"),
        (curvature.by.is_some() && !is_ply, "--by is for --format ply"),
        (is_ply && curvature.mesh.is_none(), "--mesh is missing: a .barchan file holds no geometry for ply to colour"),
    ];
    match refusals.into_iter().find(|(applies, _)| *applies) {
        Some((_, words)) => Err(Failure::Usage(words.to_owned())),
        None => Ok(()),
    }
}

fn check_present(file: &AssetFile, view: &CurvatureView<'_>, part: CurvaturePart) -> Result<(), Failure> {
    if rows::present(view).any(|present| present == part) {
        return Ok(());
    }
    let present: Vec<_> = rows::present(view).map(CurvaturePart::name).collect();
    Err(file.content(format!("curvature has no {}; it has {}", part.name(), present.join(", "))))
}

/// The mesh that was named, if it is the one that was baked.
fn mesh(file: &AssetFile, arguments: &DumpArguments, vertices: u32) -> Result<MeshInput, Failure> {
    let path = arguments.curvature.mesh.as_deref().unwrap_or(Path::new(""));
    if let Some(output) = &arguments.output {
        output::check_writable(output, path)?;
    }
    let provenance = file.provenance().and_then(|json| serde_json::from_value::<Provenance>(json).ok());
    let baked = provenance.and_then(|provenance| provenance.mesh);
    let name = baked.as_ref().and_then(|baked| baked.mesh.clone());
    let mesh = read_mesh_file(&MeshFile { path: path.to_owned(), mesh: name }, None)
        .map_err(|error| if error.is_io() { Failure::Io(error.to_string()) } else { Failure::BadInput(error.to_string()) })?;
    let (found, asset) = (mesh.mesh.positions().len(), file.path.display());
    if found != vertices as usize {
        let words = format!("the mesh has {found} vertices; {asset} has the curvature of {vertices}");
        return Err(Failure::content(path, words));
    }
    match baked {
        Some(baked) if baked.blake3 != mesh.provenance.blake3 => {
            let [given, baked] = [&mesh.provenance.blake3, &baked.blake3].map(|digest| digest.get(..12).unwrap_or(digest));
            let words = format!("this is not the mesh of {asset}: its BLAKE3 begins with {given}, that of the baked one with {baked}");
            Err(Failure::content(path, words))
        }
        _ => Ok(mesh),
    }
}

fn describe(report: &Report) -> String {
    let Report { output, vertices, numbers, colouring, .. } = report;
    let mut text = format!("dumped    curvature to {output}: {vertices} vertices, {}\n", numbers.join(", "));
    if let Some(Colouring { words, limit, unit, .. }) = colouring {
        let limit = number(*limit);
        text += &format!("colours   {words}: white is 0, full blue -{limit} {unit}, full red {limit} {unit} (95 % are within)\n");
    }
    text
}
