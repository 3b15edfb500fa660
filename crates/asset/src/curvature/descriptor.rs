//! What a curvature table is: how many vertices, which columns, and how stored numbers become values.
//!
//! A half is multiplied by a power of two, which is exact: so a number keeps eleven bits however much smaller than the
//! largest it is, down to 2⁻²⁸ of it. A bias, as tables of texels have, would cost just that, and curvature spans decades.
//! The least product, 2⁻²⁴ · 2⁻¹⁰², is still a normal f32, so that fused or flushing arithmetic changes nothing.

use crate::bytes::{CHUNK_ALIGN, align_up, array_at, u32_at};
use crate::{CurvatureColumn, CurvatureError, LengthUnit, VertexFormat};

/// The only section version of curvature tables.
pub const CURVATURE_VERSION: u16 = 1;
/// 2¹⁰⁰, the largest size of a number in a table; rounding to a half does not pass it.
pub(crate) const GREATEST_NUMBER: f32 = f32::from_bits((127 + 100) << 23);
/// What the squared length of a direction, or the product of two, may be off by besides what its encoding costs.
#[cfg(feature = "write")]
pub(crate) const UNIT_SLACK: f64 = 1e-6;
/// 2⁻¹⁰².
pub(crate) const LEAST_SCALE: f32 = f32::from_bits((127 - 102) << 23);
/// 2⁹⁶.
const GREATEST_SCALE: f32 = f32::from_bits((127 + 96) << 23);

const HEAD_BYTES: usize = 16;
const COLUMN_BYTES: usize = 24;
const MAX_COLUMNS: usize = CurvatureColumn::ALL.len();

/// How one column is stored. `value = scale · stored` in f32.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ColumnLayout {
    /// What it holds.
    pub column: CurvatureColumn,
    /// What to tell the vertex buffer. Halves of three numbers are four, the last of which is zero.
    pub format: VertexFormat,
    /// Factor of stored halves, a power of two from 2⁻¹⁰² to 2⁹⁶; 1 for whatever else.
    pub scale: f32,
    /// The least decoded number, in the column's unit; 0 for flags.
    pub range_min: f32,
    /// The greatest decoded number; 0 for flags.
    pub range_max: f32,
    /// No decoded number is farther than this from the one that was encoded.
    pub worst_case_error: f32,
}

/// What a curvature table is. One that exists is within the format.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvatureDescriptor {
    vertices: u32,
    length_unit: LengthUnit,
    columns: [Option<ColumnLayout>; MAX_COLUMNS],
}

impl CurvatureDescriptor {
    /// A table of `vertices` vertices with those columns, which are in the order of [`CurvatureColumn::ALL`].
    ///
    /// # Errors
    /// No vertex, a column twice or in another place, without its companion or in a format that is not for it, no
    /// principal curvature, or a real number outside the format.
    pub fn new(vertices: u32, length_unit: LengthUnit, columns: &[ColumnLayout]) -> Result<Self, CurvatureError> {
        let mut descriptor = Self { vertices, length_unit, columns: [None; MAX_COLUMNS] };
        if vertices == 0 {
            return Err(CurvatureError::Extent { field: "vertex_count", found: vertices, min: 1, max: u32::MAX });
        }
        for (k, layout) in columns.iter().enumerate() {
            let column = layout.column;
            if k > 0 && columns[k - 1].column >= column {
                return Err(CurvatureError::Order { column });
            }
            layout.check()?;
            descriptor.columns[column.index()] = Some(*layout);
        }
        if descriptor.column(CurvatureColumn::Principal).is_none() {
            return Err(CurvatureError::Missing { column: CurvatureColumn::Principal });
        }
        let companions = columns.iter().filter_map(|layout| layout.column.companion());
        match companions.into_iter().find(|&companion| descriptor.column(companion).is_none()) {
            Some(column) => Err(CurvatureError::Missing { column }),
            None => Ok(descriptor),
        }
    }

    /// Reads and checks the descriptor of a section of version [`CURVATURE_VERSION`].
    ///
    /// # Errors
    /// Another length than its columns ask for, a reserved number that is not zero, a number that stands for nothing, or
    /// whatever [`Self::new`] refuses.
    pub fn parse(bytes: &[u8]) -> Result<Self, CurvatureError> {
        let (found, least) = (bytes.len() as u64, HEAD_BYTES as u64);
        if found < least {
            return Err(CurvatureError::Length { found, expected: least });
        }
        let length_unit = u32_at(bytes, 4);
        let unknown =
            CurvatureError::Enumeration { field: "length_unit", found: length_unit, accepted: LengthUnit::ACCEPTED };
        let length_unit = LengthUnit::from_number(length_unit).ok_or(unknown)?;
        let (count, reserved) = (u32_at(bytes, 8), u32_at(bytes, 12));
        if !(1..=MAX_COLUMNS as u32).contains(&count) {
            let max = MAX_COLUMNS as u32;
            return Err(CurvatureError::Extent { field: "column_count", found: count, min: 1, max });
        }
        if reserved != 0 {
            return Err(CurvatureError::Reserved { found: reserved });
        }
        let expected = (HEAD_BYTES + COLUMN_BYTES * count as usize) as u64;
        if found != expected {
            return Err(CurvatureError::Length { found, expected });
        }
        let records = bytes[HEAD_BYTES..].chunks_exact(COLUMN_BYTES);
        let mut columns = [ColumnLayout::read(&bytes[HEAD_BYTES..])?; MAX_COLUMNS];
        for (column, record) in columns.iter_mut().zip(records) {
            *column = ColumnLayout::read(record)?;
        }
        Self::new(u32_at(bytes, 0), length_unit, &columns[..count as usize])
    }

