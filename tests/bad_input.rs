//! Whatever is wrong is said in one sentence that names the file, the field, the value and what would be accepted, with the
//! exit code of whoever must act: usage 1, bad input 2, system 4. What was there before stays.

#[path = "bad_input/height_map.rs"]
mod height_map;
#[path = "bad_input/mesh.rs"]
mod mesh;
#[path = "bad_input/mutations.rs"]
mod mutations;
#[path = "bad_input/output.rs"]
mod output;
#[path = "bad_input/plan.rs"]
mod plan;
#[path = "bad_input/recipe.rs"]
mod recipe;
mod support;
#[path = "bad_input/usage.rs"]
mod usage;
