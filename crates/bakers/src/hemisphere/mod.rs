//! Hemisphere depth maps: how deep a ray may go before it can meet the relief.
//!
//! # What is baked
//!
//! Takeshi Suzuki, *An Accelerated Relief Mapping Using Depth Maps*: heights are turned into depths D = (top − h) / thickness, 0 at
//! the highest sample and 1 at the lowest, with h the bilinear surface. A ray comes from a direction on the hemisphere, enters the plane
//! at depth 0 and is followed to its first hit, the least d with D ≤ d at the place where the ray then is. That depth is stored *where
//! the ray enters*, for every texel of the top plane and every direction of a grid of rings and azimuths, so that a search through the
//! relief need not begin at the top.
//!
//! - [`DepthMode::Nearest`] is the paper's: of each cell of directions one ray is followed, that of the ring's inner edge and the middle
//!   of the azimuth, since the paper rounds the polar angle towards the apex and the azimuth to the nearest. Rays enter at the
//!   texel centres of the height map, and a texel of a smaller table has the least of its own, the paper's eq 2 (`nearest`, `reduce`).
//! - [`DepthMode::Conservative`] is the least over *all* rays of the cell of directions that enter anywhere in the texel, proven, not
//!   sampled: no search that begins there begins behind the surface (`conservative`).
//!
//! # Departures
//!
//! - The paper marches with steps; here the first hit on the bilinear surface is solved for, cell by cell.
//! - Eq 2 halves sides that are powers of two. Any size up to the map's own is accepted, and odd ones are defined.
//! - The paper has no word on rings at 90°. The last ring ends below, and begins lower still.
//! - Ring 0 of the nearest mode is vertical in all azimuths: the depths of the surface itself.
//!
//! # Conventions
//!
//! A direction points from the surface to the eye or the light, azimuths counter-clockwise from +u with v up the picture. A ray that
//! comes from polar angle θ and azimuth φ stands at depth d at its entry less d · thickness · tan θ · (cos φ, sin φ), in
//! lengths. Rays go on beyond the edge by the field's policy; a footprint of the reduction never does. On a relief without thickness all
//! depths are 0. In the nearest mode a ray is given up after 2¹⁷ texels, and the depth where it then stands is stored: less than its
//! hit's.
//!
//! [`DepthMode::Nearest`]: barchan_asset::DepthMode::Nearest
//! [`DepthMode::Conservative`]: barchan_asset::DepthMode::Conservative

mod baker;
mod conservative;
pub(crate) mod depths;
mod map;
mod nearest;
mod params;
mod path;
mod ray;
mod reduce;
pub mod reference;
mod windows;

pub use baker::{HemisphereBaker, bake};
pub use map::HemisphereMap;
pub use params::HemisphereParams;
