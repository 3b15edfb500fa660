//! The curvature of a mesh: a row per vertex, or the mesh in colour, as a file or as a picture.

mod colouring;
mod picture;
mod ply;
mod rows;

use barchan_asset::CurvatureView;
use barchan_field::LengthUnit;
use barchan_pipeline::{
    CurvaturePart, MeshFile, MeshInput, MeshOrigin, PipelineError, Provenance, SurfaceSource, Table, generate_mesh,
    read_mesh_file,
};
use serde::Serialize;

use self::colouring::Colouring;
use super::npy;
use crate::args::{DumpArguments, DumpFormat, MeshPictureArguments};
use crate::asset_file::AssetFile;
use crate::console::{self, number};
use crate::curvature_rows;
use crate::failure::{ExitStatus, Failure};
use crate::output;
use crate::png;

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
    /// Pixels across and down of a picture; `null` where there is none.
    pixels: Option<[u32; 2]>,
}

pub(super) fn run(file: &AssetFile, arguments: &DumpArguments, json: bool) -> Result<ExitStatus, Failure> {
    check_flags(arguments)?;
    if let (Some(output), Some(mesh)) = (&arguments.output, &arguments.curvature.mesh) {
        output::check_writable(output, mesh)?;
    }
    let table = file.curvature()?;
    let view = table.view();
    let part = arguments.curvature.column.unwrap_or(CurvaturePart::Principal);
    check_present(file, &view, part)?;
    let (mut colouring, mut pixels) = (None, None);
    let bytes = match arguments.format {
        DumpFormat::Text => rows::text(&view, part).into_bytes(),
        DumpFormat::Csv => rows::csv(&view).into_bytes(),
        DumpFormat::Npy => rows::npy(&view, part)?,
        DumpFormat::Ply | DumpFormat::Png => {
            let mesh = mesh(file, arguments, view.vertices())?;
            let chosen = colouring.insert(Colouring::new(&view, arguments.curvature.by.unwrap_or_default()));
            if arguments.format == DumpFormat::Ply {
                ply::encode(&mesh.mesh, &view, chosen)
            } else {
                let picture = picture::draw(&mesh, &view, chosen, &arguments.curvature.picture);
                pixels = Some([picture.width, picture.height]);
                png::encode(&picture)?
            }
        }
        DumpFormat::Exr => {
            let words = "--format is exr; npy, csv, text, ply and png show the curvature of vertices";
            return Err(Failure::Usage(words.to_owned()));
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
            DumpFormat::Csv => curvature_rows::present(&view).flat_map(curvature_rows::numbers).copied().collect(),
            DumpFormat::Ply => curvature_rows::numbers(CurvaturePart::Principal).to_vec(),
            DumpFormat::Png => Vec::new(),
            _ => curvature_rows::numbers(part).to_vec(),
        },
        colouring,
        pixels,
    };
    console::present(&report, json, describe)?;
    Ok(ExitStatus::Success)
}

/// Refuses flags that say nothing about what is dumped.
fn check_flags(arguments: &DumpArguments) -> Result<(), Failure> {
    let DumpArguments { format, texture, curvature, .. } = arguments;
    let (is_ply, is_png) = (*format == DumpFormat::Ply, *format == DumpFormat::Png);
    let MeshPictureArguments { view, up, size } = &curvature.picture;
    let has_column = matches!(format, DumpFormat::Npy | DumpFormat::Text);
    let refusals = [
        (texture.layer.is_some(), "--layer is for textures; curvature has vertices"),
        (texture.mip.is_some(), "--mip is for textures; curvature has vertices"),
        (
            curvature.column.is_some() && !has_column,
            "--column is for npy and text; csv has every column, ply k1 and k2",
        ),
        (curvature.mesh.is_some() && !(is_ply || is_png), "--mesh is for --format ply and png"),
        (curvature.by.is_some() && !(is_ply || is_png), "--by is for --format ply and png"),
        (view.is_some() && !is_png, "--view is for --format png"),
        (up.is_some() && !is_png, "--up is for --format png"),
        (size.is_some() && !is_png, "--size is for --format png"),
    ];
    match refusals.into_iter().find(|(applies, _)| *applies) {
        Some((_, words)) => Err(Failure::Usage(words.to_owned())),
        None => Ok(()),
    }
}

