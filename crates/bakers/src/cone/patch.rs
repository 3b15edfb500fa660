//! Rectangles of the bilinear surface, whole cells and parts of them.

/// A rectangle inside one bilinear cell: a bilinear surface again, so that its corners are its extremes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Patch {
    /// From and to along u and downwards along v, in lengths from a place that several patches share.
    pub(super) u: [f64; 2],
    pub(super) v: [f64; 2],
    /// Heights in lengths, `[upper or lower row][left or right column]`.
    pub(super) heights: [[f64; 2]; 2],
}

/// A point of the surface: along u, downwards along v, and height, in lengths.
pub(super) type Point = [f64; 3];

impl Patch {
    /// The four corners.
    pub(super) fn corners(&self) -> [Point; 4] {
        [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| [self.u[i], self.v[j], self.heights[j][i]])
    }

    pub(super) fn lowest(&self) -> f64 {
        self.heights.as_flattened().iter().copied().fold(f64::INFINITY, f64::min)
    }

    pub(super) fn highest(&self) -> f64 {
        self.heights.as_flattened().iter().copied().fold(f64::NEG_INFINITY, f64::max)
    }

    /// The distance to another patch on the ground.
    pub(super) fn gap(&self, other: &Self) -> f64 {
        let gap = |a: [f64; 2], b: [f64; 2]| (b[0] - a[1]).max(a[0] - b[1]).max(0.0);
        let (along_u, along_v) = (gap(self.u, other.u), gap(self.v, other.v));
        (along_u * along_u + along_v * along_v).sqrt()
    }

    pub(super) fn centre(&self) -> [f64; 2] {
        [self.u, self.v].map(|ends| 0.5 * (ends[0] + ends[1]))
    }

    /// Its sides along u and v.
    pub(super) fn sides(&self) -> [f64; 2] {
        [self.u, self.v].map(|ends| ends[1] - ends[0])
    }

    /// The two halves of the longer side.
    pub(super) fn halves(&self) -> [Self; 2] {
        let [[h00, h10], [h01, h11]] = self.heights;
        let ([side_u, side_v], [centre_u, centre_v]) = (self.sides(), self.centre());
        if side_u >= side_v {
            let (upper, lower) = (0.5 * (h00 + h10), 0.5 * (h01 + h11));
            [
                Self { u: [self.u[0], centre_u], heights: [[h00, upper], [h01, lower]], ..*self },
                Self { u: [centre_u, self.u[1]], heights: [[upper, h10], [lower, h11]], ..*self },
            ]
        } else {
            let (left, right) = (0.5 * (h00 + h01), 0.5 * (h10 + h11));
            [
                Self { v: [self.v[0], centre_v], heights: [[h00, h10], [left, right]], ..*self },
                Self { v: [centre_v, self.v[1]], heights: [[left, right], [h01, h11]], ..*self },
            ]
        }
    }

    /// The steepest ascent anywhere in the patch in directions whose component along u has the sign of `towards[0]`, and
    /// downwards along v that of `towards[1]`; 0 leaves either sign open.
    pub(super) fn steepest(&self, towards: [i64; 2]) -> f64 {
        let [[h00, h10], [h01, h11]] = self.heights;
        let [side_u, side_v] = self.sides();
        let greatest = |rises: [f64; 2], sign: i64| match sign {
            0 => rises[0].abs().max(rises[1].abs()),
            sign => (sign as f64 * rises[0]).max(sign as f64 * rises[1]).max(0.0),
        };
        let along_u = greatest([h10 - h00, h11 - h01], towards[0]) / side_u;
        let along_v = greatest([h01 - h00, h11 - h10], towards[1]) / side_v;
        (along_u * along_u + along_v * along_v).sqrt()
    }
}
