//! A recipe to a plan to an asset.
//!
//! [`Recipe`] is what a person wrote, parsed and spelled out. [`Plan`] is what will be baked, what is left out, and why.
//! [`bake`] carries a plan out and gives the file's bytes with a [`BakeReport`] of what was done, how long it took and how
//! far the result is from the truth. Height maps are read here, through `barchan_import`; nothing is written.

mod accuracy;
mod bake;
mod error;
mod plan;
mod provenance;
mod recipe;
mod report;
mod source;
mod spacing;
mod syntax;
mod table;

pub use accuracy::HorizonAccuracy;
pub use bake::{Baked, Progress, bake};
pub use error::PipelineError;
pub use plan::{Decision, Plan, PlannedTable};
pub use provenance::{CanonicalRecipe, HorizonProvenance, InputProvenance, PROVENANCE_SCHEMA, Provenance};
pub use recipe::{
    Compression, DistanceRecipe, HeightMapSource, HeightRecipe, HorizonRecipe, Recipe, RecipeError, Scene, ShapeSource,
    Source, TableEncoding,
};
pub use report::{BAKE_SCHEMA, BakeReport, GridReport, LeftOut, StageTime, TableReport};
pub use table::Table;
