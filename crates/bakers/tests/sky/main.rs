//! What the tables of the sky promise, through the crate's public face.

mod closed_forms;
mod extremes;
mod invariance;
mod reference;
mod refusals;
mod support;
