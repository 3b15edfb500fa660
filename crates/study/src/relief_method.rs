//! The ways to find a hit that the studies compare: where a search starts, and how it goes on.

use std::fmt;

/// How a hit is searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Search {
    /// Equal steps of depth, then bisection: the paper's baseline.
    Linear,
    /// Equal steps of depth, then one secant: parallax occlusion mapping.
    Parallax,
    /// Steps of a cone map, ended in the bilinear cell.
    Cones,
    /// Steps of a relaxed cone map, then bisection.
    RelaxedCones,
    /// Descent of a maximum mip.
    MaximumMip,
}

/// Where a search starts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feed {
    /// On the top plane.
    Top,
    /// At the paper's depth: that of one ray of the direction cell.
    Nearest,
    /// At a depth that no ray of the direction cell is stopped before.
    Conservative,
}

/// A start and a search.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Method {
    /// How it goes on.
    pub search: Search,
    /// Where it starts.
    pub feed: Feed,
}

impl Search {
    /// Every one, in the order of the docs.
    pub const ALL: [Self; 5] = [Self::Linear, Self::Parallax, Self::Cones, Self::RelaxedCones, Self::MaximumMip];

    /// Its name in records.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Linear => "linear",
            Self::Parallax => "parallax_occlusion",
            Self::Cones => "cone_steps",
            Self::RelaxedCones => "relaxed_cone_steps",
            Self::MaximumMip => "maximum_mip",
        }
    }
}

impl Feed {
    /// Every one, in the order of the docs.
    pub const ALL: [Self; 3] = [Self::Top, Self::Nearest, Self::Conservative];

    /// Its name in records.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Top => "top",
            Self::Nearest => "nearest",
            Self::Conservative => "conservative",
        }
    }
}

impl Method {
    /// Every pair.
    pub fn all() -> impl Iterator<Item = Self> {
        Search::ALL.into_iter().flat_map(|search| Feed::ALL.map(|feed| Self { search, feed }))
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}+{}", self.feed.name(), self.search.name())
    }
}
