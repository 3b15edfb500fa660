//! `barchan inspect`: what a file holds.

mod provenance;

use barchan_asset::{
    Asset, CurvatureDescriptor, CurvatureView, DepthMode, Section, SectionKind, TextureDescriptor, VertexFlags,
};
use barchan_pipeline::FlagCount;
use serde::Serialize;

use crate::args::FileArguments;
use crate::asset_file::AssetFile;
use crate::bake::{LayerCounts, layer_words};
use crate::console::{self, bytes, number, value_in};
use crate::failure::{ExitStatus, Failure};
use crate::mesh_words;

#[derive(Serialize)]
struct Report {
    schema: &'static str,
    file: String,
    version: String,
    file_bytes: u64,
    identity: String,
    sections: Vec<SectionReport>,
    /// As stored: a newer program may have written more than this one knows.
    provenance: Option<serde_json::Value>,
}

#[derive(Serialize)]
struct SectionReport {
    kind: String,
    name: Option<&'static str>,
    section_version: u16,
    critical: bool,
    codec: String,
    offset: u64,
    stored_bytes: u64,
    raw_bytes: u64,
    crc32: String,
    intact: bool,
    table: Option<TableReport>,
    /// Of the curvature of a mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    curvature: Option<CurvatureReport>,
}

#[derive(Serialize)]
struct CurvatureReport {
    vertices: u32,
    length_unit: &'static str,
    /// The least κ2 and the greatest κ1, in 1 / length unit.
    minimum: f32,
    maximum: f32,
    columns: Vec<ColumnReport>,
    /// How many vertices have each remark that any has; `null` where the payload is damaged.
    flagged: Option<Vec<FlagCount>>,
    #[serde(skip)]
    length: &'static str,
}

#[derive(Serialize)]
struct ColumnReport {
    column: &'static str,
    format: &'static str,
    bytes: u64,
    scale: f32,
    minimum: f32,
    maximum: f32,
    worst_case_error: f32,
}

#[derive(Serialize)]
struct TableReport {
    format: &'static str,
    width: u32,
    height: u32,
    layers: u32,
    mips: u32,
    semantic: &'static str,
    unit: &'static str,
    length_unit: &'static str,
    scale: f64,
    bias: f64,
    minimum: f64,
    maximum: f64,
    worst_case_error: f64,
    wrap_u: &'static str,
    wrap_v: &'static str,
    spacing_u: f64,
    spacing_v: f64,
    search_radius: Option<f64>,
    transfer: &'static str,
    /// The first and the last azimuth in degrees; `null` where there is no direction, and all the way round.
    arc_degrees: Option<(f64, f64)>,
    /// Points per azimuth of a swept table, besides the horizon's.
    candidates: Option<u32>,
    /// The curvatures a swept table serves, in 1 / length unit.
    curvature: Option<(f64, f64)>,
    /// Of a hemisphere table.
    #[serde(skip_serializing_if = "Option::is_none")]
    directions: Option<DirectionsReport>,
    /// The heights of depth 0 and of depth 1, in the length unit, where values are depths.
    #[serde(skip_serializing_if = "Option::is_none")]
    relief: Option<ReliefReport>,
    #[serde(skip)]
    descriptor: TextureDescriptor,
}

#[derive(Serialize)]
struct DirectionsReport {
    rings: u32,
    azimuths: u32,
    ring_spacing: &'static str,
    max_polar_degrees: f64,
    depth_mode: Option<&'static str>,
}

#[derive(Serialize)]
struct ReliefReport {
    top: f64,
    thickness: f64,
}

pub(crate) fn run(arguments: &FileArguments, json: bool) -> Result<ExitStatus, Failure> {
    let file = AssetFile::read(&arguments.file)?;
    let report = report(&file, &file.open()?)?;
    console::present(&report, json, describe)?;
    Ok(ExitStatus::Success)
}

fn report(file: &AssetFile, asset: &Asset<'_>) -> Result<Report, Failure> {
    let (major, minor) = asset.version();
    let sections = asset.sections().map(|section| section_report(file, &section)).collect::<Result<_, _>>()?;
    Ok(Report {
        schema: "barchan.inspect/1",
        file: file.path.display().to_string(),
        version: format!("{major}.{minor}"),
        file_bytes: asset.file_size(),
        identity: asset.identity().iter().map(|byte| format!("{byte:02x}")).collect(),
        sections,
        provenance: file.provenance(),
    })
}

