//! Closed-form height fields: what tests measure against, and what samples are made of.
//!
//! # Conventions
//!
//! A shape is a surface over the whole tile, not an array: [`Shape::height_at`] gives it at any point and
//! [`Shape::rasterize`] samples it at the texel centres, in f64, and rounds once to f32. Points are fractions of the
//! tile: `u` is 0 at its left border and 1 at its right, `v` is 0 at its **bottom** border and 1 at its top, so texel
//! `(column, row)` has its centre at `u = (column + ½) / width`, `v = 1 − (row + ½) / height`. Heights, radii and widths
//! are in the grid's length unit, measured over the extents, so texels need not be square.
//!
//! # Tiling
//!
//! [`Ripples`], [`CylinderBumps`], [`ReptileSkin`], [`Dunes`] and [`FractalTerrain`] repeat exactly with the tile: counts
//! are whole numbers and the noise beneath them lives on a torus. The others are single features; they need
//! [`Edge::Clamp`](crate::Edge::Clamp), or room around them.
//!
//! # Determinism
//!
//! The same bits on every platform: integer hashing, `libm` for every transcendental, no fused multiply-add, and every
//! sum in a fixed order. The tests pin a digest of each example.
//!
//! # In recipes
//!
//! Each parameter set is a struct of its own. With RON's `unwrap_variant_newtypes` extension a shape reads
//! `Dunes(dune_height: 24.0, dunes_across: 2, ripple_height: 0.6, ripples_across: 48, seed: 7)`. Unknown fields are refused.

pub(crate) mod check;
mod crests;
mod cylinder_bumps;
mod dunes;
mod features;
mod fractal_terrain;
pub(crate) mod noise;
mod reptile_skin;
mod ripples;
#[cfg(test)]
mod tests;
mod wind_ripples;

use serde::{Deserialize, Serialize};

use crate::{FieldError, Grid, HeightField};

pub use cylinder_bumps::CylinderBumps;
pub use dunes::Dunes;
pub use features::{Gaussian, Plane, Pyramid, Spike, StepWall};
pub use fractal_terrain::FractalTerrain;
pub use reptile_skin::ReptileSkin;
pub use ripples::{RipplePattern, Ripples};

/// A closed-form height field.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Shape {
    /// An inclined plane.
    Plane(Plane),
    /// Low ground, then a vertical wall, then high ground.
    StepWall(StepWall),
    /// One texel that sticks out.
    Spike(Spike),
    /// A sinusoid, or two crossed ones.
    Ripples(Ripples),
    /// A Gaussian hill.
    Gaussian(Gaussian),
    /// A square pyramid.
    Pyramid(Pyramid),
    /// Rows of half-cylinders.
    CylinderBumps(CylinderBumps),
    /// Rounded polygonal scales with grooves between them.
    ReptileSkin(ReptileSkin),
    /// Wind-rippled dunes with slip faces.
    Dunes(Dunes),
    /// Fractal relief.
    FractalTerrain(FractalTerrain),
}

/// The surface of one shape over one grid: height at fractions `(u, v)` of the tile.
pub type Surface = Box<dyn Fn(f64, f64) -> f64 + Send + Sync>;

impl Shape {
    /// The name of every shape, in the order of [`Shape::examples`].
    pub const ALL_NAMES: [&'static str; 10] = [
        Plane::NAME,
        StepWall::NAME,
        Spike::NAME,
        Ripples::NAME,
        Gaussian::NAME,
        Pyramid::NAME,
        CylinderBumps::NAME,
        ReptileSkin::NAME,
        Dunes::NAME,
        FractalTerrain::NAME,
    ];

    /// One sensible instance of each shape, meant for a tile of 256 × 256 length units, at any resolution.
    #[must_use]
    pub fn examples() -> Vec<Self> {
        vec![
            Self::Plane(Plane { slope_u: 0.25, slope_v: -0.125 }),
            Self::StepWall(StepWall { height: 32.0, position: 0.5, across: Axis::U }),
            Self::Spike(Spike { height: 32.0 }),
            Self::Ripples(Ripples {
                amplitude: 4.0,
                waves_u: 8,
                waves_v: 0,
                phase: 0.0,
                pattern: RipplePattern::Oblique,
            }),
            Self::Gaussian(Gaussian { height: 48.0, sigma: 32.0, centre_u: 0.5, centre_v: 0.5 }),
            Self::Pyramid(Pyramid { height: 48.0, half_width: 64.0, centre_u: 0.5, centre_v: 0.5 }),
            Self::CylinderBumps(CylinderBumps { height: 8.0, rows: 16, coverage: 1.0, across: Axis::U }),
            Self::ReptileSkin(ReptileSkin { scale_height: 4.0, scales_across: 12, irregularity: 0.5, seed: 3 }),
            Self::Dunes(Dunes {
                dune_height: 24.0,
                dunes_across: 2,
                ripple_height: 0.6,
                ripples_across: 48,
                sinuosity: 0.6,
                slip_degrees: 32.0,
                seed: 7,
            }),
            Self::FractalTerrain(FractalTerrain { height: 40.0, hurst: 0.9, features_across: 2, octaves: 6, seed: 1 }),
        ]
    }

