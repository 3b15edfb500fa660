//! What will be baked, what is left out, and why.

use barchan_asset::{Encoding, Format, Semantic};
use barchan_bakers::horizon::Azimuths;
use barchan_bakers::sky::MIN_SKY_DIRECTIONS;
use barchan_bakers::swept::SweptParams;
use barchan_field::Grid;

use crate::{HemisphereMode, HorizonRecipe, PipelineError, Recipe, ReliefMapping, ReliefSearch, Scene, Table};

/// A recipe with a decision for every table.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// What was asked for.
    pub recipe: Recipe,
    /// One entry for every table there is, in the order of the file.
    pub tables: Vec<PlannedTable>,
}

/// A table and what becomes of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlannedTable {
    /// The table.
    pub table: Table,
    /// Baked or left out.
    pub decision: Decision,
    /// Why, as a clause for people.
    pub reason: &'static str,
}

/// What becomes of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Decision {
    /// It goes into the file.
    Bake,
    /// The scene does not need it.
    LeaveOut,
    /// The recipe has nothing to bake it from.
    NoInput,
}

impl Decision {
    /// `bake`, `leave_out` or `no_input`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Bake => "bake",
            Self::LeaveOut => "leave_out",
            Self::NoInput => "no_input",
        }
    }
}

/// Why a table that was asked for is left out after all.
pub(crate) const FLAT_ALONE: &str = "the flat horizon alone keeps the error asked for";

impl Plan {
    /// Decides on every table. `only`, where given, overrides the scene, but not what there is to bake from.
    #[must_use]
    pub fn new(recipe: Recipe, only: Option<&[Table]>) -> Self {
        let decide = |table| {
            let (decision, reason) = match only {
                Some(chosen) if chosen.contains(&table) => (Decision::Bake, "named by --only"),
                _ if !has_input(&recipe, table) => (Decision::NoInput, missing_input(table)),
                Some(_) => (Decision::LeaveOut, "not named by --only"),
                None => decide(table, &recipe),
            };
            PlannedTable { table, decision, reason }
        };
        Self { tables: Table::ALL.map(decide).to_vec(), recipe }
    }

    /// Whether a table goes into the file.
    #[must_use]
    pub fn bakes(&self, table: Table) -> bool {
        self.tables.iter().any(|planned| planned.table == table && planned.decision == Decision::Bake)
    }

    /// Whether horizons are looked for.
    #[must_use]
    pub fn needs_horizon(&self) -> bool {
        self.bakes_any(Table::is_of_horizons)
    }

    /// Whether tables are baked by which rays find their hit.
    #[must_use]
    pub fn serves_relief_search(&self) -> bool {
        self.bakes_any(Table::is_for_relief_search)
    }

    fn bakes_any(&self, is_meant: impl Fn(Table) -> bool) -> bool {
        Table::ALL.into_iter().any(|table| is_meant(table) && self.bakes(table))
    }

    /// Refuses to bake a table from nothing.
    ///
    /// # Errors
    /// The first such table.
    pub(crate) fn check(&self) -> Result<(), PipelineError> {
        let baseless = |table: &Table| self.bakes(*table) && !has_input(&self.recipe, *table);
        match Table::ALL.into_iter().find(baseless) {
            Some(table) => Err(PipelineError::NoInput { table: table.name(), missing: missing_input(table) }),
            None => Ok(()),
        }
    }

    /// The range of curvatures that the scene names.
    #[must_use]
    pub fn curvature(&self) -> Option<(f64, f64)> {
        self.recipe.scene.and_then(|scene| scene.curvature)
    }

    /// Whether the range of curvatures is that of the mesh: somebody has to name it, and the scene does not.
    #[must_use]
    pub fn sweeps_over_mesh(&self) -> bool {
        self.recipe.mesh.is_some() && self.curvature().is_none() && self.swept_table().is_some()
    }

    /// Whether anything is baked from the mesh.
    #[must_use]
    pub(crate) fn looks_at_mesh(&self) -> bool {
        self.recipe.mesh.is_some() && (self.bakes(Table::Curvature) || self.sweeps_over_mesh())
    }

    /// From where rays come: what the scene says of relief mapping, or what is taken where nobody says.
    #[must_use]
    pub fn relief_mapping(&self) -> ReliefMapping {
        self.recipe.scene.and_then(|scene| scene.relief_mapping).unwrap_or_default()
    }

