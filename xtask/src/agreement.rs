//! `cargo xtask agreement`: the table of errors that the README quotes.

use anyhow::Result;

use crate::run::cargo;

/// Every closed form, and the real terrain, whose samples are whole metres: 65535 m is white.
pub(crate) fn agreement() -> Result<()> {
    cargo("run --release -p barchan-bakers --example agreement -- samples/jacksboro.png 65535 0")
}
