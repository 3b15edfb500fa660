//! The directions and the depths of relief tables, as `formats/hemisphere-v1.md` defines them.

mod directions;
mod relief;

pub use directions::{HemisphereDirections, RingSpacing};
pub use relief::{DepthMode, ReliefRange};
