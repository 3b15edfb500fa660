//! One layer of a table as a GPU samples it: bilinear, with an address mode.

use barchan_asset::{TableView, Wrap};

/// A decoded layer.
#[derive(Debug, Clone, PartialEq)]
pub struct Texture {
    width: u32,
    height: u32,
    wrap: (Wrap, Wrap),
    values: Vec<f32>,
}

impl Texture {
    /// Decodes one layer of a table of one number a texel.
    ///
    /// # Panics
    /// If the table has no such layer.
    #[must_use]
    pub fn new(table: &TableView<'_>, layer: u32) -> Self {
        Self::of_channel(table, layer, 0)
    }

    /// Decodes one of the numbers of each texel of a layer.
    ///
    /// # Panics
    /// If the table has no such layer or channel.
    #[must_use]
    pub fn of_channel(table: &TableView<'_>, layer: u32, channel: u32) -> Self {
        let descriptor = table.descriptor();
        let channels = descriptor.format.channels() as usize;
        assert!((channel as usize) < channels, "channel {channel} of {channels}");
        let row = |row| table.row(layer, row).skip(channel as usize).step_by(channels);
        Self {
            width: descriptor.width,
            height: descriptor.height,
            wrap: (descriptor.wrap_u, descriptor.wrap_v),
            values: (0..descriptor.height).flat_map(row).collect(),
        }
    }

    /// Decodes one layer of a table of one number a texel into something else.
    ///
    /// # Panics
    /// If the table has no such layer.
    #[must_use]
    pub fn map(table: &TableView<'_>, layer: u32, of: impl Fn(f32) -> f32) -> Self {
        let mut texture = Self::new(table, layer);
        texture.values.iter_mut().for_each(|value| *value = of(*value));
        texture
    }

    /// The same texture with every value replaced.
    #[must_use]
    pub fn zip_map(mut self, other: &Self, combine: impl Fn(f32, f32) -> f32) -> Self {
        for (value, &other) in self.values.iter_mut().zip(&other.values) {
            *value = combine(*value, other);
        }
        self
    }

    /// Texels along u.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Texels along v.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// What lies beyond the edge along u and v.
    pub(crate) fn wrap(&self) -> (Wrap, Wrap) {
        self.wrap
    }

    /// The lowest and the highest value.
    #[must_use]
    pub fn range(&self) -> (f32, f32) {
        self.values.iter().fold((f32::INFINITY, f32::NEG_INFINITY), |(lo, hi), &v| (lo.min(v), hi.max(v)))
    }

    /// One texel, beyond the edge too.
    #[inline]
    #[must_use]
    pub fn texel(&self, column: i64, row: i64) -> f32 {
        let (column, row) = (address(self.wrap.0, column, self.width), address(self.wrap.1, row, self.height));
        self.values[row * self.width as usize + column]
    }

    /// The four texels around a place, upper row first, and the place between them.
    #[inline]
    #[must_use]
    pub fn cell(&self, x: f64, y: f64) -> ([f64; 4], (f64, f64)) {
        let (left, top) = (x.floor(), y.floor());
        let (column, row) = (left as i64, top as i64);
        let corners = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| f64::from(self.texel(column + i, row + j)));
        (corners, (x - left, y - top))
    }

    /// The bilinear interpolant at a place.
    #[inline]
    #[must_use]
    pub fn sample(&self, x: f64, y: f64) -> f64 {
        let ([upper_left, upper_right, lower_left, lower_right], (right, down)) = self.cell(x, y);
        let upper = upper_left + (upper_right - upper_left) * right;
        let lower = lower_left + (lower_right - lower_left) * right;
        upper + (lower - upper) * down
    }
}

#[inline]
fn address(wrap: Wrap, index: i64, size: u32) -> usize {
    let size = i64::from(size);
    match wrap {
        Wrap::Clamp => index.clamp(0, size - 1) as usize,
        Wrap::Repeat if (0..size).contains(&index) => index as usize,
        Wrap::Repeat => index.rem_euclid(size) as usize,
    }
}
