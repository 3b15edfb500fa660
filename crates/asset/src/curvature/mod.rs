//! Curvature per vertex of a mesh.

mod flags;

pub use flags::VertexFlags;
