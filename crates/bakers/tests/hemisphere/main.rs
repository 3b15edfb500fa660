//! What a hemisphere depth map promises, through the crate's public face.

mod agreement;
mod closed_forms;
mod conservative;
mod extremes;
#[path = "../common/fields.rs"]
mod fields;
mod invariance;
mod overshoots;
#[path = "../common/random.rs"]
mod random;
mod reduction;
mod reference;
mod refusals;
mod support;