    fn swept_table(&self) -> Option<Table> {
        Table::ALL.into_iter().find(|&table| table.is_swept() && self.bakes(table))
    }

    /// What to bake over a range of curvatures, if a swept table is wanted.
    ///
    /// # Errors
    /// A swept table without a range.
    pub(crate) fn swept_params(&self, range: Option<(f64, f64)>) -> Result<Option<SweptParams>, PipelineError> {
        let Some(table) = self.swept_table() else { return Ok(None) };
        let range = range.ok_or(PipelineError::NoCurvature { table: table.name() })?;
        Ok(Some(self.recipe.curved.params(range)))
    }

    /// Why the scene does without a table that could be baked; `None` if it is baked or cannot be.
    pub(crate) fn left_out(&self, table: Table) -> Option<&'static str> {
        let planned = self.tables.iter().find(|planned| planned.table == table)?;
        (planned.decision == Decision::LeaveOut).then_some(planned.reason)
    }

    /// How many texels a texture has or would have for heights on a grid, all layers and levels together; of a swept table as many
    /// as are certain.
    pub(crate) fn texels(&self, table: Table, grid: &Grid) -> u64 {
        let Recipe { horizon, curved, hemisphere, .. } = &self.recipe;
        let texels = grid.texels() as u64;
        let layers = texels.saturating_mul(horizon.directions.into());
        match table {
            Table::Horizon | Table::Distance => layers,
            table if table.is_swept() => layers.saturating_mul(curved.points.unwrap_or(2).saturating_sub(1).into()),
            Table::Hemisphere => {
                let (width, height) = hemisphere.size_for(grid.width, grid.height);
                let factors = [width, height, hemisphere.rings, hemisphere.azimuths];
                factors.into_iter().map(u64::from).fold(1, u64::saturating_mul)
            }
            Table::MaximumMip => {
                let extent = |texels: u32, level| u64::from(texels >> level).max(1);
                let levels = 0..=grid.width.max(grid.height).ilog2();
                levels.map(|level| extent(grid.width, level) * extent(grid.height, level)).sum()
            }
            _ => texels,
        }
    }

    /// What a texture takes or would take, not counting what aligns it; `None` of what is no texture.
    pub(crate) fn tight_bytes(&self, table: Table, grid: &Grid) -> Option<u64> {
        let texel_bytes = self.format(table)?.texel_bytes();
        Some(self.texels(table, grid).saturating_mul(texel_bytes.into()))
    }

    /// The format of a texture's texels; `None` of what is no texture.
    pub(crate) fn format(&self, table: Table) -> Option<Format> {
        Semantic::of_kind(table.kind()).map(|semantic| self.encoding(table).format(semantic))
    }

    /// How a table is stored, or would be.
    #[must_use]
    pub fn encoding(&self, table: Table) -> Encoding {
        let Recipe { height, horizon, distance, curved, sky, hemisphere, cone_map, maximum_mip, curvature, .. } =
            &self.recipe;
        match table {
            Table::Height => height.encoding.into(),
            Table::Horizon => horizon.encoding.into(),
            Table::Distance => distance.encoding.into(),
            Table::SweptHorizon | Table::SweptDistance => curved.encoding.into(),
            Table::SkyVisibility | Table::BentNormal | Table::ApertureCone => sky.encoding.into(),
            Table::Hemisphere => hemisphere.encoding.into(),
            Table::ConeMap | Table::RelaxedConeMap => cone_map.encoding.into(),
            Table::MaximumMip => maximum_mip.encoding.into(),
            Table::Curvature => curvature.encoding.into(),
        }
    }
}

type Reasoned = (Decision, &'static str);

fn has_input(recipe: &Recipe, table: Table) -> bool {
    if table.is_of_a_mesh() { recipe.mesh.is_some() } else { recipe.source.is_some() }
}

fn missing_input(table: Table) -> &'static str {
    if table.is_of_a_mesh() { "there is no mesh" } else { "there is no height map" }
}

