//! Delaunay triangulation in a rectangular chart, which is tiled where the surface is closed.
//!
//! The chart's coordinates are whole numbers, so that a tile and its copy are the same to the last bit, and with exact predicates so are their
//! triangles. Only a margin of the copies is triangulated; it grows until the triangles fit together across the seam.

use glam::DVec2;

use super::layout::{Ends, Layout};
use super::metric::Metric;
use super::{delaunay, soundness};

/// How many steps of the tiling of its copies a tile needs around it: the widest gap between independent points is a few.
const MARGIN: f64 = 12.0;

pub(super) fn triangulated(parameters: &[DVec2], metric: &Metric, layout: &Layout) -> Option<Vec<[u32; 3]>> {
    let ends = layout.ends;
    let conformal = metric.conformal_v();
    let size = DVec2::new(1.0, conformal.total() / layout.stretch);
    let scale = (1_u64 << 40) as f64 / size.max_element();
    let period = (size * scale).round();
    let place = |at: &DVec2| (DVec2::new(at.x, conformal.at(at.y) / layout.stretch) * scale).round();
    let tile: Vec<DVec2> = parameters.iter().map(place).collect();

    let mut margin = MARGIN * layout.spacing_u / metric.narrowest() * scale;
    loop {
        let triangles = tiled(&tile, period, margin, ends)?;
        if soundness::is_manifold(&triangles, parameters, ends) {
            return Some(triangles);
        }
        if margin > period.max_element() || !ends.closed_u {
            return None;
        }
        margin *= 2.0;
    }
}

/// The triangles of one tile among its copies.
fn tiled(tile: &[DVec2], period: DVec2, margin: f64, ends: Ends) -> Option<Vec<[u32; 3]>> {
    let mut sites: Vec<(u32, DVec2)> = (0..).zip(tile.iter().copied()).collect();
    let shifts = |closed: bool| if closed { -1..=1 } else { 0..=0 };
    for (i, j) in shifts(ends.closed_u).flat_map(|i| shifts(ends.closed_v).map(move |j| (i, j))) {
        if (i, j) == (0, 0) {
            continue;
        }
        let shift = period * DVec2::new(f64::from(i), f64::from(j));
        let (low, high) = (DVec2::splat(-margin), period + margin);
        let copies = (0..).zip(tile.iter().map(|&place| place + shift));
        sites.extend(copies.filter(|(_, place)| place.cmpge(low).all() && place.cmple(high).all()));
    }
    let found = delaunay::triangulated(sites.iter().map(|&(_, place)| place))?;
    let kept = found.triangles.into_iter().filter_map(|corners| {
        // Of a triangle and its copies the one counts whose first vertex lies in the tile itself.
        let vertices = corners.map(|site| sites[site as usize].0);
        let first = (0..3).min_by_key(|&corner| vertices[corner])?;
        ((corners[first] as usize) < tile.len()).then_some(vertices)
    });
    Some(kept.collect())
}
