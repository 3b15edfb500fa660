//! The curvature-swept horizon: a few points per texel and direction instead of one, so that relief keeps its shadows
//! on a base surface of any curvature in a range.
//!
//! # Theory
//!
//! On a base surface of curvature κ, a point of slope δ at the distance d is seen from a texel at height h at about
//! δ(1 − κh) − ½κd: Koiichi Onoue, Nelson Max, Tomoyuki Nishita, *Bumpmap Shadows on Curved Surfaces*, eq 2. Over all
//! points of the relief that is (1 − κh) · max [δ(d) − λd], λ = κ/(2(1 − κh)): a maximum of straight lines in λ,
//! convex, whose pieces are the upper hull of the points (d, δ). As the surface bends, far points sink and a nearer
//! one takes over; the paper stores the first only and corrects it, which on relief of many scales is worse than no
//! correction.
//!
//! Baked are the few hull points that keep the angle of the horizon, by the exact formula, within an error over the
//! whole range, concave curvatures included. δ(d) − λd is the slope over the profile h(s) − λs², so one ordinary
//! horizon sweep per *bend* λ finds the point for it: [`Nodes`] says which bends, [`select`] which of the points
//! found are kept.
//!
//! The table has one layer of (δ, d) per point. The first is the flat horizon, the paper's table: a run time that
//! knows one point works as before. Later layers are in the order of what they are worth, so any number of leading
//! layers may be read. A run time takes the maximum over the points, each corrected, and the horizon of the smooth
//! surface: `barchan_shade::curved_horizon`.
//!
//! # Departures
//!
//! - Eq 2 drops a term of first order in κ, −κdδ², with the width of the point's own height: points are judged, and
//!   to be used, by the exact form, and bends reach half as far again as eq 2 says: [`Nodes`].
//! - Concave surfaces have no horizon of their own, and relief rises with distance: the search radius bounds the
//!   answer, up to half round the hollow.
//!
//! # What it saves
//!
//! RMS error of the angle in degrees against brute force, `cargo run --release -p barchan-bakers --example kappa`:
//! the example shapes on 256² texels, κ per texel length, search radius 200. At κ = 0 every column is exact. One
//! table per shape serves all rows. "Paper" is eq 2 and eq 3 of the flat map's point, "nearest" the same with ties as
//! [`CurvatureRange::tie`] has them, K the points kept, by the exact form, "all found" what the bends could give.
//!
//! Convex surfaces, κ from 0 to 0.015, 5 bends:
//!
//! | relief, κ | flat map | paper | paper, nearest | K = 1 | K = 2 | K = 3 | K = 4 | all found |
//! |---|---:|---:|---:|---:|---:|---:|---:|---:|
//! | ripples, 0.005 | 4.3 | 4.7 | 0.33 | 0.27 | 0.23 | 0.026 | 0.024 | 0.024 |
//! | ripples, 0.015 | 9.2 | 8.9 | 4.3 | 4.4 | 0.18 | 0.077 | 0.077 | 0.077 |
//! | cylinder bumps, 0.005 | 1.9 | 5.5 | 0.13 | 0.10 | 0.015 | 0.015 | 0.000 | 0.000 |
//! | cylinder bumps, 0.015 | 4.9 | 9.4 | 1.2 | 1.2 | 0.096 | 0.016 | 0.016 | 0.016 |
//! | reptile skin, 0.005 | 1.9 | 2.3 | 2.3 | 2.3 | 0.21 | 0.014 | 0.008 | 0.008 |
//! | reptile skin, 0.015 | 4.1 | 4.9 | 4.9 | 4.9 | 0.25 | 0.022 | 0.016 | 0.016 |
//! | dunes, 0.005 | 6.9 | 5.6 | 5.6 | 5.7 | 0.66 | 0.12 | 0.077 | 0.075 |
//! | dunes, 0.015 | 9.7 | 12.9 | 12.9 | 13.1 | 0.50 | 0.10 | 0.067 | 0.057 |
//! | fractal terrain, 0.005 | 5.5 | 6.1 | 6.1 | 6.3 | 0.70 | 0.082 | 0.041 | 0.039 |
//! | fractal terrain, 0.015 | 9.7 | 14.0 | 14.0 | 14.3 | 0.59 | 0.10 | 0.074 | 0.073 |
//!
//! Convex and concave, κ from −0.015 to 0.015, 8 bends:
//!
//! | relief, κ | flat map | paper | paper, nearest | K = 1 | K = 2 | K = 3 | K = 4 | all found |
//! |---|---:|---:|---:|---:|---:|---:|---:|---:|
//! | ripples, −0.015 | 72.6 | 58.3 | 63.3 | 62.2 | 0.32 | 0.000 | 0.000 | 0.000 |
//! | ripples, −0.005 | 17.9 | 11.7 | 14.4 | 14.3 | 0.090 | 0.043 | 0.012 | 0.011 |
//! | ripples, 0.005 | 4.3 | 4.7 | 0.33 | 0.27 | 0.27 | 0.23 | 0.024 | 0.024 |
//! | ripples, 0.015 | 9.2 | 8.9 | 4.3 | 4.4 | 4.4 | 0.18 | 0.077 | 0.077 |
//! | cylinder bumps, −0.015 | 72.5 | 58.0 | 68.3 | 68.1 | 0.000 | 0.000 | 0.000 | 0.000 |
//! | cylinder bumps, −0.005 | 19.8 | 13.3 | 18.3 | 18.3 | 0.15 | 0.003 | 0.003 | 0.000 |
//! | cylinder bumps, 0.005 | 1.9 | 5.5 | 0.13 | 0.10 | 0.10 | 0.015 | 0.000 | 0.000 |
//! | cylinder bumps, 0.015 | 4.9 | 9.4 | 1.2 | 1.2 | 1.2 | 0.096 | 0.016 | 0.016 |
//! | reptile skin, −0.015 | 74.8 | 68.3 | 68.3 | 67.8 | 0.74 | 0.069 | 0.009 | 0.000 |
//! | reptile skin, −0.005 | 20.1 | 17.4 | 17.4 | 17.4 | 0.21 | 0.028 | 0.013 | 0.006 |
//! | reptile skin, 0.005 | 1.9 | 2.3 | 2.3 | 2.3 | 2.2 | 0.23 | 0.015 | 0.008 |
//! | reptile skin, 0.015 | 4.1 | 4.9 | 4.9 | 4.9 | 4.8 | 0.21 | 0.023 | 0.016 |
//! | dunes, −0.015 | 76.7 | 58.6 | 58.6 | 55.1 | 4.6 | 0.063 | 0.021 | 0.000 |
//! | dunes, −0.005 | 20.3 | 12.7 | 12.7 | 12.4 | 1.0 | 0.12 | 0.039 | 0.019 |
//! | dunes, 0.005 | 6.9 | 5.6 | 5.6 | 5.7 | 3.5 | 0.59 | 0.10 | 0.075 |
//! | dunes, 0.015 | 9.7 | 12.9 | 12.9 | 13.1 | 9.6 | 0.40 | 0.085 | 0.057 |
//! | fractal terrain, −0.015 | 72.0 | 56.3 | 56.3 | 52.7 | 5.6 | 0.27 | 0.023 | 0.000 |
//! | fractal terrain, −0.005 | 17.6 | 11.0 | 11.0 | 10.7 | 1.2 | 0.21 | 0.11 | 0.077 |
//! | fractal terrain, 0.005 | 5.5 | 6.1 | 6.1 | 6.3 | 2.3 | 0.65 | 0.083 | 0.039 |
//! | fractal terrain, 0.015 | 9.7 | 14.0 | 14.0 | 14.3 | 8.8 | 0.48 | 0.095 | 0.073 |
//!
//! The paper's correction is worse than none on fractal relief, on reptile skin and, at 0.015, on dunes; where ties
//! are taken at their far end, even on half cylinders. On convex surfaces the second point mends it. A range of both
//! signs wants three: the worst curvature decides, and one more point all goes to the concave side, where far points
//! rise to the zenith: at −0.015 and 200 texels, 172° round the hollow.
//!
//! Each layer costs an angle and a distance per texel and direction: 2 bytes in 8 bit, 4 in f16. So K = 2 takes 4 or
//! 8 bytes and K = 3 takes 6 or 12, against the 2 or 4 of the paper's table.
//!
//! # Conventions
//!
//! κ in the inverse of the field's length unit, positive where convex, in the direction of the azimuth. Heights are
//! above the base surface, heights of 0: relief stands on it, and what lies below counts as on it where the smooth
//! surface hides things.

mod accuracy;
mod bake;
mod layers;
mod nodes;
mod params;
mod ray;
pub mod reference;
mod select;

pub use accuracy::SelectionErrors;
pub use bake::SweptBaker;
pub use layers::{CandidateLayer, PointLayerMut, measure_band, select_band};
pub use nodes::Nodes;
pub use params::{CurvatureRange, MAX_POINTS, Points, SweptParams, Tie};
pub use select::{HorizonCandidate, losses_by_count, select};

/// Names the algorithm in provenance. It changes when a table's bytes do.
pub const ALGORITHM: &str = "horizon-swept-1";
