//! Error between fields and between pictures: RMS, maximum, where it is worst, percentiles, false colour.
//!
//! Slices and iterators in, numbers out: no files, no printing, no dependency. Whatever is measured, the answer does not
//! depend on how many threads computed the inputs: sums are f64, compensated, and taken in index order.

mod colour;
mod error_stats;
mod mask;
mod sum;

pub use colour::{false_colour, signed_colour};
pub use error_stats::{Difference, ErrorStats, Percentiles, first_difference};
pub use mask::MaskDisagreement;
