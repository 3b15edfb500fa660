//! A curvature table as numbers.

use crate::bytes::{CHUNK_ALIGN, array_at, u16_at, u32_at};
use crate::half::f16_to_f32;
use crate::{ColumnLayout, CurvatureColumn, CurvatureDescriptor, CurvatureError, SurfaceForms, VertexFlags};

/// A descriptor and its decoded payload, checked once to belong together.
///
/// # Decoding
/// A float is the value; a half is multiplied by the column's scale, a power of two, in f32.
///
/// # Trust
/// The payload's numbers are not looked at here. A hostile file can hold NaN, directions that are none, or a first form
/// that is not positive: `validate` tells.
#[derive(Debug, Clone, Copy)]
pub struct CurvatureView<'a> {
    descriptor: CurvatureDescriptor,
    payload: &'a [u8],
}

impl<'a> CurvatureView<'a> {
    /// `payload` is the decoded payload of the section that `descriptor` came from.
    ///
    /// # Errors
    /// A payload of another length than vertices and columns ask for.
    pub fn new(descriptor: CurvatureDescriptor, payload: &'a [u8]) -> Result<Self, CurvatureError> {
        let (found, expected) = (payload.len() as u64, descriptor.payload_length());
        if found != expected {
            return Err(CurvatureError::PayloadLength { found, expected });
        }
        Ok(Self { descriptor, payload })
    }

    /// What the table is.
    #[must_use]
    pub fn descriptor(&self) -> &CurvatureDescriptor {
        &self.descriptor
    }

    /// The decoded payload it was made of.
    #[must_use]
    pub fn payload(&self) -> &'a [u8] {
        self.payload
    }

    /// How many vertices there are: row i of the table is vertex i of the mesh.
    #[must_use]
    pub fn vertices(&self) -> u32 {
        self.descriptor.vertices()
    }

    /// The stored bytes of a column, tight, ready for upload into a vertex buffer of its format; `None` if the table does
    /// not have it.
    #[must_use]
    pub fn column(&self, column: CurvatureColumn) -> Option<&'a [u8]> {
        self.parts(column).map(|(_, bytes)| bytes)
    }

    /// The bytes between a column and the next, which are zero in a valid file; empty behind the last.
    #[must_use]
    pub fn column_padding(&self, column: CurvatureColumn) -> &'a [u8] {
        let Some((layout, bytes)) = self.parts(column) else { return &[] };
        let end = self.descriptor.offset(layout.column).unwrap_or(0) as usize + bytes.len();
        // The payload's length was checked: whatever follows a column's end is padding and another column.
        let rest = self.payload.get(end..).unwrap_or(&[]);
        &rest[..rest.len().min(end.next_multiple_of(CHUNK_ALIGN as usize) - end)]
    }

    /// κ1 ≥ κ2 of a vertex in 1 / length unit, positive where the surface is convex seen from the front.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[must_use]
    pub fn principal(&self, vertex: u32) -> [f32; 2] {
        // Every descriptor has the column.
        self.numbers(CurvatureColumn::Principal, vertex).unwrap_or_default()
    }

    /// The unit tangents t1 and t2 along which κ1 and κ2 are found, in the mesh's own axes. Their sign means nothing.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[must_use]
    pub fn directions(&self, vertex: u32) -> Option<[[f32; 3]; 2]> {
        let first = self.numbers(CurvatureColumn::Direction1, vertex)?;
        Some([first, self.numbers(CurvatureColumn::Direction2, vertex)?])
    }

    /// The fundamental forms, which a shader interpolates.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[must_use]
    pub fn forms(&self, vertex: u32) -> Option<SurfaceForms> {
        let first = self.numbers(CurvatureColumn::FirstForm, vertex)?;
        Some(SurfaceForms { first, second: self.numbers(CurvatureColumn::SecondForm, vertex)? })
    }

    /// V1 and V2, the principal directions in texture coordinates (u, v), per length unit.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[must_use]
    pub fn uv_directions(&self, vertex: u32) -> Option<[[f32; 2]; 2]> {
        let [u1, v1, u2, v2] = self.numbers(CurvatureColumn::UvDirections, vertex)?;
        Some([[u1, v1], [u2, v2]])
    }

    /// The remarks on a vertex; none where the table has no such column.
    ///
    /// # Panics
    /// If there is no such vertex.
    #[must_use]
    pub fn flags(&self, vertex: u32) -> VertexFlags {
        let stored = self.stored(CurvatureColumn::Flags, vertex);
        stored.map_or(VertexFlags::NONE, |(_, bytes)| VertexFlags(u32_at(bytes, 0)))
    }

    /// The decoded numbers of a column at one vertex; `N` is at most what its format holds.
    pub(crate) fn numbers<const N: usize>(&self, column: CurvatureColumn, vertex: u32) -> Option<[f32; N]> {
        let (layout, bytes) = self.stored(column, vertex)?;
        Some(core::array::from_fn(|k| match layout.format.is_half() {
            true => layout.scale * f16_to_f32(u16_at(bytes, 2 * k)),
            false => f32::from_le_bytes(array_at(bytes, 4 * k)),
        }))
    }

    /// The layout of a column, and what it stores of one vertex.
    pub(crate) fn stored(&self, column: CurvatureColumn, vertex: u32) -> Option<(&ColumnLayout, &'a [u8])> {
        assert!(vertex < self.vertices(), "vertex {vertex} of {}", self.vertices());
        let (layout, bytes) = self.parts(column)?;
        let stride = layout.format.stride() as usize;
        Some((layout, &bytes[vertex as usize * stride..][..stride]))
    }

    fn parts(&self, column: CurvatureColumn) -> Option<(&ColumnLayout, &'a [u8])> {
        let (layout, offset) = (self.descriptor.column(column)?, self.descriptor.offset(column)?);
        Some((layout, &self.payload[offset as usize..][..self.descriptor.bytes_of(layout) as usize]))
    }
}
