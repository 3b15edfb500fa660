//! The one list of tables that plans, flags and reports are made from.

use barchan_asset::SectionKind;

/// A table that can be baked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Table {
    /// Heights.
    Height,
    /// Horizon elevations.
    Horizon,
    /// Distances to the horizon.
    Distance,
    /// Elevations of further points, which become the horizon on curved surfaces.
    SweptHorizon,
    /// Their distances.
    SweptDistance,
    /// How much of the sky is seen.
    SkyVisibility,
    /// The mean direction of the visible sky.
    BentNormal,
    /// The cone of directions towards the visible sky.
    ApertureCone,
    /// Depths at which rays from a grid of directions first hit.
    Hemisphere,
    /// Cones above the surface that hold none of it.
    ConeMap,
    /// Cones in which a ray passes the surface at most once.
    RelaxedConeMap,
    /// The greatest heights of ever larger squares.
    MaximumMip,
    /// The curvature of a mesh, per vertex.
    Curvature,
}

impl Table {
    /// Every table, in the order of the file.
    pub const ALL: [Self; 13] = [
        Self::Height,
        Self::Horizon,
        Self::Distance,
        Self::SweptHorizon,
        Self::SweptDistance,
        Self::SkyVisibility,
        Self::BentNormal,
        Self::ApertureCone,
        Self::Hemisphere,
        Self::ConeMap,
        Self::RelaxedConeMap,
        Self::MaximumMip,
        Self::Curvature,
    ];

    /// The section it is stored in.
    #[must_use]
    pub fn kind(self) -> SectionKind {
        match self {
            Self::Height => SectionKind::HEIGHT,
            Self::Horizon => SectionKind::HORIZON,
            Self::Distance => SectionKind::DISTANCE,
            Self::SweptHorizon => SectionKind::SWEPT_HORIZON,
            Self::SweptDistance => SectionKind::SWEPT_DISTANCE,
            Self::SkyVisibility => SectionKind::SKY_VISIBILITY,
            Self::BentNormal => SectionKind::BENT_NORMAL,
            Self::ApertureCone => SectionKind::APERTURE_CONE,
            Self::Hemisphere => SectionKind::HEMISPHERE,
            Self::ConeMap => SectionKind::CONE_MAP,
            Self::RelaxedConeMap => SectionKind::RELAXED_CONE_MAP,
            Self::MaximumMip => SectionKind::MAXIMUM_MIP,
            Self::Curvature => SectionKind::CURVATURE,
        }
    }

    /// Whether it holds further points for curved surfaces.
    #[must_use]
    pub fn is_swept(self) -> bool {
        matches!(self, Self::SweptHorizon | Self::SweptDistance)
    }

    /// Whether it is summed over all azimuths.
    #[must_use]
    pub fn is_of_the_sky(self) -> bool {
        matches!(self, Self::SkyVisibility | Self::BentNormal | Self::ApertureCone)
    }

    /// Whether rays find their hit on the relief with it. It is baked from the heights as they are stored.
    #[must_use]
    pub fn is_for_relief_search(self) -> bool {
        matches!(self, Self::Hemisphere | Self::ConeMap | Self::RelaxedConeMap | Self::MaximumMip)
    }

    /// Whether it comes from horizons: every table of relief but the heights and those of relief search.
    #[must_use]
    pub fn is_of_horizons(self) -> bool {
        self != Self::Height && !self.is_for_relief_search() && !self.is_of_a_mesh()
    }

    /// Whether it is baked from a mesh; all others are textures, baked from heights.
    #[must_use]
    pub fn is_of_a_mesh(self) -> bool {
        self == Self::Curvature
    }

    /// Its name on the command line and in reports: that of its section.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.kind().name().expect("the sections of tables have names")
    }
}