fn section_report(file: &AssetFile, section: &Section<'_>) -> Result<SectionReport, Failure> {
    let kind = section.kind();
    let table = (kind.is_texture() && section.is_known()).then(|| section.texture()).transpose();
    let table = table.map_err(|error| file.content(format!("{kind}: {error}")))?;
    let is_curvature = kind == SectionKind::CURVATURE && section.is_known();
    let curvature = is_curvature.then(|| section.curvature()).transpose();
    let curvature = curvature.map_err(|error| file.content(format!("{kind}: {error}")))?;
    Ok(SectionReport {
        kind: kind.to_string(),
        name: kind.name(),
        section_version: section.version(),
        critical: section.is_critical(),
        codec: section.codec().map_or_else(|| format!("codec {}", section.codec_number()), |codec| codec.name().into()),
        offset: section.offset(),
        stored_bytes: section.stored_length(),
        raw_bytes: section.raw_length(),
        crc32: format!("{:08x}", section.crc32()),
        intact: section.is_intact(),
        table: table.map(table_report),
        curvature: curvature.map(|descriptor| curvature_report(file, &descriptor)),
    })
}

fn table_report(descriptor: TextureDescriptor) -> TableReport {
    TableReport {
        format: descriptor.format.name(),
        width: descriptor.width,
        height: descriptor.height,
        layers: descriptor.layers,
        mips: descriptor.mips,
        semantic: descriptor.semantic.name(),
        unit: descriptor.unit.name(),
        length_unit: descriptor.length_unit.name(),
        scale: descriptor.scale,
        bias: descriptor.bias,
        minimum: descriptor.range_min,
        maximum: descriptor.range_max,
        worst_case_error: descriptor.worst_case_error,
        wrap_u: descriptor.wrap_u.name(),
        wrap_v: descriptor.wrap_v.name(),
        spacing_u: descriptor.spacing_u,
        spacing_v: descriptor.spacing_v,
        search_radius: (descriptor.search_radius > 0.0).then_some(descriptor.search_radius),
        transfer: descriptor.transfer.name(),
        arc_degrees: console::covered_arc(&descriptor),
        candidates: descriptor.semantic.is_swept().then_some(descriptor.candidates),
        curvature: descriptor.semantic.is_swept().then_some((descriptor.curvature_min, descriptor.curvature_max)),
        directions: descriptor.directions().map(|directions| DirectionsReport {
            rings: directions.rings,
            azimuths: directions.azimuths.count(),
            ring_spacing: directions.spacing.name(),
            max_polar_degrees: directions.max_polar_radians.to_degrees(),
            depth_mode: descriptor.depth_mode.map(DepthMode::name),
        }),
        relief: descriptor.relief().map(|relief| ReliefReport { top: relief.top, thickness: relief.thickness }),
        descriptor,
    }
}

fn curvature_report(file: &AssetFile, descriptor: &CurvatureDescriptor) -> CurvatureReport {
    let vertices = descriptor.vertices();
    let columns = descriptor.columns().map(|layout| ColumnReport {
        column: layout.column.name(),
        format: layout.format.name(),
        bytes: u64::from(vertices) * u64::from(layout.format.stride()),
        scale: layout.scale,
        minimum: layout.range_min,
        maximum: layout.range_max,
        worst_case_error: layout.worst_case_error,
    });
    let (minimum, maximum) = descriptor.curvature_range();
    CurvatureReport {
        vertices,
        length_unit: descriptor.length_unit().name(),
        minimum,
        maximum,
        columns: columns.collect(),
        flagged: file.curvature().ok().map(|table| flag_counts(&table.view())),
        length: descriptor.length_unit().symbol(),
    }
}

fn flag_counts(view: &CurvatureView<'_>) -> Vec<FlagCount> {
    let count = |flag| (0..view.vertices()).filter(|&vertex| view.flags(vertex).contains(flag)).count() as u64;
    let counts = VertexFlags::ALL.into_iter().map(|(flag, name)| (name.to_owned(), count(flag)));
    counts.filter(|(_, vertices)| *vertices > 0).map(|(flag, vertices)| FlagCount { flag, vertices }).collect()
}

