//! Pictures of coloured meshes, through the crate's public face.

use barchan_shade::{ColouredMesh, MeshView, Picture, UpAxis};
use glam::DVec3;

const BACKGROUND: [u8; 3] = [16, 18, 22];
const WHITE: [u8; 3] = [255; 3];
const RED: [u8; 3] = [255, 0, 0];
const BLUE: [u8; 3] = [0, 0, 255];

/// The corners of the unit square, +x to the right and +y up as seen from +z.
const SQUARE: [DVec3; 4] = [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, 0.0), DVec3::Y];

/// From +z, which a square of 1 fills but for 3 pixels of 100 at either side.
fn from_front() -> MeshView {
    MeshView::from_degrees(UpAxis::Y, 0.0, 0.0)
}

fn drawn(positions: &[DVec3], colours: &[[u8; 3]], triangles: &[[u32; 3]], view: MeshView) -> Picture {
    Picture::of_mesh(&ColouredMesh { positions, colours, triangles }, &view, 100)
}

fn white(positions: &[DVec3], triangles: &[[u32; 3]], view: MeshView) -> Picture {
    drawn(positions, &vec![WHITE; positions.len()], triangles, view)
}

fn at(picture: &Picture, column: u32, row: u32) -> [u8; 3] {
    let index = 3 * (row * picture.width + column) as usize;
    picture.rgb[index..index + 3].try_into().unwrap()
}

/// Numbers from 0 to 1, the same on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A ball of radius 1 whose triangles run counter-clockwise seen from outside, with a seam at one meridian.
fn ball(around: u32, along: u32) -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let point = |(u, v): (u32, u32)| {
        // The last meridian lies exactly on the first.
        let (longitude_sin, longitude_cos) =
            libm::sincos(std::f64::consts::TAU * f64::from(u % around) / f64::from(around));
        let (sin, cos) = libm::sincos(std::f64::consts::PI * f64::from(v) / f64::from(along));
        DVec3::new(sin * longitude_cos, sin * longitude_sin, cos)
    };
    let positions = (0..=around).flat_map(|u| (0..=along).map(move |v| (u, v))).map(point).collect();
    let cells = (0..around).flat_map(|u| (0..along).map(move |v| u * (along + 1) + v));
    let next = along + 1;
    (positions, cells.flat_map(|at| [[at, at + 1, at + next + 1], [at, at + next + 1, at + next]]).collect())
}

#[test]
fn a_square_covers_its_pixels_and_no_other() {
    let picture = white(&SQUARE, &[[0, 1, 2], [0, 2, 3]], from_front());
    assert_eq!((picture.width, picture.height, picture.rgb.len()), (100, 100, 30_000));
    for (column, row) in (0..100).flat_map(|column| (0..100).map(move |row| (column, row))) {
        let inside = [column, row].iter().all(|at| (3..97).contains(at));
        assert_eq!(at(&picture, column, row), if inside { WHITE } else { BACKGROUND }, "{column}, {row}");
    }
}

#[test]
fn a_triangle_covers_what_is_below_its_slope_and_blends_along_it() {
    let picture = white(&SQUARE, &[[0, 1, 3]], from_front());
    for (column, row) in (3..97).flat_map(|column| (3..97).map(move |row| (column, row))) {
        let colour = at(&picture, column, row);
        match column.cmp(&row) {
            std::cmp::Ordering::Less => assert_eq!(colour, WHITE, "{column}, {row}"),
            std::cmp::Ordering::Greater => assert_eq!(colour, BACKGROUND, "{column}, {row}"),
            // Half of its samples or three quarters: those on the slope are drawn or they are not.
            std::cmp::Ordering::Equal => assert!((130..240).contains(&colour[0]), "{colour:?}"),
        }
    }
}

#[test]
fn the_longer_side_has_the_size_and_the_other_follows() {
    let wide = SQUARE.map(|corner| corner * DVec3::new(4.0, 1.0, 1.0));
    let high = SQUARE.map(|corner| corner * DVec3::new(1.0, 2.0, 1.0));
    let extent = |positions: &[DVec3]| {
        let picture = white(positions, &[[0, 1, 2], [0, 2, 3]], from_front());
        (picture.width, picture.height)
    };
    assert_eq!(extent(&wide), (100, 30));
    assert_eq!(extent(&high), (53, 100));
}

