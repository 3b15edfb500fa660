//! What a hemisphere depth map promises, through the crate's public face.

mod agreement;
mod closed_forms;
mod extremes;
mod invariance;
mod reduction;
mod reference;
mod refusals;
mod support;
