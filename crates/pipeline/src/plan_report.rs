//! What a plan comes to, for machines; the CLI prints it for people.

use std::path::Path;

use barchan_field::Grid;
use serde::Serialize;

use crate::plan::FLAT_ALONE;
use crate::{
    CurvaturePart, Decision, MeshSource, PipelineError, Plan, PlannedTable, Source, Table, mesh_input, plan_check,
    source,
};

/// Names the layout of [`PlanReport`] as JSON.
pub const PLAN_SCHEMA: &str = "barchan.plan/1";

/// Where pictures of a table begin: multiples of so many bytes.
const PICTURE_ALIGN: u64 = 256;

/// What would be baked, what left out and why, as far as that is known before an input is read.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanReport {
    /// [`PLAN_SCHEMA`].
    pub schema: &'static str,
    /// The height map or shape, in words; `null` where there is none.
    pub source: Option<String>,
    /// The grid of the heights; `null` where there are none, and where only their file says it.
    pub grid: Option<PlannedGrid>,
    /// The mesh, in words; `null` where there is none.
    pub mesh: Option<String>,
    /// Every table there is, in the order of the file.
    pub tables: Vec<TableOutline>,
    /// Inputs that were not looked into: what is wrong in them, and what of the recipe does not fit them, a bake finds.
    pub unread: Vec<String>,
}

/// The grid of heights that a recipe alone determines.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlannedGrid {
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
}

/// A table, what becomes of it, and how it is stored or would be.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TableOutline {
    /// Its name.
    pub table: &'static str,
    /// `bake`, `leave_out` or `no_input`.
    pub decision: &'static str,
    /// Why.
    pub reason: &'static str,
    /// How a texel is stored; of a mesh's curvature, both curvatures of a vertex.
    pub format: &'static str,
    /// Texels along u; `null` where only an input says it, and where there are none.
    pub width: Option<u32>,
    /// Texels along v, likewise.
    pub height: Option<u32>,
    /// Directions times candidates, rings times azimuths, or 1; `null` where a bake finds out how many candidates are needed.
    pub layers: Option<u32>,
    /// Rings around the normal, in a hemisphere table; else 0.
    pub rings: u32,
    /// Points per direction besides the horizon's, in a swept table, `null` where a bake finds out; else 0.
    pub candidates: Option<u32>,
    /// Levels of a mip chain, `null` where only an input says it; else 1.
    pub mips: Option<u32>,
    /// Bytes before packing, or what leaving it out saves, of a swept table as much as is certain; `null` where only an input or a
    /// bake says it.
    pub raw_bytes: Option<u64>,
    /// Bytes for every texel of the heights, all layers together; `null` where that is not known, or not how it is sized.
    pub bytes_per_texel: Option<u64>,
}

impl Plan {
    /// What this plan comes to. Nothing is baked and no input is read; what a bake would refuse without, is refused. Relative paths
    /// start at `folder`.
    ///
    /// # Errors
    /// As those of [`crate::bake()`]: inputs that are not there, parameters out of range, a table from nothing.
    pub fn report(&self, folder: &Path) -> Result<PlanReport, PipelineError> {
        let grid = plan_check::check(self, folder)?;
        let (source, mesh) = (self.recipe.source.as_ref(), self.recipe.mesh.as_ref());
        let source_words = source.map(|source| source::words(source, folder));
        let mesh_words = mesh.map(|mesh| mesh_input::words(mesh, folder));
        let map_file = source_words.clone().filter(|_| matches!(source, Some(Source::HeightMap(_))));
        let mesh_file = mesh_words.clone().filter(|_| matches!(mesh, Some(MeshSource::File(_))));
        Ok(PlanReport {
            schema: PLAN_SCHEMA,
            source: source_words,
            grid: grid.as_ref().map(PlannedGrid::new),
            mesh: mesh_words,
            tables: self.tables.iter().map(|planned| self.outline(planned, grid.as_ref())).collect(),
            unread: map_file.into_iter().chain(mesh_file).collect(),
        })
    }

