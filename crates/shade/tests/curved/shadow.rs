//! Shadows by baked points against the oracle and against what they must agree with.

use barchan_asset::{DistanceView, HeightView, HorizonView};
use barchan_bakers::swept::CurvatureRange;
use barchan_field::{Edge, HeightField};
use barchan_shade::{
    BaseSurface, CurvedMethod, CurvedShadow, Cylinder, DirectionalLight, DisplacedShadow, HorizonShadow,
    MismatchedTables, Place, Plane, Sphere, SphereChart, Surface, TangentLight,
};
use glam::{DMat2, DVec2, DVec3};

use crate::support::{Map, assert_near, ball, centre, cylinder_bumps, example, field, noise, relief, towards};

const FLAT_MAP_METHODS: [CurvedMethod; 4] =
    [CurvedMethod::Flat, CurvedMethod::PaperAsPrinted, CurvedMethod::Paper, CurvedMethod::Exact(1)];

/// Centres of texels of one tile, some thousand of them.
fn centres(field: &HeightField) -> Vec<DVec2> {
    let (width, height) = (field.grid().width, field.grid().height);
    (0..1500)
        .map(|k| (noise(11, k, 0) * width as f32, noise(12, k, 0) * height as f32))
        .map(|(column, row)| centre(field, column as u32, row as u32) - DVec2::splat(0.5))
        .collect()
}

/// A relief on a base surface, and which of many places under some lights are in shadow.
struct Scene {
    places: Vec<Place>,
    truth: Vec<bool>,
}

impl Scene {
    fn new(base: &impl BaseSurface, relief: &Surface, places: &[DVec2], lights: &[DVec3], reach: f64) -> Self {
        let oracle = DisplacedShadow::new(base, relief, reach);
        let pairs = || lights.iter().flat_map(|light| places.iter().map(move |uv| (*uv, *light)));
        let truth: Vec<bool> = pairs().map(|(uv, light)| oracle.in_shadow(uv, light)).collect();
        let shadows = truth.iter().filter(|&&shadow| shadow).count();
        assert!((truth.len() / 10..truth.len() * 9 / 10).contains(&shadows), "{shadows} shadows of {}", truth.len());
        Self { places: pairs().map(|(uv, light)| Place::new(base, relief, uv, light)).collect(), truth }
    }

    /// The share of wrong shadows.
    fn wrong(&self, shadow: &CurvedShadow, method: CurvedMethod) -> f64 {
        let wrong = |(place, truth): &(&Place, &bool)| {
            shadow.in_shadow(method, place.texel, &place.light, place.curvature()) != **truth
        };
        self.places.iter().zip(&self.truth).filter(wrong).count() as f64 / self.truth.len() as f64
    }
}

#[test]
fn on_a_flat_base_every_method_is_the_horizon_map() {
    let field = field((24, 20), Edge::Wrap, |column, row| 3.0 * noise(5, column, row));
    let (map, relief) = (Map::flat(&field, 16, 30.0), relief(&field));
    let plane = Plane { chart: DMat2::from_diagonal(DVec2::new(24.0, 20.0)) };
    let table = &map.flat[0];
    let (view, curved) = (HorizonView::new(*table.descriptor(), table.payload()).unwrap(), map.shadow());
    for (azimuth, elevation) in [(0.0, 10.0), (33.0, 25.0), (357.0, 40.0)] {
        let light = DirectionalLight::from_degrees(azimuth, elevation);
        let flat = HorizonShadow::new(&view, &light);
        for k in 0..200 {
            let uv = DVec2::new(noise(1, k, 0).into(), noise(2, k, 0).into());
            let place = Place::new(&plane, &relief, uv, light.towards);
            let (x, y) = place.texel;
            for method in FLAT_MAP_METHODS {
                let found = curved.elevation_radians(method, place.texel, &place.light, place.curvature());
                // Slopes are kept in f32, and the horizon map blends its azimuths in f32.
                assert_near(found, flat.elevation_radians(x, y), 1e-6);
                let near = (found - elevation.to_radians()).abs() < 1e-5;
                let shadow = curved.in_shadow(method, place.texel, &place.light, place.curvature());
                assert!(near || shadow == flat.in_shadow(x, y));
            }
        }
    }
}

