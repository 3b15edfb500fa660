//! `barchan inspect`: what a file holds.

use barchan_asset::{Asset, Limits, Section, SectionKind, TextureDescriptor};
use barchan_pipeline::{EncodingProvenance, HorizonProvenance, Provenance};
use serde::Serialize;

use crate::args::FileArguments;
use crate::asset_file::AssetFile;
use crate::bake::layer_words;
use crate::console::{self, bytes, number, value_in};
use crate::failure::{ExitStatus, Failure};

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
    #[serde(skip)]
    descriptor: TextureDescriptor,
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
        provenance: provenance(asset, &file.limits()),
    })
}

fn section_report(file: &AssetFile, section: &Section<'_>) -> Result<SectionReport, Failure> {
    let kind = section.kind();
    let table = (kind.is_texture() && section.is_known()).then(|| section.texture()).transpose();
    let table = table.map_err(|error| file.content(format!("{kind}: {error}")))?;
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
        descriptor,
    }
}

fn provenance(asset: &Asset<'_>, limits: &Limits) -> Option<serde_json::Value> {
    let payload = asset.section(SectionKind::PROVENANCE)?.payload(limits).ok()?;
    serde_json::from_slice(&payload).ok()
}

fn describe(report: &Report) -> String {
    let mut text = String::new();
    let mut line = |what: &str, words: String| text += &format!("{what:14} {words}\n");
    line("file", format!("{}, {}, format {}", report.file, bytes(report.file_bytes), report.version));
    line("identity", format!("blake3 {}", report.identity));
    for section in &report.sections {
        let name = section.name.unwrap_or(&section.kind);
        line(name, section_words(section));
        for words in section.table.iter().flat_map(table_words) {
            line("", words);
        }
    }
    if let Some(provenance) = &report.provenance {
        for words in provenance_words(provenance) {
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
    let layers = layer_words(table.layers, descriptor.candidates);
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
    vec![
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
    ]
}

/// What this program knows of a provenance; all of it, as JSON, where it knows nothing.
fn provenance_words(json: &serde_json::Value) -> Vec<String> {
    let Ok(provenance) = serde_json::from_value::<Provenance>(json.clone()) else {
        return vec![json.to_string()];
    };
    let mut words =
        vec![format!("{}, input {}", provenance.generator, json["input"]), format!("recipe {}", json["recipe"])];
    words.extend(provenance.horizon.iter().flat_map(horizon_words));
    words.extend(provenance.swept.map(|swept| format!("{}, {} points", swept.algorithm, swept.points)));
    words.extend(provenance.sky.map(|sky| sky.algorithm));
    let lossy = provenance.encodings.iter().filter(|encoding| encoding.max > 0.0);
    words.extend(lossy.map(encoding_words));
    words
}

fn horizon_words(horizon: &HorizonProvenance) -> Vec<String> {
    let HorizonProvenance { algorithm, method, directions, arc, radius, accuracy } = horizon;
    let method = method.map(|method| format!(" {}", method.name())).unwrap_or_default();
    let arc = arc.map(|arc| format!(" {}", console::arc(arc))).unwrap_or_default();
    let baked = format!("{algorithm}{method}, {directions} directions{arc}, radius {radius}");
    std::iter::once(baked).chain(accuracy.as_ref().map(console::accuracy)).collect()
}

/// What storing cost, measured over all values.
fn encoding_words(encoding: &EncodingProvenance) -> String {
    let EncodingProvenance { table, format, unit, rms, max } = encoding;
    let [rms, max] = [*rms, *max].map(|error| console::error_in(unit, error));
    format!("{table} stored as {format}: measured {rms} RMS, {max} at most")
}