fn describe(report: &Report) -> String {
    let mut text = String::new();
    let mut line = |what: &str, words: String| text += &format!("{what:14} {words}\n");
    line("file", format!("{}, {}, format {}", report.file, bytes(report.file_bytes), report.version));
    line("identity", format!("blake3 {}", report.identity));
    for section in &report.sections {
        let name = section.name.unwrap_or(&section.kind);
        line(name, section_words(section));
        let curvature = section.curvature.iter().flat_map(curvature_words);
        for words in section.table.iter().flat_map(table_words).chain(curvature) {
            line("", words);
        }
    }
    if let Some(provenance) = &report.provenance {
        let length =
            report.sections.iter().find_map(|section| section.curvature.as_ref()).map_or("", |found| found.length);
        for words in provenance::words(provenance, length) {
            line("provenance", words);
        }
    }
    text
}

fn section_words(section: &SectionReport) -> String {
    let SectionReport { kind, codec, offset, stored_bytes, raw_bytes, crc32, .. } = section;
    let damage = if section.intact { "" } else { ", DAMAGED: checksum mismatch" };
    let packed = if codec == "raw" { String::new() } else { format!(" of {}", bytes(*raw_bytes)) };
    let rank = if section.critical { "critical" } else { "ancillary" };
    let stored = bytes(*stored_bytes);
    format!("{kind} at {offset}, {codec} {stored}{packed}, {rank}, crc32 {crc32}{damage}")
}

fn table_words(table: &TableReport) -> Vec<String> {
    let descriptor = &table.descriptor;
    let in_unit = |value| value_in(descriptor.unit, value);
    let length = descriptor.length_unit.symbol();
    let layers = layer_words(LayerCounts {
        layers: table.layers,
        candidates: descriptor.candidates,
        rings: descriptor.rings,
        mips: table.mips,
    });
    let arc = table.arc_degrees.map(|arc| format!(" {}", console::arc(arc))).unwrap_or_default();
    let curvature = table.curvature.map(|(min, max)| format!(", curvature {min} to {max} per {length}"));
    let transfer = match table.transfer {
        "identity" => String::new(),
        transfer => format!(" of the {}", if transfer == "square" { "root" } else { transfer }),
    };
    let radius = table.search_radius.map(|radius| format!(", search radius {} {length}", number(radius)));
    let error = match table.worst_case_error {
        0.0 => "exact".to_owned(),
        error => format!("encoded to ± {}", in_unit(error)),
    };
    let mut words = vec![
        format!(
            "{} × {} texels of {} × {} {length}{layers}{arc}, {}{transfer}, {} / {}{}{}",
            table.width,
            table.height,
            number(table.spacing_u),
            number(table.spacing_v),
            table.format,
            table.wrap_u,
            table.wrap_v,
            radius.unwrap_or_default(),
            curvature.unwrap_or_default(),
        ),
        format!("{} {} to {}, {error}", table.semantic, in_unit(table.minimum), in_unit(table.maximum)),
    ];
    words.extend(table.directions.as_ref().map(directions_words));
    words.extend(table.relief.as_ref().map(|ReliefReport { top, thickness }| {
        format!("depth 0 at {} {length}, depth 1 at {} {length}", number(*top), number(top - thickness))
    }));
    words
}

fn directions_words(directions: &DirectionsReport) -> String {
    let DirectionsReport { ring_spacing, max_polar_degrees, depth_mode, .. } = directions;
    let mode = depth_mode.unwrap_or("unknown");
    format!("{mode}, rings to {}° from the normal by {ring_spacing}", number(*max_polar_degrees))
}

fn curvature_words(curvature: &CurvatureReport) -> Vec<String> {
    let CurvatureReport { vertices, minimum, maximum, columns, flagged, length, .. } = curvature;
    let [least, greatest] = [minimum, maximum].map(|&curvature| number(curvature.into()));
    let per = mesh_words::singular(length);
    let flagged = match flagged {
        Some(flagged) => mesh_words::flagged(flagged, (*vertices).into()),
        None => "its remarks cannot be read".to_owned(),
    };
    let mut words = vec![format!("{vertices} vertices, κ from {least} to {greatest} per {per}"), flagged];
    words.extend(columns.iter().map(|column| {
        let ColumnReport { column, format, bytes: size, minimum, maximum, worst_case_error, .. } = column;
        let size = bytes(*size);
        let [least, greatest] = [minimum, maximum].map(|&value| number(value.into()));
        match (*column, *worst_case_error) {
            ("flags", _) => format!("{column} {format}, {size}"),
            (_, 0.0) => format!("{column} {format}, {size}, {least} to {greatest}, exact"),
            (_, error) => {
                format!("{column} {format}, {size}, {least} to {greatest}, encoded to ± {}", number(error.into()))
            }
        }
    }));
    words
}
