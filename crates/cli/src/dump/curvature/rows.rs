//! Numbers per vertex, for people, spreadsheets and NumPy.

use std::fmt::Write;

use barchan_asset::{CurvatureView, VertexFlags};
use barchan_pipeline::CurvaturePart;

use crate::console::number;
use crate::failure::Failure;

/// What the numbers of a part are called.
pub(super) fn numbers(part: CurvaturePart) -> &'static [&'static str] {
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
pub(super) fn present(view: &CurvatureView<'_>) -> impl Iterator<Item = CurvaturePart> {
    let descriptor = *view.descriptor();
    let has = move |part: &CurvaturePart| part.columns().iter().all(|&column| descriptor.column(column).is_some());
    CurvaturePart::ALL.into_iter().filter(has)
}

/// The numbers of a part at a vertex; flags as the number they are stored as.
fn values(view: &CurvatureView<'_>, part: CurvaturePart, vertex: u32) -> Vec<f32> {
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

/// `[vertices, numbers]`.
pub(super) fn npy(view: &CurvatureView<'_>, part: CurvaturePart) -> Result<Vec<u8>, Failure> {
    let shape = [u64::from(view.vertices()), numbers(part).len() as u64];
    super::npy::array(&shape, (0..view.vertices()).flat_map(|vertex| values(view, part, vertex)))
}

/// A heading, then a line per vertex.
pub(super) fn text(view: &CurvatureView<'_>, part: CurvaturePart) -> String {
    let length = view.descriptor().length_unit().symbol();
    let unit = match part {
        CurvaturePart::Principal | CurvaturePart::UvDirections => format!(" per {}", length.trim_end_matches('s')),
        CurvaturePart::Forms => format!(" in {length}"),
        CurvaturePart::Directions | CurvaturePart::Flags => String::new(),
    };
    // Writing into a String cannot fail.
    let mut text = format!("# curvature, {}{unit}, {} vertices\n", numbers(part).join(", "), view.vertices());
    for vertex in 0..view.vertices() {
        if part == CurvaturePart::Flags {
            text += &flag_names(view.flags(vertex));
        } else {
            for value in values(view, part, vertex) {
                let _ = write!(text, "{:>11}", number(value.into()));
            }
        }
        text.push('\n');
    }
    text
}

/// Every column there is, a line per vertex. Numbers are written so that they read back to the bit.
pub(super) fn csv(view: &CurvatureView<'_>) -> String {
    let parts: Vec<_> = present(view).collect();
    let names: Vec<_> = parts.iter().flat_map(|&part| numbers(part)).copied().collect();
    let mut text = format!("vertex,{}\n", names.join(","));
    for vertex in 0..view.vertices() {
        let _ = write!(text, "{vertex}");
        for &part in &parts {
            if part == CurvaturePart::Flags {
                let _ = write!(text, ",{}", flag_names(view.flags(vertex)));
                continue;
            }
            for value in values(view, part, vertex) {
                let _ = write!(text, ",{value}");
            }
        }
        text.push('\n');
    }
    text
}

/// `boundary|clamped`; nothing where there is no remark.
fn flag_names(flags: VertexFlags) -> String {
    let names = VertexFlags::ALL.into_iter().filter(|(flag, _)| flags.contains(*flag)).map(|(_, name)| name);
    names.collect::<Vec<_>>().join("|")
}
