//! Pictures, byte by byte.
//!
//! Colours end as whole 255ths: what f32 and f64 say of light is within 1 of 255. The rest is places where the two decide otherwise,
//! at the edges of shadows and where a ray of relief just meets or misses a ridge: a stated share of the pixels.

use barchan_asset::{BentNormalView, HeightView, HorizonView, Semantic, SkyVisibilityView};
use barchan_field::shapes::FractalTerrain;
use barchan_field::{Edge, Shape};
use barchan_pipeline::{Table, TableEncoding};
use barchan_shade::{
    BACKGROUND, DirectionalLight, HorizonShadow, LinearSearch, Palette, Picture, Pixels, Relief, ReliefLight,
    ReliefPixels, ReliefRoad, ReliefShadow, ReliefStage, SHADOW_TOLERANCE, SkyLight, StageBase, StageEye, Surface,
};
use barchan_view::{Canvas, GpuPicture, PictureBase, PictureLight, ReliefView, TopView};
use barchan_wgpu::{ReliefSearch, Sampling};

use crate::compare::agree;
use crate::support::{Loaded, SAMPLINGS, gpu, recipe};

const EDGES: [Edge; 2] = [Edge::Wrap, Edge::Clamp];

/// Relief with heights and slopes of all sizes, on texels that are not square.
fn terrain(edge: Edge, tables: &[Table]) -> Loaded {
    let shape =
        Shape::FractalTerrain(FractalTerrain { height: 9.0, hurst: 0.8, features_across: 3, octaves: 5, seed: 1 });
    Loaded::baked(recipe(shape, (64, 48), edge, TableEncoding::F32), tables)
}

fn canvas(loaded: &Loaded, sampling: Sampling) -> Canvas<'_> {
    Canvas { gpu: gpu(), asset: &loaded.asset, plan: &loaded.plan, sampling }
}

fn top_view(pixels: &Pixels) -> TopView {
    let (across, down) = pixels.texels();
    TopView { size: (pixels.width, pixels.height), texels: [across as f32, down as f32] }
}

fn light(palette: &Palette, sun: &DirectionalLight) -> PictureLight {
    let [towards, albedo, sun, sky] =
        [sun.towards, palette.albedo, palette.sun, palette.sky].map(|vector| vector.as_vec3().to_array());
    PictureLight { towards, albedo, sun, sky, background: BACKGROUND }
}

/// All but a share of the bytes of each colour are within 1 of 255.
#[track_caller]
fn agree_within_1(name: &str, found: &GpuPicture, expected: &Picture, allowed_share: f64) {
    assert_eq!(found.size, (expected.width, expected.height), "{name}");
    for (channel, colour) in ["red", "green", "blue"].into_iter().enumerate() {
        let bytes = |rgb: &[u8]| rgb.iter().skip(channel).step_by(3).map(|&byte| f64::from(byte)).collect::<Vec<_>>();
        let name = format!("pictures_{name}_{colour}");
        agree(&name, found.size, &bytes(&found.rgb), &bytes(&expected.rgb), 1.0, allowed_share);
    }
}

#[test]
fn from_above_under_a_sun() {
    for edge in EDGES {
        let loaded = terrain(edge, &[Table::Height, Table::Horizon]);
        let surface = Surface::new(&loaded.view(Semantic::Height, HeightView::new));
        let horizon = loaded.view(Semantic::HorizonElevation, HorizonView::new);
        let (pixels, palette) = (Pixels::over(&surface, 3), Palette::SAND);
        // On an azimuth that is baked, and between two.
        for azimuth in [45.0, 157.0] {
            let sun = DirectionalLight::from_degrees(azimuth, 12.0);
            let shadow = HorizonShadow::new(&horizon, &sun);
            let mask = pixels.map(|x, y| shadow.in_shadow(x, y));
            let expected = Picture::lit(&surface, &sun, &pixels, &mask, &palette);
            let dark = mask.iter().filter(|&&dark| dark).count();
            assert!((100..mask.len() - 100).contains(&dark), "{dark} pixels in shadow");
            for (sampling, allowed) in [(Sampling::Loaded, 1e-4), (Sampling::Filtered, 0.01)] {
                let found = canvas(&loaded, sampling)
                    .sunlit(&top_view(&pixels), &light(&palette.exposed_for(&sun), &sun))
                    .unwrap();
                agree_within_1(&format!("sunlit_{edge:?}_{azimuth}_{sampling:?}"), &found, &expected, allowed);
                let found_dark = found.pixels.iter().flatten().filter(|pixel| pixel.in_shadow).count();
                assert!(found_dark.abs_diff(dark) as f64 <= allowed * mask.len() as f64, "{found_dark} for {dark}");
            }
        }
    }
}