/// A chart that shears and stretches, and lights along baked azimuths of the texture.
#[test]
fn an_affine_chart_is_exact_and_its_stretch_matters() {
    let field = example("reptile_skin", 64);
    let (shadow, relief) = (Map::flat(&field, 16, 120.0).shadow(), relief(&field));
    let plane = Plane { chart: DMat2::from_cols(DVec2::new(110.0, 10.0), DVec2::new(-30.0, 50.0)) };
    let light = |direction: u32| {
        let step = DVec2::from_angle(std::f64::consts::TAU * f64::from(direction) / 16.0);
        (plane.chart * step).normalize().extend(0.35).normalize()
    };
    let lights = [light(1), light(6), light(11)];
    let scene = Scene::new(&plane, &relief, &centres(&field), &lights, f64::INFINITY);
    let wrong = scene.wrong(&shadow, CurvedMethod::Exact(1));
    assert!(wrong < 0.002, "{wrong}");
    let unstretched = |place: &Place| Place { light: TangentLight { stretch: 1.0, ..place.light }, ..*place };
    let scene = Scene { places: scene.places.iter().map(unstretched).collect(), truth: scene.truth };
    assert!(scene.wrong(&shadow, CurvedMethod::Exact(1)) > 0.03);
}

/// Figure 4: κ = 0.015, half-cylinders on a ball, 32 azimuths.
#[test]
fn on_a_ball_with_cylinder_bumps_each_step_of_the_method_is_nearer_the_truth() {
    let field = cylinder_bumps(128, 8);
    let relief = relief(&field);
    let map = Map::swept(&field, 32, 128.0, CurvatureRange { min: 0.0, max: 0.015 }, 3).shadow();
    let ball = ball(&field, 1.0 / 0.015, SphereChart::Stereographic);
    let lights = [towards(10.0, 10.0), towards(100.0, 20.0), towards(200.0, 35.0)];
    let scene = Scene::new(&ball, &relief, &centres(&field), &lights, f64::INFINITY);
    let [flat, printed, paper, one, two, three] = CurvedMethod::ALL.map(|method| scene.wrong(&map, method));
    let all = [flat, printed, paper, one, two, three];
    assert!(printed > 2.0 * flat && flat > 1.3 * paper && paper >= one && one >= two, "{all:?}");
    assert!(two < 0.008 && three < 0.008 && flat > 0.02, "{all:?}");
}

#[test]
fn on_relief_of_many_scales_one_point_is_not_enough() {
    let field = example("fractal_terrain", 96);
    let relief = relief(&field);
    let map = Map::swept(&field, 32, 100.0, CurvatureRange { min: 0.0, max: 0.015 }, 3).shadow();
    let ball = ball(&field, 1.0 / 0.015, SphereChart::Stereographic);
    let lights = [towards(10.0, 10.0), towards(100.0, 20.0), towards(200.0, 35.0)];
    let scene = Scene::new(&ball, &relief, &centres(&field), &lights, f64::INFINITY);
    let [flat, printed, paper, one, two, three] = CurvedMethod::ALL.map(|method| scene.wrong(&map, method));
    let all = [flat, printed, paper, one, two, three];
    assert!(printed > 1.5 * flat && flat > paper && one > 3.0 * two && two < 0.012 && three < 0.012, "{all:?}");
}

/// Inside a cylinder of radius 100, looked round for 64: the wall rises to 18° there, and lights stand higher.
#[test]
fn in_a_hollow_far_relief_rises_and_is_found() {
    let field = example("fractal_terrain", 96);
    let (relief, extent) = (relief(&field), DVec2::splat(96.0));
    let map = Map::swept(&field, 16, 64.0, CurvatureRange { min: -0.01, max: 0.0 }, 3).shadow();
    let base = Cylinder { radius: 100.0, hollow: true, chart: DMat2::from_diagonal(extent) };
    // Light from across, and texture coordinates around the bottom.
    let places: Vec<DVec2> = centres(&field).into_iter().filter(|uv| uv.x.abs() < 0.2).collect();
    let lights = [40.0_f64, 48.0, 56.0].map(|degrees| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        DVec3::new(-sin, cos, 0.0)
    });
    let scene = Scene::new(&base, &relief, &places, &lights, 62.0);
    let [flat, printed, paper, one, _, three] = CurvedMethod::ALL.map(|method| scene.wrong(&map, method));
    // The paper leaves hollows flat.
    assert_eq!(flat, printed);
    let all = [flat, paper, one, three];
    assert!(flat > 0.02 && paper < flat && one < flat && three < 0.005, "{all:?}");
}

