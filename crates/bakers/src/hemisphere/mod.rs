//! Hemisphere depth maps: how deep a ray may go before it can meet the relief.

mod baker;
mod conservative;
pub(crate) mod depths;
mod map;
mod nearest;
mod params;
mod path;
pub(crate) mod ray;
mod reduce;
pub mod reference;
mod windows;

pub use baker::{HemisphereBaker, bake};
pub use map::HemisphereMap;
pub use params::HemisphereParams;
