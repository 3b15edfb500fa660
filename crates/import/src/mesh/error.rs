//! What only a mesh can have wrong. Vertices and faces count from 0, lines from 1.

use thiserror::Error;

use crate::{Format, error::number};

/// Why the content of a file did not become a mesh.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MeshError {
    /// A line of a text contradicts the format or the rest of the file.
    #[error("the {format} file is damaged at line {line}: {reason}")]
    Line {
        /// The format.
        format: Format,
        /// The line, counted from 1.
        line: u64,
        /// The contradiction.
        reason: String,
    },
    /// A position of an OBJ file that is not finite, or so large that its square would not be.
    #[error("vertex {vertex} (line {line}) has a coordinate of {}; finite numbers up to 1e30 would be accepted", number(*.value))]
    Position {
        /// The vertex, counted from 0.
        vertex: u64,
        /// Its line, counted from 1.
        line: u64,
        /// The offending coordinate.
        value: f64,
    },
    /// A texture coordinate of an OBJ file that is not finite.
    #[error(
        "texture coordinate {index} (line {line}) is {}; finite numbers, or no texture coordinates at all, would be accepted",
        number(*.value)
    )]
    TextureCoordinate {
        /// The `vt`, counted from 0.
        index: u64,
        /// Its line, counted from 1.
        line: u64,
        /// The offending coordinate.
        value: f64,
    },
    /// A corner names a vertex that is not there.
    #[error("face {face} of the {format} file names vertex {vertex}; 0 to {} would be accepted", vertices.saturating_sub(1))]
    Corner {
        /// The format.
        format: Format,
        /// The face, or the triangle of a glTF primitive, counted from 0.
        face: u64,
        /// What it names.
        vertex: i64,
        /// How many vertices there are.
        vertices: u64,
    },
    /// More than the caller accepts.
    #[error("the {format} mesh has {found} {things} or more; `max_{things}` accepts {max}")]
    TooMany {
        /// The format.
        format: Format,
        /// `vertices` or `triangles`.
        things: &'static str,
        /// How many were counted when it was refused.
        found: u64,
        /// The limit.
        max: u64,
    },
    /// A header promises more than the file has bytes for.
    #[error(
        "the {format} file promises {count} of {what}; the {bytes} bytes left for them can hold {possible} at most"
    )]
    Implausible {
        /// The format.
        format: Format,
        /// What is counted.
        what: String,
        /// How many are promised.
        count: u64,
        /// Bytes there are.
        bytes: u64,
        /// How many fit.
        possible: u64,
    },
    /// No surface.
    #[error("the {format} file has no triangle (vertices: {vertices}); a surface of at least one triangle is needed")]
    NoTriangles {
        /// The format.
        format: Format,
        /// Vertices there are.
        vertices: u64,
    },
    /// The mesh asked for is not there.
    #[error("`mesh` is `{wanted}`, which the {format} file does not have; {present} would be accepted")]
    NoSuchMesh {
        /// The format.
        format: Format,
        /// The mesh asked for.
        wanted: String,
        /// The meshes there are.
        present: String,
    },
    /// No mesh was asked for, and there are several.
    #[error("the {format} file does not say which mesh is meant; name `mesh` as one of {present}")]
    WhichMesh {
        /// The format.
        format: Format,
        /// The meshes there are.
        present: String,
    },
    /// A file that the mesh needs beside it cannot be had.
    #[error(
        "the {format} file keeps its numbers in `{name}`, which cannot be read ({reason}); a file beside it, in its folder or below, is needed"
    )]
    External {
        /// The format.
        format: Format,
        /// The file as it is named.
        name: String,
        /// Why not.
        reason: String,
    },
}