#[test]
fn mirrored_texture_coordinates_give_the_same_shadows() {
    let straight = example("reptile_skin", 64);
    let mirrored = field((64, 64), Edge::Wrap, |column, row| straight.texel(63 - i64::from(column), row.into()));
    let seen = |field: &HeightField, side: f64| {
        let base = Sphere { tile: DVec2::new(side * 64.0, 64.0), ..ball(field, 66.0, SphereChart::Geographic) };
        let (relief, map) = (relief(field), Map::flat(field, 16, 64.0).shadow());
        let oracle = DisplacedShadow::new(&base, &relief, f64::INFINITY);
        let of = |uv: &DVec2| {
            let (uv, light) = (DVec2::new(side * uv.x, uv.y), towards(70.0, 12.0));
            let place = Place::new(&base, &relief, uv, light);
            assert_eq!(place.frame.mirrored(), side < 0.0);
            assert_near(place.curvature(), 1.0 / 66.0, 1e-15);
            let elevation = map.elevation_radians(CurvedMethod::Exact(1), place.texel, &place.light, place.curvature());
            (elevation, oracle.in_shadow(uv, light))
        };
        centres(&straight).iter().map(of).collect::<Vec<_>>()
    };
    let (a, b) = (seen(&straight, 1.0), seen(&mirrored, -1.0));
    // Sweeps in the other direction find other points here and there.
    let different = a.iter().zip(&b).filter(|(a, b)| (a.0 - b.0).abs() > 0.01).count();
    assert!(different < a.len() / 100, "{different}");
    assert!(a.iter().zip(&b).all(|(a, b)| a.1 == b.1), "the truth has no chart");
}

/// The same outer shape, once as relief above a ball, once as relief sunk below a larger one under a larger texture.
#[test]
fn sunken_relief_is_the_same_as_relief_on_a_smaller_ball() {
    let raised = example("reptile_skin", 48);
    let sunken = field((48, 48), Edge::Wrap, |column, row| raised.texel(column.into(), row.into()) - 8.0);
    let seen = |field: &HeightField, radius: f64| {
        let tile = DVec2::splat(48.0 * radius / 60.0);
        let base = Sphere { radius, hollow: false, chart: SphereChart::Stereographic, tile };
        let (relief, map) = (relief(field), Map::flat(field, 16, 48.0).shadow());
        let oracle = DisplacedShadow::new(&base, &relief, f64::INFINITY);
        let of = |uv: DVec2| {
            let light = towards(160.0, 8.0);
            let place = Place::new(&base, &relief, uv, light);
            let elevation = map.elevation_radians(CurvedMethod::Exact(1), place.texel, &place.light, place.curvature());
            (elevation, oracle.in_shadow(uv, light))
        };
        (0..400).map(|k| of(DVec2::new(noise(1, k, 0).into(), noise(2, k, 0).into()) - 0.5)).collect::<Vec<_>>()
    };
    for (a, b) in seen(&raised, 60.0).into_iter().zip(seen(&sunken, 68.0)) {
        assert_near(a.0, b.0, 1e-5);
        assert_eq!(a.1, b.1);
    }
}

#[test]
fn bumps_behind_the_terminator_are_lit_where_they_reach_into_the_light() {
    let field = cylinder_bumps(128, 8);
    let relief = relief(&field);
    let map = Map::swept(&field, 32, 128.0, CurvatureRange { min: 0.0, max: 0.015 }, 3).shadow();
    let ball = ball(&field, 1.0 / 0.015, SphereChart::Stereographic);
    let lights = [0.0, 2.0, 4.0, 6.0].map(|elevation| towards(0.0, elevation));
    let scene = Scene::new(&ball, &relief, &centres(&field), &lights, f64::INFINITY);
    let lit_behind = |in_shadow: &dyn Fn(usize) -> bool| -> Vec<usize> {
        let behind = |k: &usize| scene.places[*k].light.height < -0.02 && !in_shadow(*k);
        (0..scene.places.len()).filter(behind).collect()
    };
    let by_map = |k: usize| {
        let place = &scene.places[k];
        map.in_shadow(CurvedMethod::Exact(3), place.texel, &place.light, place.curvature())
    };
    let (found, truth) = (lit_behind(&by_map), lit_behind(&|k| scene.truth[k]));
    assert!(truth.len() > 20, "{}", truth.len());
    let both = found.iter().filter(|k| truth.contains(k)).count();
    assert!(both * 10 >= truth.len() * 9 && both * 10 >= found.len() * 9, "{both} {} {}", truth.len(), found.len());
    // They face the light, though the ball does not.
    let bright =
        truth.iter().filter(|&&k| scene.places[k].lambert(&relief, lights[k / centres(&field).len()]) > 0.1).count();
    assert!(bright * 3 > truth.len(), "{bright} of {}", truth.len());
}

