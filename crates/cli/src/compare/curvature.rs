//! Two curvature tables, part by part.

use barchan_asset::{CurvatureView, LengthUnit};
use barchan_pipeline::{CurvaturePart, Table};

use super::{Position, TableReport, compare_values, mismatched};
use crate::curvature_rows::{numbers, present, values};

/// One report for every part that either has.
pub(super) fn compare(a: &CurvatureView<'_>, b: &CurvatureView<'_>, tolerance: f64) -> Vec<TableReport> {
    if let Some(mismatch) = shape_mismatch(a, b) {
        return vec![mismatched(Table::Curvature.name(), mismatch)];
    }
    let is_in = |view: &CurvatureView<'_>, part: CurvaturePart| present(view).any(|present| present == part);
    let compare_one = |part: CurvaturePart| match (is_in(a, part), is_in(b, part)) {
        (false, false) => None,
        // A table without remarks is one in which no vertex has any.
        (true, true) => Some(compare_part(a, b, part, tolerance)),
        _ if part == CurvaturePart::Flags => Some(compare_part(a, b, part, tolerance)),
        (in_a, _) => {
            let holder = if in_a { "first" } else { "second" };
            Some(mismatched(part.full_name(), format!("only the {holder} file has it")))
        }
    };
    CurvaturePart::ALL.into_iter().filter_map(compare_one).collect()
}

/// Facts that must agree before values can be compared.
fn shape_mismatch(a: &CurvatureView<'_>, b: &CurvatureView<'_>) -> Option<String> {
    let facts = |view: &CurvatureView<'_>| {
        let length_unit = view.descriptor().length_unit().name().to_owned();
        [("vertex count", view.vertices().to_string()), ("length unit", length_unit)]
    };
    let different = facts(a).into_iter().zip(facts(b)).find(|(a, b)| a != b);
    different.map(|((fact, a), (_, b))| format!("{fact} is {a} in one and {b} in the other"))
}

fn compare_part(a: &CurvatureView<'_>, b: &CurvatureView<'_>, part: CurvaturePart, tolerance: f64) -> TableReport {
    let all = |view| (0..a.vertices()).flat_map(move |vertex| values(view, part, vertex)).collect::<Vec<f32>>();
    let (values_a, mut values_b) = (all(a), all(b));
    match part {
        CurvaturePart::Directions => agree_in_sign(&values_a, &mut values_b, 3),
        CurvaturePart::UvDirections => agree_in_sign(&values_a, &mut values_b, 2),
        CurvaturePart::Principal | CurvaturePart::Forms | CurvaturePart::Flags => {}
    }
    let names = numbers(part);
    let position =
        |index: usize| Position::Vertex { vertex: (index / names.len()) as u32, number: names[index % names.len()] };
    // The numbers of the other parts have no unit, or several.
    let unit = if part == CurvaturePart::Principal { per_length(a.descriptor().length_unit()) } else { "" };
    let report = compare_values([&values_a, &values_b], tolerance, unit, position);
    TableReport { table: part.full_name(), same: report.first.is_none(), mismatch: None, values: Some(report) }
}

/// Turns directions of `b` round that point against those of `a`: the sign of a principal direction means nothing.
fn agree_in_sign(a: &[f32], b: &mut [f32], dimensions: usize) {
    for (a, b) in a.chunks_exact(dimensions).zip(b.chunks_exact_mut(dimensions)) {
        let dot: f64 = a.iter().zip(b.iter()).map(|(&a, &b)| f64::from(a) * f64::from(b)).sum();
        if dot < 0.0 {
            b.iter_mut().for_each(|component| *component = -*component);
        }
    }
}

fn per_length(unit: LengthUnit) -> &'static str {
    match unit {
        LengthUnit::SceneUnit => "per unit",
        LengthUnit::Metre => "per m",
        LengthUnit::Centimetre => "per cm",
        LengthUnit::Millimetre => "per mm",
        LengthUnit::Kilometre => "per km",
    }
}
