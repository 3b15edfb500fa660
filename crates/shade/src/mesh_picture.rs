//! A picture of a mesh whose vertices have colours, for those who have no viewer at hand.
//!
//! Triangles are drawn into samples, four to a pixel, and the nearest stays; of equally near ones the first in the mesh. Both
//! sides of a triangle are seen. A lamp beside the eye, and some light from everywhere, show the form: colour · (a + (1 − a)
//! |n · v|), in linear light. A picture is drawn in bands, so that samples take little memory however large it is.

use std::ops::Range;

use glam::DVec3;

use crate::mesh_cover::{STEPS, cover};
use crate::mesh_normals::SmoothNormals;
use crate::mesh_view::{MeshView, SeenMesh};
use crate::picture::{BACKGROUND, Picture, encode_srgb};

/// Samples per pixel, across and down.
const SAMPLES: u32 = 2;

/// The most pixels that a picture of a mesh may have on a side.
pub const MAX_MESH_PICTURE: u32 = 8192;

/// Rows of pixels drawn at a time.
const BAND: u32 = 64;

/// The share of light that comes from everywhere.
const AMBIENT: f64 = 0.1;

/// A mesh to draw.
#[derive(Debug, Clone, Copy)]
pub struct ColouredMesh<'a> {
    /// Of vertices, in any unit: finite, within ±1e30.
    pub positions: &'a [DVec3],
    /// Of vertices, sRGB, interpolated over triangles.
    pub colours: &'a [[u8; 3]],
    /// Three vertices each.
    pub triangles: &'a [[u32; 3]],
}

impl Picture {
    /// All of a mesh on a dark ground, in a picture whose longer side has `size` pixels, 1 to [`MAX_MESH_PICTURE`]. The other side follows what
    /// is seen; the picture is an empty square where that has no extent.
    ///
    /// # Panics
    /// If `size` is out of range, there is not one colour per vertex, or a triangle names a vertex that does not exist.
    #[must_use]
    pub fn of_mesh(mesh: &ColouredMesh<'_>, view: &MeshView, size: u32) -> Self {
        assert!((1..=MAX_MESH_PICTURE).contains(&size), "a size from 1 to {MAX_MESH_PICTURE}");
        assert_eq!(mesh.positions.len(), mesh.colours.len(), "one colour per vertex");
        let Some(seen) = SeenMesh::new(mesh.positions, mesh.triangles, view, size) else {
            let pixels = size as usize * size as usize;
            return Self { width: size, height: size, rgb: [BACKGROUND].repeat(pixels).into_flattened() };
        };
        let (width, height) = (seen.width, seen.height);
        let drawing = Drawing::new(mesh, seen);
        let bands = (0..height).step_by(BAND as usize);
        let rgb = bands.flat_map(|first| drawing.band(first..height.min(first + BAND))).collect();
        Self { width, height, rgb }
    }
}

struct Drawing<'a> {
    triangles: &'a [[u32; 3]],
    seen: SeenMesh,
    /// The points on the grid of samples, right and down.
    grid: Vec<[i64; 2]>,
    normals: SmoothNormals,
    /// Of vertices, in linear light.
    colours: Vec<[f32; 3]>,
}

/// What a sample shows.
#[derive(Clone, Copy)]
struct Sample {
    /// Towards the eye.
    nearness: f64,
    /// Linear light.
    colour: [f32; 3],
}

impl<'a> Drawing<'a> {
    fn new(mesh: &ColouredMesh<'a>, seen: SeenMesh) -> Self {
        let steps = f64::from(SAMPLES) * STEPS as f64;
        let (across, down) = (0.5 * f64::from(seen.width), 0.5 * f64::from(seen.height));
        let on_grid = |point: &DVec3| {
            [across + seen.scale * point.x, down - seen.scale * point.y].map(|pixels| (steps * pixels).round() as i64)
        };
        let linear: Vec<f32> = (0..=255).map(linear).collect();
        let colour = |rgb: &[u8; 3]| rgb.map(|byte| linear[usize::from(byte)]);
        Self {
            triangles: mesh.triangles,
            grid: seen.points.iter().map(on_grid).collect(),
            normals: SmoothNormals::new(&seen.points, mesh.triangles),
            colours: mesh.colours.iter().map(colour).collect(),
            seen,
        }
    }

    /// Some rows of pixels, three bytes each.
    fn band(&self, rows: Range<u32>) -> Vec<u8> {
        let columns = (SAMPLES * self.seen.width) as usize;
        let rows = SAMPLES * rows.start..SAMPLES * rows.end;
        let nothing = Sample { nearness: f64::NEG_INFINITY, colour: BACKGROUND.map(linear) };
        let mut samples = vec![nothing; columns * rows.len()];
        for triangle in self.triangles {
            self.draw(triangle, columns, &rows, &mut samples);
        }
        let pixels_of_a_row = |row: &[Sample]| {
            let (upper, lower) = row.split_at(columns);
            let across = SAMPLES as usize;
            let pixels = upper.chunks_exact(across).zip(lower.chunks_exact(across));
            pixels.flat_map(|(upper, lower)| mean([upper[0], upper[1], lower[0], lower[1]])).collect::<Vec<u8>>()
        };
        samples.chunks_exact(SAMPLES as usize * columns).flat_map(pixels_of_a_row).collect()
    }

    fn draw(&self, triangle: &[u32; 3], columns: usize, rows: &Range<u32>, samples: &mut [Sample]) {
        let vertices = triangle.map(|corner| corner as usize);
        let corners = vertices.map(|vertex| self.grid[vertex]);
        let nearness = vertices.map(|vertex| self.seen.points[vertex].z);
        let colours = vertices.map(|vertex| self.colours[vertex]);
        // Most triangles are in few bands.
        let (first, end) = (i64::from(rows.start), i64::from(rows.end));
        if corners.iter().all(|corner| corner[1] < first * STEPS)
            || corners.iter().all(|corner| corner[1] > end * STEPS)
        {
            return;
        }
        let normals = self.normals.of_corners(&self.seen.points, triangle);
        cover(corners, columns, first..end, |covered| {
            let [a, b, c] = covered.weights;
            let sample = &mut samples[(covered.row - first) as usize * columns + covered.column];
            let nearness = a * nearness[0] + b * nearness[1] + c * nearness[2];
            if nearness > sample.nearness {
                let normal = (normals[0] * a + normals[1] * b + normals[2] * c).normalize_or_zero();
                let light = AMBIENT + (1.0 - AMBIENT) * normal.z.abs();
                let channel = |index: usize| {
                    let [p, q, r] = colours.map(|colour| f64::from(colour[index]));
                    (light * (a * p + b * q + c * r)) as f32
                };
                *sample = Sample { nearness, colour: [channel(0), channel(1), channel(2)] };
            }
        });
    }
}

/// The pixel of some samples.
fn mean(samples: [Sample; (SAMPLES * SAMPLES) as usize]) -> [u8; 3] {
    let channel = |index: usize| {
        let sum: f64 = samples.iter().map(|sample| f64::from(sample.colour[index])).sum();
        encode_srgb(sum / samples.len() as f64)
    };
    [channel(0), channel(1), channel(2)]
}

/// An sRGB byte in linear light, from 0 to 1.
fn linear(byte: u8) -> f32 {
    let encoded = f64::from(byte) / 255.0;
    let linear = if encoded <= 0.040_45 { encoded / 12.92 } else { libm::pow((encoded + 0.055) / 1.055, 2.4) };
    linear as f32
}
