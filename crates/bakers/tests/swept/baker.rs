//! The baker: what the fast sweeps find, what it keeps of that, and the rule for equal points.

use barchan_bakers::horizon::{BentLayer, HorizonParams, bake_bent};
use barchan_bakers::swept::reference::BentReference;
use barchan_bakers::swept::{CurvatureRange, HorizonCandidate, Points, SweptBaker, SweptParams, Tie, select};
use barchan_bakers::{BakeError, Exec};
use barchan_field::{Edge, HeightField, Shape};

use crate::support::{grid, params, terrain};

const BOTH: CurvatureRange = CurvatureRange { min: -0.015, max: 0.015 };
const CONVEX: CurvatureRange = CurvatureRange { min: 0.0, max: 0.015 };

fn exec() -> Exec<'static> {
    Exec::new(1).unwrap()
}

fn layers(field: &HeightField, count: usize) -> Vec<BentLayer> {
    (0..count).map(|_| BentLayer::new(field).unwrap()).collect()
}

fn example(name: &str, size: (u32, u32)) -> HeightField {
    let shape = Shape::examples().into_iter().find(|shape| shape.name() == name).unwrap();
    shape.rasterize(grid(size, Edge::Wrap)).unwrap()
}

fn swept(range: CurvatureRange, points: Points) -> SweptParams {
    SweptParams { range, points }
}

#[test]
fn layers_are_what_selection_makes_of_the_sweeps() {
    let (terrain, params) = (terrain(), params(16, 40.0));
    for range in [BOTH, CONVEX] {
        let mut baker = SweptBaker::new(&terrain, &params, &swept(range, Points::Count(3)), &exec()).unwrap();
        let mut found = layers(&terrain, baker.nodes().bends().len());
        for (index, (&bend, layer)) in baker.nodes().bends().iter().zip(&mut found).enumerate() {
            let bend = if index == 0 { baker.flat_bend() } else { bend };
            bake_bent(&terrain, &params, 3, bend, &exec(), layer).unwrap();
        }
        let mut kept = layers(&terrain, 3);
        baker.bake_direction(3, &exec(), &mut kept).unwrap();
        assert_eq!(kept[0], found[0]);
        for texel in 0..terrain.grid().texels() {
            let point =
                |layer: &BentLayer| HorizonCandidate { slope: layer.slope[texel], distance: layer.distance[texel] };
            let candidates: Vec<_> = found.iter().map(point).collect();
            let mut chosen = [HorizonCandidate::default(); 3];
            select(&candidates, terrain.samples()[texel], baker.nodes(), &mut chosen);
            assert_eq!(kept.iter().map(point).collect::<Vec<_>>(), chosen);
        }
    }
}

#[test]
fn the_same_bytes_for_any_number_of_threads_and_in_any_order() {
    let relief = example("dunes", (192, 160));
    let params = params(8, 90.0);
    let swept = swept(BOTH, Points::MaxErrorDegrees(0.5));
    let bake = |threads: usize, directions: [u32; 2]| {
        let exec = Exec::new(threads).unwrap();
        let mut baker = SweptBaker::new(&relief, &params, &swept, &exec).unwrap();
        let mut kept = layers(&relief, baker.points());
        let mut baked = directions.map(|direction| {
            baker.bake_direction(direction, &exec, &mut kept).unwrap();
            (direction, kept.clone())
        });
        baked.sort_by_key(|(direction, _)| *direction);
        baked
    };
    let one = bake(1, [1, 6]);
    assert!(one == bake(3, [6, 1]) && one == bake(2, [1, 6]));
}

#[test]
fn as_many_points_as_the_error_asks_for() {
    let (terrain, params) = (terrain(), params(16, 40.0));
    let points = |degrees| {
        let swept = swept(BOTH, Points::MaxErrorDegrees(degrees));
        let mut baker = SweptBaker::new(&terrain, &params, &swept, &exec()).unwrap();
        let errors = baker.selection_errors(&exec()).unwrap();
        assert!(errors.percentile_degrees(baker.points()) <= degrees);
        assert!(baker.points() == 1 || errors.percentile_degrees(baker.points() - 1) > degrees);
        baker.points()
    };
    let found = [80.0, 5.0, 0.5, 1e-4].map(points);
    assert!(found[0] == 1 && found.is_sorted() && found[2] > 1 && found[3] <= 8, "{found:?}");
}

