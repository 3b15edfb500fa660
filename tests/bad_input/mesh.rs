//! Meshes, flags of meshes, and what is asked of a curvature table in vain.

use crate::support::{Place, Torus, bumpy, npy};

const SMALL: Torus = Torus { around: 24, along: 16 };

fn place() -> Place {
    Place::with("torus.obj", SMALL.obj())
}

fn baked() -> Place {
    let place = place();
    place.ok("bake torus.obj");
    place
}

#[test]
fn flags_of_the_other_kind_of_input_are_refused() {
    let place = place();
    place.write("map.npy", npy(4, &bumpy(4, 4)));
    for flag in ["--directions 8", "--edge wrap", "--height-scale 2", "--radius 2", "--arc 0,90", "--fill lowest"] {
        let name = flag.split(' ').next().unwrap();
        let expected = format!("{name} is for height maps; torus.obj is a mesh (OBJ)");
        assert_eq!(place.fails(1, &format!("bake torus.obj {flag}")), expected);
    }
    for flag in ["--hard-edge 20", "--mesh body"] {
        let name = flag.split(' ').next().unwrap();
        let expected = format!("{name} is for meshes; map.npy is a height map");
        assert_eq!(place.fails(1, &format!("bake map.npy {flag}")), expected);
    }
    place.write("r.ron", "(mesh: (path: \"torus.obj\"))");
    assert_eq!(
        place.fails(1, "bake r.ron --hard-edge 20"),
        "--hard-edge is for a mesh without a recipe; set it in r.ron"
    );
    assert_eq!(place.names(), ["map.npy", "r.ron", "torus.obj"]);
}

#[test]
fn a_method_belongs_to_its_kind_of_input() {
    let place = place();
    place.write("map.npy", npy(4, &bumpy(4, 4)));
    for method in ["sweep", "exact"] {
        let expected = format!("--method is {method}; fast and accurate find the curvature of a mesh");
        assert_eq!(place.fails(1, &format!("bake torus.obj --method {method}")), expected);
    }
    assert_eq!(
        place.fails(1, "bake map.npy --method fast"),
        "--method is fast; sweep, accurate and exact find the horizon of a height map"
    );
    assert_eq!(
        place.fails(1, "bake torus.obj --encoding u8"),
        "--encoding is u8; f32, f16 and compact, which is f16, store the curvature of a mesh"
    );
}

#[test]
fn tables_without_an_input_are_refused() {
    let place = place();
    place.write("map.npy", npy(4, &bumpy(4, 4)));
    assert_eq!(
        place.fails(1, "bake torus.obj --only curvature,horizon"),
        "torus.obj: horizon cannot be baked: there is no height map"
    );
    assert_eq!(place.fails(1, "bake map.npy --only curvature"), "map.npy: curvature cannot be baked: there is no mesh");
}

#[test]
fn a_recipe_needs_heights_or_a_mesh() {
    let place = Place::with("r.ron", "(edge: wrap)");
    assert_eq!(
        place.fails(2, "bake r.ron"),
        "r.ron: neither `source` nor `mesh` is there; at least one is needed, such as `mesh: (path: \"rock.obj\")` or \
         `source: HeightMap(path: \"rock.png\")`"
    );
}

#[test]
fn what_a_recipe_says_of_a_mesh_is_checked() {
    let place = place();
    let complaint = |fields: &str| {
        place.write("r.ron", format!("(\n{fields}\n)"));
        place.fails(2, "bake r.ron").strip_prefix("r.ron:").unwrap().to_owned()
    };
    let mesh = "mesh: (path: \"torus.obj\")";
    for (fields, expected) in [
        ("mesh: (pth: \"a\")", "2:8: unknown field `pth`; did you mean `path`?"),
        ("mesh: ()", "2:8: mesh: neither `path` nor `surface` is there; one of them is needed"),
        ("mesh: (surface: Spher(radius: 1.0))", "2:17: unknown value `Spher`; did you mean `Sphere`?"),
        ("mesh: (surface: Sphere(radius: -1.0), vertices: 100)", " mesh: "),
        (&format!("{mesh}, curvature: (method: acurate)"), "2:48: unknown value `acurate`; did you mean `accurate`?"),
        (&format!("{mesh}, curvature: (encoding: u8)"), "2:50: unknown value `u8` (accepted: `f32`, `f16`)"),
        (
            &format!("{mesh}, curvature: (hard_edge_degrees: 200)"),
            " curvature: hard_edge_degrees is 200; an angle from 0 to 180 is accepted",
        ),
        (
            &format!("{mesh}, curvature: (uv_directions: true)"),
            " curvature: `uv_directions` is true; the mesh has no texture coordinates, so only false is accepted",
        ),
    ] {
        let found = complaint(fields);
        assert!(found.starts_with(expected), "{found}\n{expected}");
    }
}

#[test]
fn a_mesh_that_is_none_is_refused_and_named() {
    for (content, expected) in [
        (
            "v 0 0 0\nv 1 0 0\nv 0 1 0\n",
            "the OBJ file has no triangle (vertices: 3); a surface of at least one triangle is needed",
        ),
        (
            "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n",
            "vertex 1 (line 2) has a coordinate of NaN; finite numbers up to 1e30 would be accepted",
        ),
    ] {
        let place = Place::with("a.obj", content);
        assert_eq!(place.fails(2, "bake a.obj"), format!("a.obj: {expected}"));
        assert_eq!(place.names(), ["a.obj"]);
    }
    let place = Place::with("r.ron", "(mesh: (path: \"map.npy\"))");
    place.write("map.npy", npy(4, &bumpy(4, 4)));
    assert_eq!(place.fails(2, "bake r.ron"), "map.npy: the file is an NPY image; an OBJ, PLY or glTF file is needed");
    place.write("r.ron", "(mesh: (path: \"none.obj\"))");
    assert!(place.fails(4, "bake r.ron").starts_with("none.obj: there is no such file; "));
    place.write("torus.obj", SMALL.obj());
    place.write("r.ron", "(source: HeightMap(path: \"torus.obj\"))");
    assert_eq!(
        place.fails(2, "bake r.ron"),
        "torus.obj: the file is an OBJ mesh; a PNG, EXR, TIFF or NPY file is needed"
    );
}

