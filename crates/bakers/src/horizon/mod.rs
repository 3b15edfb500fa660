//! Horizon and distance maps from a height field.
//!
//! # What is baked
//!
//! For texel P and azimuth φ, with h the bilinear surface,
//!
//! > δ = sup over 0 < s ≤ radius of (h(P + s φ̂) − h(P)) / s
//!
//! is the slope of the horizon, and d the distance s at which it is reached: Koiichi Onoue, Nelson Max, Tomoyuki
//! Nishita, *Bumpmap Shadows on Curved Surfaces*, eq 4, after Nelson Max, *Horizon mapping: shadows for bump-mapped
//! surfaces*, 1988. The table holds the elevation atan δ, which is bounded where δ is not.
//!
//! # Departures
//!
//! - Eq 4 as printed drops −h(P) and misplaces a parenthesis; the form above is the one meant.
//! - δ is signed: a peak sees its horizon below the horizontal, and shading on a curved surface needs to know.
//! - The surface is the bilinear one between samples and on beyond the edge by the field's policy; it is not sampled
//!   along the ray. Where it falls away below its own tangent, the supremum is the limit s → 0, and d is 0.
//! - Of several points at the same slope the farthest counts, so a level field has d = radius, never 0.
//!
//! # Methods
//!
//! [`Method::Sweep`] and [`Method::Accurate`] are line sweeps in f32 that name points of the texel's own ray and can miss
//! the highest; [`Method::Exact`] proves or corrects what they found, in f64. How each works: `sweep`, `near`, `far`, `exact`.
//!
//! # Conventions
//!
//! N azimuths 2πk/N, k = 0 along +u, or an arc, counter-clockwise as seen in the picture; v points up the picture. φ̂ is a unit
//! vector in lengths, not in texels: with texels twice as high as wide, 45° is not the texel diagonal.

mod atan;
mod azimuths;
mod bake;
mod bands;
mod best;
mod direction;
mod exact;
mod far;
mod lane_hull;
mod lines;
mod map;
mod near;
mod own_ray;
mod params;
pub mod reference;
mod sheared;
mod sliding_hull;
mod sweep;

pub use azimuths::Azimuths;
pub use bake::{bake, bake_bent, bake_direction};
pub use map::{BentLayer, HorizonLayer, HorizonMap, HorizonPoint};
pub use params::{HorizonParams, MAX_DIRECTIONS, MAX_RADIUS_TEXELS, Method};

use barchan_asset::MAX_ELEVATION as MAX_ELEVATION_RADIANS;

/// Names the algorithm in provenance. It changes when a bake's bytes do.
pub const ALGORITHM: &str = "horizon-sweep-2";
