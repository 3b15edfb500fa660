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
}

impl Table {
    /// Every table, in the order of the file.
    pub const ALL: [Self; 3] = [Self::Height, Self::Horizon, Self::Distance];

    /// The section it is stored in.
    #[must_use]
    pub fn kind(self) -> SectionKind {
        match self {
            Self::Height => SectionKind::HEIGHT,
            Self::Horizon => SectionKind::HORIZON,
            Self::Distance => SectionKind::DISTANCE,
        }
    }

    /// Its name on the command line and in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Height => "height",
            Self::Horizon => "horizon",
            Self::Distance => "distance",
        }
    }

    /// The table of that name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|table| table.name() == name)
    }
}
