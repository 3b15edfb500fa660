//! Regular tilings: a grid of parameters, closed by a fan at each pole.

use glam::DVec2;

use super::Connected;
use super::layout::Layout;
use super::points::with_poles;

pub(super) fn connected(layout: &Layout) -> Connected {
    let ends = layout.ends;
    let lines: Vec<u32> = layout.lines().collect();
    let (steps_u, columns) = (layout.steps_u[0], layout.points_on(0));
    let mut parameters = vec![];
    for &line in &lines {
        let v = f64::from(line) / f64::from(layout.steps_v);
        parameters.extend((0..columns).map(|column| DVec2::new(f64::from(column) / f64::from(steps_u), v)));
    }

    let rows = lines.len() as u32;
    let first = u32::from(ends.poles);
    let vertex = |column: u32, row: u32| first + (row % rows) * columns + column % columns;
    let mut triangles = vec![];
    for row in 0..if ends.closed_v { rows } else { rows - 1 } {
        for column in 0..steps_u {
            let [low_left, low_right] = [vertex(column, row), vertex(column + 1, row)];
            let [high_left, high_right] = [vertex(column, row + 1), vertex(column + 1, row + 1)];
            triangles.extend([[low_left, low_right, high_right], [low_left, high_right, high_left]]);
        }
    }
    let parameters = with_poles(parameters, ends);
    if ends.poles {
        let (south, north) = (0, parameters.len() as u32 - 1);
        for column in 0..steps_u {
            triangles.push([south, vertex(column + 1, 0), vertex(column, 0)]);
            triangles.push([north, vertex(column, rows - 1), vertex(column + 1, rows - 1)]);
        }
    }
    Connected { parameters, triangles }
}
