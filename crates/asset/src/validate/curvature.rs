//! The numbers of a curvature table.

use std::format;
use std::string::String;

use crate::bytes::first_nonzero;
use crate::curvature::UNIT_SLACK;
use crate::{ColumnLayout, CurvatureColumn, CurvatureView, VertexFlags};

/// A finding's number and sentence.
type Complaint = (&'static str, String);

/// Reports padding that is not zero, and of each column the first number that is not what the format allows or a range that
/// the numbers do not reach.
pub(super) fn check(table: &CurvatureView<'_>, mut add: impl FnMut(&'static str, String)) {
    for layout in table.descriptor().columns() {
        let name = layout.column.name();
        if let Some(at) = first_nonzero(table.column_padding(layout.column)) {
            add("B0504", format!("the padding byte {at} behind {name} is not zero"));
        }
        if let Err((id, message)) = check_column(table, layout) {
            add(id, message);
        }
    }
    let whole = (0..table.vertices()).try_for_each(|vertex| check_directions(table, vertex));
    if let Err((id, message)) = whole {
        add(id, message);
    }
}

fn check_column(table: &CurvatureView<'_>, layout: &ColumnLayout) -> Result<(), Complaint> {
    match layout.column {
        CurvatureColumn::Principal => check_numbers::<2>(table, layout),
        CurvatureColumn::UvDirections => check_numbers::<4>(table, layout),
        CurvatureColumn::Flags => check_flags(table),
        _ => check_numbers::<3>(table, layout),
    }
}

fn check_numbers<const N: usize>(table: &CurvatureView<'_>, layout: &ColumnLayout) -> Result<(), Complaint> {
    let (column, name) = (layout.column, layout.column.name());
    let (mut least, mut greatest) = (f32::INFINITY, f32::NEG_INFINITY);
    for vertex in 0..table.vertices() {
        let numbers: [f32; N] = table.numbers(column, vertex).unwrap_or([0.0; N]);
        for number in numbers {
            if !number.is_finite() {
                return Err(("B0501", format!("{name} of vertex {vertex} is {numbers:?}; numbers must be finite")));
            }
            if number < layout.range_min || number > layout.range_max {
                let (min, max) = (layout.range_min, layout.range_max);
                let message = format!("{name} of vertex {vertex} is {numbers:?}; the stated range is {min} to {max}");
                return Err(("B0502", message));
            }
            (least, greatest) = (least.min(number), greatest.max(number));
        }
        check_vertex(table, layout, vertex)?;
    }
    if (least, greatest) == (layout.range_min, layout.range_max) {
        return Ok(());
    }
    let (min, max) = (layout.range_min, layout.range_max);
    Err(("B0503", format!("{name} spans {least} to {greatest}; the stated range is {min} to {max}")))
}

/// What finite numbers of one vertex have to be besides.
fn check_vertex(table: &CurvatureView<'_>, layout: &ColumnLayout, vertex: u32) -> Result<(), Complaint> {
    let name = layout.column.name();
    if layout.format.stride() == 8 && layout.column.components() == 3 {
        let padding = table.stored(layout.column, vertex).map(|(_, bytes)| &bytes[6..]);
        if padding.is_some_and(|bytes| first_nonzero(bytes).is_some()) {
            return Err(("B0504", format!("the fourth half of {name} of vertex {vertex} is not zero")));
        }
    }
    if layout.column == CurvatureColumn::Principal {
        let [first, second] = table.principal(vertex);
        if first < second {
            return Err(("B0507", format!("vertex {vertex} has κ1 = {first} below κ2 = {second}")));
        }
        if table.flags(vertex).is_unknown() && [first, second] != [0.0; 2] {
            let message = format!("vertex {vertex} has no curvature to be known, but κ1 = {first}, κ2 = {second}");
            return Err(("B0511", message));
        }
    }
    if layout.column == CurvatureColumn::FirstForm
        && let Some(forms) = table.forms(vertex).filter(|forms| !forms.is_positive())
    {
        let [e, f, g] = forms.first;
        let message = format!("vertex {vertex} has E = {e}, F = {f}, G = {g}; E > 0 and EG − F² > 0 is accepted");
        return Err(("B0509", message));
    }
    Ok(())
}

/// Whether the principal directions of a vertex are two unit vectors at right angles, give or take what the encoding costs.
fn check_directions(table: &CurvatureView<'_>, vertex: u32) -> Result<(), Complaint> {
    let Some(directions) = table.directions(vertex) else { return Ok(()) };
    let error = |column| table.descriptor().column(column).map_or(0.0, |layout| f64::from(layout.worst_case_error));
    let errors = [error(CurvatureColumn::Direction1), error(CurvatureColumn::Direction2)];
    let size = |vector: [f32; 3]| vector.map(|x| f64::from(x).abs()).iter().sum::<f64>();
    let dot = |a: [f32; 3], b: [f32; 3]| -> f64 { (0..3).map(|k| f64::from(a[k]) * f64::from(b[k])).sum() };
    for (direction, error) in directions.into_iter().zip(errors) {
        let squared = dot(direction, direction);
        // (x ± ε)² summed is farther off by at most this.
        let slack = UNIT_SLACK + error * (2.0 * size(direction) + 3.0 * error);
        if (squared - 1.0).abs() > slack {
            return Err(("B0506", format!("vertex {vertex} has a principal direction of squared length {squared}")));
        }
    }
    let [first, second] = directions;
    let slack = UNIT_SLACK + errors[0] * size(second) + errors[1] * size(first) + 3.0 * errors[0] * errors[1];
    let product = dot(first, second);
    if product.abs() > slack {
        let message = format!("the principal directions of vertex {vertex} have a product of {product}; 0 is accepted");
        return Err(("B0508", message));
    }
    Ok(())
}

fn check_flags(table: &CurvatureView<'_>) -> Result<(), Complaint> {
    match (0..table.vertices()).find(|&vertex| !VertexFlags::KNOWN.contains(table.flags(vertex))) {
        Some(vertex) => {
            let (found, known) = (table.flags(vertex).0, VertexFlags::KNOWN.0);
            Err(("B0510", format!("vertex {vertex} has the remarks {found:#x}; bits of {known:#x} are known")))
        }
        None => Ok(()),
    }
}
