//! What there is to know of a vertex beside its curvature.

use core::ops::BitOr;

/// A set of remarks on one vertex, as 32 bits in the file.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct VertexFlags(pub u32);

impl VertexFlags {
    /// No remark.
    pub const NONE: Self = Self(0);
    /// Texture coordinates run clockwise seen from the front: Pu × Pv points into the surface.
    pub const MIRRORED_UV: Self = Self(1);
    /// No triangle uses the vertex; its curvature is stored as 0.
    pub const ISOLATED: Self = Self(1 << 1);
    /// The triangles around the vertex span no plane, or too few points surround it; its curvature is stored as 0.
    pub const DEGENERATE: Self = Self(1 << 2);
    /// On the edge of the surface: the curvature was found from one side.
    pub const BOUNDARY: Self = Self(1 << 3);
    /// The curvature was beyond what its edges can resolve, and was cut.
    pub const CLAMPED: Self = Self(1 << 4);
    /// Several sheets of surface meet in the vertex; the curvature is that of the largest.
    pub const NON_MANIFOLD: Self = Self(1 << 5);
    /// Texture coordinates have no area here: the forms are those of the mean curvature in some tangent frame.
    pub const DEGENERATE_UV: Self = Self(1 << 6);

    /// All remarks at once: the bits that may be set.
    pub const KNOWN: Self = Self(0x7F);

    /// Every remark and its name.
    pub const ALL: [(Self, &'static str); 7] = [
        (Self::MIRRORED_UV, "mirrored_uv"),
        (Self::ISOLATED, "isolated"),
        (Self::DEGENERATE, "degenerate"),
        (Self::BOUNDARY, "boundary"),
        (Self::CLAMPED, "clamped"),
        (Self::NON_MANIFOLD, "non_manifold"),
        (Self::DEGENERATE_UV, "degenerate_uv"),
    ];

    /// Whether every remark of `other` is among these.
    #[must_use]
    pub fn contains(self, other: Self) -> bool {
        self.0 & other.0 == other.0
    }

    /// Whether the curvature could not be known, and 0 stands for it.
    #[must_use]
    pub fn is_unknown(self) -> bool {
        self.contains(Self::ISOLATED) || self.contains(Self::DEGENERATE)
    }
}

impl BitOr for VertexFlags {
    type Output = Self;

    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_known_bits_are_those_with_a_name() {
        assert_eq!(
            VertexFlags::ALL.into_iter().fold(VertexFlags::NONE, |all, (flag, _)| all | flag),
            VertexFlags::KNOWN
        );
    }
}
