//! What relief does to light: shadows and occlusion by relief rays, against the traced truth and closed forms; what a camera sees of
//! it, and heat maps.

#[path = "../common/mod.rs"]
mod common;
mod heat;
mod occlusion;
mod quadrature;
mod shadow;
mod support;
mod view;
