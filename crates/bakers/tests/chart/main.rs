//! What the forms of curvature in texture coordinates promise, through the crate's public face. The curvature they are made of is
//! exact here.

mod closed_forms;
mod odd_charts;
mod support;
