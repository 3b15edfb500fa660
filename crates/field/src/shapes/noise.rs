//! Hashing and noise that repeat exactly with the tile.
//!
//! Gradient noise after Perlin (*Improving Noise*, 2002) on a lattice that closes over the torus. The lattice need not
//! lie along the axes: an integer matrix M takes tile fractions to lattice coordinates, and lattice points that differ
//! by a column of M are the same point of the torus, so they are reduced to one representative before hashing, in whole
//! numbers. That lets each octave of a sum be rotated, which hides the lattice, and still tile to the last bit.
//! Departure: gradients are drawn from a bell-shaped distribution instead of from twelve directions.

/// One stream of hashed numbers per seed (SplitMix64's finaliser; Steele, Lea, Flood: *Fast Splittable Pseudorandom
/// Number Generators*, 2014).
#[inline]
pub(crate) fn hash(seed: u64, i: i64, j: i64) -> u64 {
    let i = (i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let j = (j as u64).wrapping_mul(0xd1b5_4a32_d192_ed03);
    mix(mix(seed ^ i).wrapping_add(j))
}

#[inline]
fn mix(mut z: u64) -> u64 {
    z = z.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// A seed for an independent stream.
pub(super) fn stream(seed: u64, index: i64) -> u64 {
    hash(seed, index, -1)
}

/// Field `index` (0 … 3) of 16 bits, as a number from −1 to 1, both excluded.
#[inline]
pub(super) fn signed(hash: u64, index: u32) -> f64 {
    (f64::from((hash >> (16 * index)) as u16) - 32767.5) / 32768.0
}

/// 0 at and below 0, 1 at and above 1, with a continuous second derivative.
#[inline]
pub(super) fn fade(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// `t` with a parabola for a start: slope 0 at 0, slope 1 from `onset` on. For `t` ≥ 0.
#[inline]
pub(super) fn eased(t: f64, onset: f64) -> f64 {
    if t < onset { t * t / (2.0 * onset) } else { t - 0.5 * onset }
}

/// Gradient noise with a standard deviation of 1 over many seeds, in practice within −4 … 4.
#[derive(Debug, Clone, Copy)]
pub(super) struct GradientNoise {
    /// Lattice coordinates are `(a u + b v, c u + d v)`.
    matrix: [i64; 4],
    determinant: i64,
    seed: u64,
}

impl GradientNoise {
    /// About `cells_u` × `cells_v` cells per tile, 1 … 1e9 each, turned by `angle` radians as far as whole numbers allow.
    pub(super) fn new(cells_u: f64, cells_v: f64, angle: f64, seed: u64) -> Self {
        let (cells_u, cells_v) = (cells_u.clamp(1.0, 1e9), cells_v.clamp(1.0, 1e9));
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let entry = |x: f64| libm::round(x) as i64;
        let matrix = [entry(cells_u * cos), entry(-cells_v * sin), entry(cells_u * sin), entry(cells_v * cos)];
        let [a, b, c, d] = matrix;
        let determinant = a * d - b * c;
        // Of sin and cos one is at least ½√2 and so rounds to a whole number other than 0: the matrix is never singular.
        Self { matrix, determinant, seed }
    }

    /// The noise at tile fractions `(u, v)`.
    #[inline]
    pub(super) fn at(&self, u: f64, v: f64) -> f64 {
        let [a, b, c, d] = self.matrix.map(|m| m as f64);
        let (x, y) = (a * u + b * v, c * u + d * v);
        let (x0, y0) = (x.floor(), y.floor());
        let (fx, fy) = (x - x0, y - y0);
        let (i, j) = (x0 as i64, y0 as i64);
        let corner = |di: i64, dj: i64| self.slope(i + di, j + dj, fx - di as f64, fy - dj as f64);
        let (tx, ty) = (fade(fx), fade(fy));
        let low = corner(0, 0) * (1.0 - tx) + corner(1, 0) * tx;
        let high = corner(0, 1) * (1.0 - tx) + corner(1, 1) * tx;
        (low * (1.0 - ty) + high * ty) * UNIT_DEVIATION
    }

    /// The plane through lattice point `(i, j)` with that point's gradient.
    #[inline]
    fn slope(&self, i: i64, j: i64, x: f64, y: f64) -> f64 {
        let (i, j) = self.representative(i, j);
        let h = hash(self.seed, i, j);
        (signed(h, 0) + signed(h, 1)) * x + (signed(h, 2) + signed(h, 3)) * y
    }

    /// The lattice point that stands for all that the tile's periods, the columns of M, take to each other.
    #[inline]
    fn representative(&self, i: i64, j: i64) -> (i64, i64) {
        let ([a, b, c, d], n) = (self.matrix, self.determinant);
        // Tile coordinates of the point are M⁻¹ (i, j) = (d i − b j, a j − c i) / det.
        let (tile_u, tile_v) = (floor_div(d * i - b * j, n), floor_div(a * j - c * i, n));
        (i - a * tile_u - b * tile_v, j - c * tile_u - d * tile_v)
    }
}

/// ⌊a / b⌋ for either sign of `b`, which must not be 0.
#[inline]
fn floor_div(a: i64, b: i64) -> i64 {
    if b > 0 { a.div_euclid(b) } else { (-a).div_euclid(-b) }
}

/// One over the standard deviation: each gradient component has variance 2/3, of which the fade leaves
/// 8 ∫f²x² ∫f² = 0.09306, where f = 1 − fade.
const UNIT_DEVIATION: f64 = 4.014_752_125_089_425;

/// Smooth noise around a circle: a cubic B-spline through hashed values from −1 to 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct CircleNoise {
    knots: i64,
    seed: u64,
}

impl CircleNoise {
    /// About `knots` values around the circle, 1 … 1e9.
    pub(super) fn new(knots: f64, seed: u64) -> Self {
        Self { knots: knots.clamp(1.0, 1e9) as i64, seed }
    }

    /// Value and derivative at `t` turns.
    #[inline]
    pub(super) fn at(&self, t: f64) -> (f64, f64) {
        let x = t * self.knots as f64;
        let x0 = x.floor();
        let f = x - x0;
        let knot = |k: i64| signed(hash(self.seed, (x0 as i64 + k).rem_euclid(self.knots), 0), 0);
        let [a, b, c, d] = [knot(-1), knot(0), knot(1), knot(2)];
        let r = 1.0 - f;
        let value =
            (a * r * r * r + b * (4.0 - 3.0 * f * f * (2.0 - f)) + c * (4.0 - 3.0 * r * r * (2.0 - r)) + d * f * f * f)
                / 6.0;
        let slope = 0.5 * (d * f * f - a * r * r + b * f * (3.0 * f - 4.0) - c * r * (3.0 * r - 4.0));
        (value, slope * self.knots as f64)
    }
}
