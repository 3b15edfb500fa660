//! The command line.

use crate::support::{Place, bumpy, npy, parse_json};

const RECIPE: &str = "(source: Shape(shape: Plane(slope_u: 0.5, slope_v: 0.0), width: 4, height: 4))";

/// The first line of a usage error of the argument parser: exit code 1, nothing on stdout.
fn usage_error(place: &Place, words: &str) -> String {
    let run = place.run(words);
    assert_eq!((run.code, run.stdout.as_str()), (Some(1), ""), "barchan {words}\n{}", run.stderr);
    run.stderr.lines().next().unwrap_or_default().to_owned()
}

#[test]
fn asking_for_help_or_the_version_is_no_error() {
    let place = Place::new();
    for words in
        ["--help", "-h", "help", "--version", "bake --help", "help dump", "render -h", "inspect --help", "plan --help"]
    {
        assert_ne!(place.ok(words), "", "{words}");
    }
    assert!(place.ok("--help").contains("Exit codes: 0 done, 1 wrong usage, 2 bad input, 3 difference found, 4 disk"));
}

#[test]
fn unknown_words_are_usage_errors() {
    let place = Place::with("map.npy", npy(4, &bumpy(4, 4)));
    for words in [
        "",
        "bke map.npy",
        "bake",
        "bake map.npy --directons 8",
        "bake map.npy --encoding f64",
        "bake map.npy --edge mirror",
        "bake map.npy --unit mile",
        "bake map.npy --compression gzip",
        "bake map.npy --only height,heat",
        "bake map.npy --progress loud",
        "bake map.npy --fill highest",
        "bake map.npy -j many",
        "bake map.npy -j 5000",
        "bake map.npy extra",
        "inspect",
        "dump map.npy colour",
        "dump map.npy height --format jpg",
        "compare map.npy",
        "compare map.npy map.npy --tolerance -1",
        "render map.npy",
        "render map.npy -o x.png --elevation 91",
        "render map.npy -o x.png --azimuth east",
        "render map.npy -o x.png --scale 0",
    ] {
        let run = place.run(words);
        assert_eq!((run.code, run.stdout.as_str()), (Some(1), ""), "barchan {words}");
        assert_ne!(run.stderr, "", "barchan {words}");
    }
    assert_eq!(place.names(), ["map.npy"]);
}

#[test]
fn a_flag_names_its_value_and_what_would_be_accepted() {
    let place = Place::with("map.npy", npy(4, &bumpy(4, 4)));
    let tables = "height, horizon, distance, swept_horizon, swept_distance, sky_visibility, bent_normal, \
                  aperture_cone, hemisphere, cone_map, relaxed_cone_map, maximum_mip, curvature";
    let arc = "accepted: degrees from within ±360 to a larger number, less than 360 beyond";
    let length = "spacing u is 0; a positive, finite length per texel is needed";
    for (flag, error) in [
        ("--rings 0", "'0' for '--rings <N>': 0 is not in 1..=2048"),
        ("--azimuths 2049", "'2049' for '--azimuths <N>': 2049 is not in 1..=2048"),
        ("--size 8,0", "'8,0' for '--size <N[,N]>': accepted: a number of texels, or two with a comma"),
        ("--depth-mode near", "'near' for '--depth-mode <MODE>': accepted: conservative, nearest"),
        ("--directions 0", "'0' for '--directions <N>': 0 is not in 1..=2048"),
        ("--directions 2049", "'2049' for '--directions <N>': 2049 is not in 1..=2048"),
        ("--spacing 0", &format!("'0' for '--spacing <LENGTH[,LENGTH]>': {length}")),
        (
            "--spacing 1,-2",
            "'1,-2' for '--spacing <LENGTH[,LENGTH]>': spacing v is -2; a positive, finite length per texel is needed",
        ),
        ("--spacing wide", "'wide' for '--spacing <LENGTH[,LENGTH]>': accepted: a length, or two with a comma"),
        ("--spacing 1,2,3", "'1,2,3' for '--spacing <LENGTH[,LENGTH]>': accepted: a length, or two with a comma"),
        (
            "--spacing nan",
            "'nan' for '--spacing <LENGTH[,LENGTH]>': spacing u is NaN; a positive, finite length per texel is needed",
        ),
        ("--radius 0", "'0' for '--radius <LENGTH>': accepted: a positive number"),
        ("--radius -3", "'-3' for '--radius <LENGTH>': accepted: a positive number"),
        ("--height-scale inf", "'inf' for '--height-scale <LENGTH>': accepted: a finite number"),
        ("--encoding f64", "'f64' for '--encoding <ENCODING>': accepted: f32, f16, u8, compact"),
        ("--only heat", &format!("'heat' for '--only <TABLE,..>': accepted: {tables}")),
        ("--method best", "'best' for '--method <METHOD>': accepted: sweep, fast, accurate, exact"),
        ("--arc 90", &format!("'90' for '--arc <FIRST,LAST>': {arc}")),
        ("--arc 90,0", &format!("'90,0' for '--arc <FIRST,LAST>': {arc}")),
        ("--arc 0,360", &format!("'0,360' for '--arc <FIRST,LAST>': {arc}")),
        ("--arc -361,0", &format!("'-361,0' for '--arc <FIRST,LAST>': {arc}")),
        ("--arc 0,east", &format!("'0,east' for '--arc <FIRST,LAST>': {arc}")),
        ("-j -1", "unexpected argument '-1' found"),
        ("-j 1025", "'1025' for '--jobs <N>': accepted: 0 to 1024"),
    ] {
        let line = usage_error(&place, &format!("bake map.npy {flag}"));
        assert!(line.ends_with(error), "{flag}: {line}");
    }
}

