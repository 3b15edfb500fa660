//! The fast bakers: whole lines at a time, amortised constant work per texel and direction at any size, relief and radius.
//!
//! For each texel the ray's nearest columns are looked at exactly, where neighbouring lines see different things
//! ([`near`](super::near)); of the rest, upper hulls name the places worth a look, and the texel's own ray is followed
//! there ([`far`](super::far)). So every value is the slope of a true point of the surface on the texel's own ray: a sweep
//! can miss the highest one but never invents one, and is never above the reference by more than the rounding of f32.

use fearless_simd::{Level, Simd, dispatch, f32x16, prelude::*};

use super::atan::atan;
use super::best::Best;
use super::far::{BLOCK, Care, Eyes, Look, RayEnd, Scene, Seen};
use super::lane_hull::LANES;
use super::lines::{LINES, MARGIN, STRIDE};
use super::near::NearRay;
use super::sheared::{ResultTile, TILE};
use super::sliding_hull::SlidingHull;
use super::{MAX_ELEVATION_RADIANS, Method};

/// How much is looked at.
#[derive(Debug, Clone, Copy)]
struct Effort {
    /// Columns looked at without asking the hulls: at least this many.
    near: usize,
    /// How many of them wholly.
    exact: usize,
    /// How many columns share an answer of the hulls.
    every: usize,
    /// Whether the ceiling is followed as well as the line, and a line's block as well as its highest column.
    thorough: bool,
}

impl Effort {
    fn of(method: Method) -> Self {
        match method {
            Method::Sweep => Self { near: 4, exact: 1, every: 4, thorough: false },
            Method::Accurate | Method::Exact => Self { near: 12, exact: usize::MAX, every: 2, thorough: true },
        }
    }

    fn first_far_block(self, column: usize) -> usize {
        column / BLOCK + self.near / BLOCK + 1
    }
}

/// The column before which all of a column's rays were looked at without asking the hulls.
pub(crate) fn near_end(column: usize, method: Method) -> usize {
    Effort::of(method).first_far_block(column) * BLOCK
}

/// Buffers of one thread, kept from block to block.
pub(crate) struct Workspace {
    groups: Vec<Group>,
    near: NearRay,
    values: Box<ResultTile>,
    distance: Box<ResultTile>,
}

/// What sixteen lines see.
struct Group {
    line: SlidingHull,
    ceiling: SlidingHull,
    /// What the nearer and the farther part of the line named last.
    seen: [Seen; 2],
}

impl Workspace {
    pub(crate) fn new() -> Self {
        let group = |_| Group {
            line: SlidingHull::new(),
            ceiling: SlidingHull::new(),
            seen: std::array::from_fn(|_| Seen::nothing()),
        };
        Self {
            groups: (0..LINES / LANES).map(group).collect(),
            near: NearRay::new(),
            values: Box::new([[0.0; LINES]; TILE]),
            distance: Box::new([[0.0; LINES]; TILE]),
        }
    }
}

/// From scaled heights per column to slopes, and from columns to lengths.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Units {
    pub(crate) slope: f32,
    pub(crate) length: f32,
    /// The largest distance that is not beyond the radius.
    pub(crate) farthest: f32,
    /// Whether elevations are wanted, or slopes.
    pub(crate) angles: bool,
}

/// Takes the results of some columns, at most [`TILE`], elevations in radians or slopes, and distances in lengths.
pub(crate) type Sink<'a> = dyn FnMut(std::ops::Range<usize>, &[[f32; LINES]], &[[f32; LINES]]) + 'a;

/// A block of lines to be swept.
pub(crate) struct Job<'a> {
    pub(crate) scene: Scene<'a>,
    /// Where its texels lie.
    pub(crate) columns: std::ops::Range<usize>,
    pub(crate) columns_in_sight: usize,
    pub(crate) units: Units,
}