fn decide(table: Table, recipe: &Recipe) -> Reasoned {
    let Recipe { scene, horizon, hemisphere, mesh, .. } = recipe;
    match table {
        Table::Height => (Decision::Bake, "the surface itself"),
        Table::Horizon => (Decision::Bake, "shadows"),
        Table::Distance if mesh.is_some() => (Decision::Bake, "corrects the horizon on the curved mesh"),
        Table::Distance => decide_distance(*scene),
        Table::SweptHorizon | Table::SweptDistance => decide_swept(*scene, mesh.is_some()),
        Table::SkyVisibility | Table::BentNormal | Table::ApertureCone => match scene {
            Some(scene) => decide_sky(table, *scene),
            None => decide_sky_of_a_bare_map(table, horizon),
        },
        Table::Hemisphere | Table::ConeMap | Table::RelaxedConeMap | Table::MaximumMip => match scene {
            None => (Decision::LeaveOut, "no recipe says that rays are followed to the relief"),
            Some(Scene { relief_mapping: None, .. }) => (Decision::LeaveOut, "the scene has no relief mapping"),
            Some(Scene { relief_mapping: Some(mapping), .. }) => decide_relief_search(table, *mapping, hemisphere.mode),
        },
        Table::Curvature => (Decision::Bake, "what the mesh is there for"),
    }
}

fn decide_distance(scene: Option<Scene>) -> Reasoned {
    use Decision::{Bake, LeaveOut};
    match scene {
        None => (Bake, "no recipe says that the scene does without it"),
        Some(scene) if scene.is_curved() => (Bake, "corrects the horizon on curved surfaces"),
        Some(Scene { soft_shadows: true, .. }) => (Bake, "sizes penumbrae"),
        Some(_) => (LeaveOut, "the scene has no curved surfaces and no soft shadows"),
    }
}

fn decide_swept(scene: Option<Scene>, has_mesh: bool) -> Reasoned {
    use Decision::{Bake, LeaveOut};
    match scene {
        Some(Scene { curvature: Some(_), .. }) => (Bake, "keeps the horizon right over the range of curvatures"),
        _ if has_mesh => (Bake, "keeps the horizon right over the curvatures of the mesh"),
        None => (LeaveOut, "no recipe says between which curvatures"),
        Some(scene) if scene.is_curved() => (LeaveOut, "the scene does not say between which curvatures"),
        Some(_) => (LeaveOut, "the scene has no curved surfaces"),
    }
}

fn decide_sky(table: Table, scene: Scene) -> Reasoned {
    use Decision::{Bake, LeaveOut};
    match table {
        Table::ApertureCone if scene.area_lights => (Bake, "cuts area lights"),
        Table::ApertureCone => (LeaveOut, "the scene has no area lights"),
        Table::BentNormal if scene.ambient_light => (Bake, "turns the light of the sky"),
        _ if scene.ambient_light => (Bake, "dims the light of the sky"),
        _ => (LeaveOut, "the scene has no ambient light"),
    }
}

/// What is small beside the horizon is baked, if the azimuths allow it.
fn decide_sky_of_a_bare_map(table: Table, horizon: &HorizonRecipe) -> Reasoned {
    use Decision::{Bake, LeaveOut};
    match (table, horizon.azimuths()) {
        (Table::ApertureCone, _) => (LeaveOut, "no recipe says that the scene has area lights"),
        (_, Azimuths::Arc { .. }) => (LeaveOut, "an arc of azimuths does not see all of the sky"),
        (_, Azimuths::FullCircle { count }) if count < MIN_SKY_DIRECTIONS => {
            (LeaveOut, "fewer than 3 azimuths do not see all of the sky")
        }
        _ => (Bake, "no recipe says that the scene does without it"),
    }
}

/// Every search may start where the hemisphere table says; each has one table of its own, or none.
fn decide_relief_search(table: Table, mapping: ReliefMapping, mode: HemisphereMode) -> Reasoned {
    use Decision::{Bake, LeaveOut};
    let (own, reason) = match mapping.search {
        ReliefSearch::ConeSteps => (Some(Table::ConeMap), "the search is by cone steps"),
        ReliefSearch::RelaxedConeSteps => (Some(Table::RelaxedConeMap), "the search is by relaxed cone steps"),
        ReliefSearch::MaximumMip => (Some(Table::MaximumMip), "the search is by maximum mips"),
        ReliefSearch::Linear => (None, "the search is by steps of one length"),
    };
    match (table, mode) {
        (Table::Hemisphere, HemisphereMode::Conservative) => (Bake, "starts rays where none has hit before"),
        (Table::Hemisphere, HemisphereMode::Nearest) => (Bake, "starts rays near their hits, some beyond"),
        _ if own == Some(table) => (Bake, reason),
        _ => (LeaveOut, reason),
    }
}
