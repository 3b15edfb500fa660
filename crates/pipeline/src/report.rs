//! What a bake did, for machines; the CLI prints it for people.

use std::path::PathBuf;

use barchan_asset::{Finished, SectionKind};
use barchan_field::HeightField;
use serde::Serialize;

use crate::bake::Inputs;
use crate::curvature::WrittenCurvature;
use crate::curvature_part::column_unit;
use crate::plan::FLAT_ALONE;
use crate::provenance::{HorizonProvenance, Provenance, SweptProvenance};
use crate::search_provenance::ReliefSearchProvenance;
use crate::sink::WrittenTable;
use crate::{CurvaturePart, CurvatureProvenance, Decision, Plan, PlannedTable, Table};

/// Names the layout of [`BakeReport`] as JSON.
pub const BAKE_SCHEMA: &str = "barchan.bake/2";

/// What was baked, what was left out, sizes, times and errors.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BakeReport {
    /// [`BAKE_SCHEMA`].
    pub schema: &'static str,
    /// The height map or shape, in words; `null` where there is none.
    pub source: Option<String>,
    /// Texels whose height a fill rule made up.
    pub filled_texels: u64,
    /// The field; `null` where there is none.
    pub grid: Option<GridReport>,
    /// The mesh; `null` where there is none.
    pub mesh: Option<MeshReport>,
    /// The tables in the file.
    pub tables: Vec<TableReport>,
    /// The tables that are not.
    pub left_out: Vec<LeftOut>,
    /// What the horizon's baker did and how exactly; `null` without a horizon or distance table.
    pub horizon: Option<HorizonProvenance>,
    /// How many points were kept for curved surfaces; `null` where none were looked for.
    pub swept: Option<SweptProvenance>,
    /// What the bakers of tables for relief search did and how near they let rays start; `null` where none ran.
    pub relief_search: Option<ReliefSearchProvenance>,
    /// What the baker of curvature did and found; `null` where it did not run.
    pub curvature: Option<CurvatureProvenance>,
    /// Wall-clock time of each stage, in the order they ran.
    pub stages: Vec<StageTime>,
    /// Texels times directions baked per second of the horizon stage, in millions.
    pub mtexel_directions_per_second: Option<f64>,
    /// Rays per second of the hemisphere stage, in millions: one from every texel of the heights in every direction of the table,
    /// however many of them are followed together.
    pub mrays_per_second: Option<f64>,
    /// Vertices baked per second of the curvature stage, in millions.
    pub mvertices_per_second: Option<f64>,
    /// Worker threads.
    pub threads: usize,
    /// Size of the file in bytes.
    pub file_bytes: u64,
    /// BLAKE3 of the uncompressed content, in hexadecimal.
    pub identity: String,
}

/// The field that was baked.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GridReport {
    /// Texels along u.
    pub width: u32,
    /// Texels along v.
    pub height: u32,
    /// Length per texel along u.
    pub spacing_u: f64,
    /// Length per texel along v.
    pub spacing_v: f64,
    /// The length unit's symbol.
    pub unit: &'static str,
    /// `wrap` or `clamp`.
    pub edge: &'static str,
    /// The lowest height.
    pub lowest: f32,
    /// The highest height.
    pub highest: f32,
}

/// The mesh that was baked.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MeshReport {
    /// The file or surface, in words.
    pub source: String,
    /// The file, as a path from the current folder; `null` for a surface.
    pub path: Option<PathBuf>,
    /// Vertices: the rows of the table.
    pub vertices: u64,
    /// Triangles.
    pub triangles: u64,
    /// The length unit's symbol.
    pub unit: &'static str,
    /// Vertices that an OBJ file does not have as `v`: one for each further pair of texture coordinate and normal.
    pub seam_vertices: u64,
    /// Faces of more than three corners, which were cut into triangles.
    pub polygons: u64,
    /// Vertices of triangles without a texture coordinate, where others have one.
    pub uvs_missing: u64,
    /// Vertices of triangles without a usable normal, where others have one.
    pub normals_missing: u64,
    /// Points, lines and curves of the file, which were left out.
    pub ignored: u64,
}

