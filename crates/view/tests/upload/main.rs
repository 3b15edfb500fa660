//! Uploads: what arrives, and what becomes of a device that refuses, is lost, or is shared.

mod arrival;
mod refusal;
mod support;
