//! The fast sweep of bent relief against its f64 twin.
//!
//! Held against each other is what either maximises, δ(s) − λs, as an angle: which of two points almost as high is
//! named does not matter. The sweep can only miss, so it is never above the twin, and what it names is a point of the
//! surface.

use std::f64::consts::PI;

use barchan_bakers::Exec;
use barchan_bakers::horizon::{BentLayer, HorizonParams, Method, bake_bent};
use barchan_bakers::swept::Tie;
use barchan_bakers::swept::reference::BentReference;
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};

use crate::support::params;

const WIDTH: u32 = 160;
const HEIGHT: u32 = 96;

/// Of 16 azimuths: 0°, 22.5°, 247.5°.
const DIRECTIONS: [u32; 3] = [0, 1, 11];

/// Edge, spacing and radius: within the tile and beyond it, texels that are not square.
///
/// A clamped field's radius beyond the tile is left to concave bends: convex ones have their horizon somewhere on the
/// level ground that goes on from its edge, of which the sweep sees only the two ends.
const PLACES: [(Edge, (f64, f64), f64); 5] = [
    (Edge::Wrap, (1.0, 1.0), 50.0),
    (Edge::Wrap, (1.0, 1.0), 200.0),
    (Edge::Wrap, (1.0, 2.5), 60.0),
    (Edge::Clamp, (1.0, 1.0), 50.0),
    (Edge::Clamp, (0.3, 0.2), 20.7),
];

fn relief(name: &str, edge: Edge, (u, v): (f64, f64)) -> HeightField {
    let grid =
        Grid { width: WIDTH, height: HEIGHT, spacing: Spacing::new(u, v).unwrap(), unit: LengthUnit::SceneUnit, edge };
    let named = Shape::examples().into_iter().find(|shape| shape.name() == name);
    named.map_or_else(|| noise(grid), |shape| shape.rasterize(grid).unwrap())
}

/// Heights from 0 to 1, texel by texel: SplitMix64's.
fn noise(grid: Grid) -> HeightField {
    let height = |index: u64| {
        let z = index.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z >> 40) as f32 / (1 << 24) as f32
    };
    HeightField::new(grid, (0..grid.texels() as u64).map(height).collect()).unwrap()
}

/// Degrees by which sweeps miss the highest point, and by which they pass it or leave the surface.
#[derive(Default)]
struct Errors {
    squares: f64,
    count: f64,
    above: f64,
    off_the_surface: f64,
}

impl Errors {
    fn rms(&self) -> f64 {
        (self.squares / self.count).sqrt()
    }

    fn add(&mut self, field: &HeightField, params: &HorizonParams, direction: u32, bend: f64) {
        let mut layer = BentLayer::new(field).unwrap();
        bake_bent(field, params, direction, bend, &Exec::new(1).unwrap(), &mut layer).unwrap();
        let twin = BentReference::new(field, params, direction, bend, Tie::Nearest);
        let (cos, sin) = params.azimuths.vector(direction);
        let (along_x, along_y) = (cos / field.grid().spacing.u(), -sin / field.grid().spacing.v());
        for texel in (0..field.grid().texels()).step_by(61) {
            let (column, row) = (texel as u32 % WIDTH, texel as u32 / WIDTH);
            let (slope, distance) = (f64::from(layer.slope[texel]), f64::from(layer.distance[texel]));
            assert!((0.0..=params.radius).contains(&distance));
            let degrees = |slope: f64, distance: f64| (slope - bend * distance).atan().to_degrees();
            let expected = twin.point(column, row);
            let error = degrees(slope, distance) - degrees(expected.slope, expected.distance);
            self.squares += error * error;
            self.count += 1.0;
            self.above = self.above.max(error);
            let height = |s: f64| field.surface(f64::from(column) + s * along_x, f64::from(row) + s * along_y);
            let seen = (height(distance) - height(0.0)) / distance;
            if distance > 0.0 {
                self.off_the_surface = self.off_the_surface.max((seen.atan() - slope.atan()).to_degrees().abs());
            }
        }
    }
}

/// Bends by the angle that the surface turns within the radius: λ = ½κ.
fn bend(turn: f64, radius: f64) -> f64 {
    0.5 * turn / radius
}

#[test]
fn bent_sweeps_miss_no_more_than_flat_ones() {
    for name in ["fractal_terrain", "ripples", "noise"] {
        for (edge, spacing, radius) in PLACES {
            let field = relief(name, edge, spacing);
            for (method, most) in [(Method::Sweep, 2.0), (Method::Accurate, 0.35), (Method::Exact, 0.35)] {
                let params = HorizonParams { method, ..params(16, radius) };
                for turn in [0.0, 0.5, 5.0, -0.5, -0.99 * PI] {
                    let mut errors = Errors::default();
                    for direction in DIRECTIONS {
                        errors.add(&field, &params, direction, bend(turn, radius));
                    }
                    let place = format!("{name} {edge:?} {spacing:?} {radius} {} {turn}", method.name());
                    assert!(errors.rms() < most, "{place}: {}° RMS", errors.rms());
                    assert!(errors.above < 1e-3, "{place}: {}° above", errors.above);
                    assert!(errors.off_the_surface < 1e-3, "{place}: {}° off", errors.off_the_surface);
                }
            }
        }
    }
}

/// In a hollow all relief rises with its distance, so the radius bounds what is found.
#[test]
fn steeply_concave_bends_end_at_the_radius() {
    for name in ["fractal_terrain", "ripples", "noise"] {
        for (edge, spacing, radius) in PLACES.into_iter().chain([(Edge::Clamp, (1.0, 1.0), 300.0)]) {
            let field = relief(name, edge, spacing);
            let mut layer = BentLayer::new(&field).unwrap();
            let lengths = field.range().1 - field.range().0;
            // Steep enough that the last texel's length outweighs all relief.
            let bend = -4.0 * f64::from(lengths) / (radius * spacing.0.min(spacing.1)) - 1.0 / radius;
            for direction in DIRECTIONS {
                let exec = Exec::new(1).unwrap();
                bake_bent(&field, &params(16, radius), direction, bend, &exec, &mut layer).unwrap();
                let near = layer.distance.iter().copied().fold(f32::INFINITY, f32::min);
                assert!(f64::from(near) > radius - 2.0 * spacing.0.max(spacing.1), "{name} {edge:?}: {near}");
                let mut errors = Errors::default();
                errors.add(&field, &params(16, radius), direction, bend);
                assert!(errors.rms() < 0.01, "{name} {edge:?} {radius}: {}° RMS", errors.rms());
            }
        }
    }
}