    /// The shape's name: lower case, words joined by `_`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Self::Plane(_) => Plane::NAME,
            Self::StepWall(_) => StepWall::NAME,
            Self::Spike(_) => Spike::NAME,
            Self::Ripples(_) => Ripples::NAME,
            Self::Gaussian(_) => Gaussian::NAME,
            Self::Pyramid(_) => Pyramid::NAME,
            Self::CylinderBumps(_) => CylinderBumps::NAME,
            Self::ReptileSkin(_) => ReptileSkin::NAME,
            Self::Dunes(_) => Dunes::NAME,
            Self::FractalTerrain(_) => FractalTerrain::NAME,
        }
    }

    /// Does the surface continue itself across the seam of a wrapped tile?
    #[must_use]
    pub fn tiles(&self) -> bool {
        matches!(
            self,
            Self::Ripples(_) | Self::CylinderBumps(_) | Self::ReptileSkin(_) | Self::Dunes(_) | Self::FractalTerrain(_)
        )
    }

    /// Refuses parameters that are not finite or out of range, naming the first.
    pub fn validate(&self) -> Result<(), FieldError> {
        match self {
            Self::Plane(p) => p.validate(),
            Self::StepWall(p) => p.validate(),
            Self::Spike(p) => p.validate(),
            Self::Ripples(p) => p.validate(),
            Self::Gaussian(p) => p.validate(),
            Self::Pyramid(p) => p.validate(),
            Self::CylinderBumps(p) => p.validate(),
            Self::ReptileSkin(p) => p.validate(),
            Self::Dunes(p) => p.validate(),
            Self::FractalTerrain(p) => p.validate(),
        }
    }

    /// The height at fractions `u` (rightwards) and `v` (upwards) of the tile, in the grid's length unit. Outside 0 … 1 a
    /// shape that [tiles](Self::tiles) repeats and any other goes on. Parameters or grids that [`Shape::rasterize`]
    /// refuses give a meaningless number.
    #[must_use]
    pub fn height_at(&self, grid: &Grid, u: f64, v: f64) -> f64 {
        self.surface(grid)(u, v)
    }

    /// [`Shape::height_at`] as a function, for many points: what depends on the grid alone is computed once.
    #[must_use]
    pub fn surface(&self, grid: &Grid) -> Surface {
        match *self {
            Self::Plane(p) => p.surface(grid),
            Self::StepWall(p) => p.surface(),
            Self::Spike(p) => p.surface(grid),
            Self::Ripples(p) => p.surface(),
            Self::Gaussian(p) => p.surface(grid),
            Self::Pyramid(p) => p.surface(grid),
            Self::CylinderBumps(p) => p.surface(),
            Self::ReptileSkin(p) => p.surface(grid),
            Self::Dunes(p) => p.surface(grid),
            Self::FractalTerrain(p) => p.surface(grid),
        }
    }

    /// The surface sampled at the texel centres of `grid`.
    pub fn rasterize(&self, grid: Grid) -> Result<HeightField, FieldError> {
        self.check_over(&grid)?;
        let Grid { width, height, .. } = grid;
        let surface = self.surface(&grid);
        let mut samples = Vec::with_capacity(grid.texels());
        for row in 0..height {
            let v = 1.0 - (f64::from(row) + 0.5) / f64::from(height);
            samples.extend((0..width).map(|column| surface((f64::from(column) + 0.5) / f64::from(width), v) as f32));
        }
        HeightField::new(grid, samples)
    }

    /// Refuses what [`Shape::rasterize`] does before it computes a height.
    ///
    /// # Errors
    /// A grid without texels, and parameters out of range for it, naming the first.
    pub fn check_over(&self, grid: &Grid) -> Result<(), FieldError> {
        let Grid { width, height, .. } = *grid;
        if width == 0 || height == 0 {
            return Err(FieldError::Empty { width, height });
        }
        self.validate()?;
        self.validate_over(grid)
    }

    /// What only the extents of the tile can refuse.
    fn validate_over(&self, grid: &Grid) -> Result<(), FieldError> {
        match self {
            Self::Dunes(p) => p.validate_over(grid),
            _ => Ok(()),
        }
    }
}

/// An axis of the tile.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// Rightwards, along rows.
    #[default]
    U,
    /// Upwards, along columns.
    V,
}

impl Axis {
    fn of(self, u: f64, v: f64) -> f64 {
        match self {
            Self::U => u,
            Self::V => v,
        }
    }
}
