//! The truth: the first hit with the bilinear surface, cell by cell in f64.

use super::cell::Cell;
use super::{Fetches, Found, Relief, ReliefRay, ReliefSearch, Start};

/// Follows a ray from cell to cell and solves each exactly: to rounding, the definition of what the searches look for.
///
/// As a search it costs one gather a cell.
#[derive(Debug, Clone, Copy)]
pub struct TracedRelief<'a> {
    relief: Relief<'a>,
}

impl<'a> TracedRelief<'a> {
    /// Traces a relief.
    #[must_use]
    pub fn new(relief: &Relief<'a>) -> Self {
        Self { relief: *relief }
    }

    /// The depth of the first hit at or behind a depth: `from` itself where the ray is inside the relief there.
    #[must_use]
    pub fn first_hit(&self, ray: &ReliefRay, from: f64) -> f64 {
        self.walk(ray, from).0
    }

    /// The hit, and the cells walked.
    fn walk(&self, ray: &ReliefRay, from: f64) -> (f64, u32) {
        let mut depth = if from > 0.0 { from.min(1.0) } else { 0.0 };
        let mut cell = Cell::behind(ray, depth);
        let mut cells = 0;
        // It ends: a ray's way is bounded, and every turn goes on by a cell.
        loop {
            cells += 1;
            let exit = cell.exit(ray, depth);
            let hit = cell.first_hit(ray, self.relief.corners(cell), (depth, exit.depth));
            // Nothing is deeper than 1, whatever rounding says.
            if let Some(hit) = hit.or((exit.depth >= 1.0).then_some(1.0)) {
                return (hit, cells);
            }
            (depth, cell) = (exit.depth, exit.next);
        }
    }
}

impl ReliefSearch for TracedRelief<'_> {
    fn name(&self) -> &'static str {
        "traced"
    }

    /// From a start that is not proven it begins at the top, as that alone is the truth.
    fn find(&self, ray: &ReliefRay, start: Start) -> Found {
        let (depth, cells) = self.walk(ray, if start.proven { start.depth } else { 0.0 });
        let mut fetches = start.fetches;
        fetches += Fetches { heights: cells, tables: 0 };
        Found { depth, fetches }
    }
}
