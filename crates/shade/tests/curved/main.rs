//! Shading of relief on curved surfaces, through the crate's public face and encoded tables.

#[path = "../common/mod.rs"]
mod common;

mod bases;
mod equations;
mod forms;
mod picture;
mod shadow;
mod support;
mod tangent;
mod traced;
