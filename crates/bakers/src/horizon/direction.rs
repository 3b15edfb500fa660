//! The azimuths of a horizon map and the way a ray moves over the texel grid.

use barchan_field::{Grid, Spacing};

/// Cosine and sine of azimuth `2π index / count`, exact at multiples of 90° and equal to each other at odd multiples
/// of 45°, so that rays along the axes and diagonals stay on texel centres at any distance.
#[must_use]
pub fn azimuth_vector(index: u32, count: u32) -> (f64, f64) {
    let (index, count) = (u64::from(index), u64::from(count));
    let quadrant = (4 * index / count) % 4;
    let part = (4 * index) % count;
    let (cos, sin) = first_quadrant(part, count);
    match quadrant {
        0 => (cos, sin),
        1 => (-sin, cos),
        2 => (-cos, -sin),
        _ => (sin, -cos),
    }
}

/// Cosine and sine of `90° · part / count`, folded at 45° so that the two halves mirror each other to the bit.
fn first_quadrant(part: u64, count: u64) -> (f64, f64) {
    let angle = |part: u64| std::f64::consts::FRAC_PI_2 * part as f64 / count as f64;
    if part == 0 {
        (1.0, 0.0)
    } else if 2 * part == count {
        (std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::FRAC_1_SQRT_2)
    } else if 2 * part < count {
        (libm::cos(angle(part)), libm::sin(angle(part)))
    } else {
        let mirrored = count - part;
        (libm::sin(angle(mirrored)), libm::cos(angle(mirrored)))
    }
}

/// How far a ray moves over the grid per unit of length: columns, and rows counted downwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RayStep {
    pub(crate) columns: f64,
    pub(crate) rows: f64,
}

impl RayStep {
    pub(crate) fn new(index: u32, count: u32, spacing: Spacing) -> Self {
        let (cos, sin) = azimuth_vector(index, count);
        // v points up the picture, rows are counted downwards.
        Self { columns: cos / spacing.u(), rows: -sin / spacing.v() }
    }
}

/// The grid as one ray direction sees it: turned and mirrored so that the ray's longer component runs along `+major`
/// and its shorter one along `+minor`. Eight octants become one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Octant {
    /// Minor steps per major step, in [0, 1].
    pub(crate) tilt: f64,
    /// Length of the ray per major step.
    pub(crate) length_per_major: f64,
    /// Texels along the major axis.
    pub(crate) majors: usize,
    /// Texels along the minor axis.
    pub(crate) minors: usize,
    origin: isize,
    major_stride: isize,
    minor_stride: isize,
}

impl Octant {
    pub(crate) fn new(step: RayStep, grid: &Grid) -> Self {
        let (width, height) = (grid.width as usize, grid.height as usize);
        let columns = Axis { texels: width, stride: 1, speed: step.columns };
        let rows = Axis { texels: height, stride: width as isize, speed: step.rows };
        let (major, minor) = if columns.speed.abs() >= rows.speed.abs() { (columns, rows) } else { (rows, columns) };
        Self {
            tilt: (minor.speed / major.speed).abs(),
            length_per_major: 1.0 / major.speed.abs(),
            majors: major.texels,
            minors: minor.texels,
            origin: major.origin() + minor.origin(),
            major_stride: major.directed_stride(),
            minor_stride: minor.directed_stride(),
        }
    }

    /// Where texel `(major, minor)` lies in the field's row-by-row order.
    #[inline]
    pub(crate) fn index(&self, major: usize, minor: usize) -> usize {
        (self.origin + major as isize * self.major_stride + minor as isize * self.minor_stride) as usize
    }
}

/// One axis of the grid under a ray.
#[derive(Clone, Copy)]
struct Axis {
    texels: usize,
    stride: isize,
    speed: f64,
}

impl Axis {
    fn origin(self) -> isize {
        if self.speed < 0.0 { (self.texels as isize - 1) * self.stride } else { 0 }
    }

    fn directed_stride(self) -> isize {
        if self.speed < 0.0 { -self.stride } else { self.stride }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarter_turns_are_exact() {
        let turns: Vec<_> = (0..4).map(|k| azimuth_vector(k, 4)).collect();
        assert_eq!(turns, [(1.0, 0.0), (-0.0, 1.0), (-1.0, -0.0), (0.0, -1.0)]);
    }

    #[test]
    fn every_vector_has_unit_length_and_the_azimuth_asked_for() {
        for count in [1, 2, 3, 5, 7, 8, 16, 17, 32, 360] {
            for k in 0..count {
                let (cos, sin) = azimuth_vector(k, count);
                let azimuth = std::f64::consts::TAU * f64::from(k) / f64::from(count);
                assert!((cos - azimuth.cos()).abs() < 1e-15 && (sin - azimuth.sin()).abs() < 1e-15, "{k}/{count}");
            }
        }
    }

    #[test]
    fn diagonals_keep_to_texel_centres() {
        let grid = Grid {
            width: 5,
            height: 7,
            spacing: Spacing::UNIT,
            unit: barchan_field::LengthUnit::SceneUnit,
            edge: barchan_field::Edge::Clamp,
        };
        for k in [1, 3, 5, 7] {
            assert_eq!(Octant::new(RayStep::new(k, 8, Spacing::UNIT), &grid).tilt, 1.0);
        }
    }
}
