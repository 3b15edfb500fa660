//! What the curvature of a mesh promises, through the crate's public face.

mod accuracy;
mod broken;
mod clamping;
mod extremes;
mod fast;
mod holes;
mod hubs;
mod invariance;
mod mended;
mod reference;
mod shells;
mod slivers;
mod solids;
mod support;
