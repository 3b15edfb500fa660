//! Which colour stands for which curvature.

use barchan_asset::CurvatureView;
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

    /// sRGB.
    pub(super) fn colour(&self, view: &CurvatureView<'_>, vertex: u32) -> [u8; 3] {
        if view.flags(vertex).is_unknown() {
            return UNKNOWN;
        }
        let value = value(view, self.by, vertex);
        // Where 95 of 100 are 0, whatever is not has full colour.
        signed_colour(if value == 0.0 { 0.0 } else { value / self.limit })
    }

    /// One line of ASCII.
    pub(super) fn comment(&self) -> String {
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
