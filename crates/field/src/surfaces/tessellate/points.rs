//! Random points on a surface, by their parameters. Borders get points of their own, and so do poles: the south pole comes first,
//! the north pole last.

use glam::DVec2;

use super::super::ParametricSurface;
use super::super::random::Random;
use super::POLE;
use super::layout::{Ends, Layout};
use super::metric::{Cumulative, Metric};

/// How far a point may be off the middle of its cell, in cells.
const JITTER: f64 = 0.4;

/// One point per cell of the tiling.
pub(super) fn jittered(layout: &Layout, metric: &Metric, random: &mut Random) -> Vec<DVec2> {
    let ends = layout.ends;
    let mut points = vec![];
    for line in layout.lines() {
        let steps = layout.steps_u[line as usize];
        let on_border_v = ends.open_v() && (line == 0 || line == layout.steps_v);
        let phase = if ends.closed_u { random.unit() } else { 0.0 };
        let height = f64::from(line) / f64::from(layout.steps_v);
        let across = metric.area_along_row(metric.along_v.inverse(height));
        for point in 0..layout.points_on(line) {
            let on_border_u = !ends.closed_u && (point == 0 || point == steps);
            let (right, up) = (offset(on_border_u, random), offset(on_border_v, random));
            let u = wrapped((f64::from(point) + phase + right) / f64::from(steps), ends.closed_u);
            let v = wrapped((f64::from(line) + up) / f64::from(layout.steps_v), ends.closed_v);
            points.push(DVec2::new(across.inverse(u), metric.along_v.inverse(v)));
        }
    }
    with_poles(points, ends)
}

fn offset(on_border: bool, random: &mut Random) -> f64 {
    let offset = JITTER * (2.0 * random.unit() - 1.0);
    if on_border { 0.0 } else { offset }
}

fn wrapped(fraction: f64, closed: bool) -> f64 {
    if closed { fraction.rem_euclid(1.0) } else { fraction }
}

/// `vertices` points without regard for each other, those on borders in the number that the tiling has there.
pub(super) fn independent(
    surface: &ParametricSurface,
    layout: &Layout,
    metric: &Metric,
    vertices: u32,
    random: &mut Random,
) -> Vec<DVec2> {
    let ends = layout.ends;
    let mut points = on_borders(surface, layout, random);
    let taken = points.len() as u32 + if ends.poles { 2 } else { 0 };
    let along_v = metric.area_along_v();
    for _ in taken..vertices {
        let v = along_v.inverse(random.unit());
        let u = metric.area_along_row(v).inverse(random.unit());
        // No point may lie nearer to a pole than the vertex that stands for it.
        points.push(DVec2::new(u, if ends.poles { v.clamp(10.0 * POLE, 1.0 - 10.0 * POLE) } else { v }));
    }
    with_poles(points, ends)
}

/// Points spread evenly by length along each border, then the corners.
fn on_borders(surface: &ParametricSurface, layout: &Layout, random: &mut Random) -> Vec<DVec2> {
    let ends = layout.ends;
    let mut points = vec![];
    let mut spread = |count: u32, along: &Cumulative, place: &dyn Fn(f64) -> DVec2| {
        points.extend((0..count).map(|_| place(along.inverse(random.unit()))));
    };
    for end in [0.0, 1.0] {
        if ends.open_v() {
            let steps = layout.steps_u[if end == 0.0 { 0 } else { layout.steps_v as usize }];
            let along = Cumulative::of_function(|u| surface.jet(u, end).du.length());
            spread(if ends.closed_u { steps } else { steps - 1 }, &along, &|u| DVec2::new(u, end));
        }
        if !ends.closed_u {
            let along = Cumulative::of_function(|v| surface.jet(end, v).dv.length());
            spread(layout.steps_v - 1, &along, &|v| DVec2::new(end, v));
        }
    }
    if !ends.closed_u {
        points.extend([DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::ONE]);
    }
    points
}

/// `points`, between the vertices that stand for the poles if there are any.
pub(super) fn with_poles(points: Vec<DVec2>, ends: Ends) -> Vec<DVec2> {
    if !ends.poles {
        return points;
    }
    let (south, north) = (DVec2::new(0.0, POLE), DVec2::new(0.0, 1.0 - POLE));
    [vec![south], points, vec![north]].concat()
}