#[test]
fn flags_of_height_maps_are_refused_beside_a_recipe() {
    let place = Place::with("r.ron", RECIPE);
    for flag in [
        "--directions 8",
        "--edge wrap",
        "--spacing 2",
        "--integers raw",
        "--height-scale 2",
        "--height-offset 2",
        "--radius 2",
        "--arc 0,90",
        "--channel R",
        "--no-data 0",
        "--fill lowest",
    ] {
        let name = flag.split(' ').next().unwrap();
        assert_eq!(
            place.fails(1, &format!("bake r.ron {flag}")),
            format!("{name} is for a height map without a recipe; set it in r.ron")
        );
    }
    for flag in ["--unit metre", "--method exact", "--encoding u8", "--compression zstd"] {
        let name = flag.split(' ').next().unwrap();
        assert_eq!(
            place.fails(1, &format!("bake r.ron {flag}")),
            format!("{name} is for a height map or a mesh without a recipe; set it in r.ron")
        );
    }
}

#[test]
fn a_table_that_flags_cannot_describe_needs_a_recipe() {
    let place = Place::with("map.npy", npy(4, &bumpy(4, 4)));
    for table in ["swept_horizon", "swept_distance"] {
        assert_eq!(
            place.fails(1, &format!("bake map.npy --only height,{table}")),
            format!("map.npy: {table} needs a recipe that names `scene: (curvature: (min, max))`")
        );
    }
    place.write("r.ron", RECIPE);
    assert_eq!(
        place.fails(2, "bake r.ron --only swept_horizon"),
        "r.ron: scene: `curvature` is missing; swept_horizon needs a range, such as `curvature: (0.0, 0.02)`"
    );
    assert_eq!(place.names(), ["map.npy", "r.ron"]);
}

#[test]
fn with_json_an_error_is_an_object_on_stdout_too() {
    let place = Place::with("r.ron", "(edge: wrp)");
    for (words, code) in
        [("--json bake r.ron", 2), ("bake missing.ron --json", 4), ("--json bake r.ron --edge wrap", 1)]
    {
        let run = place.run(words);
        let report = parse_json(&run.stdout);
        assert_eq!((run.code, &report["schema"]), (Some(code), &"barchan.error/1".into()));
        assert_eq!((&report["exit_code"], &report["error"]), (&code.into(), &run.message().into()));
    }
}

#[test]
fn a_missing_file_is_the_systems_fault_and_named() {
    let place = Place::new();
    let missing = "cannot be read: No such file or directory (os error 2)";
    for words in ["bake none.ron", "inspect none.barchan", "validate none.barchan", "dump none.barchan height"] {
        let message = place.fails(4, words);
        assert_eq!(message, format!("{}: {missing}", words.split(' ').nth(1).unwrap()));
    }
    let all = "a PNG, EXR, TIFF, NPY, OBJ, PLY or glTF file is needed";
    let needed = format!("there is no such file; {all}");
    assert_eq!(place.fails(4, "bake none.png"), format!("none.png: {needed}"));
    place.write("a.ron", "(source: HeightMap(path: \"maps/none.tif\"))");
    assert_eq!(place.fails(4, "bake a.ron"), format!("maps/none.tif: {needed}"));
    assert_eq!(place.fails(4, "inspect ."), ".: this is a folder; a .barchan file is needed");
    assert_eq!(place.fails(4, "bake . -o x"), format!(".: this is a folder; {all}"));
}

#[cfg(unix)]
#[test]
fn a_device_that_never_ends_is_not_read() {
    let place = Place::with("a.ron", "(source: HeightMap(path: \"/dev/zero\"))");
    let needed = "/dev/zero: this is a pipe or a device; a .barchan file is needed";
    assert_eq!(place.fails(4, "inspect /dev/zero"), needed);
    for words in ["bake a.ron", "bake /dev/zero"] {
        assert!(place.fails(4, words).starts_with("/dev/zero: the file cannot be read (it is a pipe or a device; "));
    }
}

#[cfg(unix)]
#[test]
fn an_unreadable_file_is_the_systems_fault() {
    use std::os::unix::fs::PermissionsExt;
    let place = Place::with("a.barchan", "secret");
    std::fs::set_permissions(place.path("a.barchan"), std::fs::Permissions::from_mode(0o000)).unwrap();
    // Whoever may read everything, as root may, cannot be refused.
    if std::fs::read(place.path("a.barchan")).is_err() {
        assert_eq!(place.fails(4, "inspect a.barchan"), "a.barchan: cannot be read: Permission denied (os error 13)");
    }
}

#[test]
fn with_json_a_word_that_is_not_understood_is_an_object_too() {
    let place = Place::with("r.ron", RECIPE);
    for (words, error) in [
        ("--json bake r.ron --edge wrp", "invalid value 'wrp' for '--edge <EDGE>': accepted: wrap, clamp"),
        ("bake --json", "the following required arguments were not provided: <INPUT>"),
    ] {
        let run = place.run(words);
        let report = parse_json(&run.stdout);
        assert_eq!((run.code, &report["exit_code"], &report["error"]), (Some(1), &1.into(), &error.into()));
    }
}
