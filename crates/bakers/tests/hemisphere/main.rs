//! What a hemisphere depth map promises, through the crate's public face.

mod agreement;
mod support;