    fn outline(&self, planned: &PlannedTable, grid: Option<&Grid>) -> TableOutline {
        let PlannedTable { table, mut decision, mut reason } = *planned;
        let candidates = self.candidates(table);
        if decision == Decision::Bake && table.is_swept() && candidates == Some(0) {
            (decision, reason) = (Decision::LeaveOut, FLAT_ALONE);
        }
        let (layers, mips) = (self.layers(table, candidates), mips(table, grid));
        let extent = self.extent(table, grid);
        let format = self.format(table);
        let raw_bytes = match decision {
            Decision::Bake => self.payload(table, extent, layers, mips),
            Decision::LeaveOut => grid.and_then(|grid| self.tight_bytes(table, grid)),
            Decision::NoInput => None,
        };
        let is_per_texel = ![Table::Hemisphere, Table::MaximumMip].contains(&table);
        let per_texel = || Some(u64::from(layers?) * u64::from(format?.texel_bytes()));
        TableOutline {
            table: table.name(),
            decision: decision.name(),
            reason,
            format: format
                .map_or_else(|| CurvaturePart::Principal.format_name(self.recipe.curvature.encoding), |f| f.name()),
            width: extent.map(|(width, _)| width),
            height: extent.map(|(_, height)| height),
            layers,
            rings: if table == Table::Hemisphere { self.recipe.hemisphere.rings } else { 0 },
            candidates,
            mips,
            raw_bytes,
            bytes_per_texel: is_per_texel.then(per_texel).flatten(),
        }
    }

    /// Points per direction besides the horizon's; `None` where a bake finds out.
    fn candidates(&self, table: Table) -> Option<u32> {
        if table.is_swept() { self.recipe.curved.points.map(|points| points.saturating_sub(1)) } else { Some(0) }
    }

    fn layers(&self, table: Table, candidates: Option<u32>) -> Option<u32> {
        let (directions, hemisphere) = (self.recipe.horizon.directions, &self.recipe.hemisphere);
        match table {
            Table::Horizon | Table::Distance => Some(directions),
            Table::SweptHorizon | Table::SweptDistance => candidates.map(|count| directions.saturating_mul(count)),
            Table::Hemisphere => Some(hemisphere.rings.saturating_mul(hemisphere.azimuths)),
            _ => Some(1),
        }
    }

    /// Texels along u and v.
    fn extent(&self, table: Table, grid: Option<&Grid>) -> Option<(u32, u32)> {
        let hemisphere = &self.recipe.hemisphere;
        match table {
            Table::Curvature => None,
            Table::Hemisphere => hemisphere.size.or(grid.map(|grid| hemisphere.size_for(grid.width, grid.height))),
            _ => grid.map(|grid| (grid.width, grid.height)),
        }
    }

    /// Bytes of all layers or levels, padded between but not behind the last.
    fn payload(&self, table: Table, extent: Option<(u32, u32)>, layers: Option<u32>, mips: Option<u32>) -> Option<u64> {
        let (width, height) = extent?;
        let texel_bytes = u64::from(self.format(table)?.texel_bytes());
        let picture = |level: u32| {
            let texels = |along: u32| u64::from(along.checked_shr(level).unwrap_or(0).max(1));
            texels(width).saturating_mul(texels(height)).saturating_mul(texel_bytes)
        };
        let aligned = |level: u32| picture(level).checked_next_multiple_of(PICTURE_ALIGN).unwrap_or(u64::MAX);
        let last = mips?.saturating_sub(1);
        let levels = (0..last).map(aligned).fold(0, u64::saturating_add);
        let further_layers = aligned(0).saturating_mul(u64::from(layers?).saturating_sub(1));
        Some(levels.saturating_add(further_layers).saturating_add(picture(last)))
    }
}

/// Levels of a mip chain down to one texel.
fn mips(table: Table, grid: Option<&Grid>) -> Option<u32> {
    match table {
        Table::MaximumMip => grid.map(|grid| grid.width.max(grid.height).max(1).ilog2() + 1),
        _ => Some(1),
    }
}

impl PlannedGrid {
    fn new(grid: &Grid) -> Self {
        Self {
            width: grid.width,
            height: grid.height,
            spacing_u: grid.spacing.u(),
            spacing_v: grid.spacing.v(),
            unit: grid.unit.symbol(),
            edge: grid.edge.name(),
        }
    }
}
