//! What a horizon map promises, through the crate's public face.

mod agreement;
mod closed_forms;
mod extremes;
mod invariance;
mod reference;
mod refusals;
mod support;
