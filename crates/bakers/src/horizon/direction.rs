//! The way a ray moves over the texel grid.

use barchan_field::{Grid, Spacing};

/// How far a ray moves over the grid per unit of length: columns, and rows counted downwards.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RayStep {
    pub(crate) columns: f64,
    pub(crate) rows: f64,
}

impl RayStep {
    pub(crate) fn new((cos, sin): (f64, f64), spacing: Spacing) -> Self {
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
    along_rows: bool,
    origin: isize,
    major_stride: isize,
    minor_stride: isize,
}

impl Octant {
    pub(crate) fn new(step: RayStep, grid: &Grid) -> Self {
        let (width, height) = (grid.width as usize, grid.height as usize);
        let columns = Axis { texels: width, stride: 1, speed: step.columns };
        let rows = Axis { texels: height, stride: width as isize, speed: step.rows };
        let along_rows = columns.speed.abs() >= rows.speed.abs();
        let (major, minor) = if along_rows { (columns, rows) } else { (rows, columns) };
        Self {
            tilt: (minor.speed / major.speed).abs(),
            length_per_major: 1.0 / major.speed.abs(),
            majors: major.texels,
            minors: minor.texels,
            along_rows,
            origin: major.origin() + minor.origin(),
            major_stride: major.directed_stride(),
            minor_stride: minor.directed_stride(),
        }
    }

    /// Whether the major axis runs along the picture's rows.
    pub(crate) fn runs_along_rows(&self) -> bool {
        self.along_rows
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
    use crate::horizon::Azimuths;

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
            assert_eq!(Octant::new(RayStep::new(Azimuths::full_circle(8).vector(k), Spacing::UNIT), &grid).tilt, 1.0);
        }
    }
}
