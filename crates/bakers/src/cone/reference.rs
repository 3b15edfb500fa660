//! The obvious twin: the slopes between all points of a lattice.
//!
//! A lattice knows some of the ascents, so its cones are at least as wide as the true ones, and narrow to them as it gets
//! finer. The baker's cones are nowhere wider.

use barchan_field::{Edge, Grid, HeightField};

use super::{ConeKind, widest};
use crate::hemisphere::depths::relief_range;

/// The ratio of the widest cone of a texel that no point of a lattice contradicts. `parts` points divide a texel along u
/// and v; with `n` texels, O(n · parts⁴) for strict cones and O(n^1.5 · parts³) for relaxed ones.
///
/// # Panics
/// If `parts` is 0.
#[must_use]
pub fn ratio(field: &HeightField, kind: ConeKind, column: u32, row: u32, parts: u32) -> f64 {
    assert!(parts > 0, "a lattice has points");
    let lattice = Lattice::new(field, parts);
    let texel = [column, row].map(|index| i64::from(index) * i64::from(parts));
    let cap = widest(field.grid(), relief_range(field).thickness);
    match kind {
        ConeKind::Strict => lattice.strict(texel).min(cap),
        ConeKind::Relaxed => lattice.relaxed(texel).min(cap),
    }
}

/// Heights at evenly spaced places, texel centres among them.
struct Lattice<'a> {
    field: &'a HeightField,
    parts: i64,
    /// Points along u and v of the tile.
    extents: [i64; 2],
    heights: Vec<f64>,
    /// Along u and v, in lengths.
    steps: [f64; 2],
}

impl<'a> Lattice<'a> {
    fn new(field: &'a HeightField, parts: u32) -> Self {
        let Grid { width, height, spacing, edge, .. } = *field.grid();
        let parts = i64::from(parts);
        let extents = [width, height].map(|texels| match edge {
            Edge::Wrap => i64::from(texels) * parts,
            Edge::Clamp => (i64::from(texels) - 1) * parts + 1,
        });
        let place = |index: i64| index as f64 / parts as f64;
        let places = (0..extents[1]).flat_map(|j| (0..extents[0]).map(move |i| (i, j)));
        let heights = places.map(|(i, j)| field.surface(place(i), place(j))).collect();
        Self { field, parts, extents, heights, steps: [spacing.u(), spacing.v()].map(|length| length / parts as f64) }
    }

    /// The height of a point, which may be beyond the edge.
    fn height(&self, [i, j]: [i64; 2]) -> f64 {
        let edge = self.field.grid().edge;
        let [i, j] = [(i, 0), (j, 1)].map(|(index, axis)| edge.resolve(index, self.extents[axis] as u32));
        self.heights[j * self.extents[0] as usize + i]
    }

    /// All points of the tile and, where it repeats, all points nearer than its extent along u and v.
    fn points(&self, [column, row]: [i64; 2]) -> impl Iterator<Item = [i64; 2]> {
        let along = |index: i64, extent: i64| match self.field.grid().edge {
            Edge::Wrap => index - extent..=index + extent,
            Edge::Clamp => 0..=extent - 1,
        };
        let columns = along(column, self.extents[0]);
        along(row, self.extents[1]).flat_map(move |j| columns.clone().map(move |i| [i, j]))
    }

    fn distance(&self, from: [i64; 2], to: [i64; 2]) -> f64 {
        libm::hypot((to[0] - from[0]) as f64 * self.steps[0], (to[1] - from[1]) as f64 * self.steps[1])
    }

    fn strict(&self, texel: [i64; 2]) -> f64 {
        let reach = -self.parts..=self.parts;
        let feet = reach.clone().flat_map(|j| reach.clone().map(move |i| [texel[0] + i, texel[1] + j]));
        feet.flat_map(|foot| self.points(texel).map(move |head| (foot, head)))
            .map(|(foot, head)| {
                let rise = self.height(head) - self.height(foot);
                if rise > 0.0 { self.distance(foot, head) / rise } else { f64::INFINITY }
            })
            .fold(f64::INFINITY, f64::min)
    }

    /// As the paper does: for every point, the ray from the top above the texel to that point is followed on to where it
    /// leaves the relief, and the cone is kept off that exit.
    fn relaxed(&self, texel: [i64; 2]) -> f64 {
        let exits = self.points(texel).filter(|&head| head != texel).filter_map(|head| self.exit(texel, head));
        exits.fold(f64::INFINITY, |narrowest, (distance, height)| {
            let rise = height - self.height(texel);
            if rise > 0.0 { narrowest.min(distance / rise) } else { narrowest }
        })
    }

    /// Distance and height of the first exit at or behind a point, if it is within a tile and above the texel.
    fn exit(&self, texel: [i64; 2], head: [i64; 2]) -> Option<(f64, f64)> {
        let top = f64::from(self.field.range().1);
        let (distance, drop) = (self.distance(texel, head), top - self.height(head));
        let place = |factor: f64, axis: usize| {
            let along = texel[axis] as f64 + factor * (head[axis] - texel[axis]) as f64;
            along / self.parts as f64
        };
        let above = |factor: f64| top - factor * drop - self.field.surface(place(factor, 0), place(factor, 1));
        // A ray that lies in the surface does not leave it.
        let (lowest, _) = self.field.range();
        let clearly = 1e-9 * (top - f64::from(lowest));
        let farthest = (head[0] - texel[0]).abs().max((head[1] - texel[1]).abs());
        let stride = 0.25 / farthest as f64;
        let mut inside = 1.0;
        loop {
            let next = inside + stride;
            if !self.within_a_tile(texel, [place(next, 0), place(next, 1)]) || top - next * drop < self.height(texel) {
                return None;
            }
            if above(next) > clearly {
                let exit = bisect(inside, next, |factor| above(factor) > clearly);
                return Some((exit * distance, top - exit * drop));
            }
            inside = next;
        }
    }

    fn within_a_tile(&self, texel: [i64; 2], place: [f64; 2]) -> bool {
        (0..2).all(|axis| {
            let (parts, extent) = (self.parts as f64, self.extents[axis] as f64);
            let at = place[axis] * parts;
            match self.field.grid().edge {
                Edge::Wrap => (at - texel[axis] as f64).abs() <= extent,
                Edge::Clamp => (0.0..=extent - 1.0).contains(&at),
            }
        })
    }
}

/// The last of `inside` and the places after it, up to `outside`, that is not outside.
fn bisect(mut inside: f64, mut outside: f64, is_outside: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..40 {
        let middle = 0.5 * (inside + outside);
        if is_outside(middle) { outside = middle } else { inside = middle }
    }
    inside
}
