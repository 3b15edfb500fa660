//! Relief on curved surfaces: its functions one by one, whole maps, and curvature that comes from a mesh.

mod draw;
mod equations;
mod maps;
mod mesh;
mod tangent;
