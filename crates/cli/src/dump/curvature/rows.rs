//! Numbers per vertex, for people, spreadsheets and NumPy.

use std::fmt::Write;

use barchan_asset::{CurvatureView, VertexFlags};
use barchan_pipeline::CurvaturePart;

use crate::console::number;
use crate::curvature_rows::{numbers, present, values};
use crate::failure::Failure;
use crate::mesh_words::singular;

/// `[vertices, numbers]`.
pub(super) fn npy(view: &CurvatureView<'_>, part: CurvaturePart) -> Result<Vec<u8>, Failure> {
    let shape = [u64::from(view.vertices()), numbers(part).len() as u64];
    super::npy::array(&shape, (0..view.vertices()).flat_map(|vertex| values(view, part, vertex)))
}

/// A heading, then a line per vertex.
pub(super) fn text(view: &CurvatureView<'_>, part: CurvaturePart) -> String {
    let length = view.descriptor().length_unit().symbol();
    let unit = match part {
        CurvaturePart::Principal | CurvaturePart::UvDirections => format!(" per {}", singular(length)),
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
