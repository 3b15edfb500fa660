//! `barchan dump`: a table's values in formats that other programs read.

mod curvature;
mod exr;
mod npy;
mod picture;
mod text;

use std::ops::Range;

use barchan_asset::{BentNormalView, Semantic, Unit};
use barchan_pipeline::Table;
use serde::Serialize;

use crate::args::{CurvatureDumpArguments, DumpArguments, DumpFormat, MeshPictureArguments, TextureDumpArguments};
use crate::asset_file::{AssetFile, DecodedTable, list_tables};
use crate::console;
use crate::failure::{ExitStatus, Failure};
use crate::output;

/// A table and the layers of it that were asked for.
struct Selection<'a> {
    table: &'a DecodedTable<'a>,
    /// As [`barchan_asset::TableView`] counts them: a level of a mip chain is one.
    layers: Range<u32>,
    /// One layer was named, so the layer axis is dropped where a format has one.
    single: bool,
}

impl Selection<'_> {
    fn width(&self) -> usize {
        self.extent().0 as usize
    }

    fn height(&self) -> usize {
        self.extent().1 as usize
    }

    /// Columns and rows of each layer; of levels there is only one.
    fn extent(&self) -> (u32, u32) {
        self.table.descriptor.picture_extent(self.layers.start)
    }

    /// Whether values are angles of elevation.
    fn is_elevation(&self) -> bool {
        self.table.descriptor.unit == Unit::Radian
    }

    fn is_directional(&self) -> bool {
        self.table.descriptor.semantic.is_directional()
    }

    /// What the numbers of a texel are called.
    fn numbers(&self) -> &'static [&'static str] {
        match self.table.table {
            Table::BentNormal => &["u", "v", "height"],
            Table::ApertureCone => &["u", "v", "height", "cosine_of_half_angle"],
            Table::Height => &["height"],
            Table::Horizon => &["horizon"],
            Table::Distance => &["distance"],
            Table::SweptHorizon => &["swept_horizon"],
            Table::SweptDistance => &["swept_distance"],
            Table::SkyVisibility => &["sky_visibility"],
            Table::Hemisphere => &["depth"],
            Table::ConeMap | Table::RelaxedConeMap => &["depth", "ratio"],
            Table::MaximumMip => &["maximum_height"],
            // Not a texture, and never selected as one.
            Table::Curvature => &[],
        }
    }

    /// The decoded values of one layer, row by row, the numbers of a texel side by side. A bent normal has its height too.
    fn layer_values(&self, layer: u32) -> Vec<f32> {
        let (view, descriptor) = (self.table.view(), self.table.descriptor);
        let rows = 0..self.extent().1;
        if self.table.table != Table::BentNormal {
            return rows.flat_map(|row| view.row(layer, row)).collect();
        }
        let normals = BentNormalView::new(descriptor, &self.table.payload).expect("checked when it was decoded");
        let texels = rows.flat_map(|row| (0..descriptor.width).map(move |column| (column, row)));
        texels.flat_map(|(column, row)| normals.normal(column, row)).collect()
    }
}

#[derive(Serialize)]
struct Report {
    schema: &'static str,
    file: String,
    table: &'static str,
    output: String,
    layers: u32,
    /// The level of a mip chain.
    #[serde(skip_serializing_if = "Option::is_none")]
    mip: Option<u32>,
    width: u32,
    height: u32,
    values: &'static str,
}

pub(crate) fn run(arguments: &DumpArguments, json: bool) -> Result<ExitStatus, Failure> {
    if let Some(output) = &arguments.output {
        output::check_writable(output, &arguments.file)?;
    }
    let file = AssetFile::read(&arguments.file)?;
    let table = chosen_table(&file, arguments.table)?;
    if table.is_of_a_mesh() {
        return curvature::run(&file, arguments, json);
    }
    if let Some(flag) = first_curvature_flag(&arguments.curvature) {
        return Err(Failure::Usage(format!("{flag} is for curvature; {} is a texture", table.name())));
    }
    let table = file.decode(table)?;
    let selection = select(&file, arguments, &table)?;
    let bytes = encode(arguments.format, &selection)?;
    let Some(output) = &arguments.output else {
        return to_stdout(arguments.format, json, &bytes);
    };
    output::write_whole(output, &bytes)?;
    let report = Report {
        schema: "barchan.dump/1",
        file: file.path.display().to_string(),
        table: table.table.name(),
        output: output.display().to_string(),
        layers: selection.layers.len() as u32,
        mip: (table.descriptor.mips > 1).then_some(selection.layers.start),
        width: selection.extent().0,
        height: selection.extent().1,
        values: value_words(arguments.format, &selection),
    };
    console::present(&report, json, describe)?;
    Ok(ExitStatus::Success)
}

fn chosen_table(file: &AssetFile, named: Option<Table>) -> Result<Table, Failure> {
    let present = file.tables()?;
    match (named, present.as_slice()) {
        (Some(table), _) => Ok(table),
        (None, [table]) => Ok(*table),
        (None, []) => Err(file.content("there is no table in the file")),
        (None, tables) => {
            let path = file.path.display();
            Err(Failure::Usage(format!("{path}: the file has {}; name one of them", list_tables(tables))))
        }
    }
}

