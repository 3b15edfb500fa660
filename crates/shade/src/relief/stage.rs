//! Plain scenes of relief: a plane or a ball that wears it, and the camera that sees all there is to see.

use std::f64::consts::TAU;

use barchan_asset::Wrap;
use glam::{DMat2, DVec2, DVec3};

use crate::{BaseSurface, Camera, DirectionalLight, Lens, Plane, Sphere, SphereChart, Surface};

/// How much longer a picture is than what is in it, where that ends.
const MARGIN: f64 = 1.04;

/// A base surface for relief before a camera, whose rays are parallel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReliefStage {
    /// What wears the relief.
    pub base: StageBase,
    /// What looks at it.
    pub camera: Camera,
}

/// What wears the relief of a stage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StageBase {
    /// The plane z = 0.
    Plane(Plane),
    /// A ball round the origin.
    Ball(Sphere),
}

/// From where a stage is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StageEye {
    /// In degrees, counter-clockwise from +x: 270 looks along +y.
    pub azimuth: f64,
    /// Above the plane z = 0, in degrees, −90 to 90.
    pub elevation: f64,
    /// Pixels of the picture's longer side, at least 1.
    pub size: u32,
}

impl ReliefStage {
    /// Relief on the plane z = 0, as long as its tile is: u along x, v along y.
    ///
    /// A tile that wraps fills the picture, 4 to 3, of which `tiles` are as wide as it is; one that is clamped is seen once,
    /// whole.
    #[must_use]
    pub fn plane(surface: &Surface, eye: StageEye, tiles: u32) -> Self {
        let extent = DVec2::from(surface.extent());
        let (_, right, up) = eye.axes();
        let seen = |axis: DVec3| axis.truncate().abs().dot(extent);
        let view = if Self::repeats(surface) {
            DVec2::new(1.0, 0.75) * f64::from(tiles.max(1)) * extent.x
        } else {
            // Of a tile seen from its edge nothing is left.
            MARGIN * DVec2::new(seen(right), seen(up).max(1e-3 * seen(right)))
        };
        Self {
            base: StageBase::Plane(Plane { chart: DMat2::from_diagonal(extent) }),
            camera: eye.camera((0.5 * extent).extend(0.0), view),
        }
    }

    /// Relief on a ball round the origin, around whose equator the tile goes `tiles` times. It should wrap.
    #[must_use]
    pub fn ball(surface: &Surface, eye: StageEye, tiles: u32) -> Self {
        let tile = DVec2::from(surface.extent());
        let radius = f64::from(tiles.max(1)) * tile.x / TAU;
        Self {
            base: StageBase::Ball(Sphere { radius, hollow: false, chart: SphereChart::Geographic, tile }),
            camera: eye.camera(DVec3::ZERO, DVec2::splat(2.0 * MARGIN * radius)),
        }
    }

    /// Whether a tile goes on in both directions.
    #[must_use]
    pub fn repeats(surface: &Surface) -> bool {
        surface.heights().wrap() == (Wrap::Repeat, Wrap::Repeat)
    }
}

impl StageBase {
    /// The surface.
    #[must_use]
    pub fn surface(&self) -> &dyn BaseSurface {
        match self {
            Self::Plane(plane) => plane,
            Self::Ball(sphere) => sphere,
        }
    }
}

impl StageEye {
    /// Unit vectors towards the eye, and to the right and up in its picture.
    fn axes(&self) -> (DVec3, DVec3, DVec3) {
        let towards = DirectionalLight::from_degrees(self.azimuth, self.elevation).towards;
        // The azimuth a quarter turn on, level: also where the eye is straight above.
        let right = DirectionalLight::from_degrees(self.azimuth + 90.0, 0.0).towards;
        (towards, right, towards.cross(right))
    }

    /// A camera that sees so much length across and down.
    fn camera(&self, target: DVec3, view: DVec2) -> Camera {
        let (towards, _, up) = self.axes();
        // An eye above the plane z = 0 is above it in the lowest row of the picture, too.
        let lowest = if towards.z > 0.0 { 0.5 * view.y * up.z / towards.z } else { 0.0 };
        let pixels = |length: f64| (f64::from(self.size) * length / view.max_element()).round().max(1.0) as u32;
        Camera {
            eye: target + towards * lowest.max(4.0 * view.element_sum()),
            target,
            up,
            lens: Lens::Orthographic { height: view.y },
            width: pixels(view.x),
            height: pixels(view.y),
        }
    }
}
