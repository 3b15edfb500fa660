//! The curvature of a mesh, from numbers per vertex to columns.
//!
//! What the format asks of a vertex is checked before anything is encoded, and holds for what is decoded: rounding to a half
//! is monotone, so κ1 ≥ κ2 survives it; a first form that it would leave not positive is rounded outwards instead.

use std::format;
use std::vec::Vec;

use super::codes::{nearest_half, value_of_half};
use super::encode::{EncodeError, Encoding};
use super::loss::{EncodingLoss, LayerMeasure};
use crate::bytes::CHUNK_ALIGN;
use crate::curvature::{GREATEST_NUMBER, LEAST_SCALE, UNIT_SLACK};
use crate::{
    ColumnLayout, CurvatureColumn, CurvatureDescriptor, CurvatureError, CurvatureView, LengthUnit, SurfaceForms,
    VertexFlags,
};

/// The curvature of a mesh to be written; row i of every column is vertex i.
#[derive(Debug, Clone, Copy)]
pub struct CurvatureTable<'a> {
    /// The unit of lengths.
    pub length_unit: LengthUnit,
    /// κ1 ≥ κ2 in 1 / length unit, positive where convex seen from the front, within ±2¹⁰⁰; of 1 to 4294967295 vertices.
    pub principal: &'a [[f32; 2]],
    /// Unit tangents t1 and t2 at right angles, in the mesh's own axes.
    pub directions: Option<&'a [[[f32; 3]; 2]]>,
    /// The fundamental forms in texture coordinates, the first positive: [`SurfaceForms::nearest`] makes them of f64.
    pub forms: Option<&'a [SurfaceForms]>,
    /// V1 and V2: t1 and t2 in texture coordinates (u, v), per length unit.
    pub uv_directions: Option<&'a [[[f32; 2]; 2]]>,
    /// Remarks; the column is left out where no vertex has one. May be empty.
    pub flags: &'a [VertexFlags],
}

/// Curvature in its stored form, ready for [`crate::AssetWriter::add_curvature`].
#[derive(Debug, Clone, PartialEq)]
pub struct EncodedCurvature {
    descriptor: CurvatureDescriptor,
    payload: Vec<u8>,
    losses: Vec<(CurvatureColumn, EncodingLoss)>,
}

impl EncodedCurvature {
    /// What the table is.
    #[must_use]
    pub fn descriptor(&self) -> &CurvatureDescriptor {
        &self.descriptor
    }

    /// The decoded payload of the section.
    #[must_use]
    pub fn payload(&self) -> &[u8] {
        &self.payload
    }

    /// What the encoding cost, column by column, in the unit of each; flags cost nothing and are left out.
    #[must_use]
    pub fn losses(&self) -> &[(CurvatureColumn, EncodingLoss)] {
        &self.losses
    }

    /// The numbers as a reader will decode them.
    ///
    /// # Errors
    /// None in practice: the parts were made for each other.
    pub fn view(&self) -> Result<CurvatureView<'_>, CurvatureError> {
        CurvatureView::new(self.descriptor, &self.payload)
    }
}