/// A table in the file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TableReport {
    /// Its name.
    pub table: &'static str,
    /// How a texel is stored.
    pub format: &'static str,
    /// Directions times candidates, rings times azimuths, or 1.
    pub layers: u32,
    /// Rings around the normal, in a hemisphere table; else 0.
    pub rings: u32,
    /// Points per direction besides the horizon's, in a swept table; else 0.
    pub candidates: u32,
    /// Levels of a mip chain; else 1.
    pub mips: u32,
    /// Bytes in the file.
    pub stored_bytes: u64,
    /// Bytes after unpacking.
    pub raw_bytes: u64,
    /// The most that encoding can change a value, in `unit`.
    pub worst_case_error: f64,
    /// What encoding changed, measured over every value: RMS, in `unit`.
    pub encoding_rms: f64,
    /// The largest such change.
    pub encoding_max: f64,
    /// The unit of values.
    pub unit: &'static str,
    /// Why it was baked.
    pub reason: &'static str,
    /// The columns of a table of vertices; empty for textures.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub columns: Vec<ColumnReport>,
}

/// A column of a table of vertices.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ColumnReport {
    /// Its name.
    pub column: &'static str,
    /// How a vertex is stored.
    pub format: &'static str,
    /// Bytes after unpacking.
    pub raw_bytes: u64,
    /// The most that encoding can change a number.
    pub worst_case_error: f64,
    /// What encoding changed, measured over every number: RMS.
    pub encoding_rms: f64,
    /// The largest such change.
    pub encoding_max: f64,
    /// The unit of numbers.
    pub unit: &'static str,
}

/// A table that is not in the file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LeftOut {
    /// Its name; of a part of a table, the table's and its own: `curvature.directions`.
    pub table: &'static str,
    /// Why.
    pub reason: &'static str,
    /// What it would have taken, uncompressed; of a swept table as much as is certain.
    pub bytes_saved: u64,
}

/// How long a stage took.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StageTime {
    /// `source`, `mesh`, `curvature`, `forms`, `points`, `bounds`, `horizon`, `encode`, `write`, `sky`, `measure`, `hemisphere`,
    /// `starts`, `cone_map`, `relaxed_cone_map`, `maximum_mip` or `checksum`, if there was anything to do; the CLI adds `save`.
    pub stage: &'static str,
    /// Wall-clock seconds.
    pub seconds: f64,
}

/// All that a report is made of.
pub(crate) struct Facts<'a> {
    pub(crate) plan: &'a Plan,
    pub(crate) inputs: &'a Inputs,
    pub(crate) written: &'a [WrittenTable],
    pub(crate) curvature: Option<&'a WrittenCurvature>,
    pub(crate) provenance: Provenance,
    pub(crate) threads: usize,
}