#[test]
fn a_light_at_the_zenith_reaches_and_one_from_below_does_not() {
    let field = field((8, 8), Edge::Wrap, |column, row| 9.0 * noise(1, column, row));
    let shadow = Map::flat(&field, 8, 10.0).shadow();
    let vertical =
        |height| TangentLight { height, level: 0.0, direction: DVec2::ZERO, azimuth_radians: 0.0, stretch: 1.0 };
    for method in CurvedMethod::ALL {
        for curvature in [-0.1, 0.0, 0.1] {
            assert!(!shadow.in_shadow(method, (2.3, 4.4), &vertical(1.0), curvature));
            assert!(shadow.in_shadow(method, (2.3, 4.4), &vertical(-1.0), curvature));
        }
    }
}

#[test]
fn between_texels_it_is_what_the_texels_around_say() {
    let field = field((8, 8), Edge::Wrap, |column, row| 5.0 * noise(7, column, row));
    let shadow = Map::swept(&field, 8, 12.0, CurvatureRange { min: -0.05, max: 0.05 }, 3).shadow();
    let light = TangentLight { height: 0.1, level: 0.9, direction: DVec2::X, azimuth_radians: 1.0, stretch: 1.1 };
    for method in CurvedMethod::ALL {
        for curvature in [-0.05, 0.02] {
            let at = |x: f64, y: f64| shadow.elevation_radians(method, (x, y), &light, curvature);
            let corners = at(2.0, 7.0) * 0.75 * 0.5
                + at(3.0, 7.0) * 0.25 * 0.5
                + at(2.0, 8.0) * 0.75 * 0.5
                + at(3.0, 8.0) * 0.25 * 0.5;
            assert_near(at(2.25, 7.5), corners, 1e-14);
        }
    }
}

#[test]
fn methods_have_names_and_ask_for_no_more_points_than_there_are() {
    let names = CurvedMethod::ALL.map(|method| method.to_string());
    assert_eq!(names, ["flat", "paper-as-printed", "paper", "exact-1", "swept-2", "swept-3"]);
    let field = field((8, 8), Edge::Wrap, |column, row| 3.0 * noise(1, column, row));
    let shadow = Map::flat(&field, 8, 10.0).shadow();
    assert_eq!((shadow.points(), shadow.extent()), (1, (8.0, 8.0)));
    let light = TangentLight { height: 0.1, level: 0.9, direction: DVec2::X, azimuth_radians: 0.3, stretch: 1.2 };
    let at = |method| shadow.elevation_radians(method, (1.5, 2.5), &light, 0.02);
    assert_eq!(at(CurvedMethod::Exact(1)), at(CurvedMethod::Exact(3)));
}

#[test]
fn tables_of_different_maps_are_refused() {
    let rough = |size| field((size, 8), Edge::Wrap, |column, row| noise(1, column, row));
    let map = |size, directions| Map::flat(&rough(size), directions, 10.0);
    let (a, narrow, fewer) = (map(8, 8), map(7, 8), map(8, 4));
    let with = |distances: &Map, heights: &Map| {
        let horizon = HorizonView::new(*a.flat[0].descriptor(), a.flat[0].payload()).unwrap();
        let distance = DistanceView::new(*distances.flat[1].descriptor(), distances.flat[1].payload()).unwrap();
        let heights = HeightView::new(*heights.heights.descriptor(), heights.heights.payload()).unwrap();
        CurvedShadow::new(&horizon, &distance, None, &heights).err()
    };
    assert_eq!(with(&a, &a), None);
    assert_eq!(with(&a, &narrow), Some(MismatchedTables("height")));
    assert_eq!(with(&narrow, &a), Some(MismatchedTables("distance")));
    assert_eq!(with(&fewer, &a), Some(MismatchedTables("distance")));
}