#[test]
fn flat_scenes_and_one_point_sweep_the_flat_horizon_only() {
    let (terrain, params) = (terrain(), params(4, 40.0));
    let flat = CurvatureRange { min: 0.0, max: 0.0 };
    for (range, points, kept) in
        [(flat, Points::MaxErrorDegrees(0.01), 1), (flat, Points::Count(3), 3), (BOTH, Points::Count(1), 1)]
    {
        let mut baker = SweptBaker::new(&terrain, &params, &swept(range, points), &exec()).unwrap();
        assert_eq!((baker.nodes().bends(), baker.points()), (&[0.0][..], kept));
        let mut baked = layers(&terrain, kept);
        baker.bake_direction(1, &exec(), &mut baked).unwrap();
        assert!(baked.iter().all(|layer| *layer == baker.candidates()[0]));
    }
}

#[test]
fn what_cannot_be_baked_is_refused() {
    let (terrain, params) = (terrain(), params(4, 40.0));
    let refuse = |range: CurvatureRange, points| {
        SweptBaker::new(&terrain, &params, &swept(range, points), &exec()).map(|_| ()).unwrap_err()
    };
    let name = |error| if let BakeError::Parameter { name, .. } = error { name } else { "another" };
    assert_eq!(name(refuse(BOTH, Points::Count(9))), "points");
    assert_eq!(name(refuse(CurvatureRange { min: -0.1, max: 0.0 }, Points::Count(2))), "curvature");
    let no_radius = HorizonParams { radius: 0.0, ..params };
    let swept = swept(BOTH, Points::Count(2));
    assert!(SweptBaker::new(&terrain, &no_radius, &swept, &exec()).is_err());
}

/// Half cylinders side by side: from one crest all the others are seen at the slope 0.
#[test]
fn of_equal_crests_a_convex_range_has_the_nearest() {
    let bumps = example("cylinder_bumps", (128, 128));
    let grid = *bumps.grid();
    for size in [1e-4_f32, 1.0, 1e4] {
        let bumps = HeightField::new(grid, bumps.samples().iter().map(|height| size * height).collect()).unwrap();
        for radius in [100.0, 300.0] {
            let params = params(16, radius);
            let mut baker = SweptBaker::new(&bumps, &params, &swept(CONVEX, Points::Count(1)), &exec()).unwrap();
            for direction in [0, 1, 4, 7] {
                let mut kept = layers(&bumps, 1);
                baker.bake_direction(direction, &exec(), &mut kept).unwrap();
                let nearest = BentReference::new(&bumps, &params, direction, 0.0, Tie::Nearest);
                for texel in (0..grid.texels()).step_by(5) {
                    let near = nearest.point(texel as u32 % grid.width, texel as u32 / grid.width);
                    let lost = (near.slope.atan() - f64::from(kept[0].slope[texel]).atan()).to_degrees();
                    assert!((-1e-4..0.01).contains(&lost), "{size} {radius} {direction} {texel}: {lost}° lost");
                    // Where relief is 10000 times as high as wide, f32 does not tell the near end of a cell from its far one.
                    let within = if size > 1.0 { 1.5 } else { 1e-4 };
                    let found = f64::from(kept[0].distance[texel]);
                    assert!((found - near.distance).abs() <= within, "{found} instead of {}", near.distance);
                }
            }
        }
    }
}

#[test]
fn the_first_layer_of_a_concave_range_is_the_horizon_map() {
    let (terrain, params) = (terrain(), params(8, 40.0));
    let concave = CurvatureRange { min: -0.015, max: 0.0 };
    let mut baker = SweptBaker::new(&terrain, &params, &swept(concave, Points::Count(2)), &exec()).unwrap();
    let map = barchan_bakers::horizon::bake(&terrain, &params, &exec()).unwrap();
    let mut kept = layers(&terrain, 2);
    baker.bake_direction(5, &exec(), &mut kept).unwrap();
    let texels = terrain.grid().texels();
    assert_eq!(kept[0].distance, map.distance.as_deref().unwrap()[5 * texels..][..texels]);
    let steepest = map.elevation_layer(5).iter().zip(&kept[0].slope).map(|(angle, slope)| (angle - slope.atan()).abs());
    assert!(steepest.fold(0.0, f32::max) < 1e-6);
}
