//! What the caller decides.

use barchan_field::LengthUnit;

use crate::{DecodeError, Format, MeshError};

/// What turns a file into a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshOptions {
    /// What positions are measured in; a label that changes no number. `None` takes what the format says: metres in
    /// glTF, else the scene's own unit.
    pub unit: Option<LengthUnit>,
    /// Which mesh of a glTF file: its name, or its number counted from 0. `None` takes the only one. OBJ and PLY hold
    /// one mesh.
    pub mesh: Option<String>,
    /// The most vertices to accept.
    pub max_vertices: u64,
    /// The most triangles to accept.
    pub max_triangles: u64,
}

impl Default for MeshOptions {
    /// The only mesh there is, in the format's unit; 2²⁷ vertices, 2²⁸ triangles.
    fn default() -> Self {
        Self { unit: None, mesh: None, max_vertices: 1 << 27, max_triangles: 1 << 28 }
    }
}

impl MeshOptions {
    /// Refuses more vertices than asked for, or than an index can name.
    pub(crate) fn check_vertices(&self, format: Format, found: u64) -> Result<(), DecodeError> {
        // u32::MAX itself stands for "none".
        check(format, "vertices", found, self.max_vertices.min(u64::from(u32::MAX) - 1))
    }

    pub(crate) fn check_triangles(&self, format: Format, found: u64) -> Result<(), DecodeError> {
        check(format, "triangles", found, self.max_triangles)
    }
}

fn check(format: Format, things: &'static str, found: u64, max: u64) -> Result<(), DecodeError> {
    if found > max {
        return Err(MeshError::TooMany { format, things, found, max }.into());
    }
    Ok(())
}
