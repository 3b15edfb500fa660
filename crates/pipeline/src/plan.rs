//! What will be baked, what is left out, and why.

use crate::{Recipe, Scene, Table};

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
                None => decide(table, recipe.scene),
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
}

fn decide(table: Table, scene: Option<Scene>) -> (Decision, &'static str) {
    use Decision::{Bake, LeaveOut};
    match (table, scene) {
        (Table::Height, _) => (Bake, "the surface itself"),
        (Table::Horizon, _) => (Bake, "shadows"),
        (Table::Distance, None) => (Bake, "no recipe says that the scene does without it"),
        (Table::Distance, Some(Scene { curved_surfaces: true, .. })) => {
            (Bake, "corrects the horizon on curved surfaces")
        }
        (Table::Distance, Some(Scene { soft_shadows: true, .. })) => (Bake, "sizes penumbrae"),
        (Table::Distance, Some(_)) => (LeaveOut, "the scene has no curved surfaces and no soft shadows"),
    }
}
