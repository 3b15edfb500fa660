//! Where the texels of a field lie: extent, spacing, unit and what is beyond the edge.

use serde::{Deserialize, Serialize};

use crate::FieldError;

/// What the surface is beyond the outermost texel centres.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Edge {
    /// The field repeats: the texel after the last column is the first one.
    Wrap,
    /// The outermost texel centre's height goes on for ever, along each axis on its own.
    Clamp,
}

impl Edge {
    /// The texel that stands for index `i` of an axis of `size` texels; `size` must not be 0.
    #[inline]
    #[must_use]
    pub fn resolve(self, i: i64, size: u32) -> usize {
        let size = i64::from(size);
        let resolved = match self {
            Self::Wrap => i.rem_euclid(size),
            Self::Clamp => i.clamp(0, size - 1),
        };
        resolved as usize
    }

    /// `wrap` or `clamp`, as in recipes and on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Wrap => "wrap",
            Self::Clamp => "clamp",
        }
    }
}

/// The length unit of heights, spacings and distances. It labels results; nothing is converted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LengthUnit {
    /// The scene's own unit, whatever that is.
    #[default]
    SceneUnit,
    /// Metres.
    Metre,
    /// Centimetres.
    Centimetre,
    /// Millimetres.
    Millimetre,
    /// Kilometres.
    Kilometre,
}

impl LengthUnit {
    /// The symbol printed after a length.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::SceneUnit => "units",
            Self::Metre => "m",
            Self::Centimetre => "cm",
            Self::Millimetre => "mm",
            Self::Kilometre => "km",
        }
    }
}

/// Length per texel along u and along v, both positive and finite. Texels need not be square.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spacing {
    u: f64,
    v: f64,
}

impl Spacing {
    /// One length unit per texel along both axes.
    pub const UNIT: Self = Self { u: 1.0, v: 1.0 };

    /// Refuses zero, negative and non-finite lengths, and lengths outside 1e-30 … 1e30, whose squares and products
    /// with texel counts would leave the range of f32 tables.
    pub fn new(u: f64, v: f64) -> Result<Self, FieldError> {
        for (axis, value) in [('u', u), ('v', v)] {
            if !(1e-30..=1e30).contains(&value) {
                return Err(FieldError::Spacing { axis, value });
            }
        }
        Ok(Self { u, v })
    }

    /// The same length along both axes.
    pub fn square(length: f64) -> Result<Self, FieldError> {
        Self::new(length, length)
    }

    /// Length per texel along u.
    #[must_use]
    pub fn u(self) -> f64 {
        self.u
    }

    /// Length per texel along v.
    #[must_use]
    pub fn v(self) -> f64 {
        self.v
    }
}

/// Extent, spacing, unit and edge policy: all of a height field but its heights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Texels along u.
    pub width: u32,
    /// Texels along v.
    pub height: u32,
    /// Length per texel.
    pub spacing: Spacing,
    /// What lengths are measured in.
    pub unit: LengthUnit,
    /// What lies beyond the edge.
    pub edge: Edge,
}

impl Grid {
    /// Texels in all.
    #[must_use]
    pub fn texels(&self) -> usize {
        self.width as usize * self.height as usize
    }

    /// The field's extent along u, in its length unit.
    #[must_use]
    pub fn extent_u(&self) -> f64 {
        f64::from(self.width) * self.spacing.u()
    }

    /// The field's extent along v, in its length unit.
    #[must_use]
    pub fn extent_v(&self) -> f64 {
        f64::from(self.height) * self.spacing.v()
    }

    /// The length of the diagonal: no two points of the field are farther apart.
    #[must_use]
    pub fn diagonal(&self) -> f64 {
        libm::hypot(self.extent_u(), self.extent_v())
    }
}
