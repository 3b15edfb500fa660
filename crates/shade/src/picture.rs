//! A lit height field seen from straight above.

use glam::DVec3;

use crate::{DirectionalLight, SkyLight, Surface};

/// sRGB, where a picture shows nothing.
pub const BACKGROUND: [u8; 3] = [16, 18, 22];

/// The pixels of a picture over a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pixels {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Texels per pixel across and down.
    texels: (f64, f64),
}

impl Pixels {
    /// Pixels that are square in length, whatever the texels are: `per_texel` of them, at least 1, to the shorter side of a
    /// texel.
    #[must_use]
    pub fn over(surface: &Surface, per_texel: u32) -> Self {
        let (spacing_u, spacing_v) = surface.spacing();
        let length = spacing_u.min(spacing_v) / f64::from(per_texel.max(1));
        let count = |texels: u32, spacing: f64| (f64::from(texels) * spacing / length).round().max(1.0) as u32;
        let (across, down) = (surface.heights().width(), surface.heights().height());
        let (width, height) = (count(across, spacing_u), count(down, spacing_v));
        let texels = (f64::from(across) / f64::from(width), f64::from(down) / f64::from(height));
        Self { width, height, texels }
    }

    /// A pixel at the centre of every texel, whatever its shape.
    #[must_use]
    pub fn one_per_texel(surface: &Surface) -> Self {
        Self { width: surface.heights().width(), height: surface.heights().height(), texels: (1.0, 1.0) }
    }

    /// Texels per pixel across and down.
    #[must_use]
    pub fn texels(&self) -> (f64, f64) {
        self.texels
    }

    /// Something of every pixel's place, row by row from the top; places are `(x, y)` in texels from the centre of
    /// texel (0, 0).
    pub fn map<T>(&self, mut of: impl FnMut(f64, f64) -> T) -> Vec<T> {
        let mut all = Vec::with_capacity(self.width as usize * self.height as usize);
        for row in 0..self.height {
            for column in 0..self.width {
                let x = (f64::from(column) + 0.5) * self.texels.0 - 0.5;
                let y = (f64::from(row) + 0.5) * self.texels.1 - 0.5;
                all.push(of(x, y));
            }
        }
        all
    }
}

/// Colours in linear light, red, green, blue.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Palette {
    /// What the surface reflects, 0 to 1.
    pub albedo: DVec3,
    /// Light of the sun on ground that faces it.
    pub sun: DVec3,
    /// Light of the sky on ground that faces up.
    pub sky: DVec3,
}

impl Palette {
    /// Dry sand under a warm sun and a blue sky.
    pub const SAND: Self = Self {
        albedo: DVec3::new(0.80, 0.62, 0.42),
        sun: DVec3::new(0.78, 0.70, 0.58),
        sky: DVec3::new(0.07, 0.11, 0.20),
    };

    /// The same sand under clouds: as bright in the open as level ground is in the sun.
    pub const OVERCAST_SAND: Self =
        Self { albedo: Self::SAND.albedo, sun: DVec3::ZERO, sky: DVec3::new(0.92, 0.96, 1.0) };

    /// Exposed for a sun, so that level ground in it is as bright at dawn as at noon.
    #[must_use]
    pub fn exposed_for(self, light: &DirectionalLight) -> Self {
        Self { sun: self.sun / exposed_height(light), ..self }
    }
}

/// An 8-bit sRGB picture, three bytes a pixel, row by row from the top.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Picture {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// `3 · width · height` bytes.
    pub rgb: Vec<u8>,
}

impl Picture {
    /// Lights a surface: Lambert's law for the sun where `shadow` says it reaches, an even sky everywhere.
    ///
    /// The exposure is that of [`Palette::exposed_for`].
    ///
    /// # Panics
    /// If `shadow` does not hold one value per pixel.
    #[must_use]
    pub fn lit(
        surface: &Surface,
        light: &DirectionalLight,
        pixels: &Pixels,
        shadow: &[bool],
        palette: &Palette,
    ) -> Self {
        assert_eq!(shadow.len(), pixels.width as usize * pixels.height as usize, "one shadow value per pixel");
        let exposure = 1.0 / exposed_height(light);
        let mut shadow = shadow.iter();
        let colours = pixels.map(|x, y| {
            let normal = surface.normal(x, y);
            let reached = !shadow.next().copied().unwrap_or(true);
            let sun = if reached { normal.dot(light.towards).max(0.0) * exposure } else { 0.0 };
            let sky = 0.5 + 0.5 * normal.z;
            to_srgb(palette.albedo * (palette.sun * sun + palette.sky * sky))
        });
        Self { width: pixels.width, height: pixels.height, rgb: colours.into_flattened() }
    }

    /// Lights a surface by an overcast sky alone.
    #[must_use]
    pub fn overcast(pixels: &Pixels, sky: &SkyLight, palette: &Palette) -> Self {
        let colours = pixels.map(|x, y| to_srgb(palette.albedo * palette.sky * sky.irradiance(x, y)));
        Self { width: pixels.width, height: pixels.height, rgb: colours.into_flattened() }
    }

    /// Pictures of the same height side by side, `gap` white pixels between them.
    ///
    /// # Panics
    /// If heights differ.
    #[must_use]
    pub fn side_by_side(pictures: &[Self], gap: u32) -> Self {
        let height = pictures.first().map_or(0, |picture| picture.height);
        assert!(pictures.iter().all(|picture| picture.height == height), "pictures of the same height");
        let gaps = gap * (pictures.len() as u32).saturating_sub(1);
        let width = pictures.iter().map(|picture| picture.width).sum::<u32>() + gaps;
        let mut rgb = Vec::with_capacity(3 * width as usize * height as usize);
        for row in 0..height as usize {
            for (index, picture) in pictures.iter().enumerate() {
                if index > 0 {
                    rgb.extend(std::iter::repeat_n(255, 3 * gap as usize));
                }
                let row_bytes = 3 * picture.width as usize;
                rgb.extend_from_slice(&picture.rgb[row * row_bytes..][..row_bytes]);
            }
        }
        Self { width, height, rgb }
    }
}

/// The sine of the sun's elevation that a picture is exposed for: no lower than 7°.
fn exposed_height(light: &DirectionalLight) -> f64 {
    light.towards.z.max(0.12)
}

/// Linear light to sRGB bytes, with a shoulder instead of a hard clip.
pub(crate) fn to_srgb(linear: DVec3) -> [u8; 3] {
    linear.to_array().map(|light| encode_srgb(1.0 - libm::exp(-1.2 * light)))
}

/// Linear light from 0 to 1 as an sRGB byte.
pub(crate) fn encode_srgb(linear: f64) -> u8 {
    let encoded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055 };
    (255.0 * encoded).round().clamp(0.0, 255.0) as u8
}
