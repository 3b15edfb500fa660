//! How stored points become the slope of a horizon on a curved base: the variants of the docs.

use barchan_shade::{Correction, StoredPoint, curved_horizon, geometric_horizon_as_printed, paper_horizon};

/// One variant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reading {
    /// The first point's slope as it is: no correction.
    Flat,
    /// The first point, corrected by eq 2 and eq 3 as printed.
    PaperAsPrinted,
    /// The first point, corrected by eq 2 and eq 3 with its sign mended.
    Paper,
    /// So many points, each carried over exactly: 1 to 3.
    Exact(u32),
}

impl Reading {
    /// Every variant, in the order of the docs.
    pub const ALL: [Self; 6] =
        [Self::Flat, Self::PaperAsPrinted, Self::Paper, Self::Exact(1), Self::Exact(2), Self::Exact(3)];

    /// Its name in records.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::PaperAsPrinted => "paper-as-printed",
            Self::Paper => "paper",
            Self::Exact(1) => "exact-1",
            Self::Exact(2) => "swept-2",
            Self::Exact(_) => "swept-3",
        }
    }

    /// Its name in the docs.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Flat => "no correction",
            Self::PaperAsPrinted => "paper as printed",
            Self::Paper => "paper, corrected",
            Self::Exact(1) => "one point, exact",
            Self::Exact(2) => "swept, K = 2",
            Self::Exact(_) => "swept, K = 3",
        }
    }

    /// The slope of the horizon seen from `height` above a base of a curvature, by the leading ones of at least as many
    /// `points` as it reads.
    #[must_use]
    pub fn slope(self, points: &[StoredPoint], curvature: f64, height: f64) -> f64 {
        match self {
            Self::Flat => points[0].slope,
            Self::PaperAsPrinted => {
                let eq_2 = Correction::Paper.slope(points[0], curvature, height);
                eq_2.max(geometric_horizon_as_printed(curvature, height))
            }
            Self::Paper => paper_horizon(points[0], curvature, height),
            Self::Exact(count) => curved_horizon(&points[..count as usize], curvature, height),
        }
    }
}