#[test]
fn a_dump_names_what_curvature_does_not_have() {
    let place = baked();
    for (flags, expected) in [
        ("--layer 0", "--layer is for textures; curvature has vertices"),
        ("--mip 0", "--mip is for textures; curvature has vertices"),
        ("--column forms --format csv", "--column is for npy and text; csv has every column, ply k1 and k2"),
        ("--mesh torus.obj", "--mesh is for --format ply and png"),
        ("--by k1", "--by is for --format ply and png"),
        ("--format ply --mesh torus.obj --view 0,90 -o a.ply", "--view is for --format png"),
        ("--up z", "--up is for --format png"),
        ("--size 100", "--size is for --format png"),
        ("--format ply -o a.ply", "--mesh is missing: a .barchan file holds no geometry for ply to colour"),
        ("--format png -o a.png", "--mesh is missing: a .barchan file holds no geometry for png to colour"),
        ("--format exr -o a.exr", "--format is exr; npy, csv, text, ply and png show the curvature of vertices"),
        ("--format npy", "-o is missing: only text and csv go to stdout, and not with --json"),
        ("--format ply --mesh torus.obj -o torus.obj", "torus.obj: this is the input; another name is needed for -o"),
    ] {
        assert_eq!(place.fails(1, &format!("dump torus.barchan curvature {flags}")), expected);
    }
    assert_eq!(
        place.fails(2, "dump torus.barchan curvature --column forms"),
        "torus.barchan: curvature has no forms; it has principal, directions"
    );
    assert_eq!(place.names(), ["torus.barchan", "torus.obj"]);
}

#[test]
fn a_picture_of_a_mesh_says_which_views_and_sizes_there_are() {
    let place = baked();
    let view = "accepted: an azimuth within ±360 degrees and an elevation within ±90, such as 30,25";
    for (flag, error) in [
        ("--view 30", format!("'30' for '--view <AZIMUTH,ELEVATION>': {view}")),
        ("--view 0,91", format!("'0,91' for '--view <AZIMUTH,ELEVATION>': {view}")),
        ("--view -361,0", format!("'-361,0' for '--view <AZIMUTH,ELEVATION>': {view}")),
        ("--view 1,nan", format!("'1,nan' for '--view <AZIMUTH,ELEVATION>': {view}")),
        ("--size 0", "'0' for '--size <N>': 0 is not in 1..=8192".to_owned()),
        ("--size 8193", "'8193' for '--size <N>': 8193 is not in 1..=8192".to_owned()),
    ] {
        let run = place.run(&format!("dump torus.barchan --format png --mesh torus.obj {flag} -o a.png"));
        assert_eq!(run.code, Some(1), "{flag}: {}", run.stdout);
        assert!(run.stderr.contains(&error), "{flag}: {}", run.stderr);
    }
    assert_eq!(place.names(), ["torus.barchan", "torus.obj"]);
}

#[test]
fn only_the_mesh_that_was_baked_is_coloured() {
    let place = baked();
    place.write("other.obj", Torus { around: 9, along: 9 }.obj());
    place.write("moved.obj", SMALL.obj().replacen("v 2.5 ", "v 2.6 ", 1));
    let dump = |mesh: &str| place.fails(2, &format!("dump torus.barchan --format ply --mesh {mesh} -o a.ply"));
    assert_eq!(dump("other.obj"), "other.obj: the mesh has 81 vertices; torus.barchan has the curvature of 384");
    let message = dump("moved.obj");
    assert!(
        message.starts_with("moved.obj: not the mesh that torus.barchan was baked from: its BLAKE3 is "),
        "{message}"
    );
    assert!(place.fails(4, "dump torus.barchan --format ply --mesh none.obj -o a.ply").starts_with("none.obj: "));
}

#[test]
fn textures_have_no_curvature_to_choose_from() {
    let place = Place::with("map.npy", npy(4, &bumpy(4, 4)));
    place.ok("bake map.npy --only height");
    for flag in ["--column principal", "--mesh a.obj", "--by k1", "--view 0,0", "--up y", "--size 9"] {
        let name = flag.split(' ').next().unwrap();
        let expected = format!("{name} is for curvature; height is a texture");
        assert_eq!(place.fails(1, &format!("dump map.barchan {flag}")), expected);
    }
    assert_eq!(
        place.fails(1, "dump map.barchan --format ply -o a.ply"),
        "--format ply is for curvature; text, csv, npy, png and exr show textures"
    );
    assert_eq!(
        place.fails(2, "dump map.barchan curvature"),
        "map.barchan: there is no curvature table; the file has height"
    );
}

#[test]
fn a_picture_needs_relief() {
    let place = baked();
    for flags in ["", "--ambient"] {
        assert_eq!(
            place.fails(2, &format!("render torus.barchan -o a.png {flags}")),
            "torus.barchan: the file has the curvature of a mesh alone; a picture needs the relief of a height map, and `dump \
             --format png` draws the mesh in colour"
        );
    }
}