fn check_present(file: &AssetFile, view: &CurvatureView<'_>, part: CurvaturePart) -> Result<(), Failure> {
    if curvature_rows::present(view).any(|present| present == part) {
        return Ok(());
    }
    let present: Vec<_> = curvature_rows::present(view).map(CurvaturePart::name).collect();
    Err(file.content(format!("curvature has no {}; it has {}", part.name(), present.join(", "))))
}

/// The mesh that was baked: generated again, or read from where the arguments say, and checked to be the same.
fn mesh(file: &AssetFile, arguments: &DumpArguments, vertices: u32) -> Result<MeshInput, Failure> {
    let provenance = file.provenance().and_then(|json| serde_json::from_value::<Provenance>(json).ok());
    let origin = provenance.and_then(|provenance| provenance.mesh).map(|mesh| mesh.source);
    let mesh = match (origin, &arguments.curvature.mesh) {
        (Some(MeshOrigin::Surface(source)), None) => return generated(file, &source, vertices),
        (Some(MeshOrigin::Surface(_)), Some(_)) => {
            let words = format!("{}: --mesh is not needed: its mesh was generated, and is again", file.path.display());
            return Err(Failure::Usage(words));
        }
        (_, None) => {
            let format = if arguments.format == DumpFormat::Png { "png" } else { "ply" };
            let words = format!("--mesh is missing: a .barchan file holds no geometry for {format} to colour");
            return Err(Failure::Usage(words));
        }
        (Some(MeshOrigin::File { blake3, mesh, .. }), Some(path)) => {
            Expected { file, vertices, blake3: Some(blake3) }.read(&MeshFile { path: path.clone(), mesh })?
        }
        // A file without provenance, or of a program that this one does not know.
        (None, Some(path)) => {
            Expected { file, vertices, blake3: None }.read(&MeshFile { path: path.clone(), mesh: None })?
        }
    };
    Ok(mesh)
}

fn generated(file: &AssetFile, source: &SurfaceSource, vertices: u32) -> Result<MeshInput, Failure> {
    let mesh = generate_mesh(source, LengthUnit::default()).map_err(|error| file.content(error))?;
    match mesh.mesh.positions().len() {
        found if found == vertices as usize => Ok(mesh),
        found => {
            let words =
                format!("its surface has {found} vertices here, and curvature for {vertices}: another version made it");
            Err(file.content(words))
        }
    }
}

/// What the mesh of a file must be.
struct Expected<'a> {
    file: &'a AssetFile,
    vertices: u32,
    blake3: Option<String>,
}

impl Expected<'_> {
    fn read(&self, mesh_file: &MeshFile) -> Result<MeshInput, Failure> {
        let mesh = read_mesh_file(mesh_file, None).map_err(PipelineError::from)?;
        let (found, vertices, asset) = (mesh.mesh.positions().len(), self.vertices, self.file.path.display());
        if found != vertices as usize {
            let words = format!("the mesh has {found} vertices; {asset} has the curvature of {vertices}");
            return Err(Failure::content(&mesh_file.path, words));
        }
        let MeshOrigin::File { blake3: given, .. } = &mesh.provenance.source else { return Ok(mesh) };
        match &self.blake3 {
            Some(baked) if baked != given => {
                let [given, baked] = [given, baked].map(|digest| digest.get(..12).unwrap_or(digest));
                let words = format!("not the mesh that {asset} was baked from: its BLAKE3 is {given}…, not {baked}…");
                Err(Failure::content(&mesh_file.path, words))
            }
            _ => Ok(mesh),
        }
    }
}

fn describe(report: &Report) -> String {
    let Report { output, vertices, numbers, colouring, pixels, .. } = report;
    let what = match pixels {
        Some([width, height]) => format!("{width} × {height} pixels"),
        None => numbers.join(", "),
    };
    let mut text = format!("dumped    curvature to {output}: {vertices} vertices, {what}\n");
    if let Some(Colouring { words, limit, unit, .. }) = colouring {
        let limit = number(*limit);
        text +=
            &format!("colours   {words}: blue to -{limit}, white 0, red to {limit} {unit}, which 95 % are within\n");
    }
    text
}
