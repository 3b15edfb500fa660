//! What a curvature table is made of, as plans and reports name it.

use barchan_asset::{CurvatureColumn, LengthUnit, VertexFormat};

use crate::CurvatureEncoding;

/// Columns that are of use only together, which are baked or left out as one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CurvaturePart {
    /// κ1 and κ2.
    Principal,
    /// Principal directions in three dimensions.
    Directions,
    /// The fundamental forms in texture coordinates.
    Forms,
    /// Principal directions in texture coordinates.
    UvDirections,
    /// Remarks on vertices.
    Flags,
}

impl CurvaturePart {
    /// Every part, in the order of the file.
    pub const ALL: [Self; 5] = [Self::Principal, Self::Directions, Self::Forms, Self::UvDirections, Self::Flags];

    /// `principal`, `directions`, `forms`, `uv_directions` or `flags`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Principal => "principal",
            Self::Directions => "directions",
            Self::Forms => "forms",
            Self::UvDirections => "uv_directions",
            Self::Flags => "flags",
        }
    }

    /// The columns it is stored in.
    #[must_use]
    pub fn columns(self) -> &'static [CurvatureColumn] {
        match self {
            Self::Principal => &[CurvatureColumn::Principal],
            Self::Directions => &[CurvatureColumn::Direction1, CurvatureColumn::Direction2],
            Self::Forms => &[CurvatureColumn::FirstForm, CurvatureColumn::SecondForm],
            Self::UvDirections => &[CurvatureColumn::UvDirections],
            Self::Flags => &[CurvatureColumn::Flags],
        }
    }

    /// Its name with that of the table, as in `curvature.forms`.
    #[must_use]
    pub fn full_name(self) -> &'static str {
        match self {
            Self::Principal => "curvature.principal",
            Self::Directions => "curvature.directions",
            Self::Forms => "curvature.forms",
            Self::UvDirections => "curvature.uv_directions",
            Self::Flags => "curvature.flags",
        }
    }

    /// What it takes per vertex.
    pub(crate) fn vertex_bytes(self, encoding: CurvatureEncoding) -> u64 {
        self.columns().iter().map(|&column| u64::from(format(column, encoding).stride())).sum()
    }

    /// How a vertex of its first column is stored.
    pub(crate) fn format_name(self, encoding: CurvatureEncoding) -> &'static str {
        format(self.columns()[0], encoding).name()
    }
}

fn format(column: CurvatureColumn, encoding: CurvatureEncoding) -> VertexFormat {
    column.formats()[usize::from(encoding == CurvatureEncoding::F16)]
}

/// The symbol of the unit of a column's numbers.
pub(crate) fn column_unit(column: CurvatureColumn, length: LengthUnit) -> &'static str {
    let [per_length, squared] = match length {
        LengthUnit::SceneUnit => ["1/unit", "units²"],
        LengthUnit::Metre => ["1/m", "m²"],
        LengthUnit::Centimetre => ["1/cm", "cm²"],
        LengthUnit::Millimetre => ["1/mm", "mm²"],
        LengthUnit::Kilometre => ["1/km", "km²"],
    };
    match column {
        CurvatureColumn::Principal | CurvatureColumn::UvDirections => per_length,
        CurvatureColumn::FirstForm => squared,
        CurvatureColumn::SecondForm => length.symbol(),
        CurvatureColumn::Direction1 | CurvatureColumn::Direction2 | CurvatureColumn::Flags => "",
    }
}
