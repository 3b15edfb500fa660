//! What there is to say of a mesh and its curvature, in a report of a bake and of a file.

use barchan_pipeline::{CurvatureProvenance, FlagCount, MendedMesh, MeshRange, MeshReport};

use crate::console::number;

/// The file, and where it did not fit a mesh of one row per vertex.
pub(crate) fn source(mesh: &MeshReport) -> String {
    let MeshReport {
        source, vertices, triangles, seam_vertices, polygons, uvs_missing, normals_missing, ignored, ..
    } = mesh;
    let remarks = said([
        (*seam_vertices, "of the vertices behind the last `v`, for seams"),
        (*polygons, "polygons cut into triangles"),
        (*uvs_missing, "vertices without the texture coordinate that others have"),
        (*normals_missing, "vertices without the normal that others have"),
        (*ignored, "points, lines or curves left out"),
    ]);
    let remarks = remarks.map(|remarks| format!(", {remarks}")).unwrap_or_default();
    format!("{source}, {vertices} vertices, {triangles} triangles{remarks}")
}

/// Counts that are not zero, if any is not.
fn said<const N: usize>(counts: [(u64, &str); N]) -> Option<String> {
    let words: Vec<_> =
        counts.into_iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
    (!words.is_empty()).then(|| words.join(", "))
}

/// How the vertices became smooth sheets, and what was mended on the way.
pub(crate) fn welded(mended: &MendedMesh, vertices: u64, unit: &str) -> String {
    let MendedMesh { mean_edge, points, .. } = mended;
    let mends = said([
        (mended.flipped_triangles, "triangles turned over"),
        (mended.collapsed_triangles, "triangles between fewer than three points left out"),
        (mended.duplicate_triangles, "double triangles left out"),
        (mended.non_manifold_edges, "edges of more than two triangles cut"),
        (mended.hard_edges, "hard edges cut"),
        (mended.unorientable_edges, "edges cut that no front agrees across"),
    ]);
    let mends = mends.unwrap_or_else(|| "nothing to mend".to_owned());
    format!("{vertices} vertices to {points} points of smooth sheets, mean edge {} {unit}, {mends}", number(*mean_edge))
}

/// The range of curvatures, and the noise.
pub(crate) fn found(curvature: &CurvatureProvenance, unit: &str) -> String {
    let mean_edge = curvature.mended.mean_edge;
    let range = match curvature.range {
        Some((least, greatest)) => format!("κ from {} to {} per {}", number(least), number(greatest), singular(unit)),
        None => "no vertex whose curvature is known".to_owned(),
    };
    let noise = match curvature.noise {
        0.0 => "no noise that can be told from the surface's own shape".to_owned(),
        noise if mean_edge > 0.0 => {
            format!("noise {} {unit} RMS, {} of the mean edge", number(noise), number(noise / mean_edge))
        }
        noise => format!("noise {} {unit} RMS", number(noise)),
    };
    format!("{range}, {noise}")
}

/// The range of curvatures that relief was swept over, and how much of the mesh's that is.
pub(crate) fn swept(range: &MeshRange, unit: &str) -> String {
    let words = |(least, greatest)| format!("{} to {} per {}", number(least), number(greatest), singular(unit));
    let MeshRange { mesh, swept } = *range;
    match mesh == swept {
        true => format!("over the curvatures of the mesh, {}: all but 0.1 % at either end", words(mesh)),
        false => {
            format!("over {}, as much of the mesh's {} as texels and search radius allow", words(swept), words(mesh))
        }
    }
}

/// `unit` for `units`; symbols of other units as they are.
pub(crate) fn singular(unit: &str) -> &str {
    if unit == "units" { "unit" } else { unit }
}

/// Remarks and on how many vertices; those whose curvature is unknown first.
pub(crate) fn flagged(counts: &[FlagCount], vertices: u64) -> String {
    let is_unknown = |count: &&FlagCount| ["isolated", "degenerate"].contains(&count.flag.as_str());
    let list = |counts: Vec<&FlagCount>| {
        let words: Vec<_> = counts.iter().map(|count| format!("{} {}", count.vertices, count.flag)).collect();
        if words.is_empty() { "none".to_owned() } else { words.join(", ") }
    };
    let (unknown, others) = counts.iter().partition(is_unknown);
    format!("of {vertices} vertices, unknown and stored as 0: {}; remarks: {}", list(unknown), list(others))
}
