//! From where a mesh is seen, and how it fills its picture.

use glam::{DMat3, DVec3};

/// How much of the longer side of a picture is left free on either side.
const MARGIN: f64 = 0.03;

/// The axis of a mesh that points up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UpAxis {
    /// As in glTF.
    Y,
    /// As on maps.
    Z,
}

/// A view from far away, along parallel lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshView {
    /// Unit vectors in the frame of the mesh: right and up in the picture, and towards the eye.
    axes: [DVec3; 3],
}

impl MeshView {
    /// The view from an azimuth and an elevation in degrees. The azimuth grows counter-clockwise as seen from above, from +x
    /// towards +y where z is up, and from +z, the front of a glTF mesh, towards +x where y is.
    #[must_use]
    pub fn from_degrees(up: UpAxis, azimuth: f64, elevation: f64) -> Self {
        let (azimuth_sin, azimuth_cos) = libm::sincos(azimuth.to_radians());
        let (sin, cos) = libm::sincos(elevation.to_radians());
        let axes = [
            DVec3::new(-azimuth_sin, azimuth_cos, 0.0),
            DVec3::new(-sin * azimuth_cos, -sin * azimuth_sin, cos),
            DVec3::new(cos * azimuth_cos, cos * azimuth_sin, sin),
        ];
        Self {
            axes: match up {
                UpAxis::Z => axes,
                UpAxis::Y => axes.map(|axis| DVec3::new(axis.y, axis.z, axis.x)),
            },
        }
    }
}

/// The vertices of a mesh as a picture sees them.
pub(crate) struct SeenMesh {
    /// Right, up and towards the eye; the middle of the mesh is at 0, and the longer side of what is seen measures 1.
    pub(crate) points: Vec<DVec3>,
    /// Pixels across.
    pub(crate) width: u32,
    /// Pixels down.
    pub(crate) height: u32,
    /// Pixels per unit of the points.
    pub(crate) scale: f64,
}

impl SeenMesh {
    /// All of the mesh in a picture whose longer side has `size` pixels. Vertices of no triangle do not count. Nothing if what
    /// is seen has no extent.
    pub(crate) fn new(positions: &[DVec3], triangles: &[[u32; 3]], view: &MeshView, size: u32) -> Option<Self> {
        // About its own middle first, so that a mesh far from the origin keeps its shape.
        let (low, high) = bounds(positions, triangles)?;
        let middle = 0.5 * low + 0.5 * high;
        let turn = DMat3::from_cols_array_2d(&view.axes.map(|axis| axis.to_array())).transpose();
        let mut points: Vec<DVec3> = positions.iter().map(|&position| turn * (position - middle)).collect();
        let (low, high) = bounds(&points, triangles)?;
        let (middle, extent) = (0.5 * low + 0.5 * high, high - low);
        let longer = extent.x.max(extent.y);
        if longer <= 0.0 {
            return None;
        }
        for point in &mut points {
            *point = (*point - middle) / longer;
        }
        let (size, scale) = (f64::from(size), f64::from(size) * (1.0 - 2.0 * MARGIN));
        let pixels = |extent: f64| (size - scale * (1.0 - extent / longer)).round().max(1.0) as u32;
        Some(Self { points, width: pixels(extent.x), height: pixels(extent.y), scale })
    }
}

/// The least and greatest coordinates that triangles have.
fn bounds(points: &[DVec3], triangles: &[[u32; 3]]) -> Option<(DVec3, DVec3)> {
    let corners = triangles.iter().flatten().map(|&vertex| points[vertex as usize]);
    corners.map(|point| (point, point)).reduce(|(low, high), (point, _)| (low.min(point), high.max(point)))
}
