//! What will be baked, what is left out, and why.

use barchan_bakers::horizon::Azimuths;
use barchan_bakers::sky::MIN_SKY_DIRECTIONS;
use barchan_bakers::swept::SweptParams;

use crate::{HorizonRecipe, PipelineError, Recipe, Scene, Table, TableEncoding};

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
}

impl Plan {
    /// Decides on every table. `only`, where given, overrides the scene.
    #[must_use]
    pub fn new(recipe: Recipe, only: Option<&[Table]>) -> Self {
        let decide = |table| {
            let (decision, reason) = match only {
                Some(chosen) if chosen.contains(&table) => (Decision::Bake, "named by --only"),
                Some(_) => (Decision::LeaveOut, "not named by --only"),
                None => decide(table, recipe.scene, &recipe.horizon),
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

    /// Whether horizons are looked for: all tables but the heights come from them.
    #[must_use]
    pub fn needs_horizon(&self) -> bool {
        Table::ALL.into_iter().any(|table| table != Table::Height && self.bakes(table))
    }

    /// The range of curvatures that the scene names.
    #[must_use]
    pub fn curvature(&self) -> Option<(f64, f64)> {
        self.recipe.scene.and_then(|scene| scene.curvature)
    }

    /// What to bake over the range of curvatures, if a swept table is wanted.
    ///
    /// # Errors
    /// A swept table without a range.
    pub(crate) fn swept_params(&self) -> Result<Option<SweptParams>, PipelineError> {
        let Some(table) = Table::ALL.into_iter().find(|&table| table.is_swept() && self.bakes(table)) else {
            return Ok(None);
        };
        let range = self.curvature().ok_or(PipelineError::NoCurvature { table: table.name() })?;
        Ok(Some(self.recipe.curved.params(range)))
    }

    /// How a table is stored, or would be.
    #[must_use]
    pub fn encoding(&self, table: Table) -> TableEncoding {
        let Recipe { height, horizon, distance, curved, sky, .. } = &self.recipe;
        match table {
            Table::Height => height.encoding,
            Table::Horizon => horizon.encoding,
            Table::Distance => distance.encoding,
            Table::SweptHorizon | Table::SweptDistance => curved.encoding,
            Table::SkyVisibility | Table::BentNormal | Table::ApertureCone => sky.encoding,
        }
    }
}

type Reasoned = (Decision, &'static str);

fn decide(table: Table, scene: Option<Scene>, horizon: &HorizonRecipe) -> Reasoned {
    match table {
        Table::Height => (Decision::Bake, "the surface itself"),
        Table::Horizon => (Decision::Bake, "shadows"),
        Table::Distance => decide_distance(scene),
        Table::SweptHorizon | Table::SweptDistance => decide_swept(scene),
        Table::SkyVisibility | Table::BentNormal | Table::ApertureCone => match scene {
            Some(scene) => decide_sky(table, scene),
            None => decide_sky_of_a_bare_map(table, horizon),
        },
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

fn decide_swept(scene: Option<Scene>) -> Reasoned {
    use Decision::{Bake, LeaveOut};
    match scene {
        None => (LeaveOut, "no recipe says between which curvatures"),
        Some(Scene { curvature: Some(_), .. }) => (Bake, "keeps the horizon right over the range of curvatures"),
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
