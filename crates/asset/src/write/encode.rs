//! How values are stored, and why they could not be.

use std::string::String;

use crate::{Component, Format, Semantic, Transfer};

/// How values are stored. Where they are rounded to one side, as a bound has to be, errors are twice as large.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Encoding {
    /// As they are: 4 bytes, exact, not filterable on every GPU.
    F32,
    /// 2 bytes; error at most 2⁻¹² of half the table's range, and rounding; of curvature 2⁻¹¹ of each number.
    F16,
    /// 1 byte; error at most 1/510 of the table's range, and rounding. Not for curvature.
    U8,
    /// What suits the kind: 1 byte of the sine of an elevation, of the root of a distance, of what has no unit; 2 bytes
    /// of a height, of a maximum of heights and of curvature.
    Compact,
}

impl Encoding {
    /// Every encoding, the most exact first.
    pub const ALL: [Self; 4] = [Self::F32, Self::F16, Self::U8, Self::Compact];

    /// `f32`, `f16`, `u8` or `compact`, as in recipes and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F16 => "f16",
            Self::U8 => "u8",
            Self::Compact => "compact",
        }
    }

    /// The texel format that stores a table of that meaning.
    #[must_use]
    pub fn format(self, semantic: Semantic) -> Format {
        match (self.component(semantic), semantic.channels()) {
            (Component::Unorm8, 1) => Format::R8Unorm,
            (Component::Unorm8, 2) => Format::Rg8Unorm,
            (Component::Unorm8, _) => Format::Rgba8Unorm,
            (Component::Float16, 1) => Format::R16Float,
            (Component::Float16, 2) => Format::Rg16Float,
            (Component::Float16, _) => Format::Rgba16Float,
            (Component::Float32, 1) => Format::R32Float,
            (Component::Float32, 2) => Format::Rg32Float,
            (Component::Float32, _) => Format::Rgba32Float,
        }
    }

    /// What stored numbers of a table of that meaning go through to become values.
    #[must_use]
    pub fn transfer(self, semantic: Semantic) -> Transfer {
        match self {
            Self::Compact if semantic.allows(Transfer::Sine) => Transfer::Sine,
            Self::Compact if semantic.allows(Transfer::Square) => Transfer::Square,
            // What is rounded down in equal steps leaves nothing of the narrow cones of steep relief.
            Self::U8 if semantic.is_cone_map() => Transfer::Square,
            _ => Transfer::Identity,
        }
    }

    fn component(self, semantic: Semantic) -> Component {
        match self {
            Self::F32 => Component::Float32,
            Self::F16 => Component::Float16,
            Self::Compact if matches!(semantic, Semantic::Height | Semantic::MaximumHeight) => Component::Float16,
            Self::U8 | Self::Compact => Component::Unorm8,
        }
    }
}

impl EncodeError {
    /// The same of a value whose place among all values is another one.
    pub(super) fn at_index(self, place: impl Fn(usize) -> usize) -> Self {
        match self {
            Self::Value { index, value, min, max } => Self::Value { index: place(index), value, min, max },
            other => other,
        }
    }
}

/// Why values could not be encoded.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EncodeError {
    /// The number of values does not follow from the extent.
    #[error("there are {found} values; the extent asks for {expected}")]
    Count {
        /// Values given.
        found: u64,
        /// Values the extent asks for.
        expected: u64,
    },
    /// The number of mip levels is not that of a table of this extent.
    #[error("there are {found} mip levels; {expected} is accepted, the last of one texel")]
    Levels {
        /// Levels given.
        found: usize,
        /// The only number accepted.
        expected: u32,
    },
    /// A value is NaN, infinite or outside what the table may hold, or outside the bounds given.
    #[error("value {index} is {value}; {min} to {max} is accepted")]
    Value {
        /// Its place among the values; of a layer if layers are encoded one by one.
        index: usize,
        /// The value.
        value: f32,
        /// The least value accepted.
        min: f32,
        /// The greatest value accepted.
        max: f32,
    },
    /// Bounds that are no range, or wider than what the table may hold.
    #[error("values are bounded by {min} to {max}; a range within {legal_min} to {legal_max} is accepted")]
    Bounds {
        /// The lower bound given.
        min: f32,
        /// The upper bound given.
        max: f32,
        /// The least value the table may hold.
        legal_min: f32,
        /// The greatest.
        legal_max: f32,
    },
    /// The range has no scale in f32.
    #[error("{encoding} cannot hold values from {min} to {max}: their difference is beyond f32; f32 is accepted")]
    TooWide {
        /// The least value.
        min: f32,
        /// The greatest value.
        max: f32,
        /// The encoding asked for.
        encoding: &'static str,
    },
    /// A layer that the table does not have.
    #[error("layer {layer} was encoded; the table has {layers}")]
    Layer {
        /// The layer, counted from 0.
        layer: u32,
        /// Layers of the table.
        layers: u32,
    },
    /// A table without one of its layers.
    #[error("layer {layer} of {layers} was not encoded")]
    Missing {
        /// The first layer that is missing, counted from 0.
        layer: u32,
        /// Layers of the table.
        layers: u32,
    },
    /// An encoding that a kind of table does not have.
    #[error("{table} cannot be stored as {encoding}; {accepted} is accepted")]
    Encoding {
        /// The kind of table.
        table: &'static str,
        /// The encoding asked for.
        encoding: &'static str,
        /// The names of those it has.
        accepted: &'static str,
    },
    /// A column of a mesh that has another number of vertices than the mesh.
    #[error("{column} has {found} vertices; {expected} is accepted")]
    Vertices {
        /// The column.
        column: &'static str,
        /// Vertices it has.
        found: u64,
        /// Vertices of the mesh, or the most there can be.
        expected: u64,
    },
    /// What a curvature table cannot say of a vertex.
    #[error("{column} of vertex {vertex} is {found}; {accepted}")]
    Vertex {
        /// The column.
        column: &'static str,
        /// The vertex, counted from 0.
        vertex: usize,
        /// Its numbers.
        found: String,
        /// What would be accepted.
        accepted: &'static str,
    },
    /// A curvature table outside the format.
    #[error(transparent)]
    Curvature(#[from] crate::CurvatureError),
    /// The facts about the table are outside the format.
    #[error(transparent)]
    Descriptor(#[from] crate::DescriptorError),
}
