//! What the curvature-swept horizon promises, through the crate's public face and as a run time reads it.

mod baker;
mod references;
mod refusals;
mod selection;
mod support;
mod sweeps;
