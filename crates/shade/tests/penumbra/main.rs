//! Soft shadows of disc lights, through the crate's public face and encoded tables.

#[path = "../common/mod.rs"]
mod common;

mod closed_forms;
mod support;
mod tables;
mod traced;
