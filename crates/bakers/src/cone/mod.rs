//! Cone maps: how wide a cone above every texel is free of the relief.
//!
//! # What is baked
//!
//! For every texel its depth, 0 at the highest sample and 1 at the lowest, and the **ratio** r of a cone that stands on
//! its tip on the surface: r = horizontal length / length in height. A ray that is above the surface at P by the height
//! g and goes s horizontally for every length that it sinks may sink by r g / (s + r): so far it is inside the cone. That
//! is one look-up a step. Jonathan Dummer, *Cone Step Mapping: An Iterative Ray-Heightfield Intersection Algorithm*, 2006.
//!
//! # Strict cones
//!
//! Dummer's cone is free of the surface at texel centres, and what a bilinear filter makes of four such cones is a cone
//! of nothing. Here texel k holds
//!
//! > r_k = inf |Q − P| / (h(Q) − h(P)) over all P within a texel of its centre along u and v, and all higher Q,
//!
//! h the bilinear surface with all that the edge policy makes of it.
//!
//! **Filtered, they hold at every place.** Let P be anywhere and w_k ≥ 0 the weights of the bilinear filter there, which
//! sum to 1. Texels with w_k > 0 have P within a texel of their centres, so r_k ≤ r(P), the ratio of the widest cone
//! that is free at P itself, and so Σ w_k r_k ≤ r(P). Depths are rounded down, D'_k ≤ D_k; the surface being bilinear,
//! Σ w_k D'_k ≤ Σ w_k D_k = D(P): the filtered depth is that of a point on or above the surface, and a cone on a higher
//! tip with the same ratio is inside the cone of P. So a step ends before or on the first hit, for any ray, and may be
//! rounded to any length that is not longer.
//!
//! **Finding r.** A place within a texel of a centre is in one of the four cells around it, so that r_k is the least of
//! the ratios of four cells, each of which serves four texels. For a cell F the steepest ascent 1/r_F = sup (h(Q) − h(P)) /
//! |Q − P| over P in F is bounded as follows.
//!
//! - *Q in F or one of the eight cells around it*: the way from P to Q stays in these nine. On it the mean slope is at
//!   most the greatest derivative along it, and its direction is of the half or quarter plane that leads from F to the
//!   cell. The greatest derivative in such directions is a convex function of the gradient, and each component of
//!   the gradient of a bilinear cell is linear in one coordinate: the maximum is at the corners.
//! - *Q farther*: let Q's ascent be steeper than all gradients of F. Then P may be moved towards Q to where the way leaves
//!   F, which only makes the ascent steeper: it is enough to look at the sides of F that face Q. A side and a cell
//!   are compared by their corners, which bounds the slope from above and below (`bounds`), and halved where these are
//!   farther apart than 1/64 of the slope.
//! - *Which Q*: squares of the maximum mip, the most promising first, and of those nothing that its highest point, its
//!   distance and F's lowest corner rule out. Of a tile that repeats, only cells within half a tile along u and v are
//!   looked at: each other is as high as one of these and farther away.
//! - *Beyond clamped edges* places have the heights of their nearest on the edge, and two such are no nearer to each
//!   other than those. So the cells of the tile are enough, for P and for Q.
//!
//! # Relaxed cones
//!
//! Fabio Policarpo, Manuel M. Oliveira, *Relaxed Cone Stepping for Relief Mapping*, GPU Gems 3, ch. 18, 2007: a step may
//! end inside the relief if only it cannot come out again, for then a bisection finds the hit. Let A be the point of the
//! top plane above the centre of texel k. Here
//!
//! > r_k = inf |E − P| / (h(E) − h(P)) over all higher points E where a ray from A leaves the relief, P the texel's own
//! > point.
//!
//! The paper samples rays through all texels and follows each to its first exit; every exit is the first one behind some
//! point of the surface, so that in the limit both are the same. Of the bilinear cell D = a + b u + c v + t u v, in depths
//! and lengths from A, the exits are the points t u v > a, as (u, v) · ∇D > D says that the ray goes out; no ray need be
//! followed. The rest is the search of the strict cones with P a single point.
//!
//! What relaxed cones do **not** promise: they are made for rays from A. A ray that passes above the texel lower than A,
//! as all but the first step do, leaves the relief at places where none from A does, and may go in and out of a ridge
//! within one step; so may one between texel centres. Exits beyond clamped edges, or farther than one tile along u or v,
//! are not looked at. Hits are missed, therefore, of all kinds of relief; the test `relaxed` says how many.
//!
//! # Conventions
//!
//! Ratios are pure numbers, rounded down, and slopes lengths over lengths: texels need not be square. No ratio exceeds
//! the tile's diagonal / the relief's thickness, nor [`MAX_RATIO`], which is the ratio of
//! relief without thickness, but for rounding; on the highest plateau, where no cone ends, it is this that is stored. A wall too steep for f32 has ratio 0. Where r is
//! not capped, what is stored is within 1/64 of what the corners of halved cells prove; against the true infimum only
//! the bound of the nine nearest cells is wider than that.

mod ascent;
mod bounds;
mod ground;
mod map;
mod patch;
pub mod reference;
mod relaxed;
mod strict;

use barchan_asset::f32_at_most;
use barchan_field::{Grid, HeightField};

pub use map::{ConeKind, ConeMap};

use crate::hemisphere::depths::relief_range;
use crate::memory::zeros;
use crate::{BakeError, Exec, maximum_mip};

/// No cone is wider: the greatest number of 16-bit floats, a half-angle within 2 · 10⁻⁵ of a right angle.
pub const MAX_RATIO: f64 = 65504.0;

/// Bakes the depth and the cone of every texel.
///
/// # Errors
///
/// [`BakeError::Memory`] or [`BakeError::TooLarge`] where the map and what it takes to bake it do not fit.
pub fn bake(field: &HeightField, kind: ConeKind, exec: &Exec) -> Result<ConeMap, BakeError> {
    let grid = *field.grid();
    let relief = relief_range(field);
    let mut values = zeros("the cone map", 2 * grid.texels() as u64)?;
    let mip = maximum_mip::bake(field, exec)?;
    let ground = ground::Ground::new(field);
    let least = 1.0 / widest(&grid, relief.thickness);
    let slopes = match kind {
        ConeKind::Strict => strict::slopes(&ground, &mip, least, exec)?,
        ConeKind::Relaxed => relaxed::slopes(&ground, &mip, relief.top, least, exec)?,
    };
    let shortest = grid.spacing.u().min(grid.spacing.v());
    for ((texel, &height), &slope) in values.chunks_exact_mut(2).zip(field.samples()).zip(&slopes) {
        texel[0] = f32_at_most(relief.depth(f64::from(height)));
        texel[1] = f32_at_most(1.0 / with_rounding(slope, relief.thickness / shortest));
    }
    Ok(ConeMap { grid, relief, values })
}

/// The ratio of the widest cone that is stored.
fn widest(grid: &Grid, thickness: f64) -> f64 {
    (grid.diagonal() / thickness).min(MAX_RATIO)
}

/// A slope that is no less for what f64 has rounded. A few operations each round by 2⁻⁵³; heights between texels round by
/// as much of the thickness, over at least a texel's length: `greatest` is the slope of the thickness over that.
fn with_rounding(slope: f64, greatest: f64) -> f64 {
    slope * (1.0 + 2.0_f64.powi(-40)) + greatest * 2.0_f64.powi(-48)
}
