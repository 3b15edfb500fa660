//! What cone maps promise, through the crate's public face.

mod closed_forms;
mod extremes;
mod invariance;
mod reference;
mod relaxed;
mod strict;
mod support;