#[test]
fn from_above_under_an_overcast_sky() {
    for (edge, tables) in [
        (Edge::Wrap, &[Table::Height, Table::SkyVisibility, Table::BentNormal][..]),
        (Edge::Clamp, &[Table::Height, Table::SkyVisibility]),
    ] {
        let loaded = terrain(edge, tables);
        let surface = Surface::new(&loaded.view(Semantic::Height, HeightView::new));
        let visibility = loaded.view(Semantic::SkyVisibility, SkyVisibilityView::new);
        let bent_normal =
            tables.contains(&Table::BentNormal).then(|| loaded.view(Semantic::BentNormal, BentNormalView::new));
        let sky = SkyLight::new(&visibility, bent_normal.as_ref());
        let (pixels, palette) = (Pixels::over(&surface, 2), Palette::OVERCAST_SAND);
        let expected = Picture::overcast(&pixels, &sky, &palette);
        for sampling in SAMPLINGS {
            let sun = DirectionalLight::from_degrees(0.0, 90.0);
            let found = canvas(&loaded, sampling).overcast(&top_view(&pixels), &light(&palette, &sun)).unwrap();
            agree_within_1(&format!("overcast_{edge:?}_{sampling:?}"), &found, &expected, 0.0);
        }
    }
}

#[test]
fn a_picture_of_many_tiles_is_one_picture() {
    let loaded = terrain(Edge::Wrap, &[Table::Height, Table::Horizon]);
    let surface = Surface::new(&loaded.view(Semantic::Height, HeightView::new));
    let (pixels, sun) = (Pixels::over(&surface, 16), DirectionalLight::from_degrees(30.0, 40.0));
    let light = light(&Palette::SAND, &sun);
    let whole = canvas(&loaded, Sampling::Loaded).sunlit(&top_view(&pixels), &light).unwrap();
    assert!(whole.size.0 > 512 && whole.size.1 > 512, "{:?} is more than one tile", whole.size);
    // The same view with fewer pixels: each is the middle one of three by three.
    let (across, down) = (whole.size.0 / 3, whole.size.1 / 3);
    let texels = [3.0 * pixels.texels().0 as f32, 3.0 * pixels.texels().1 as f32];
    let found = canvas(&loaded, Sampling::Loaded).sunlit(&TopView { size: (across, down), texels }, &light).unwrap();
    let middles = (0..down).flat_map(|row| (0..across).map(move |column| (3 * row + 1, 3 * column + 1)));
    let expected: Vec<f64> = middles
        .map(|(row, column)| f64::from(whole.rgb[3 * (row as usize * whole.size.0 as usize + column as usize)]))
        .collect();
    let reds: Vec<f64> = found.rgb.iter().step_by(3).map(|&byte| f64::from(byte)).collect();
    agree("pictures_tiles", found.size, &reds, &expected, 1.0, 1e-4);
}

#[test]
fn relief_from_a_side_on_a_plane_and_on_a_ball() {
    for (edge, on_ball) in [(Edge::Wrap, false), (Edge::Wrap, true), (Edge::Clamp, false)] {
        let loaded = terrain(edge, &[Table::Height]);
        let surface = Surface::new(&loaded.view(Semantic::Height, HeightView::new));
        let eye = StageEye { azimuth: 250.0, elevation: 40.0, size: 160 };
        let stage = if on_ball { ReliefStage::ball(&surface, eye, 6) } else { ReliefStage::plane(&surface, eye, 2) };
        let (sun, palette) = (DirectionalLight::from_degrees(200.0, 30.0), Palette::SAND);
        let expected = relief_by_cpu(&surface, &stage, &sun, &palette);
        for (sampling, allowed) in [(Sampling::Loaded, 2e-3), (Sampling::Filtered, 0.05)] {
            let found = canvas(&loaded, sampling).relief(&relief_view(&stage), &light(&palette, &sun)).unwrap();
            agree_within_1(&format!("relief_{edge:?}_{on_ball}_{sampling:?}"), &found, &expected, allowed);
            let seen = found.pixels.iter().flatten();
            assert!(seen.clone().all(|pixel| pixel.fetches.0 >= 11), "a step and ten halvings at least");
            assert!(seen.count() * 3 > found.pixels.len(), "something is seen");
        }
    }
}

fn relief_by_cpu(surface: &Surface, stage: &ReliefStage, sun: &DirectionalLight, palette: &Palette) -> Picture {
    let relief = Relief::new(surface);
    let search = LinearSearch::new(&relief, 64, 10);
    let road = ReliefRoad { depth_map: None, search: &search };
    let seen = ReliefPixels::new(&stage.camera, stage.base.surface(), &relief, &road);
    let shadow = ReliefShadow { relief, road, tolerance: SHADOW_TOLERANCE };
    let dark = seen.map(&false, |pixel| seen.in_shadow(pixel, &shadow, sun.towards).in_shadow);
    seen.picture(&ReliefLight { sun: sun.towards, shadow: &dark, occlusion: None }, palette)
}

fn relief_view(stage: &ReliefStage) -> ReliefView {
    let rays = stage.camera.parallel_rays().unwrap();
    let [corner, across, down, eye] =
        [rays.corner, rays.across, rays.down, rays.towards_eye].map(|vector| vector.as_vec3().to_array());
    let (base, tile) = match stage.base {
        StageBase::Plane(plane) => (PictureBase::Plane, plane.chart.diagonal()),
        StageBase::Ball(ball) => (PictureBase::Sphere { radius: ball.radius as f32 }, ball.tile),
    };
    ReliefView {
        size: (stage.camera.width, stage.camera.height),
        corner,
        across,
        down,
        eye,
        base,
        tile: tile.as_vec2().to_array(),
        search: ReliefSearch::Linear { steps: 64, bisections: 10 },
        has_sun: true,
        tolerance: SHADOW_TOLERANCE as f32,
        sky: Vec::new(),
    }
}