impl Job<'_> {
    /// Sweeps it; distances are found only if they are wanted.
    pub(crate) fn sweep(&self, method: Method, distance: bool, workspace: &mut Workspace, sink: &mut Sink<'_>) {
        let effort = Effort::of(method);
        let level = Level::new();
        match (effort.thorough, distance) {
            (true, true) => dispatch!(level, simd => self.run::<_, true, true>(simd, effort, workspace, sink)),
            (true, false) => dispatch!(level, simd => self.run::<_, true, false>(simd, effort, workspace, sink)),
            (false, true) => dispatch!(level, simd => self.run::<_, false, true>(simd, effort, workspace, sink)),
            (false, false) => dispatch!(level, simd => self.run::<_, false, false>(simd, effort, workspace, sink)),
        }
    }

    #[inline(always)]
    fn run<S: Simd, const THOROUGH: bool, const DISTANCE: bool>(
        &self,
        simd: S,
        effort: Effort,
        workspace: &mut Workspace,
        sink: &mut Sink<'_>,
    ) {
        let Workspace { groups, near, values, distance } = workspace;
        for group in groups.iter_mut() {
            group.line.restart();
            group.ceiling.restart();
            group.seen = std::array::from_fn(|_| Seen::nothing());
        }
        for column in self.columns.clone().rev() {
            let sight = Sight::new(self, column, effort);
            near.follow(self.scene.lines, column, sight.exact, sight.near);
            let in_tile = column % TILE;
            for (index, group) in groups.iter_mut().enumerate() {
                let lane = index * LANES;
                group.slide::<S, THOROUGH>(simd, &self.scene, lane, &sight);
                let height = self.scene.load(simd, column * STRIDE + MARGIN + lane);
                let eyes = Eyes { simd, column, lane, height };
                let best = self.look::<S, THOROUGH, DISTANCE>(eyes, group, near, &sight);
                self.store(simd, best, lane, &mut values[in_tile], &mut distance[in_tile]);
            }
            if in_tile == 0 || column == self.columns.start {
                let end = (column - in_tile + TILE).min(self.columns.end);
                sink(column..end, &values[in_tile..], &distance[in_tile..]);
            }
        }
    }

    #[inline(always)]
    fn look<S: Simd, const THOROUGH: bool, const DISTANCE: bool>(
        &self,
        eyes: Eyes<S>,
        group: &mut Group,
        near: &NearRay,
        sight: &Sight,
    ) -> Best<S, DISTANCE> {
        let (scene, simd) = (&self.scene, eyes.simd);
        let mut best = Best::none(simd);
        near.consider(scene, eyes, &mut best);
        if let Some(end) = &sight.end {
            scene.consider_end(eyes, end, &mut best);
        }
        if sight.ceiling_blocks.is_some() {
            let Group { line, ceiling, seen } = group;
            let care = if THOROUGH { Care::Block } else { Care::Column };
            let look = Look { care, every: sight.every };
            let [seen_near, seen_far] = seen;
            scene.consider(eyes, line.nearer(simd), seen_near, look, &mut best);
            if THOROUGH {
                scene.consider_ceiling(eyes, ceiling.nearer(simd), &mut best);
            }
            scene.consider(eyes, line.farther(simd), seen_far, look, &mut best);
            if THOROUGH {
                scene.consider_ceiling(eyes, ceiling.farther(simd), &mut best);
            }
        }
        best
    }

    #[inline(always)]
    fn store<S: Simd, const DISTANCE: bool>(
        &self,
        simd: S,
        best: Best<S, DISTANCE>,
        lane: usize,
        values: &mut [f32; LINES],
        distance: &mut [f32; LINES],
    ) {
        let splat = |value: f32| f32x16::splat(simd, value);
        let slope = (best.slope + best.distance * self.scene.bend) * self.units.slope;
        let (value, limit) =
            if self.units.angles { (atan(simd, slope), MAX_ELEVATION_RADIANS) } else { (slope, f32::MAX) };
        // Adding 0 makes one zero of two.
        let value = (value + splat(0.0)).max(splat(-limit)).min(splat(limit));
        value.store_slice(&mut values[lane..lane + LANES]);
        if DISTANCE {
            let length = (best.distance * self.units.length).min(splat(self.units.farthest));
            length.store_slice(&mut distance[lane..lane + LANES]);
        }
    }
}

/// What the texels of a column can see.
struct Sight {
    /// Columns looked at without asking the hulls, and how many of them wholly.
    near: usize,
    exact: usize,
    every: usize,
    /// The first and the last block that the line's hull covers: those that lie within the radius.
    blocks: Option<(usize, usize)>,
    /// The same for the ceiling's, which may end in a block that the radius cuts.
    ceiling_blocks: Option<(usize, usize)>,
    /// What lies between the last whole block and the radius.
    end: Option<RayEnd>,
}

impl Sight {
    fn new(sweep: &Job<'_>, column: usize, effort: Effort) -> Self {
        let lines = sweep.scene.lines;
        let first = effort.first_far_block(column);
        let near = first * BLOCK - column;
        let exact = effort.exact.min(near);
        let in_reach = (column + lines.radius as usize + 1) / BLOCK;
        let blocks_end = in_reach.min((sweep.columns_in_sight - 1) / BLOCK);
        let blocks = (blocks_end > first).then(|| (first, blocks_end - 1));
        let ceiling_end = ((column + lines.radius as usize) / BLOCK + 1).min((sweep.columns_in_sight - 1) / BLOCK);
        let ceiling_blocks = (ceiling_end > first).then(|| (first, ceiling_end - 1));
        let end = (lines.radius > exact as f64).then(|| {
            let after = effort.thorough.then(|| first.max(blocks_end) * BLOCK);
            RayEnd::new(lines, column, after, sweep.columns_in_sight)
        });
        Self { near, exact, every: effort.every, blocks, ceiling_blocks, end }
    }
}

impl Group {
    #[inline(always)]
    fn slide<S: Simd, const THOROUGH: bool>(&mut self, simd: S, scene: &Scene<'_>, lane: usize, sight: &Sight) {
        if let Some((first, last)) = sight.blocks {
            self.line.slide_to(
                simd,
                first,
                last,
                scene.bend,
                #[inline(always)]
                |block| scene.line_point(simd, lane, block),
            );
        }
        if let Some((first, last)) = sight.ceiling_blocks.filter(|_| THOROUGH) {
            self.ceiling.slide_to(
                simd,
                first,
                last,
                scene.bend,
                #[inline(always)]
                |block| scene.ceiling_point(simd, lane, block),
            );
        }
    }
}
