//! What there is to say of a mesh and its curvature, in a report of a bake and of a file.

use barchan_pipeline::{CurvatureProvenance, FlagCount, MendedMesh, MeshReport};

use crate::console::number;

/// The file, and where it did not fit a mesh of one row per vertex.
pub(crate) fn source(mesh: &MeshReport) -> String {
    let MeshReport { source, vertices, triangles, seam_vertices, polygons, uvs_missing, normals_replaced, ignored, .. } =
        mesh;
    let remarks = said([
        (*seam_vertices, "of the vertices behind the last `v`, for seams"),
        (*polygons, "polygons cut into triangles"),
        (*uvs_missing, "vertices without the texture coordinate that others have"),
        (*normals_replaced, "vertices without the normal that others have"),
        (*ignored, "points, lines or curves left out"),
    ]);
    let remarks = remarks.map(|remarks| format!(", {remarks}")).unwrap_or_default();
    format!("{source}, {vertices} vertices, {triangles} triangles{remarks}")
}

/// What was mended on the way to smooth sheets; `None` if nothing was.
pub(crate) fn mended(mended: &MendedMesh) -> Option<String> {
    said([
        (mended.flipped_triangles, "triangles turned over"),
        (mended.collapsed_triangles, "triangles without an area left out"),
        (mended.duplicate_triangles, "double triangles left out"),
        (mended.non_manifold_edges, "edges of more than two triangles cut"),
        (mended.hard_edges, "hard edges cut"),
        (mended.unorientable_edges, "edges without a consistent front cut"),
    ])
}

/// Counts that are not zero, if any is not.
fn said<const N: usize>(counts: [(u64, &str); N]) -> Option<String> {
    let words: Vec<_> =
        counts.into_iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect();
    (!words.is_empty()).then(|| words.join(", "))
}

/// What was found: how the vertices were welded, the range of curvatures, the noise, and how many vertices are flagged, by cause.
pub(crate) fn findings(curvature: &CurvatureProvenance, vertices: u64, unit: &str) -> Vec<String> {
    let MendedMesh { mean_edge, points, .. } = curvature.mended;
    let per = unit.strip_suffix("units").map_or(unit, |_| "unit");
    let welded = format!("{points} points of smooth sheets, mean edge {} {unit}", number(mean_edge));
    let range = match curvature.range {
        Some((least, greatest)) => format!("κ from {} to {} per {per}", number(least), number(greatest)),
        None => "no vertex whose curvature is known".to_owned(),
    };
    let noise = match curvature.noise {
        0.0 => "no noise that can be told from the surface's shape".to_owned(),
        noise if mean_edge > 0.0 => {
            format!("noise of {} {unit} RMS, {} of the mean edge", number(noise), number(noise / mean_edge))
        }
        noise => format!("noise of {} {unit} RMS", number(noise)),
    };
    vec![welded, format!("{range}, {noise}"), flagged(&curvature.flagged, vertices)]
}

/// Remarks and on how many vertices; those whose curvature is unknown first.
pub(crate) fn flagged(counts: &[FlagCount], vertices: u64) -> String {
    let is_unknown = |count: &&FlagCount| ["isolated", "degenerate"].contains(&count.flag.as_str());
    let list = |counts: Vec<&FlagCount>| {
        let words: Vec<_> = counts.iter().map(|count| format!("{} {}", count.vertices, count.flag)).collect();
        if words.is_empty() { "none".to_owned() } else { words.join(", ") }
    };
    let (unknown, others) = counts.iter().partition(is_unknown);
    format!("of {vertices} vertices unknown and stored as 0: {}; flagged: {}", list(unknown), list(others))
}
