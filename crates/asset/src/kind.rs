//! What a section holds.

use core::fmt;
use core::ops::RangeInclusive;

use crate::{CURVATURE_VERSION, SECTION_VERSION, Semantic};

/// Four ASCII letters or digits that say what a section holds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SectionKind(pub [u8; 4]);

/// Every kind this version knows, and its name. All lists of kinds derive from this one.
const KNOWN: [(SectionKind, &str); 14] = [
    (SectionKind::HEIGHT, "height"),
    (SectionKind::HORIZON, "horizon"),
    (SectionKind::DISTANCE, "distance"),
    (SectionKind::SWEPT_HORIZON, "swept_horizon"),
    (SectionKind::SWEPT_DISTANCE, "swept_distance"),
    (SectionKind::SKY_VISIBILITY, "sky_visibility"),
    (SectionKind::BENT_NORMAL, "bent_normal"),
    (SectionKind::APERTURE_CONE, "aperture_cone"),
    (SectionKind::HEMISPHERE, "hemisphere"),
    (SectionKind::CONE_MAP, "cone_map"),
    (SectionKind::RELAXED_CONE_MAP, "relaxed_cone_map"),
    (SectionKind::MAXIMUM_MIP, "maximum_mip"),
    (SectionKind::CURVATURE, "curvature"),
    (SectionKind::PROVENANCE, "provenance"),
];

impl SectionKind {
    /// Heights in the field's length unit.
    pub const HEIGHT: Self = Self(*b"HGHT");
    /// Horizon elevation angles in radians, one layer per azimuth.
    pub const HORIZON: Self = Self(*b"HORZ");
    /// Horizontal distances to the horizon point in the field's length unit, one layer per azimuth.
    pub const DISTANCE: Self = Self(*b"DIST");
    /// Elevation angles in radians of points that become the horizon on a curved base, several layers per azimuth.
    pub const SWEPT_HORIZON: Self = Self(*b"SWHZ");
    /// Horizontal distances to those points in the field's length unit.
    pub const SWEPT_DISTANCE: Self = Self(*b"SWDS");
    /// Cosine-weighted share of the sky that is seen, in [0, 1].
    pub const SKY_VISIBILITY: Self = Self(*b"SKYV");
    /// The mean direction of the visible sky, two components of a unit vector.
    pub const BENT_NORMAL: Self = Self(*b"BENT");
    /// The cone of directions towards the visible sky: unit axis and cosine of the half-angle.
    pub const APERTURE_CONE: Self = Self(*b"CONE");
    /// Depths at which rays of a cell of directions first meet the relief, one layer per cell.
    pub const HEMISPHERE: Self = Self(*b"HEMI");
    /// Depth and the ratio of a cone that the relief stays out of.
    pub const CONE_MAP: Self = Self(*b"CNMP");
    /// Depth and the ratio of a cone in which a ray pierces the relief once at most.
    pub const RELAXED_CONE_MAP: Self = Self(*b"RCMP");
    /// The greatest heights of cells between texels, and of squares of them, in the field's length unit.
    pub const MAXIMUM_MIP: Self = Self(*b"MXMP");
    /// Curvature per vertex of a mesh.
    pub const CURVATURE: Self = Self(*b"CURV");
    /// How the file came about: UTF-8 JSON.
    pub const PROVENANCE: Self = Self(*b"PROV");

    /// Every kind this version knows, in the order in which they are listed to people.
    pub fn known() -> impl Iterator<Item = Self> {
        KNOWN.into_iter().map(|(kind, _)| kind)
    }

    /// `height`, `horizon`, `distance` and so on; `None` for a kind this version does not know.
    #[must_use]
    pub fn name(self) -> Option<&'static str> {
        KNOWN.iter().find(|(kind, _)| *kind == self).map(|(_, name)| *name)
    }

    /// The kind with that [`Self::name`].
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        KNOWN.iter().find(|(_, known)| *known == name).map(|(kind, _)| *kind)
    }

    /// Whether the section is a table of texels, that is, whether [`crate::Section::texture`] applies.
    #[must_use]
    pub fn is_texture(self) -> bool {
        Semantic::of_kind(self).is_some()
    }

    /// Whether a writer marks the section as critical: a reader that does not know it must refuse the file. The others
    /// only refine what these hold.
    #[must_use]
    pub fn is_critical(self) -> bool {
        matches!(self, Self::HEIGHT | Self::HORIZON | Self::DISTANCE | Self::CURVATURE)
    }

    /// The section versions that this crate reads; none for a kind it does not know.
    #[must_use]
    pub fn versions(self) -> RangeInclusive<u16> {
        match self {
            Self::PROVENANCE => 1..=1,
            Self::CURVATURE => CURVATURE_VERSION..=CURVATURE_VERSION,
            Self::HEIGHT | Self::HORIZON | Self::DISTANCE => 1..=2,
            // Born with a later version of the descriptor they share.
            _ => match Semantic::of_kind(self) {
                Some(semantic) if semantic.is_relief_search() => 3..=SECTION_VERSION,
                Some(_) => 2..=2,
                None => RangeInclusive::new(1, 0),
            },
        }
    }

    /// Whether all four bytes are ASCII letters or digits, as the format asks.
    #[must_use]
    pub fn is_well_formed(self) -> bool {
        self.0.iter().all(u8::is_ascii_alphanumeric)
    }
}

/// The four characters, such as `HORZ`; other bytes as `\x00`.
impl fmt::Display for SectionKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0.escape_ascii())
    }
}

impl fmt::Debug for SectionKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "SectionKind({self})")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_kinds_are_one_to_one() {
        for kind in SectionKind::known() {
            assert!(kind.is_well_formed());
            assert_eq!(SectionKind::from_name(kind.name().unwrap()), Some(kind));
        }
        assert_eq!(SectionKind(*b"ZZZZ").name(), None);
        assert!(SectionKind(*b"ZZZZ").versions().is_empty());
        assert_eq!(SectionKind::from_name("HGHT"), None);
    }
}
