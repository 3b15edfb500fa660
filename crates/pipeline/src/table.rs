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

    /// Its name on the command line and in reports: that of its section.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.kind().name().expect("the sections of tables have names")
    }
}