impl CurvatureTable<'_> {
    /// The table in its stored form. [`Encoding::Compact`] is [`Encoding::F16`].
    ///
    /// # Errors
    /// [`Encoding::U8`], which 256 steps are too few for; columns of different lengths; no vertex; or a number that is not
    /// finite, too large, or no curvature, direction or form.
    pub fn encode(&self, encoding: Encoding) -> Result<EncodedCurvature, EncodeError> {
        let small = match encoding {
            Encoding::F32 => false,
            Encoding::F16 | Encoding::Compact => true,
            Encoding::U8 => {
                let (table, accepted) = ("curvature", "f32, f16 or compact");
                return Err(EncodeError::Encoding { table, encoding: encoding.name(), accepted });
            }
        };
        let vertices = self.check()?;
        let mut columns = Columns { small, ..Columns::default() };
        columns.add(CurvatureColumn::Principal, self.principal);
        if let Some(directions) = self.directions {
            columns.add(CurvatureColumn::Direction1, directions.iter().map(|[first, _]| first));
            columns.add(CurvatureColumn::Direction2, directions.iter().map(|[_, second]| second));
        }
        if let Some(forms) = self.forms {
            columns.add(CurvatureColumn::FirstForm, forms.iter().map(|forms| &forms.first));
            columns.add(CurvatureColumn::SecondForm, forms.iter().map(|forms| &forms.second));
        }
        if let Some(directions) = self.uv_directions {
            columns.add(CurvatureColumn::UvDirections, directions.iter().map(|pair| pair.as_flattened()));
        }
        columns.add_flags(self.flags);
        let descriptor = CurvatureDescriptor::new(vertices, self.length_unit, &columns.layouts)?;
        Ok(EncodedCurvature { descriptor, payload: columns.payload, losses: columns.losses })
    }

    /// Refuses what the format cannot say, and counts the vertices.
    fn check(&self) -> Result<u32, EncodeError> {
        let expected = self.principal.len() as u64;
        let lengths = [
            ("directions", self.directions.map(<[_]>::len)),
            ("forms", self.forms.map(<[_]>::len)),
            ("uv_directions", self.uv_directions.map(<[_]>::len)),
            ("flags", Some(self.flags.len()).filter(|&length| length > 0)),
        ];
        for (column, length) in lengths {
            if let Some(found) = length.map(|length| length as u64).filter(|&length| length != expected) {
                return Err(EncodeError::Vertices { column, found, expected });
            }
        }
        let too_many = EncodeError::Vertices { column: "principal", found: expected, expected: u32::MAX.into() };
        let vertices = u32::try_from(expected).map_err(|_| too_many)?;
        self.check_numbers()?;
        Ok(vertices)
    }

    fn check_numbers(&self) -> Result<(), EncodeError> {
        let ordered = "κ1 ≥ κ2 within ±2¹⁰⁰ is accepted";
        check_all("principal", self.principal, ordered, |k| in_bounds(k) && k[0] >= k[1])?;
        let directions = self.directions.unwrap_or_default();
        let perpendicular = "two unit vectors at right angles are accepted";
        check_all("directions", directions, perpendicular, are_directions)?;
        let positive = "numbers within ±2¹⁰⁰ with E > 0 and EG − F² > 0 are accepted";
        check_all("forms", self.forms.unwrap_or_default(), positive, |forms| {
            in_bounds(&forms.first) && in_bounds(&forms.second) && forms.is_positive()
        })?;
        let uv_directions = self.uv_directions.unwrap_or_default();
        check_all("uv_directions", uv_directions, "±2¹⁰⁰ is accepted", |pair| in_bounds(pair.as_flattened()))?;
        check_all("flags", self.flags, "known bits are accepted", |&flags| VertexFlags::KNOWN.contains(flags))?;
        let unknown = "0 is accepted where a vertex is isolated or degenerate";
        let pairs = self.principal.iter().zip(self.flags);
        check_all("principal", pairs, unknown, |(&principal, flags)| !flags.is_unknown() || principal == [0.0; 2])
    }
}

fn in_bounds(numbers: &[f32]) -> bool {
    numbers.iter().all(|number| number.abs() <= GREATEST_NUMBER)
}

fn are_directions([first, second]: &[[f32; 3]; 2]) -> bool {
    let dot = |a: &[f32; 3], b: &[f32; 3]| -> f64 { a.iter().zip(b).map(|(&a, &b)| f64::from(a) * f64::from(b)).sum() };
    let near = |found: f64, wanted: f64| (found - wanted).abs() <= UNIT_SLACK;
    near(dot(first, first), 1.0) && near(dot(second, second), 1.0) && near(dot(first, second), 0.0)
}

/// Refuses the first vertex that is not good.
fn check_all<T: core::fmt::Debug + Copy>(
    column: &'static str,
    values: impl IntoIterator<Item = T>,
    accepted: &'static str,
    is_good: impl Fn(T) -> bool,
) -> Result<(), EncodeError> {
    match values.into_iter().enumerate().find(|&(_, value)| !is_good(value)) {
        Some((vertex, value)) => {
            let found = format!("{value:?}");
            Err(EncodeError::Vertex { column, vertex, found, accepted })
        }
        None => Ok(()),
    }
}

/// Columns as they come.
#[derive(Default)]
struct Columns {
    small: bool,
    layouts: Vec<ColumnLayout>,
    payload: Vec<u8>,
    losses: Vec<(CurvatureColumn, EncodingLoss)>,
}

