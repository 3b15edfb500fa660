//! The whole road: a height map, a mesh or a recipe in, a file out, and everything that can be done with the file.

#[path = "end_to_end/bake.rs"]
mod bake;
#[path = "end_to_end/compare.rs"]
mod compare;
#[path = "end_to_end/dump.rs"]
mod dump;
#[path = "end_to_end/gpu.rs"]
mod gpu;
#[path = "end_to_end/height_map.rs"]
mod height_map;
#[path = "end_to_end/mesh.rs"]
mod mesh;
#[path = "end_to_end/mesh_dump.rs"]
mod mesh_dump;
#[path = "end_to_end/plan.rs"]
mod plan;
#[path = "end_to_end/relief_search.rs"]
mod relief_search;
#[path = "end_to_end/relief_view.rs"]
mod relief_view;
#[path = "end_to_end/render.rs"]
mod render;
#[path = "end_to_end/samples.rs"]
mod samples;
mod support;