#[test]
fn colours_are_interpolated_in_linear_light() {
    let picture = drawn(&SQUARE, &[[0; 3], WHITE, WHITE, [0; 3]], &[[0, 1, 2], [0, 2, 3]], from_front());
    // Half of the light is 188 of 255.
    let grey = at(&picture, 49, 50)[0].midpoint(at(&picture, 50, 50)[0]);
    assert!((187..=189).contains(&grey), "{grey}");
    assert!(at(&picture, 4, 50)[0] < 60 && at(&picture, 95, 50)[0] > 250);
}

#[test]
fn the_nearer_hides_the_farther_whatever_the_order() {
    let positions: Vec<DVec3> = SQUARE.into_iter().chain(SQUARE.map(|corner| corner - 2.0 * DVec3::Z)).collect();
    let colours = [[RED; 4], [BLUE; 4]].concat();
    let near_first = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
    let far_first = [near_first[2], near_first[3], near_first[0], near_first[1]];
    for triangles in [near_first, far_first] {
        let front = drawn(&positions, &colours, &triangles, from_front());
        let back = drawn(&positions, &colours, &triangles, MeshView::from_degrees(UpAxis::Y, 180.0, 0.0));
        assert_eq!((at(&front, 50, 50), at(&back, 50, 50)), (RED, BLUE));
        assert!((3..97).all(|column| at(&front, column, 3) == RED && at(&back, column, 96) == BLUE));
    }
}

#[test]
fn triangles_that_cross_hide_one_another_in_part() {
    let tilted = |sign: f64| SQUARE.map(|corner| corner.with_z(sign * (corner.x - 0.5)));
    let positions = [tilted(1.0), tilted(-1.0)].concat();
    let colours = [[RED; 4], [BLUE; 4]].concat();
    let picture = drawn(&positions, &colours, &[[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]], from_front());
    let [left, right] = [20, 80].map(|column| at(&picture, column, 50));
    assert!(left[2] > 150 && left[0] == 0 && right[0] > 150 && right[2] == 0, "{left:?} {right:?}");
}

/// Wherever edges lie, and whichever way triangles run round.
#[test]
fn shared_edges_leave_no_cracks() {
    const CELLS: u32 = 37;
    // The square is 188 samples wide. Corners and many edges go through centres of samples.
    let at_samples = |corner: DVec3| {
        let nearest = |along: f64| ((188.0 * along).floor() + 0.5) / 188.0;
        let inside = |along: f64| if along > 0.0 && along < 1.0 { nearest(along) } else { along };
        DVec3::new(inside(corner.x), inside(corner.y), 0.0)
    };
    let mut random = Random(7);
    for (squeeze, on_samples) in [(1.0, false), (1e-3, false), (1.0, true)] {
        let mut place = |index: u32| {
            let moved = if index == 0 || index == CELLS { 0.0 } else { 0.8 * random.next() - 0.4 };
            (f64::from(index) + moved) / f64::from(CELLS)
        };
        let corners: Vec<DVec3> = (0..=CELLS)
            .flat_map(|u| (0..=CELLS).map(move |v| (u, v)))
            .map(|(u, v)| DVec3::new(place(u), place(v), 0.0))
            // Most cells in a narrow strip: slivers.
            .map(|corner| corner.with_x(if corner.x == 1.0 { 1.0 } else { corner.x * squeeze }))
            .map(|corner| if on_samples { at_samples(corner) } else { corner })
            .collect();
        let cells = (0..CELLS).flat_map(|u| (0..CELLS).map(move |v| u * (CELLS + 1) + v));
        let triangles: Vec<[u32; 3]> = cells
            .flat_map(|a| {
                let [b, c, d] = [a + CELLS + 1, a + CELLS + 2, a + 1];
                if a % 3 == 0 { [[a, b, c], [c, a, d]] } else { [[b, a, d], [b, c, d]] }
            })
            .collect();
        let picture = white(&corners, &triangles, from_front());
        let cracks: Vec<_> = (3..97)
            .flat_map(|column| (3..97).map(move |row| (column, row)))
            .filter(|&(column, row)| at(&picture, column, row) != WHITE)
            .collect();
        assert!(cracks.is_empty(), "{squeeze} {on_samples}: {cracks:?}");
    }
}

