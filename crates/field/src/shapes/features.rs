//! Single features with textbook closed forms: plane, wall, spike, Gaussian, pyramid.
//!
//! The wall is a discontinuity of the surface itself. Once it is rasterised, the bilinear surface between texel centres
//! turns it into a ramp one texel wide; the spike, which is *defined* by its texel, has that tent as its closed form.

use serde::{Deserialize, Serialize};

use super::check::{Check, half};
use super::{Axis, Surface};
use crate::{Edge, FieldError, Grid};

/// A plane through height 0 at the middle of the tile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    /// Rise per length along u; −1e6 … 1e6.
    pub slope_u: f64,
    /// Rise per length along v, which points up the picture; −1e6 … 1e6.
    pub slope_v: f64,
}

impl Plane {
    pub(super) const NAME: &'static str = "plane";

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        for (name, value) in [("slope_u", self.slope_u), ("slope_v", self.slope_v)] {
            Check(Self::NAME).within(name, value, -1e6..=1e6, "a slope from -1e6 to 1e6")?;
        }
        Ok(())
    }

    pub(super) fn surface(self, grid: &Grid) -> Surface {
        let (rise_u, rise_v) = (self.slope_u * grid.extent_u(), self.slope_v * grid.extent_v());
        Box::new(move |u, v| rise_u * (u - 0.5) + rise_v * (v - 0.5))
    }
}

/// Height 0 up to a position, `height` from there on to the border of the tile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StepWall {
    /// Height of the ground beyond the wall; a negative one is a drop.
    pub height: f64,
    /// Where the wall stands, as a fraction of the extent; the wall itself belongs to the far side.
    #[serde(default = "half")]
    pub position: f64,
    /// The axis that runs into the wall. Default `u`.
    #[serde(default)]
    pub across: Axis,
}

impl StepWall {
    pub(super) const NAME: &'static str = "step_wall";

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        Check(Self::NAME).height("height", self.height)?;
        Check(Self::NAME).fraction("position", self.position)
    }

    pub(super) fn surface(self) -> Surface {
        Box::new(move |u, v| if self.across.of(u, v) < self.position { 0.0 } else { self.height })
    }
}

/// Height 0 but for one texel, `(width / 2, height / 2)` rounded down: the bilinear tent around that texel's centre.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Spike {
    /// Height of the texel; a negative one is a pit.
    pub height: f64,
}

impl Spike {
    pub(super) const NAME: &'static str = "spike";

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        Check(Self::NAME).height("height", self.height)
    }

    pub(super) fn surface(self, grid: &Grid) -> Surface {
        let Grid { width, height, edge, .. } = *grid;
        // Rows are counted downwards and v upwards.
        let (from_left, from_bottom) = (width / 2, height.saturating_sub(1 + height / 2));
        Box::new(move |u, v| self.height * tent(u, from_left, width, edge) * tent(v, from_bottom, height, edge))
    }
}

/// The bilinear weight of texel `texel` of `size` at the fraction `t` of the axis.
fn tent(t: f64, texel: u32, size: u32, edge: Edge) -> f64 {
    if size <= 1 {
        return 1.0;
    }
    let (x, n, centre) = (t * f64::from(size), f64::from(size), f64::from(texel) + 0.5);
    let away = match edge {
        Edge::Clamp => x.clamp(0.5, n - 0.5) - centre,
        Edge::Wrap => x - centre - n * ((x - centre) / n).round(),
    };
    (1.0 - away.abs()).max(0.0)
}

/// A round Gaussian hill: `height · exp(−r² / 2σ²)`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gaussian {
    /// Height of the summit; a negative one is a hollow.
    pub height: f64,
    /// σ, a length.
    pub sigma: f64,
    /// Where the summit is, as a fraction of the extent along u. Default ½.
    #[serde(default = "half")]
    pub centre_u: f64,
    /// Where the summit is, as a fraction of the extent along v, upwards. Default ½.
    #[serde(default = "half")]
    pub centre_v: f64,
}

impl Gaussian {
    pub(super) const NAME: &'static str = "gaussian";

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        let check = Check(Self::NAME);
        check.height("height", self.height)?;
        check.length("sigma", self.sigma)?;
        check.fraction("centre_u", self.centre_u)?;
        check.fraction("centre_v", self.centre_v)
    }

    pub(super) fn surface(self, grid: &Grid) -> Surface {
        let (extent_u, extent_v) = (grid.extent_u(), grid.extent_v());
        Box::new(move |u, v| {
            let x = (u - self.centre_u) * extent_u / self.sigma;
            let y = (v - self.centre_v) * extent_v / self.sigma;
            self.height * libm::exp(-0.5 * (x * x + y * y))
        })
    }
}

/// A pyramid on a square base, with sides along u and v, on ground of height 0.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pyramid {
    /// Height of the apex; a negative one is a pit.
    pub height: f64,
    /// Half the side of the base, a length; the faces' slope is `height / half_width`.
    pub half_width: f64,
    /// Where the apex is, as a fraction of the extent along u. Default ½.
    #[serde(default = "half")]
    pub centre_u: f64,
    /// Where the apex is, as a fraction of the extent along v, upwards. Default ½.
    #[serde(default = "half")]
    pub centre_v: f64,
}

impl Pyramid {
    pub(super) const NAME: &'static str = "pyramid";

    pub(super) fn validate(&self) -> Result<(), FieldError> {
        let check = Check(Self::NAME);
        check.height("height", self.height)?;
        check.length("half_width", self.half_width)?;
        check.fraction("centre_u", self.centre_u)?;
        check.fraction("centre_v", self.centre_v)
    }

    pub(super) fn surface(self, grid: &Grid) -> Surface {
        let (extent_u, extent_v) = (grid.extent_u(), grid.extent_v());
        Box::new(move |u, v| {
            let x = ((u - self.centre_u) * extent_u).abs();
            let y = ((v - self.centre_v) * extent_v).abs();
            self.height * (1.0 - x.max(y) / self.half_width).max(0.0)
        })
    }
}
