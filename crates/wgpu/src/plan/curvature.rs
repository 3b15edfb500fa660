//! The curvature of a mesh as vertex buffers.

use barchan_asset::{CurvatureColumn, LengthUnit, VertexFormat};

use super::{DeviceLimits, PlanError, payload_offset, slice};
use crate::{Reader, Selection};

/// A column of curvature as a vertex buffer: one element a vertex, tight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ColumnPlan {
    /// What it holds.
    pub column: CurvatureColumn,
    /// The format of an element; halves of three numbers are four.
    pub format: VertexFormat,
    /// What a shader multiplies stored numbers by: a power of two, 1 for floats.
    pub scale: f32,
    /// Where its bytes begin in the decoded payload.
    pub offset: u64,
    /// How many there are, a multiple of 4.
    pub bytes: u64,
}

impl ColumnPlan {
    /// Its bytes of a decoded payload; none if it is too short, which is another file's.
    #[must_use]
    pub fn of<'a>(&self, payload: &'a [u8]) -> Option<&'a [u8]> {
        slice(payload, self.offset, self.bytes)
    }
}

/// What becomes of the curvature of a mesh: vertex attributes, because a vertex stage may have no storage buffer.
#[derive(Debug, Clone, PartialEq)]
pub struct CurvaturePlan {
    /// Vertices, in the mesh's own order.
    pub vertices: u32,
    /// The unit of lengths.
    pub length_unit: LengthUnit,
    /// Where the decoded payload begins in the file; nothing for a section that has to be decoded first.
    pub payload_offset: Option<u64>,
    /// The columns.
    pub columns: Vec<ColumnPlan>,
}

impl CurvaturePlan {
    pub(super) fn new(
        reader: &Reader<'_>,
        selection: &Selection,
        limits: &DeviceLimits,
    ) -> Result<Option<Self>, PlanError> {
        let Some((descriptor, section)) = reader.curvature() else { return Ok(None) };
        let payload_offset = payload_offset(&section)?;
        let mut columns = Vec::new();
        for layout in descriptor.columns().filter(|layout| selection.has_column(layout.column)) {
            let (column, most) = (layout.column, limits.max_buffer);
            let bytes = u64::from(descriptor.vertices()) * u64::from(layout.format.stride());
            if bytes > most {
                return Err(PlanError::Buffer { column, bytes, most });
            }
            let offset = descriptor.offset(column).unwrap_or(0);
            columns.push(ColumnPlan { column, format: layout.format, scale: layout.scale, offset, bytes });
        }
        let (vertices, length_unit) = (descriptor.vertices(), descriptor.length_unit());
        Ok((!columns.is_empty()).then_some(Self { vertices, length_unit, payload_offset, columns }))
    }

    /// A column, if it is planned.
    #[must_use]
    pub fn column(&self, column: CurvatureColumn) -> Option<&ColumnPlan> {
        self.columns.iter().find(|plan| plan.column == column)
    }

    /// Bytes that are uploaded.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.columns.iter().map(|column| column.bytes).sum()
    }
}