fn first_curvature_flag(flags: &CurvatureDumpArguments) -> Option<&'static str> {
    let CurvatureDumpArguments { column, mesh, by, picture: MeshPictureArguments { view, up, size } } = flags;
    let typed = [
        ("--column", column.is_some()),
        ("--mesh", mesh.is_some()),
        ("--by", by.is_some()),
        ("--view", view.is_some()),
        ("--up", up.is_some()),
        ("--size", size.is_some()),
    ];
    typed.into_iter().find(|(_, is_typed)| *is_typed).map(|(flag, _)| flag)
}

fn select<'a>(
    file: &AssetFile,
    arguments: &DumpArguments,
    table: &'a DecodedTable<'a>,
) -> Result<Selection<'a>, Failure> {
    let (name, layers, mips) = (table.table.name(), table.descriptor.layers, table.descriptor.mips);
    let out_of_range = |what: &str, value: u32, count: u32| {
        let path = file.path.display();
        let last = count - 1;
        Failure::Usage(format!("{path}: --{what} is {value}; {name} has {what}s 0 to {last}"))
    };
    let TextureDumpArguments { layer, mip } = arguments.texture;
    if let Some(mip) = mip.filter(|&mip| mip >= mips) {
        return Err(out_of_range("mip", mip, mips));
    }
    if mips > 1 && layer.is_none_or(|layer| layer < layers) {
        let level = mip.unwrap_or(0);
        return Ok(Selection { table, layers: level..level + 1, single: true });
    }
    match layer {
        Some(layer) if layer >= layers => Err(out_of_range("layer", layer, layers)),
        Some(layer) => Ok(Selection { table, layers: layer..layer + 1, single: true }),
        None => Ok(Selection { table, layers: 0..layers, single: layers == 1 }),
    }
}

fn encode(format: DumpFormat, selection: &Selection<'_>) -> Result<Vec<u8>, Failure> {
    match format {
        DumpFormat::Text => Ok(text::text(selection).into_bytes()),
        DumpFormat::Csv => Ok(text::csv(selection).into_bytes()),
        DumpFormat::Npy => npy::encode(selection),
        DumpFormat::Png => picture::encode(selection),
        DumpFormat::Exr => exr::encode(selection),
        DumpFormat::Ply => {
            Err(Failure::Usage("--format ply is for curvature; text, csv, npy, png and exr show textures".to_owned()))
        }
    }
}

/// What the numbers in the output are.
fn value_words(format: DumpFormat, selection: &Selection<'_>) -> &'static str {
    use DumpFormat::{Csv, Exr, Npy, Ply, Png, Text};
    match (selection.table.descriptor.semantic, format) {
        (Semantic::BentNormal, Png) => "16-bit red, green, blue for u, v, height from -1 to 1",
        (Semantic::ApertureCone, Png) => {
            "16-bit red, green, blue for u, v, height from -1 to 1, alpha for the cosine of the half-angle"
        }
        (Semantic::SkyVisibility, Png) => "16-bit grey, white where all of the sky is seen",
        (Semantic::HemisphereDepth, Png) => "16-bit grey from the top of the relief, black, to its bottom",
        (Semantic::ConeMap | Semantic::RelaxedConeMap, Png) => {
            "16-bit red for the depth from 0 to 1, green for the ratio over the table's range"
        }
        (_, Png) => "16-bit grey over the table's range",
        (Semantic::HemisphereDepth, _) => "depths from 0 at the top of the relief to 1 at its bottom",
        (Semantic::ConeMap | Semantic::RelaxedConeMap, _) => "depths and ratios of cones",
        (Semantic::SkyVisibility, _) => "shares of the sky",
        (Semantic::BentNormal, _) => "u, v and height of unit vectors",
        (Semantic::ApertureCone, _) => "u, v and height of unit vectors, and cosines of half-angles",
        _ if !selection.is_elevation() => "the length unit",
        (_, Text) => "degrees of elevation",
        (_, Csv) => "degrees of elevation and slope",
        (_, Npy) => "slopes",
        (_, Exr | Ply) => "radians of elevation",
    }
}

fn to_stdout(format: DumpFormat, json: bool, bytes: &[u8]) -> Result<ExitStatus, Failure> {
    if json || !matches!(format, DumpFormat::Text | DumpFormat::Csv) {
        return Err(Failure::Usage("-o is missing: only text and csv go to stdout, and not with --json".to_owned()));
    }
    console::print_bytes(bytes)?;
    Ok(ExitStatus::Success)
}

fn describe(report: &Report) -> String {
    let Report { table, output, layers, mip, width, height, values, .. } = report;
    let layers = match mip {
        Some(mip) => format!("level {mip}, "),
        None if *layers == 1 => String::new(),
        None => format!("{layers} layers of "),
    };
    format!("dumped    {table} to {output}: {layers}{width} × {height}, {values}\n")
}
