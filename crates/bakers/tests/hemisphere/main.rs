//! What a hemisphere depth map promises, through the crate's public face.

mod agreement;
mod closed_forms;
mod conservative;
mod extremes;
mod invariance;
mod overshoots;
mod reduction;
mod reference;
mod refusals;
mod support;
