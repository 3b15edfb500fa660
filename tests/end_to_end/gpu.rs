//! Pictures by the GPU, through the program.

use crate::support::Place;

const TILE: &str = "(
    source: Shape(
        shape: FractalTerrain(height: 9.0, hurst: 0.8, features_across: 3, octaves: 5, seed: 1), width: 48, height: 48,
    ),
    edge: wrap, scene: (ambient_light: true, relief_mapping: (least_elevation_degrees: 15.0)),
    horizon: (directions: 8), hemisphere: (rings: 6, azimuths: 8, size: (16, 16), encoding: u8),
)";

#[cfg(not(feature = "gpu"))]
#[test]
fn without_the_feature_the_message_names_it() {
    assert_eq!(
        Place::new().fails(1, "render missing.barchan --gpu -o lit.png"),
        "--gpu: this program was built without the feature `gpu`; build it with `cargo build --release --features gpu`, \
         or leave --gpu out"
    );
}

#[test]
fn what_the_gpu_does_not_draw_is_refused() {
    let place = Place::with("recipe.ron", TILE);
    let run = place.run("render out.barchan --gpu --eye-elevation 30 --heat -o heat.png");
    assert_eq!(run.code, Some(1));
    assert!(run.stderr.contains("--heat") && run.stderr.contains("--gpu"), "{}", run.stderr);
}

#[cfg(feature = "gpu")]
mod with_a_gpu {
    use serde_json::Value;

    use super::TILE;
    use crate::support::{Place, rgb};

    fn baked() -> Place {
        let place = Place::new();
        place.bake(TILE);
        place
    }

    fn number(report: &Value, path: &str) -> f64 {
        report.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("no {path} in {report}"))
    }

    /// CPU, GPU and difference of the same picture: all but a share within 1 of 255.
    #[track_caller]
    fn agrees(place: &Place, flags: &str, allowed_share: f64) -> Value {
        let report = place.json(&format!("render out.barchan {flags} --gpu --compare -o both.png"));
        assert_eq!(report["schema"], "barchan.render_gpu/1");
        assert!(!report["adapter"].as_str().unwrap().is_empty(), "{report}");
        let beyond = number(&report, "/comparison/differing_share_beyond_1");
        assert!(beyond <= allowed_share, "{flags}: {beyond} of the pixels differ by more than 1 of 255\n{report:#}");
        report
    }

    #[test]
    fn from_above_it_is_what_the_cpu_draws() {
        let place = baked();
        let report = agrees(&place, "--azimuth 160 --elevation 12 --scale 2", 1e-3);
        assert!((0.05..0.95).contains(&number(&report, "/sun/shadow_share")), "{report}");
        assert_eq!((&report["relief"], &report["mean_visibility"]), (&Value::Null, &Value::Null));
        let lit = place.json("render out.barchan --azimuth 160 --elevation 12 --scale 2 -o lit.png");
        let difference = number(&lit, "/shadow_share") - number(&report, "/sun/shadow_share");
        assert!(difference.abs() < 1e-3, "{difference}");
        let sky = agrees(&place, "--ambient", 0.0);
        let overcast = place.json("render out.barchan --ambient -o overcast.png");
        let difference = number(&overcast, "/mean_visibility") - number(&sky, "/mean_visibility");
        assert!(difference.abs() < 1e-4, "{difference}");
    }

    #[test]
    fn from_a_side_it_is_what_the_cpu_draws() {
        let place = baked();
        for flags in ["35 --azimuth 200", "35 --ambient", "3 --search linear --start top", "35 --on sphere --tiles 6"] {
            let report = agrees(&place, &format!("--size 48 --eye-elevation {flags}"), 0.01);
            let from_top = flags.contains("top");
            assert_eq!(report["relief"]["start"], if from_top { "top" } else { "depth_map" });
            assert!(number(&report, "/relief/mean_occlusion") > 0.01, "{report}");
            assert_eq!(report["sun"].is_null(), flags.contains("--ambient"), "{report}");
        }
    }

    #[test]
    fn every_search_finds_what_it_finds_on_the_cpu() {
        let place = Place::with("recipe.ron", TILE);
        let tables = "height,maximum_mip,cone_map,relaxed_cone_map";
        place.ok(&format!("bake recipe.ron --only {tables} -o out.barchan"));
        for (search, eye) in [
            ("maximum_mip", 20),
            ("cone_steps", 30),
            ("relaxed_cone_steps", 50),
            ("linear", 35),
            ("parallax_occlusion", 90),
        ] {
            let flags = format!("--eye-elevation {eye} --elevation 25 --search {search} --size 96");
            let report = agrees(&place, &flags, 0.01);
            let by_cpu = place.json(&format!("render out.barchan {flags} -o cpu.png"));
            for path in ["/view/mean_height_fetches", "/view/mean_table_fetches", "/seen_share"] {
                let (found, expected) = (number(&report, &format!("/relief{path}")), number(&by_cpu, path));
                assert!((found - expected).abs() <= 0.01 * expected, "{search}: {path} {found}, not {expected}");
            }
        }
    }

    #[test]
    fn the_pictures_stand_side_by_side() {
        let place = baked();
        let report = agrees(&place, "--azimuth 30 --elevation 30", 1e-3);
        let (both, panel) = (rgb(&place.read("both.png")), 48);
        assert_eq!(both.dimensions(), (3 * panel + 2 * 8, panel));
        assert_eq!((&report["width"], &report["height"]), (&(3 * panel + 16).into(), &panel.into()));
        place.ok("render out.barchan --azimuth 30 --elevation 30 -o cpu.png");
        place.ok("render out.barchan --azimuth 30 --elevation 30 --gpu -o gpu.png");
        let part = |first| image::imageops::crop_imm(&both, first, 0, panel, panel).to_image();
        let (cpu, gpu) = (rgb(&place.read("cpu.png")), rgb(&place.read("gpu.png")));
        assert_eq!((part(0), part(panel + 8)), (cpu.clone(), gpu.clone()));
        // What the report says of them is what a reader of both would find.
        let largest = cpu.as_raw().iter().zip(gpu.as_raw()).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
        assert_eq!(number(&report, "/comparison/largest_difference"), f64::from(largest));
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn without_a_gpu_the_message_says_what_installs_one() {
        let place = baked();
        // The loader of Vulkan looks for drivers where this says, and finds none.
        let run =
            place.shell("VK_DRIVER_FILES=none VK_ICD_FILENAMES=none $BARCHAN render out.barchan --gpu -o lit.png");
        assert_eq!((run.code, run.stdout.as_str()), (Some(4), ""));
        assert!(run.stderr.contains("apt-get install -y mesa-vulkan-drivers libvulkan1"), "{}", run.stderr);
        assert!(!place.path("lit.png").exists());
    }

    #[test]
    fn a_bad_file_is_refused_as_elsewhere() {
        let place = Place::with("recipe.ron", TILE);
        place.ok("bake recipe.ron --only height -o out.barchan");
        assert_eq!(
            place.fails(2, "render out.barchan --gpu -o lit.png"),
            "out.barchan: there is no horizon table; the file has height"
        );
        assert_eq!(place.names(), ["out.barchan", "recipe.ron"]);
    }
}
