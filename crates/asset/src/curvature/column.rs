//! The columns of a curvature table, and how a vertex buffer holds them.

use crate::terms::numbered;

/// What the numbers of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CurvatureColumn {
    /// κ1 ≥ κ2 in 1 / length unit, positive where convex seen from the front.
    Principal,
    /// The unit tangent t1 along which κ1 is found, in the mesh's own axes.
    Direction1,
    /// The unit tangent t2 along which κ2 is found.
    Direction2,
    /// E, F, G: length unit² per texture unit².
    FirstForm,
    /// e, f, g: length unit per texture unit², positive where convex.
    SecondForm,
    /// V1 and V2: t1 and t2 in texture coordinates, u then v of each, per length unit.
    UvDirections,
    /// [`crate::VertexFlags`].
    Flags,
}

numbered!(CurvatureColumn:
    Principal = 1 "principal", Direction1 = 2 "direction_1", Direction2 = 3 "direction_2", FirstForm = 4 "first_form",
    SecondForm = 5 "second_form", UvDirections = 6 "uv_directions", Flags = 7 "flags");

impl CurvatureColumn {
    /// Every column, in the order in which they lie in a file.
    pub const ALL: [Self; 7] = [
        Self::Principal,
        Self::Direction1,
        Self::Direction2,
        Self::FirstForm,
        Self::SecondForm,
        Self::UvDirections,
        Self::Flags,
    ];

    /// Numbers per vertex that mean something.
    #[must_use]
    pub fn components(self) -> usize {
        match self {
            Self::Principal => 2,
            Self::Direction1 | Self::Direction2 | Self::FirstForm | Self::SecondForm => 3,
            Self::UvDirections => 4,
            Self::Flags => 1,
        }
    }

    /// The formats that the column may be stored in: the exact one, then the small one.
    #[must_use]
    pub fn formats(self) -> [VertexFormat; 2] {
        match self {
            Self::Principal => [VertexFormat::Float32x2, VertexFormat::Float16x2],
            Self::Direction1 | Self::Direction2 | Self::FirstForm | Self::SecondForm => {
                [VertexFormat::Float32x3, VertexFormat::Float16x4]
            }
            Self::UvDirections => [VertexFormat::Float32x4, VertexFormat::Float16x4],
            Self::Flags => [VertexFormat::Uint32; 2],
        }
    }

    /// The column without which this one has no meaning.
    #[must_use]
    pub fn companion(self) -> Option<Self> {
        match self {
            Self::Direction1 => Some(Self::Direction2),
            Self::Direction2 => Some(Self::Direction1),
            Self::FirstForm => Some(Self::SecondForm),
            Self::SecondForm => Some(Self::FirstForm),
            Self::Principal | Self::UvDirections | Self::Flags => None,
        }
    }

    /// Its place in [`Self::ALL`].
    pub(super) fn index(self) -> usize {
        self as usize
    }
}

/// How a column is stored; the number is Vulkan's `VkFormat`, the name that of WebGPU's vertex format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum VertexFormat {
    /// Two IEEE binary16.
    Float16x2,
    /// Four of them.
    Float16x4,
    /// A number of 32 bits.
    Uint32,
    /// Two IEEE binary32.
    Float32x2,
    /// Three of them, tight.
    Float32x3,
    /// Four of them.
    Float32x4,
}

numbered!(VertexFormat:
    Float16x2 = 83 "float16x2", Float16x4 = 97 "float16x4", Uint32 = 98 "uint32", Float32x2 = 103 "float32x2",
    Float32x3 = 106 "float32x3", Float32x4 = 109 "float32x4");

impl VertexFormat {
    /// Bytes from one vertex to the next.
    #[must_use]
    pub fn stride(self) -> u32 {
        match self {
            Self::Float16x2 | Self::Uint32 => 4,
            Self::Float16x4 | Self::Float32x2 => 8,
            Self::Float32x3 => 12,
            Self::Float32x4 => 16,
        }
    }

    /// Whether it holds halves, which a scale goes with.
    #[must_use]
    pub fn is_half(self) -> bool {
        matches!(self, Self::Float16x2 | Self::Float16x4)
    }
}