    /// Appends the bytes of the descriptor to `bytes`.
    #[cfg(feature = "write")]
    pub(crate) fn write(&self, bytes: &mut std::vec::Vec<u8>) {
        let count = self.columns().count() as u32;
        for number in [self.vertices, self.length_unit.number(), count, 0] {
            bytes.extend(number.to_le_bytes());
        }
        for layout in self.columns() {
            for number in [layout.column.number(), layout.format.number()] {
                bytes.extend(number.to_le_bytes());
            }
            for number in [layout.scale, layout.range_min, layout.range_max, layout.worst_case_error] {
                bytes.extend(number.to_le_bytes());
            }
        }
    }

    /// How many vertices there are, at least 1.
    #[must_use]
    pub fn vertices(&self) -> u32 {
        self.vertices
    }

    /// The unit of lengths.
    #[must_use]
    pub fn length_unit(&self) -> LengthUnit {
        self.length_unit
    }

    /// The columns there are, in the order in which they lie in the payload.
    pub fn columns(&self) -> impl Iterator<Item = &ColumnLayout> {
        self.columns.iter().flatten()
    }

    /// How a column is stored, if it is there.
    #[must_use]
    pub fn column(&self, column: CurvatureColumn) -> Option<&ColumnLayout> {
        self.columns[column.index()].as_ref()
    }

    /// Where a column starts in the decoded payload, if it is there: a multiple of 256.
    #[must_use]
    pub fn offset(&self, column: CurvatureColumn) -> Option<u64> {
        self.column(column)?;
        let before = self.columns().take_while(|layout| layout.column < column);
        Some(before.map(|layout| padded(self.bytes_of(layout))).sum())
    }

    /// Bytes of a column: vertices, tight.
    pub(super) fn bytes_of(&self, layout: &ColumnLayout) -> u64 {
        u64::from(self.vertices) * u64::from(layout.format.stride())
    }

    /// Bytes of the decoded payload: all columns, padded between but not behind the last.
    #[must_use]
    pub fn payload_length(&self) -> u64 {
        // At most 7 columns of 2³⁶ bytes.
        self.columns().fold(0, |end, layout| padded(end) + self.bytes_of(layout))
    }

    /// The least κ2 and the greatest κ1 of all vertices, as stored, in 1 / length unit.
    #[must_use]
    pub fn curvature_range(&self) -> (f32, f32) {
        // Every descriptor has the column.
        self.column(CurvatureColumn::Principal).map_or((0.0, 0.0), |layout| (layout.range_min, layout.range_max))
    }
}

/// The next place for a column. No length of a table comes near to u64's end.
fn padded(length: u64) -> u64 {
    align_up(length, CHUNK_ALIGN).unwrap_or(u64::MAX)
}

impl ColumnLayout {
    /// Reads the record at the start of `bytes`, which are enough of them.
    fn read(bytes: &[u8]) -> Result<Self, CurvatureError> {
        let refused = |field, found, accepted| CurvatureError::Enumeration { field, found, accepted };
        let (column, format) = (u32_at(bytes, 0), u32_at(bytes, 4));
        let real = |at| f32::from_le_bytes(array_at(bytes, at));
        Ok(Self {
            column: CurvatureColumn::from_number(column).ok_or(refused("column", column, CurvatureColumn::ACCEPTED))?,
            format: VertexFormat::from_number(format).ok_or(refused("vk_format", format, VertexFormat::ACCEPTED))?,
            scale: real(8),
            range_min: real(12),
            range_max: real(16),
            worst_case_error: real(20),
        })
    }

    fn check(&self) -> Result<(), CurvatureError> {
        let Self { column, format, scale, range_min, range_max, worst_case_error } = *self;
        if !column.formats().contains(&format) {
            return Err(CurvatureError::Format { column, found: format });
        }
        let real = |field, found, holds, accepted| {
            if holds { Ok(()) } else { Err(CurvatureError::Number { column, field, found, accepted }) }
        };
        if format.is_half() {
            let is_power = scale.to_bits() & 0x007F_FFFF == 0;
            let holds = is_power && (LEAST_SCALE..=GREATEST_SCALE).contains(&scale);
            real("scale", scale, holds, "a power of two from 2⁻¹⁰² to 2⁹⁶")?;
        } else {
            real("scale", scale, scale == 1.0, "1 for what is not a half")?;
        }
        let numbers = -GREATEST_NUMBER..=GREATEST_NUMBER;
        real("range_min", range_min, numbers.contains(&range_min), "−2¹⁰⁰ to 2¹⁰⁰")?;
        let holds = numbers.contains(&range_max) && range_min <= range_max;
        real("range_max", range_max, holds, "range_min to 2¹⁰⁰")?;
        let holds = (0.0..=GREATEST_NUMBER).contains(&worst_case_error);
        real("worst_case_error", worst_case_error, holds, "0 to 2¹⁰⁰")?;
        if column == CurvatureColumn::Flags {
            for (field, found) in
                [("range_min", range_min), ("range_max", range_max), ("worst_case_error", worst_case_error)]
            {
                real(field, found, found == 0.0, "0 for flags")?;
            }
        }
        Ok(())
    }
}
