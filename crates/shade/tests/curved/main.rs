//! Shading of relief on curved surfaces, through the crate's public face and encoded tables.

mod bases;
mod forms;
mod support;
mod traced;
