//! The curvature of a vertex as named numbers, part by part.

use barchan_asset::CurvatureView;
use barchan_pipeline::CurvaturePart;

/// What the numbers of a part are called.
pub(crate) fn numbers(part: CurvaturePart) -> &'static [&'static str] {
    match part {
        CurvaturePart::Principal => &["k1", "k2"],
        CurvaturePart::Directions => {
            &["direction1_x", "direction1_y", "direction1_z", "direction2_x", "direction2_y", "direction2_z"]
        }
        // Not E, F, G and e, f, g: spreadsheets and databases know no case.
        CurvaturePart::Forms => &["first_e", "first_f", "first_g", "second_e", "second_f", "second_g"],
        CurvaturePart::UvDirections => &["direction1_u", "direction1_v", "direction2_u", "direction2_v"],
        CurvaturePart::Flags => &["flags"],
    }
}

/// The parts that a table has.
pub(crate) fn present(view: &CurvatureView<'_>) -> impl Iterator<Item = CurvaturePart> {
    let descriptor = *view.descriptor();
    let has = move |part: &CurvaturePart| part.columns().iter().all(|&column| descriptor.column(column).is_some());
    CurvaturePart::ALL.into_iter().filter(has)
}

/// The numbers of a part at a vertex; flags as the number they are stored as.
pub(crate) fn values(view: &CurvatureView<'_>, part: CurvaturePart, vertex: u32) -> Vec<f32> {
    match part {
        CurvaturePart::Principal => view.principal(vertex).to_vec(),
        CurvaturePart::Directions => view.directions(vertex).unwrap_or_default().concat(),
        CurvaturePart::Forms => {
            view.forms(vertex).map(|forms| [forms.first, forms.second].concat()).unwrap_or_default()
        }
        CurvaturePart::UvDirections => view.uv_directions(vertex).unwrap_or_default().concat(),
        CurvaturePart::Flags => vec![view.flags(vertex).0 as f32],
    }
}
