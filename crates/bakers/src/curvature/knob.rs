//! Scratch.
use std::sync::OnceLock;
pub(super) fn fo() -> f64 { static V: OnceLock<f64> = OnceLock::new(); *V.get_or_init(|| std::env::var("FO").map_or(0.6, |v| v.parse().unwrap())) }
pub(super) fn lf() -> f64 { static V: OnceLock<f64> = OnceLock::new(); *V.get_or_init(|| std::env::var("LF").map_or(5.0, |v| v.parse().unwrap())) }

pub(super) fn bn() -> usize { static V: OnceLock<usize> = OnceLock::new(); *V.get_or_init(|| std::env::var("BN").map_or(0, |v| v.parse().unwrap())) }
