//! What the curvature of a mesh promises, through the crate's public face.

mod accuracy;
mod broken;
mod holes;
mod extremes;
mod fast;
mod hubs;
mod invariance;
mod mended;
mod clamping;
mod reference;
mod shells;
mod slivers;
mod solids;
mod support;
