//! Vectors of curvature. Each vertex lies on a surface of its own; forms and directions are those of its chart.

use std::vec::Vec;

use crate::{AssetWriter, Codec, CurvatureTable, Encoding, LengthUnit, SurfaceForms, VertexFlags, WriteError};

/// A vertex of the vectors `curvature-f32` and `curvature-f16`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvedVertex {
    /// κ1 ≥ κ2 per metre.
    pub principal: [f32; 2],
    /// t1 and t2.
    pub directions: [[f32; 3]; 2],
    /// Pu and Pv, each as its parts along t1 and t2.
    pub chart: [[f32; 2]; 2],
    /// Remarks.
    pub flags: VertexFlags,
}

/// A saddle whose texture is twice as long as wide, a sheared chart, a mirrored umbilic on the edge, a vertex that no
/// triangle uses, and one bent inwards beyond its edges.
pub const CURVED: [CurvedVertex; 5] = [
    vertex([0.5, -0.25], [X, Y], [[2.0, 0.0], [0.0, 1.0]], 0),
    vertex([2.0, 1.0], [Y, Z], [[1.0, 0.0], [1.0, 1.0]], 0),
    vertex([0.1, 0.1], [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0]], [[1.0, 0.0], [0.0, -2.0]], 1 | 1 << 3),
    vertex([0.0, 0.0], [X, Y], [[1.0, 0.0], [0.0, 1.0]], 1 << 1),
    vertex([-0.003, -300.0], [Z, X], [[0.5, -0.5], [0.5, 0.5]], 1 << 4),
];

/// κ1 and κ2 of the vector `curvature-principal`, per scene unit.
pub const PRINCIPAL: [[f32; 2]; 3] = [[1000.0, -1e-3], [0.1, 1e-6], [0.0, -1.0 / 3.0]];

const X: [f32; 3] = [1.0, 0.0, 0.0];
const Y: [f32; 3] = [0.0, 1.0, 0.0];
const Z: [f32; 3] = [0.0, 0.0, 1.0];

const fn vertex(principal: [f32; 2], directions: [[f32; 3]; 2], chart: [[f32; 2]; 2], flags: u32) -> CurvedVertex {
    CurvedVertex { principal, directions, chart, flags: VertexFlags(flags) }
}

impl CurvedVertex {
    /// E = Pu · Pu and so on; e and so on weigh the parts along t1 and t2 with κ1 and κ2.
    #[must_use]
    pub fn forms(&self) -> SurfaceForms {
        let [pu, pv] = self.chart;
        let product = |[w1, w2]: [f32; 2], a: [f32; 2], b: [f32; 2]| w1 * a[0] * b[0] + w2 * a[1] * b[1];
        let form = |weights| [product(weights, pu, pu), product(weights, pu, pv), product(weights, pv, pv)];
        SurfaceForms { first: form([1.0, 1.0]), second: form(self.principal) }
    }

    /// V1 and V2: u Pu + v Pv is t1, or t2.
    #[must_use]
    pub fn uv_directions(&self) -> [[f32; 2]; 2] {
        let [[a, b], [c, d]] = self.chart;
        let determinant = a * d - b * c;
        [[d / determinant, -b / determinant], [-c / determinant, a / determinant]]
    }
}

pub(super) fn everything(encoding: Encoding) -> Result<Vec<u8>, WriteError> {
    let table = CurvatureTable {
        length_unit: LengthUnit::Metre,
        principal: &CURVED.map(|vertex| vertex.principal),
        directions: Some(&CURVED.map(|vertex| vertex.directions)),
        forms: Some(&CURVED.map(|vertex| vertex.forms())),
        uv_directions: Some(&CURVED.map(|vertex| vertex.uv_directions())),
        flags: &CURVED.map(|vertex| vertex.flags),
    };
    let mut writer = AssetWriter::new();
    writer.add_curvature(table.encode(encoding)?, Codec::Raw)?;
    writer.provenance("{\"made_by\":\"barchan vectors\"}")?;
    writer.finish()
}

pub(super) fn principal() -> Result<Vec<u8>, WriteError> {
    let (length_unit, principal) = (LengthUnit::SceneUnit, &PRINCIPAL[..]);
    let table =
        CurvatureTable { length_unit, principal, directions: None, forms: None, uv_directions: None, flags: &[] };
    let mut writer = AssetWriter::new();
    writer.add_curvature(table.encode(Encoding::Compact)?, Codec::Raw)?;
    writer.finish()
}
