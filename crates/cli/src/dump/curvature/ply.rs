//! A mesh coloured by its curvature: binary little-endian PLY, which every viewer reads.

use barchan_asset::CurvatureView;
use barchan_field::Mesh;
use barchan_metrics::{Percentiles, signed_colour};
use serde::Serialize;

use crate::args::ColouredBy;
use crate::console::number;
use crate::mesh_words::singular;

/// What stands where the curvature is unknown: a grey that no value has.
const UNKNOWN: [u8; 3] = [128; 3];

/// Which colour stands for which value.
#[derive(Serialize)]
pub(super) struct Colouring {
    #[serde(skip)]
    by: ColouredBy,
    /// What is coloured.
    pub(super) words: &'static str,
    /// The size of a value of full colour: 95 of 100 vertices have none that is larger.
    pub(super) limit: f64,
    /// The unit of the limit.
    pub(super) unit: String,
}

impl Colouring {
    /// Vertices whose curvature is unknown do not count.
    pub(super) fn new(view: &CurvatureView<'_>, by: ColouredBy) -> Self {
        let known = (0..view.vertices()).filter(|&vertex| !view.flags(vertex).is_unknown());
        let length = singular(view.descriptor().length_unit().symbol());
        let (words, power) = match by {
            ColouredBy::Mean => ("mean curvature (k1 + k2) / 2", ""),
            ColouredBy::Gaussian => ("gaussian curvature k1 k2", "²"),
            ColouredBy::K1 => ("greatest curvature k1", ""),
            ColouredBy::K2 => ("least curvature k2", ""),
        };
        let limit = Percentiles::of(known.map(|vertex| value(view, by, vertex))).p95;
        Self { by, words, limit, unit: format!("per {length}{power}") }
    }

    fn colour(&self, view: &CurvatureView<'_>, vertex: u32) -> [u8; 3] {
        if view.flags(vertex).is_unknown() {
            return UNKNOWN;
        }
        let value = value(view, self.by, vertex);
        // Where 95 of 100 are 0, whatever is not has full colour.
        signed_colour(if value == 0.0 { 0.0 } else { value / self.limit })
    }

    /// One line of ASCII.
    fn comment(&self) -> String {
        let (words, limit, unit) = (self.words, number(self.limit), self.unit.replace('²', "^2"));
        format!("colour: {words}; blue -{limit}, white 0, red {limit} {unit}; grey is unknown")
    }
}

fn value(view: &CurvatureView<'_>, by: ColouredBy, vertex: u32) -> f64 {
    let [k1, k2] = view.principal(vertex).map(f64::from);
    match by {
        ColouredBy::Mean => 0.5 * (k1 + k2),
        ColouredBy::Gaussian => k1 * k2,
        ColouredBy::K1 => k1,
        ColouredBy::K2 => k2,
    }
}

/// Positions as doubles, so that a mesh far from its origin keeps its shape; colours, κ1 and κ2 per vertex; triangles.
pub(super) fn encode(mesh: &Mesh, view: &CurvatureView<'_>, colouring: &Colouring) -> Vec<u8> {
    let mut bytes = header(mesh, colouring).into_bytes();
    for (vertex, position) in (0..).zip(mesh.positions()) {
        bytes.extend(position.to_array().iter().flat_map(|coordinate| coordinate.to_le_bytes()));
        bytes.extend(colouring.colour(view, vertex));
        bytes.extend(view.principal(vertex).iter().flat_map(|curvature| curvature.to_le_bytes()));
    }
    for triangle in mesh.triangles() {
        bytes.push(3);
        bytes.extend(triangle.iter().flat_map(|corner| corner.to_le_bytes()));
    }
    bytes
}

fn header(mesh: &Mesh, colouring: &Colouring) -> String {
    let (vertices, triangles) = (mesh.positions().len(), mesh.triangles().len());
    let (version, comment) = (env!("CARGO_PKG_VERSION"), colouring.comment());
    format!(
        "ply\n\
         format binary_little_endian 1.0\n\
         comment made by barchan {version}\n\
         comment {comment}\n\
         element vertex {vertices}\n\
         property double x\n\
         property double y\n\
         property double z\n\
         property uchar red\n\
         property uchar green\n\
         property uchar blue\n\
         property float k1\n\
         property float k2\n\
         element face {triangles}\n\
         property list uchar uint vertex_indices\n\
         end_header\n"
    )
}