impl Columns {
    /// Adds a column of so many numbers per vertex, all within the format.
    fn add<'a>(
        &mut self,
        column: CurvatureColumn,
        rows: impl IntoIterator<Item = &'a (impl AsRef<[f32]> + ?Sized + 'a)>,
    ) {
        let given: Vec<f32> = rows.into_iter().flat_map(|row| row.as_ref().iter().copied()).collect();
        let mut measure = LayerMeasure::EMPTY;
        let scale = if self.small { scale_of(&given) } else { 1.0 };
        self.align();
        if self.small {
            let halves = halves_of(column, &given, scale);
            let decoded: Vec<f32> = halves.iter().map(|&half| scale * value_of_half(half)).collect();
            measure.add(&given, &decoded);
            for row in halves.chunks_exact(column.components()) {
                // There is no vertex format of three halves.
                let padding: &[u16] = if row.len() == 3 { &[0] } else { &[] };
                self.payload.extend(row.iter().chain(padding).flat_map(|half| half.to_le_bytes()));
            }
        } else {
            measure.add(&given, &given);
            self.payload.extend(given.iter().flat_map(|number| number.to_le_bytes()));
        }
        let (range_min, range_max) = if given.is_empty() { (0.0, 0.0) } else { measure.range() };
        let worst_case_error = if self.small { worst_case_error(column, scale) } else { 0.0 };
        let format = column.formats()[usize::from(self.small)];
        self.layouts.push(ColumnLayout { column, format, scale, range_min, range_max, worst_case_error });
        self.losses.push((column, measure.loss()));
    }

    fn add_flags(&mut self, flags: &[VertexFlags]) {
        if flags.iter().all(|&flags| flags == VertexFlags::NONE) {
            return;
        }
        self.align();
        self.payload.extend(flags.iter().flat_map(|flags| flags.0.to_le_bytes()));
        let column = CurvatureColumn::Flags;
        let format = column.formats()[0];
        let layout = ColumnLayout { column, format, scale: 1.0, range_min: 0.0, range_max: 0.0, worst_case_error: 0.0 };
        self.layouts.push(layout);
    }

    fn align(&mut self) {
        let start = self.payload.len().next_multiple_of(CHUNK_ALIGN as usize);
        self.payload.resize(start, 0);
    }
}

/// The power of two by which the largest number is stored in [2¹⁴, 2¹⁵), far from overflow and from subnormal halves; 2⁻¹⁰²
/// if that is greater, 1 for zeros.
fn scale_of(numbers: &[f32]) -> f32 {
    let largest = numbers.iter().fold(0.0_f32, |largest, number| largest.max(number.abs()));
    if largest == 0.0 {
        return LEAST_SCALE;
    }
    let power_of_two = f32::from_bits(largest.to_bits() & 0x7F80_0000);
    (power_of_two / 16_384.0).max(LEAST_SCALE)
}

/// Halves of at most 2¹⁵ are 16 apart. In a first form F and another number may be off by a whole step.
fn worst_case_error(column: CurvatureColumn, scale: f32) -> f32 {
    if column == CurvatureColumn::FirstForm { 16.0 * scale } else { 8.0 * scale }
}

fn halves_of(column: CurvatureColumn, numbers: &[f32], scale: f32) -> Vec<u16> {
    let nearest = |&number: &f32| nearest_half(f64::from(number) / f64::from(scale));
    let mut halves: Vec<u16> = numbers.iter().map(nearest).collect();
    if column == CurvatureColumn::FirstForm {
        for (form, halves) in numbers.as_chunks::<3>().0.iter().zip(halves.as_chunks_mut::<3>().0) {
            keep_positive(form, halves, scale);
        }
    }
    halves
}

/// Rounds E and G up and F towards zero where the nearest halves are not a positive form.
fn keep_positive(form: &[f32; 3], halves: &mut [u16; 3], scale: f32) {
    let first = halves.map(|half| scale * value_of_half(half));
    if (SurfaceForms { first, second: [0.0; 3] }).is_positive() {
        return;
    }
    for k in [0, 2] {
        // One further in size is one more in bits.
        halves[k] += u16::from(first[k] < form[k]);
    }
    halves[1] -= u16::from(first[1].abs() > form[1].abs());
}
