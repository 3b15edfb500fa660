//! Range checks that the shapes share.

use std::ops::RangeInclusive;

use crate::FieldError;

/// Refusals for one shape.
pub(crate) struct Check(pub(crate) &'static str);

impl Check {
    /// `value` must lie in `range`; a NaN never does.
    pub(crate) fn within(
        &self,
        name: &'static str,
        value: f64,
        range: RangeInclusive<f64>,
        accepted: &'static str,
    ) -> Result<(), FieldError> {
        if range.contains(&value) { Ok(()) } else { Err(self.refusal(name, value, accepted)) }
    }

    /// A height: any sign, and small enough for f32 tables.
    pub(super) fn height(&self, name: &'static str, value: f64) -> Result<(), FieldError> {
        self.within(name, value, -1e30..=1e30, "a finite length from -1e30 to 1e30")
    }

    /// A height that must not be negative.
    pub(super) fn rise(&self, name: &'static str, value: f64) -> Result<(), FieldError> {
        self.within(name, value, 0.0..=1e30, "a finite length from 0 to 1e30")
    }

    /// A width, radius or wavelength.
    pub(super) fn length(&self, name: &'static str, value: f64) -> Result<(), FieldError> {
        self.within(name, value, 1e-30..=1e30, "a positive length from 1e-30 to 1e30")
    }

    /// A position, as a fraction of the extent.
    pub(super) fn fraction(&self, name: &'static str, value: f64) -> Result<(), FieldError> {
        self.within(name, value, 0.0..=1.0, "a fraction of the extent from 0 to 1")
    }

    /// How often something repeats across the tile.
    pub(super) fn count(&self, name: &'static str, value: u32) -> Result<(), FieldError> {
        self.within(name, f64::from(value), 1.0..=65536.0, "a count from 1 to 65536")
    }

    pub(crate) fn refusal(&self, name: &'static str, value: f64, accepted: &'static str) -> FieldError {
        FieldError::Parameter { shape: self.0, name, value, accepted }
    }
}

/// One half: the middle of the tile.
pub(super) fn half() -> f64 {
    0.5
}
