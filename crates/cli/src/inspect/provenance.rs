//! What a provenance says, for people.

use barchan_pipeline::{
    CurvatureProvenance, EncodingProvenance, HemisphereProvenance, HorizonProvenance, MeshProvenance, Provenance,
    ReliefSearchProvenance,
};

use crate::console::{self, number};
use crate::mesh_words;

/// What this program knows of a provenance; all of it, as JSON, where it knows nothing. `length` is the symbol of the mesh's unit.
pub(super) fn words(json: &serde_json::Value, length: &str) -> Vec<String> {
    let Ok(provenance) = serde_json::from_value::<Provenance>(json.clone()) else {
        return vec![json.to_string()];
    };
    let mut words = vec![provenance.generator.clone()];
    let inputs = [("input", &json["input"]), ("mesh", &json["mesh"])];
    for (what, input) in inputs.into_iter().filter(|(_, input)| !input.is_null()) {
        words[0] += &format!(", {what} {input}");
    }
    words.push(format!("recipe {}", json["recipe"]));
    words.extend(provenance.horizon.iter().flat_map(horizon_words));
    if let Some(swept) = &provenance.swept {
        words.push(format!("{}, {} points", swept.algorithm, swept.points));
        words.extend(swept.on_mesh.iter().map(|range| format!("swept {}", mesh_words::swept(range, length))));
    }
    words.extend(provenance.sky.map(|sky| sky.algorithm));
    words.extend(provenance.relief_search.iter().flat_map(search_words));
    if let (Some(curvature), Some(mesh)) = (&provenance.curvature, &provenance.mesh) {
        words.extend(curvature_provenance_words(curvature, mesh, length));
    }
    let lossy = provenance.encodings.iter().filter(|encoding| encoding.max > 0.0);
    words.extend(lossy.map(encoding_words));
    words
}

fn curvature_provenance_words(curvature: &CurvatureProvenance, mesh: &MeshProvenance, length: &str) -> Vec<String> {
    let CurvatureProvenance { algorithm, method, hard_edge_degrees, mended, .. } = curvature;
    let mut words = vec![format!("{algorithm} {}, hard edges beyond {hard_edge_degrees}°", method.name())];
    words.push(mesh_words::welded(mended, mesh.vertices, length));
    words.push(mesh_words::found(curvature, length));
    words
}

fn horizon_words(horizon: &HorizonProvenance) -> Vec<String> {
    let HorizonProvenance { algorithm, method, directions, arc, radius, accuracy } = horizon;
    let method = method.map(|method| format!(" {}", method.name())).unwrap_or_default();
    let arc = arc.map(|arc| format!(" {}", console::arc(arc))).unwrap_or_default();
    let baked = format!("{algorithm}{method}, {directions} directions{arc}, radius {radius}");
    std::iter::once(baked).chain(accuracy.as_ref().map(console::accuracy)).collect()
}

fn search_words(search: &ReliefSearchProvenance) -> Vec<String> {
    let ReliefSearchProvenance { hemisphere, cone_map, relaxed_cone_map, maximum_mip } = search;
    let mut words: Vec<_> = hemisphere.iter().flat_map(hemisphere_words).collect();
    words.extend([cone_map, relaxed_cone_map, maximum_mip].into_iter().flatten().cloned());
    words
}

fn hemisphere_words(hemisphere: &HemisphereProvenance) -> [String; 2] {
    let HemisphereProvenance { algorithm, mode, rings, azimuths, spacing, max_polar_degrees, arc, .. } = hemisphere;
    let arc = arc.map(|arc| format!(" {}", console::arc(arc))).unwrap_or_default();
    let rings = format!("{rings} rings to {}° by {}", number(*max_polar_degrees), spacing.name());
    let baked = format!("{algorithm} {}, {rings}, {azimuths} azimuths{arc}", mode.name());
    [baked, format!("starts {}", console::starts(&hemisphere.accuracy))]
}

/// What storing cost, measured over all values.
fn encoding_words(encoding: &EncodingProvenance) -> String {
    let EncodingProvenance { table, format, unit, rms, max } = encoding;
    let [rms, max] = [*rms, *max].map(|error| console::error_in(unit, error));
    format!("{table} stored as {format}: measured {rms} RMS, {max} at most")
}
