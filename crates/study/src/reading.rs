//! How stored points become the slope of a horizon on a curved base: the variants that the docs compare, and their names.

use barchan_shade::{
    Correction, CurvedMethod, StoredPoint, curved_horizon, geometric_horizon_as_printed, paper_horizon,
};

/// The most points that any variant reads.
pub(crate) const MOST_POINTS: u32 = 3;

/// A variant's name in the docs.
pub(crate) fn title(method: CurvedMethod) -> &'static str {
    match method {
        CurvedMethod::Flat => "no correction",
        CurvedMethod::PaperAsPrinted => "paper as printed",
        CurvedMethod::Paper => "paper, corrected",
        CurvedMethod::Exact(0 | 1) => "one point, exact",
        CurvedMethod::Exact(2) => "swept, K = 2",
        CurvedMethod::Exact(_) => "swept, K = 3",
    }
}

/// The slope of the horizon seen from `height` above a base of a curvature, by the leading ones of at least as many
/// `points` as the variant reads. No relief is below the base.
pub(crate) fn slope(method: CurvedMethod, points: &[StoredPoint], curvature: f64, height: f64) -> f64 {
    match method {
        CurvedMethod::Flat => points[0].slope,
        CurvedMethod::PaperAsPrinted => {
            let eq_2 = Correction::Paper.slope(points[0], curvature, height);
            eq_2.max(geometric_horizon_as_printed(curvature, height))
        }
        CurvedMethod::Paper => paper_horizon(points[0], curvature, height),
        CurvedMethod::Exact(_) => curved_horizon(&points[..method.points() as usize], curvature, height),
    }
}
