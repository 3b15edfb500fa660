//! A triangle mesh: positions, triangles, and what a file says of texture coordinates and normals.

use glam::{DVec2, DVec3};

use crate::FieldError;

/// A triangle mesh whose positions are finite and whose triangles name vertices that exist. Vertices keep the order in which they
/// were given, used or not; two may lie at one place, as at the seam of a texture.
///
/// The front of a triangle is the side from which its corners run counter-clockwise. Texture coordinates are (u, v), v up the
/// picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    uvs: Option<Vec<DVec2>>,
    normals: Option<Vec<DVec3>>,
}

impl Mesh {
    /// A mesh without texture coordinates and normals.
    ///
    /// # Errors
    /// A position that is not finite or beyond ±1e30, a triangle that names a vertex that does not exist, or more than `u32::MAX` vertices.
    pub fn new(positions: Vec<DVec3>, triangles: Vec<[u32; 3]>) -> Result<Self, FieldError> {
        if u32::try_from(positions.len()).is_err() {
            return Err(FieldError::VertexCount { found: positions.len() as u64 });
        }
        for (vertex, position) in positions.iter().enumerate() {
            // Squares of lengths stay far inside f64.
            let offending = position.to_array().into_iter().find(|coordinate| !(-1e30..=1e30).contains(coordinate));
            if let Some(value) = offending {
                return Err(FieldError::VertexPosition { vertex: vertex as u64, value });
            }
        }
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|&&vertex| vertex as usize >= positions.len()) {
                let vertices = positions.len() as u64;
                return Err(FieldError::TriangleCorner { triangle: triangle as u64, vertex, vertices });
            }
        }
        Ok(Self { positions, triangles, uvs: None, normals: None })
    }

    /// The mesh with texture coordinates, one pair per vertex.
    ///
    /// # Errors
    /// Another number of them, or one that is not finite.
    pub fn with_uvs(mut self, uvs: Vec<DVec2>) -> Result<Self, FieldError> {
        self.check_attribute("texture coordinates", uvs.len(), |vertex| uvs[vertex].is_finite())?;
        self.uvs = Some(uvs);
        Ok(self)
    }

    /// The mesh with normals as a file states them, one per vertex, of any length; they say where edges are hard. One of
    /// no length says nothing.
    ///
    /// # Errors
    /// Another number of them, or one that is not finite.
    pub fn with_normals(mut self, normals: Vec<DVec3>) -> Result<Self, FieldError> {
        self.check_attribute("normals", normals.len(), |vertex| normals[vertex].is_finite())?;
        self.normals = Some(normals);
        Ok(self)
    }

    fn check_attribute(
        &self,
        attribute: &'static str,
        found: usize,
        is_finite: impl Fn(usize) -> bool,
    ) -> Result<(), FieldError> {
        let expected = self.positions.len();
        if found != expected {
            return Err(FieldError::AttributeCount { attribute, found: found as u64, expected: expected as u64 });
        }
        match (0..expected).find(|&vertex| !is_finite(vertex)) {
            Some(vertex) => Err(FieldError::AttributeNotFinite { attribute, vertex: vertex as u64 }),
            None => Ok(()),
        }
    }

    /// Positions, in the order of the file.
    #[must_use]
    pub fn positions(&self) -> &[DVec3] {
        &self.positions
    }

    /// Three vertices each, counter-clockwise seen from the front.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Texture coordinates, if there are any.
    #[must_use]
    pub fn uvs(&self) -> Option<&[DVec2]> {
        self.uvs.as_deref()
    }

    /// Normals as given, if there are any.
    #[must_use]
    pub fn normals(&self) -> Option<&[DVec3]> {
        self.normals.as_deref()
    }
}