/// A lamp beside the eye: a tenth of the light from everywhere, and the rest by the cosine.
#[test]
fn a_ball_is_lit_by_the_closed_form() {
    let (positions, triangles) = ball(96, 48);
    let picture = white(&positions, &triangles, MeshView::from_degrees(UpAxis::Z, 33.0, 20.0));
    for (column, row) in (0..100).flat_map(|column| (0..100).map(move |row| (column, row))) {
        let [x, y] = [column, row].map(|at| (f64::from(at) + 0.5 - 50.0) / 47.0);
        let beyond = x * x + y * y;
        let colour = at(&picture, column, row);
        if beyond < 0.9 {
            let light = 0.1 + 0.9 * (1.0 - beyond).sqrt();
            let expected = 255.0 * (1.055 * light.powf(1.0 / 2.4) - 0.055);
            assert!((f64::from(colour[0]) - expected).abs() < 4.0, "{column}, {row}: {colour:?}, {expected}");
        } else if beyond > 1.08 {
            assert_eq!(colour, BACKGROUND, "{column}, {row}");
        }
    }
}

#[test]
fn neither_seams_nor_turned_triangles_are_seen() {
    let (positions, triangles) = ball(48, 24);
    let view = MeshView::from_degrees(UpAxis::Z, 0.0, 20.0);
    let whole = white(&positions, &triangles, view);
    assert_eq!(white(&positions, &triangles, view), whole, "the same again");
    let apart: Vec<DVec3> = triangles.as_flattened().iter().map(|&corner| positions[corner as usize]).collect();
    let own: Vec<[u32; 3]> =
        (0..triangles.len() as u32).map(|index| [0, 1, 2].map(|corner| 3 * index + corner)).collect();
    assert_eq!(white(&apart, &own, view), whole);
    let turned: Vec<[u32; 3]> = triangles.iter().map(|&[a, b, c]| [a, c, b]).collect();
    assert_eq!(white(&positions, &turned, view), whole);
}

/// A cube from −1 to 1, whose sides −x, x, −y, y, −z, z have colours; each corner is one vertex per side.
fn cube() -> (Vec<DVec3>, Vec<[u8; 3]>, Vec<[u32; 3]>) {
    let sides = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [-axis, axis]);
    let corners = |normal: DVec3| {
        let along = DVec3::new(normal.z, normal.x, normal.y);
        let across = normal.cross(along);
        [-along - across, along - across, along + across, across - along].map(|corner| corner + normal)
    };
    let positions = sides.flat_map(corners).collect();
    let colours = SIDES.iter().flat_map(|&colour| [colour; 4]).collect();
    (
        positions,
        colours,
        (0..6).flat_map(|side| [[0, 1, 2], [0, 2, 3]].map(|corners| corners.map(|corner| 4 * side + corner))).collect(),
    )
}

const SIDES: [[u8; 3]; 6] = [[90, 0, 0], [255, 0, 0], [0, 90, 0], [0, 255, 0], [0, 0, 90], [0, 0, 255]];

#[test]
fn a_view_is_from_where_it_says() {
    let [_, x, minus_y, y, minus_z, z] = SIDES;
    let (positions, colours, triangles) = cube();
    let middle = |up, azimuth, elevation| {
        let picture = drawn(&positions, &colours, &triangles, MeshView::from_degrees(up, azimuth, elevation));
        at(&picture, picture.width / 2, picture.height / 2)
    };
    for (up, azimuth, elevation, side) in [
        (UpAxis::Y, 0.0, 0.0, z),
        (UpAxis::Y, 90.0, 0.0, x),
        (UpAxis::Y, -180.0, 0.0, minus_z),
        (UpAxis::Y, 70.0, 90.0, y),
        (UpAxis::Y, 0.0, -90.0, minus_y),
        (UpAxis::Z, 0.0, 0.0, x),
        (UpAxis::Z, 90.0, 0.0, y),
        (UpAxis::Z, -90.0, 0.0, minus_y),
        (UpAxis::Z, 20.0, 90.0, z),
    ] {
        assert_eq!(middle(up, azimuth, elevation), side, "{up:?} {azimuth} {elevation}");
    }
    // From the front, its right and above: those sides are seen at the left, at the right and on top.
    let corner = drawn(&positions, &colours, &triangles, MeshView::from_degrees(UpAxis::Y, 45.0, 30.0));
    let [left, right, top] = [(30, 60), (70, 60), (50, 20)].map(|(column, row)| at(&corner, column, row));
    assert!(left[2] > 100 && right[0] > 100 && top[1] > 100, "{left:?} {right:?} {top:?}");
}

