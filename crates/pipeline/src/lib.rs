//! A recipe to a plan to an asset.
//!
//! [`Recipe`] is what a person wrote, parsed and spelled out. [`Plan`] is what will be baked, what is left out, and why,
//! which [`Plan::report`] says, and checks as far as that is possible, before an input is read.
//! [`bake()`] carries a plan out: it writes a file, direction by direction, into whatever it is given, and returns a
//! [`BakeReport`] of what was done, how long it took and how far the result is from the truth. Height maps are read here,
//! through `barchan_import`; no file is opened for writing.

mod accuracy;
mod bake;
mod bounds;
mod clock;
mod curvature;
mod curvature_part;
mod directions;
mod error;
mod layout;
mod mesh_input;
mod mesh_provenance;
mod mesh_recipe;
mod pair;
mod plan;
mod plan_check;
mod plan_report;
mod provenance;
mod recipe;
mod relief;
mod relief_recipe;
mod relief_search;
mod report;
mod scene;
mod search_params;
mod search_provenance;
mod search_recipe;
mod sink;
mod source;
mod spacing;
mod start_accuracy;
mod swept_range;
mod syntax;
mod table;

pub use accuracy::HorizonAccuracy;
pub use bake::{Baked, Progress, Run, bake};
pub use curvature_part::CurvaturePart;
pub use error::PipelineError;
pub use mesh_input::{MeshInput, generate_mesh, read_mesh_file};
pub use mesh_provenance::{CurvatureProvenance, FlagCount, MendedMesh, MeshOrigin, MeshProvenance};
pub use mesh_recipe::{CurvatureEncoding, CurvatureMethod, CurvatureRecipe, MeshFile, MeshSource, SurfaceSource};
pub use plan::{Decision, Plan, PlannedTable};
pub use plan_report::{PLAN_SCHEMA, PlanReport, PlannedGrid, TableOutline};
pub use provenance::{
    CanonicalRecipe, EncodingProvenance, HorizonProvenance, InputProvenance, PROVENANCE_SCHEMA, Provenance,
    SkyProvenance, SweptProvenance,
};
pub use recipe::{Compression, HeightMapSource, Recipe, RecipeError, ShapeSource, Source};
pub use relief_recipe::{
    CurvedRecipe, DistanceRecipe, HeightRecipe, HorizonMethod, HorizonRecipe, SkyRecipe, TableEncoding,
};
pub use report::{BAKE_SCHEMA, BakeReport, ColumnReport, GridReport, LeftOut, MeshReport, StageTime, TableReport};
pub use scene::{ReliefMapping, ReliefSearch, Scene};
pub use search_provenance::{HemisphereProvenance, ReliefSearchProvenance};
pub use search_recipe::{ConeMapRecipe, HemisphereMode, HemisphereRecipe, HemisphereSpacing, MaximumMipRecipe};
pub use start_accuracy::StartAccuracy;
pub use swept_range::MeshRange;
pub use table::Table;
