//! Tables that speed up the search for where a ray meets a relief: their directions, depths and views.
//!
//! `formats/hemisphere-v1.md`, `formats/cone-v1.md` and `formats/maximum-v1.md` are the law.

mod directions;
mod relief;
mod views;

pub use directions::{HemisphereDirections, RingSpacing};
pub use relief::{DepthMode, ReliefRange};
pub use views::{ConeMapView, HemisphereView, MaximumMipView, RelaxedConeMapView};
