//! What a horizon map promises, through the crate's public face.

mod agreement;
mod closed_forms;
mod extremes;
#[path = "../common/fields.rs"]
mod fields;
mod invariance;
#[path = "../common/random.rs"]
mod random;
mod reference;
mod refusals;
mod support;
