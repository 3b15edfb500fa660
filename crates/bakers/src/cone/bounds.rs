//! Bounds of the slopes between points of two patches, and the slope that a search has come to.

use super::patch::{Patch, Point};

/// A bound of a slope is not narrowed once it is within this factor of a slope that is there. On fractal relief a factor
/// of 17/16 takes a tenth off the time and 0.4 % off the mean ratio.
const TOLERANCE: f64 = 1.0 + 1.0 / 64.0;

/// What is known of the steepest of some ascents.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    pub(super) at_least: f64,
    pub(super) at_most: f64,
}

impl Bounds {
    pub(super) const NONE: Self = Self { at_least: 0.0, at_most: 0.0 };

    /// Of the ascents from any point of one patch to any of another.
    ///
    /// For a unit vector n, |Q − P| ≥ n · (Q − P). And h(Q) − h(P) − s n · (Q − P) is linear along the sides of both
    /// patches: where it is not above 0 for all corners Q, P it is so for all points, and no slope exceeds s. With n
    /// from centre to centre such an s exceeds the steepest slope between corners by no more than 1 / cos of the angle
    /// between n and a pair's direction, so that little halving is needed.
    pub(super) fn between(from: &Patch, to: &Patch) -> Self {
        let (heads, ahead) = (to.corners(), direction(from.centre(), to.centre()));
        let mut bounds = Self::NONE;
        for foot in from.corners() {
            for head in &heads {
                bounds.add(foot, *head, ahead, true);
            }
        }
        bounds.at_most = bounds.at_most.min((to.highest() - from.lowest()).max(0.0) / from.gap(to));
        bounds
    }

    /// Takes in two corners, with n `ahead`. `there`: is this ascent one of those that are asked for?
    pub(super) fn add(&mut self, foot: Point, head: Point, ahead: [f64; 2], there: bool) {
        let (u, v, rise) = (head[0] - foot[0], head[1] - foot[1], head[2] - foot[2]);
        let advance = u * ahead[0] + v * ahead[1];
        if advance <= 0.0 {
            self.at_most = f64::INFINITY;
        } else if rise > 0.0 {
            self.at_most = self.at_most.max(rise / advance);
            if there {
                self.at_least = self.at_least.max(rise / (u * u + v * v).sqrt());
            }
        }
    }
}

/// The unit vector from one place to another.
pub(super) fn direction(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let (u, v) = (to[0] - from[0], to[1] - from[1]);
    let length = (u * u + v * v).sqrt();
    [u / length, v / length]
}

/// A slope that none of the ascents looked at exceeds: either one is nearly as steep, or it is as small as is asked for.
#[derive(Debug, Clone, Copy)]
pub(super) struct Steepest(pub(super) f64);

impl Steepest {
    /// Takes in some ascents. False where their bounds are too far apart, and they are not `all_there_is` to know.
    pub(super) fn settle(&mut self, bounds: Bounds, all_there_is: bool) -> bool {
        let reached = if all_there_is { bounds.at_most } else { bounds.at_most.min(TOLERANCE * bounds.at_least) };
        self.0 = self.0.max(reached);
        bounds.at_most <= self.0
    }
}
