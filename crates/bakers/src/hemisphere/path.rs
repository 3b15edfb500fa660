//! The way of all rays of a layer, worked out once.
//!
//! Rays of one direction that enter at texel centres cross the cells around them at the same depths. Their way is a list of crossings,
//! gathered in groups and groups of groups, each within one window: where the least depth of the window is below the end of the group,
//! the ray passes above all that is there and the group is skipped.

use super::ray::{Crossing, Crossings, DepthRay};
use super::windows::{Offset, SIDES, Windows};

/// The way of the rays of one layer.
pub(super) struct Path {
    /// Groups and crossings in the order of depth, each group before what is in it.
    pub(super) steps: Vec<Step>,
    /// How deep the rays are followed, 1 but for absurd ones.
    pub(super) deepest: f32,
    /// Whether the rays stay where they enter.
    pub(super) is_vertical: bool,
}

/// A group of crossings, or one of them.
pub(super) struct Step {
    /// A window that holds all corners of its cells.
    pub(super) window: Offset,
    /// The depth at its end.
    pub(super) end: f32,
    /// The first step beyond it.
    pub(super) next: usize,
    /// If it is one crossing: what happens there.
    pub(super) cell: Option<Cell>,
}

/// The way through one cell.
pub(super) struct Cell {
    /// Of the corner with the least column and row.
    pub(super) corner: Offset,
    pub(super) start: f32,
    pub(super) depth: f32,
    pub(super) enters: (f32, f32),
    pub(super) leaves: (f32, f32),
    /// By how much of the cell's twist the surface bends along the ray: columns times rows crossed.
    pub(super) bend: f32,
}

impl Path {
    pub(super) fn new(ray: DepthRay, windows: &Windows) -> Self {
        let crossings: Vec<_> = Crossings::new(ray, (0.0, 0.0)).collect();
        let mut path = Self {
            steps: Vec::with_capacity(2 * crossings.len()),
            deepest: ray.deepest() as f32,
            is_vertical: ray.is_vertical(),
        };
        path.add(&crossings, SIDES.len() - 1, windows);
        path
    }

    /// Adds crossings in groups as large as the windows of a level allow.
    fn add(&mut self, mut crossings: &[Crossing], level: usize, windows: &Windows) {
        while let Some(first) = crossings.first() {
            let count = crossings.iter().take_while(|crossing| reach(first, crossing) < SIDES[level]).count();
            let (group, rest) = crossings.split_at(count);
            let index = self.steps.len();
            self.steps.push(Step::new(group, level, windows));
            if level > 1 {
                self.add(group, level - 1, windows);
            }
            self.steps[index].next = self.steps.len();
            crossings = rest;
        }
    }
}

/// How many cells lie between two crossings along one axis, counting both: one less than the side of a window that holds their corners.
fn reach(first: &Crossing, last: &Crossing) -> usize {
    1 + first.cell.0.abs_diff(last.cell.0).max(first.cell.1.abs_diff(last.cell.1)) as usize
}

impl Step {
    /// Of crossings that run one way within a window of a level; of one if the window is a cell.
    fn new(group: &[Crossing], level: usize, windows: &Windows) -> Self {
        let (first, last) = (&group[0], &group[group.len() - 1]);
        let least = (first.cell.0.min(last.cell.0), first.cell.1.min(last.cell.1));
        let window = windows.offset(level, least.0, least.1);
        let cell = (level == 1).then(|| Cell::new(first, windows));
        Self { window, end: last.end as f32, next: 0, cell }
    }
}

impl Cell {
    fn new(crossing: &Crossing, windows: &Windows) -> Self {
        let Crossing { cell, start, end, enters, leaves } = *crossing;
        Self {
            corner: windows.offset(0, cell.0, cell.1),
            start: start as f32,
            depth: (end - start) as f32,
            enters: (enters.0 as f32, enters.1 as f32),
            leaves: (leaves.0 as f32, leaves.1 as f32),
            bend: ((leaves.0 - enters.0) * (leaves.1 - enters.1)) as f32,
        }
    }
}