impl Facts<'_> {
    pub(crate) fn report<W>(self, finished: &Finished<W>, stages: Vec<StageTime>) -> BakeReport {
        let Inputs { relief, mesh } = self.inputs;
        let seconds_of = |name: &str| stages.iter().find(|stage| stage.stage == name).map(|stage| stage.seconds);
        let per_second =
            |amount: Option<f64>, stage| amount.zip(seconds_of(stage)).map(|(work, time)| work / 1e6 / time);
        let swept = self
            .provenance
            .horizon
            .as_ref()
            .zip(relief.as_ref())
            .map(|(horizon, loaded)| loaded.field.grid().texels() as f64 * f64::from(horizon.directions));
        let rays = self.hemisphere_rays();
        let vertices = mesh.as_ref().map(|mesh| mesh.report.vertices as f64);
        BakeReport {
            schema: BAKE_SCHEMA,
            source: relief.as_ref().map(|loaded| loaded.words.clone()),
            filled_texels: relief.as_ref().map_or(0, |loaded| loaded.filled_texels),
            grid: relief.as_ref().map(|loaded| grid_report(&loaded.field)),
            mesh: mesh.as_ref().map(|mesh| mesh.report.clone()),
            tables: self.tables(&finished.stored_lengths),
            left_out: self.left_out(),
            mtexel_directions_per_second: per_second(swept, "horizon"),
            mrays_per_second: per_second(rays, "hemisphere"),
            mvertices_per_second: per_second(vertices, "curvature"),
            horizon: self.provenance.horizon,
            swept: self.provenance.swept,
            relief_search: self.provenance.relief_search,
            curvature: self.provenance.curvature,
            stages,
            threads: self.threads,
            file_bytes: finished.bytes,
            identity: finished.identity.iter().map(|byte| format!("{byte:02x}")).collect(),
        }
    }

    fn hemisphere_rays(&self) -> Option<f64> {
        let hemisphere = self.provenance.relief_search.as_ref()?.hemisphere.as_ref()?;
        let texels = self.inputs.relief.as_ref()?.field.grid().texels() as f64;
        Some(texels * f64::from(hemisphere.rings) * f64::from(hemisphere.azimuths))
    }

    fn tables(&self, stored_lengths: &[(SectionKind, u64)]) -> Vec<TableReport> {
        let report = |planned: &PlannedTable| {
            let stored = stored_lengths.iter().find(|(kind, _)| *kind == planned.table.kind());
            let stored = stored.map_or(0, |(_, bytes)| *bytes);
            if planned.table == Table::Curvature {
                return self.curvature.map(|curvature| curvature_report(curvature, stored, planned.reason));
            }
            let written = self.written.iter().find(|written| written.table == planned.table)?;
            Some(table_report(written, stored, planned.reason))
        };
        self.plan.tables.iter().filter_map(report).collect()
    }

    /// Tables that are not there, and parts of the one that is.
    fn left_out(&self) -> Vec<LeftOut> {
        let Inputs { relief, mesh } = self.inputs;
        let textures = relief.iter().flat_map(|loaded| {
            let planned = self.plan.tables.iter().filter(|planned| !planned.table.is_of_a_mesh());
            planned.filter_map(|planned| self.texture_left_out(planned, &loaded.field))
        });
        let vertices = mesh.as_ref().map_or(0, |mesh| mesh.report.vertices);
        let encoding = self.plan.recipe.curvature.encoding;
        let part_left_out = |(part, reason): &(CurvaturePart, &'static str)| LeftOut {
            table: part.full_name(),
            reason,
            bytes_saved: vertices * part.vertex_bytes(encoding),
        };
        let curvature = self.plan.left_out(Table::Curvature).map(|reason| LeftOut {
            table: Table::Curvature.name(),
            reason,
            bytes_saved: vertices * CurvaturePart::Principal.vertex_bytes(encoding),
        });
        let parts = self.curvature.iter().flat_map(|curvature| &curvature.left_out).map(part_left_out);
        textures.chain(curvature).chain(parts).collect()
    }

    fn texture_left_out(&self, planned: &PlannedTable, field: &HeightField) -> Option<LeftOut> {
        let PlannedTable { table, decision, reason } = *planned;
        if self.written.iter().any(|written| written.table == table) {
            return None;
        }
        let reason = match decision {
            Decision::LeaveOut | Decision::NoInput => reason,
            Decision::Bake => FLAT_ALONE,
        };
        let bytes_saved = self.plan.tight_bytes(table, field.grid())?;
        Some(LeftOut { table: table.name(), reason, bytes_saved })
    }
}

fn table_report(written: &WrittenTable, stored_bytes: u64, reason: &'static str) -> TableReport {
    let WrittenTable { table, descriptor, loss } = written;
    TableReport {
        table: table.name(),
        format: descriptor.format.name(),
        layers: descriptor.layers,
        rings: descriptor.rings,
        candidates: descriptor.candidates,
        mips: descriptor.mips,
        stored_bytes,
        raw_bytes: descriptor.payload_length(),
        worst_case_error: descriptor.worst_case_error,
        encoding_rms: loss.rms,
        encoding_max: loss.max,
        unit: descriptor.unit.symbol(),
        reason,
        columns: Vec::new(),
    }
}

/// The errors of the table are those of its curvatures.
fn curvature_report(curvature: &WrittenCurvature, stored_bytes: u64, reason: &'static str) -> TableReport {
    let columns: Vec<_> = curvature
        .columns()
        .map(|(layout, loss)| ColumnReport {
            column: layout.column.name(),
            format: layout.format.name(),
            raw_bytes: u64::from(curvature.encoded.descriptor().vertices()) * u64::from(layout.format.stride()),
            worst_case_error: layout.worst_case_error.into(),
            encoding_rms: loss.rms,
            encoding_max: loss.max,
            unit: column_unit(layout.column, curvature.encoded.descriptor().length_unit()),
        })
        .collect();
    // Every table has the column, and it comes first.
    let ColumnReport { format, worst_case_error, encoding_rms, encoding_max, unit, .. } = columns[0];
    TableReport {
        table: Table::Curvature.name(),
        format,
        layers: 1,
        rings: 0,
        candidates: 0,
        mips: 1,
        stored_bytes,
        raw_bytes: curvature.encoded.descriptor().payload_length(),
        worst_case_error,
        encoding_rms,
        encoding_max,
        unit,
        reason,
        columns,
    }
}

fn grid_report(field: &HeightField) -> GridReport {
    let grid = field.grid();
    let (lowest, highest) = field.range();
    GridReport {
        width: grid.width,
        height: grid.height,
        spacing_u: grid.spacing.u(),
        spacing_v: grid.spacing.v(),
        unit: grid.unit.symbol(),
        edge: grid.edge.name(),
        lowest,
        highest,
    }
}
