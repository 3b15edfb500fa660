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
//! horizon sweep per *bend* λ finds the point for it: [`Nodes`] says which bends, [`select()`] which of the points
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
//! `cargo xtask bench --only kappa` holds tables of the example shapes against brute force, by [`SweptBaker`]; the
//! README shows what it finds. The paper's correction is worse than none on fractal relief, on reptile skin and, at a
//! curvature of 0.015 per texel, on dunes; where ties are taken at their far end, even on half cylinders. On convex
//! surfaces the second point mends it: fractal terrain at 0.015 goes from 14° RMS to 0.6°, with the third to 0.1°. A
//! range of both signs wants three: the worst curvature decides, and one more point all goes to the concave side, where
//! far points rise to the zenith: at −0.015 and 200 texels, 172° round the hollow.
//!
//! Each layer costs an angle and a distance per texel and direction: 2 bytes in 8 bit, 4 in f16. So K = 2 takes 4 or
//! 8 bytes and K = 3 takes 6 or 12, against the 2 or 4 of the paper's table. f16 costs no error worth a digit; 8 bit
//! costs 0.07° RMS, which is what the third point leaves.
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