#[test]
fn a_hard_edge_is_sharp() {
    let (positions, _, triangles) = cube();
    let picture = white(&positions, &triangles, MeshView::from_degrees(UpAxis::Y, 20.0, 0.0));
    let row: Vec<_> = (5..picture.width - 5).map(|column| at(&picture, column, 50)).collect();
    let mut shades = row.clone();
    shades.dedup();
    // Two sides, and between them at most one pixel with samples of both.
    assert!((2..=3).contains(&shades.len()), "{shades:?}");
    assert!(shades[0][0] > shades[shades.len() - 1][0] + 30, "the front is lit more");
}

#[test]
fn what_has_no_extent_is_an_empty_picture() {
    let empty = Picture { width: 100, height: 100, rgb: [BACKGROUND].repeat(10_000).into_flattened() };
    assert_eq!(white(&[], &[], from_front()), empty);
    assert_eq!(white(&SQUARE, &[], from_front()), empty);
    assert_eq!(white(&[DVec3::ONE; 3], &[[0, 1, 2], [1, 1, 1]], from_front()), empty);
    // Along the line of sight.
    assert_eq!(white(&[DVec3::ZERO, DVec3::Z, DVec3::NEG_Z], &[[0, 1, 2]], from_front()), empty);
    // A line covers nothing.
    let line = white(&[DVec3::ZERO, DVec3::X, DVec3::NEG_X], &[[0, 1, 2]], from_front());
    assert_eq!((line.width, line.rgb.chunks(3).all(|pixel| pixel == BACKGROUND)), (100, true));
}

#[test]
fn degenerate_triangles_and_unused_vertices_change_nothing() {
    let positions = [&SQUARE[..], &[DVec3::splat(1e30), DVec3::splat(0.3)]].concat();
    let triangles = [[0, 0, 0], [0, 1, 1], [0, 1, 2], [5, 5, 2], [0, 2, 3]];
    assert_eq!(
        white(&positions, &triangles[..4], from_front()),
        white(&[&SQUARE[..], &[DVec3::ZERO, DVec3::splat(0.3)]].concat(), &triangles[..4], from_front())
    );
    let square = white(&SQUARE, &[[0, 1, 2], [0, 2, 3]], from_front());
    assert_eq!(white(&SQUARE, &[[0, 0, 0], [0, 1, 2], [1, 1, 2], [0, 2, 3]], from_front()), square);
}

#[test]
fn neither_size_nor_place_in_space_matters() {
    let (positions, triangles) = ball(48, 24);
    // Far away by a power of two, and rounded to what a double holds there.
    let far = DVec3::splat(8_388_608.0);
    let rounded: Vec<DVec3> = positions.iter().map(|position| (*position + far) - far).collect();
    let view = MeshView::from_degrees(UpAxis::Y, 30.0, 25.0);
    let expected = white(&rounded, &triangles, view);
    let moved: Vec<DVec3> = rounded.iter().map(|position| *position + far).collect();
    assert_eq!(white(&moved, &triangles, view), expected);
    for scale in [2_f64.powi(-200), 2_f64.powi(90)] {
        let scaled: Vec<DVec3> = rounded.iter().map(|position| *position * scale).collect();
        assert_eq!(white(&scaled, &triangles, view), expected, "{scale}");
    }
    let extreme = [DVec3::splat(1e30), DVec3::splat(-1e30), DVec3::new(1e-300, 1e30, 0.0)];
    assert_eq!(white(&extreme, &[[0, 1, 2]], view).width.max(white(&extreme, &[[0, 1, 2]], view).height), 100);
}

/// 300 rows are five bands of 64.
#[test]
fn bands_are_not_seen() {
    let mesh = ColouredMesh { positions: &SQUARE, colours: &[WHITE; 4], triangles: &[[0, 1, 2], [0, 2, 3]] };
    let picture = Picture::of_mesh(&mesh, &from_front(), 300);
    assert_eq!(picture.rgb.chunks(3).filter(|pixel| *pixel == WHITE).count(), 282 * 282);
    assert!((9..291).all(|row| at(&picture, 9, row) == WHITE && at(&picture, 290, row) == WHITE));
    let smallest = Picture::of_mesh(&mesh, &from_front(), 1);
    assert_eq!((smallest.width, smallest.height), (1, 1));
}
