//! Starts out of made-up depth maps.

use barchan_asset::{
    Azimuths, DepthMode, Encoding, HemisphereDirections, HemisphereTable, HemisphereView, RingSpacing, TableGrid,
    TextureTable,
};
use barchan_field::{Edge, HeightField};
use barchan_shade::{DepthMapStart, Fetches, Relief, Start};
use glam::DVec3;

use crate::common::table_grid;
use crate::support::{assert_near, field, relief_range, surface, towards};

/// Edges at 0, 30 and 60°, azimuths at 0, 90, 180 and 270°.
const MAX_POLAR: f64 = 60.0;

fn relief_field(edge: Edge) -> HeightField {
    field((12, 9), (0.5, 2.0), edge, |column, row| ((column * 7 + row * 5) % 11) as f32)
}

fn directions(azimuths: Azimuths) -> HemisphereDirections {
    HemisphereDirections {
        rings: 2,
        azimuths,
        spacing: RingSpacing::EqualAngles,
        max_polar_radians: MAX_POLAR.to_radians(),
    }
}

/// 4 × 3 texels for 12 × 9 heights, with a depth of its own in every texel of every layer.
fn table(field: &HeightField, azimuths: Azimuths, mode: DepthMode) -> TextureTable {
    let source = table_grid(field.grid());
    let grid = TableGrid { width: 4, height: 3, spacing_u: 1.5, spacing_v: 6.0, ..source };
    let directions = directions(azimuths);
    let values: Vec<f32> = (0..directions.layers() * 12).map(stored).collect();
    HemisphereTable { grid, directions, mode, relief: relief_range(field), values: &values }
        .encode(Encoding::F32)
        .unwrap()
}

fn stored(index: u32) -> f32 {
    index as f32 / 128.0
}

fn view(table: &TextureTable) -> HemisphereView<'_> {
    HemisphereView::new(*table.descriptor(), table.payload()).unwrap()
}

fn start(edge: Edge, mode: DepthMode, azimuths: Azimuths, place: (f64, f64), towards: DVec3) -> Start {
    let field = relief_field(edge);
    let (surface, table) = (surface(&field), table(&field, azimuths, mode));
    let relief = Relief::new(&surface);
    DepthMapStart::new(&relief, &view(&table)).unwrap().start(&relief.ray(place.0, place.1, towards).unwrap())
}

#[test]
fn a_ray_looks_up_its_ring_its_azimuth_and_the_texel_it_enters_in() {
    let circle = Azimuths::full_circle(4);
    let layers = [((0.0, 123.0), 0), ((29.9, 44.0), 0), ((29.9, 46.0), 1), ((30.1, 316.0), 4), ((59.9, 224.0), 6)];
    // Texel (2, 1) of the map covers the source's columns 6 to 8 and rows 3 to 5.
    let texels = [((5.6, 2.6), 6), ((8.4, 5.4), 6), ((5.4, 2.6), 5), ((-0.6, 2.6), 7), ((6.0, 9.0 + 4.0), 6)];
    for ((polar, azimuth), layer) in layers {
        for (place, texel) in texels {
            // Along the normal any azimuth is right.
            let found = start(Edge::Wrap, DepthMode::Conservative, circle, place, towards(polar, azimuth));
            let expected = Start { depth: stored(layer * 12 + texel).into(), proven: true, fetches: Fetches::TABLE };
            assert_eq!(found, expected, "{polar}° {azimuth}° {place:?}");
        }
    }
}

#[test]
fn rays_that_were_not_baked_start_at_the_top_for_nothing() {
    let (circle, arc) = (Azimuths::full_circle(4), Azimuths::arc(0.0, 1.0, 3));
    let place = (6.0, 4.0);
    assert_eq!(start(Edge::Wrap, DepthMode::Conservative, circle, place, towards(60.1, 0.0)), Start::TOP);
    assert_eq!(start(Edge::Wrap, DepthMode::Conservative, arc, place, towards(20.0, 90.0)), Start::TOP);
    assert_ne!(start(Edge::Wrap, DepthMode::Conservative, arc, place, towards(20.0, 60.0)), Start::TOP);
    // Along the normal every azimuth is the same ray.
    assert!(start(Edge::Wrap, DepthMode::Conservative, Azimuths::arc(1.0, 2.0, 3), place, DVec3::Z).depth > 0.0);
    for beyond in [(-0.6, 4.0), (11.6, 4.0), (6.0, -0.6), (6.0, 8.6)] {
        assert_eq!(start(Edge::Clamp, DepthMode::Conservative, circle, beyond, towards(20.0, 0.0)), Start::TOP);
    }
    assert!(start(Edge::Clamp, DepthMode::Conservative, circle, (11.4, 8.4), towards(20.0, 0.0)).depth > 0.0);
}

#[test]
fn the_nearest_mode_projects_the_stored_point_onto_the_ray() {
    let circle = Azimuths::full_circle(4);
    let (polar, azimuth) = (47.0, 71.0);
    let (ray, ring) = (towards(polar, azimuth), towards(30.0, 90.0));
    let stored = f64::from(stored(5 * 12 + 6));
    // |OP′| = h / cos θs along the stored direction; its projection's height along the ray.
    let expected = (ring * (stored / ring.z)).dot(ray) * ray.z;
    let found = start(Edge::Wrap, DepthMode::Nearest, circle, (6.0, 4.0), ray);
    assert_near(found.depth, expected, 1e-12);
    assert!(found.depth < stored && !found.proven);
}

#[test]
fn along_a_stored_direction_the_projection_is_the_stored_depth() {
    let found =
        start(Edge::Wrap, DepthMode::Nearest, Azimuths::full_circle(4), (6.0, 4.0), towards(30.0 + 1e-9, 180.0));
    assert_near(found.depth, stored(6 * 12 + 6).into(), 1e-8);
}
