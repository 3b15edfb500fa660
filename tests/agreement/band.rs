//! What a sampler may find between texels.
//!
//! It interpolates what is stored, before the transfer, and its weights have 8 bits: between texels lies a band of numbers, to either
//! side a 256th of what the four texels around differ by, along each axis. Mesa's software driver interpolates bytes in bytes, so that
//! what it finds may be a whole step of a byte off. Where four texels are loaded, nothing but the twin's own number will do, and a
//! band is that number.

use barchan_asset::{Component, TableView, Transfer, Wrap};

/// Numbers from one to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Band {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Band {
    /// One number.
    pub(crate) fn only(number: f64) -> Self {
        Self { low: number, high: number }
    }

    /// From the least to the greatest of some numbers.
    pub(crate) fn around(numbers: impl IntoIterator<Item = f64>) -> Self {
        let none = Self { low: f64::INFINITY, high: f64::NEG_INFINITY };
        numbers.into_iter().fold(none, |band, n| Self { low: band.low.min(n), high: band.high.max(n) })
    }

    /// What a function that never falls, or never rises, makes of it.
    pub(crate) fn map(self, of: impl Fn(f64) -> f64) -> Self {
        Self::around([of(self.low), of(self.high)])
    }

    /// Squares of its numbers.
    pub(crate) fn square(self) -> Self {
        let holds_zero = self.low <= 0.0 && self.high >= 0.0;
        let squares = [self.low * self.low, self.high * self.high];
        Self::around(squares.into_iter().chain(holds_zero.then_some(0.0)))
    }

    /// A product, of what is not negative.
    pub(crate) fn times(self, other: Self) -> Self {
        Self { low: self.low.max(0.0) * other.low.max(0.0), high: self.high * other.high }
    }

    /// On the way to another band.
    pub(crate) fn mix(self, other: Self, weight: f64) -> Self {
        let mix = |a: f64, b: f64| a + (b - a) * weight;
        Self { low: mix(self.low, other.low), high: mix(self.high, other.high) }
    }

    /// The number of the band that is nearest.
    pub(crate) fn nearest(self, number: f64) -> f64 {
        // Not `clamp`, so that what is no number is near nothing.
        if number >= self.low && number <= self.high { number } else { number.max(self.low).min(self.high) }
    }

    /// Whether a number is in the band, or nearer than a tolerance.
    pub(crate) fn holds(self, number: f64, tolerance: f64) -> bool {
        number >= self.low - tolerance && number <= self.high + tolerance
    }
}

/// How far the weights of a sampler are from the true ones.
const WEIGHT_ERROR: f64 = 1.0 / 256.0;

/// One channel of a layer as a sampler reads it.
#[derive(Debug)]
pub(crate) struct Filtered {
    width: u32,
    height: u32,
    wraps: (Wrap, Wrap),
    transfer: Transfer,
    /// How far from the true one an interpolated number may be rounded.
    step: f64,
    before_transfer: Vec<f64>,
}

impl Filtered {
    /// A channel of a layer.
    pub(crate) fn new(table: &TableView<'_>, layer: u32, channel: usize) -> Self {
        let descriptor = table.descriptor();
        let channels = descriptor.format.channels() as usize;
        let row = |row| table.row_before_transfer(layer, row).skip(channel).step_by(channels).map(f64::from);
        Self {
            width: descriptor.width,
            height: descriptor.height,
            wraps: (descriptor.wrap_u, descriptor.wrap_v),
            transfer: descriptor.transfer,
            step: if descriptor.format.component() == Component::Unorm8 { descriptor.scale.abs() / 255.0 } else { 0.0 },
            before_transfer: (0..descriptor.height).flat_map(row).collect(),
        }
    }

    /// What may be found at a place.
    pub(crate) fn at(&self, x: f64, y: f64) -> Band {
        let (left, top) = (x.floor(), y.floor());
        let corner = |i, j| self.texel(left as i64 + i, top as i64 + j);
        let corners = [corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)];
        let weights = |part: f64| [-WEIGHT_ERROR, WEIGHT_ERROR].map(|error| (part + error).clamp(0.0, 1.0));
        let found = weights(x - left).into_iter().flat_map(|right| {
            let upper = corners[0] + (corners[1] - corners[0]) * right;
            let lower = corners[2] + (corners[3] - corners[2]) * right;
            weights(y - top).map(|down| upper + (lower - upper) * down)
        });
        let band = Band::around(found);
        let wider = Band { low: band.low - self.step, high: band.high + self.step };
        wider.map(|t| f64::from(self.transfer.value(t as f32)))
    }

    fn texel(&self, column: i64, row: i64) -> f64 {
        let inside = |wrap, index: i64, size: u32| match wrap {
            Wrap::Repeat => index.rem_euclid(i64::from(size)) as usize,
            Wrap::Clamp => index.clamp(0, i64::from(size) - 1) as usize,
        };
        let (column, row) = (inside(self.wraps.0, column, self.width), inside(self.wraps.1, row, self.height));
        self.before_transfer[row * self.width as usize + column]
    }
}
