//! Where a picture of a curved surface is taken from.

use glam::DVec3;

use crate::Ray;

/// How a camera spreads its rays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Lens {
    /// All parallel; the picture shows so much length from its lower to its upper edge, above 0.
    Orthographic {
        /// In the surface's length unit.
        height: f64,
    },
    /// All through the eye, so far apart from the lower to the upper edge, above 0 and below 180°.
    Perspective {
        /// In degrees.
        field_of_view: f64,
    },
}

/// A camera and its picture. The eye is not the target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Camera {
    /// Where it stands: outside all it is to see.
    pub eye: DVec3,
    /// What is in the middle of the picture.
    pub target: DVec3,
    /// What is up in the picture. Where it is along the line of sight, something else is.
    pub up: DVec3,
    /// How rays spread.
    pub lens: Lens,
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
}

/// The rays of an orthographic camera, which differ by steps alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParallelRays {
    /// Where the ray through the first pixel's centre is nearest to the target.
    pub corner: DVec3,
    /// From there to the next pixel's, to the right.
    pub across: DVec3,
    /// To the one below.
    pub down: DVec3,
    /// A unit vector towards the eye.
    pub towards_eye: DVec3,
}

impl Camera {
    /// Unit vectors along the line of sight, to the right and up in the picture.
    fn axes(&self) -> [DVec3; 3] {
        let forward = (self.target - self.eye).try_normalize().unwrap_or(DVec3::NEG_Z);
        let right = forward.cross(self.up).try_normalize().unwrap_or_else(|| forward.any_orthonormal_vector());
        [forward, right, right.cross(forward)]
    }

    /// The rays of [`Camera::rays`] by their steps; nothing for a lens that spreads them.
    #[must_use]
    pub fn parallel_rays(&self) -> Option<ParallelRays> {
        let Lens::Orthographic { height } = self.lens else { return None };
        let [forward, right, up] = self.axes();
        let pixel = height / f64::from(self.height);
        let to_corner = right * (0.5 - 0.5 * f64::from(self.width)) + up * (0.5 * f64::from(self.height) - 0.5);
        Some(ParallelRays {
            corner: self.target + to_corner * pixel,
            across: right * pixel,
            down: -up * pixel,
            towards_eye: -forward,
        })
    }

    /// The rays through the pixels' centres, row by row from the top.
    pub fn rays(&self) -> impl Iterator<Item = Ray> {
        let ([forward, right, up], camera) = (self.axes(), *self);
        // In units of half the picture's height.
        let half = 0.5 * f64::from(self.height);
        let across = move |column: u32| (f64::from(column) + 0.5 - 0.5 * f64::from(camera.width)) / half;
        let above = move |row: u32| 1.0 - (f64::from(row) + 0.5) / half;
        let ray = move |column, row| {
            let aside = right * across(column) + up * above(row);
            match camera.lens {
                Lens::Orthographic { height } => {
                    Ray { origin: camera.eye + aside * (0.5 * height), direction: forward }
                }
                Lens::Perspective { field_of_view } => {
                    let spread = libm::tan((0.5 * field_of_view).to_radians());
                    Ray { origin: camera.eye, direction: (forward + aside * spread).normalize() }
                }
            }
        };
        (0..self.height).flat_map(move |row| (0..camera.width).map(move |column| ray(column, row)))
    }
}
