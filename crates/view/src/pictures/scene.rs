//! What is drawn: plain numbers, as the shaders take them.

use barchan_wgpu::ReliefSearch;

/// Light and colours, in linear light: red, green, blue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PictureLight {
    /// A unit vector towards the sun, in the frame (u, v up the picture, height), or in space for relief on a base.
    pub towards: [f32; 3],
    /// What the surface reflects, 0 to 1.
    pub albedo: [f32; 3],
    /// Light of the sun on ground that faces it.
    pub sun: [f32; 3],
    /// Light of the sky on ground that faces up.
    pub sky: [f32; 3],
    /// sRGB, where nothing is seen.
    pub background: [u8; 3],
}

/// A height field seen from straight above.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TopView {
    /// Pixels across and down.
    pub size: (u32, u32),
    /// Texels per pixel across and down; the picture's upper left corner is that of the table.
    pub texels: [f32; 2],
}

/// Relief on a base surface before a camera far away, whose rays are parallel.
///
/// The base is all the camera sees: it stands outside, and nothing is behind it.
#[derive(Debug, Clone, PartialEq)]
pub struct ReliefView {
    /// Pixels across and down.
    pub size: (u32, u32),
    /// A point of the ray through the centre of the first pixel, near to what is seen: the farther, the less exact.
    pub corner: [f32; 3],
    /// From there to the ray of the next pixel to the right.
    pub across: [f32; 3],
    /// To that of the next one below.
    pub down: [f32; 3],
    /// A unit vector towards the eye.
    pub eye: [f32; 3],
    /// What the relief lies on.
    pub base: PictureBase,
    /// Length of one unit of u and of v of the base.
    pub tile: [f32; 2],
    /// How the relief is found: from a hemisphere table's start where one is loaded.
    pub search: ReliefSearch,
    /// Whether there is a sun; without one, all is in its shadow.
    pub has_sun: bool,
    /// By how much of its depth relief must stand before a point to shade it.
    pub tolerance: f32,
    /// The directions in which the sky is looked for; none under an open sky.
    pub sky: Vec<SkyDirection>,
}

/// What relief lies on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PictureBase {
    /// The plane z = 0: u along x, v along y.
    Plane,
    /// A sphere round the origin: u is longitude from +x to +y, v is latitude.
    Sphere {
        /// Its radius.
        radius: f32,
    },
}

/// A direction that stands for a part of the sky, in the frame of the relief.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkyDirection {
    /// A unit vector from the surface.
    pub towards: [f32; 3],
    /// The directions that it stands for, integrated over their solid angle.
    pub integral: [f32; 3],
}

impl PictureLight {
    /// Of its uniform buffer.
    pub(super) const BYTES: usize = 96;

    /// The uniform buffer of the pixels from `first` on.
    pub(super) fn bytes(&self, first: (u32, u32)) -> Vec<u8> {
        let background = self.background.map(|byte| f32::from(byte) / 255.0);
        let first = [first.0 as f32, first.1 as f32, 0.0, 0.0];
        let [towards, albedo, sun, sky, background] =
            [self.towards, self.albedo, self.sun, self.sky, background].map(|row| with(row, 0.0));
        bytes(&[first, towards, albedo, sun, sky, background])
    }
}

impl TopView {
    pub(super) fn bytes(&self) -> Vec<u8> {
        bytes(&[[self.texels[0], self.texels[1], 0.0, 0.0]])
    }
}

impl ReliefView {
    pub(super) fn bytes(&self) -> Vec<u8> {
        let radius = match self.base {
            PictureBase::Plane => 0.0,
            PictureBase::Sphere { radius } => radius,
        };
        // An integer of the shader, by its bits.
        let has_sun = f32::from_bits(u32::from(self.has_sun));
        bytes(&[
            with(self.corner, self.tolerance),
            with(self.across, radius),
            with(self.down, has_sun),
            with(self.eye, 0.0),
            [self.tile[0], self.tile[1], 0.0, 0.0],
        ])
    }

    pub(super) fn sky_bytes(&self) -> Vec<u8> {
        let rows = self.sky.iter().flat_map(|sky| [with(sky.towards, 0.0), with(sky.integral, 0.0)]);
        bytes(&rows.collect::<Vec<_>>())
    }
}

fn with([x, y, z]: [f32; 3], w: f32) -> [f32; 4] {
    [x, y, z, w]
}

fn bytes(rows: &[[f32; 4]]) -> Vec<u8> {
    rows.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect()
}
