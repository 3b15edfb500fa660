//! What the run-time equations promise, through the crate's public face and encoded tables.

#[path = "../common/mod.rs"]
mod common;

mod closed_forms;
mod horizon_map;
mod picture;
mod support;
mod traced;
