//! Rays against relief: what the exact trace, the searches and their starts promise.

#[path = "../common/mod.rs"]
mod common;

mod baked;
mod depth_map;
mod extremes;
mod rays;
mod searches;
mod support;
mod tables;
mod traced;
