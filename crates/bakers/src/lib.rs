//! The list of bakers, and nothing else: each is a folder that turns a typed field into a typed table.
//!
//! A baker opens no file, prints nothing and starts no thread of its own: how work runs is said by [`Exec`], which must
//! not change a bit of the result.

pub mod cone;
pub mod curvature;
mod error;
mod exec;
pub mod hemisphere;
pub mod horizon;
pub mod maximum_mip;
mod memory;
pub mod sky;
pub mod swept;

pub use error::BakeError;
pub use exec::Exec;
