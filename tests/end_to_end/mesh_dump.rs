//! What can be had of a curvature table.

use barchan_import::{MeshOptions, decode_mesh, no_buffers};
use serde_json::json;

use crate::support::{Place, Torus, rgb};

/// A baked torus with texture coordinates, every column, exact.
fn place() -> Place {
    let place = Place::with("torus.obj", Torus::USUAL.obj_with_uvs());
    let curvature = "curvature: (encoding: f32, directions: true, uv_directions: true)";
    place.write("torus.ron", format!("(mesh: (path: \"torus.obj\"), {curvature})"));
    place.ok("bake torus.ron");
    place
}

#[test]
fn npy_has_a_row_per_vertex() {
    let place = place();
    for (column, numbers) in [("principal", 2), ("directions", 6), ("forms", 6), ("uv_directions", 4)] {
        let array = place.array("torus.barchan", &format!("curvature --column {column}"));
        assert_eq!(array.shape, [1225, numbers], "{column}");
    }
    assert_eq!(place.array("torus.barchan", "curvature"), place.array("torus.barchan", "curvature --column principal"));
}

#[test]
fn text_and_csv_say_the_same_as_npy() {
    let place = place();
    let array = place.array("torus.barchan", "curvature");
    let csv = place.ok("dump torus.barchan curvature --format csv");
    let mut lines = csv.lines();
    let header = "vertex,k1,k2,direction1_x,direction1_y,direction1_z,direction2_x,direction2_y,direction2_z,\
                  first_e,first_f,first_g,second_e,second_f,second_g,direction1_u,direction1_v,direction2_u,direction2_v";
    assert_eq!(lines.next(), Some(header));
    let rows: Vec<Vec<f32>> = lines.map(|line| line.split(',').map(|word| word.parse().unwrap()).collect()).collect();
    assert_eq!((rows.len(), rows[1224][0]), (1225, 1224.0));
    let curvatures: Vec<f32> = rows.iter().flat_map(|row| [row[1], row[2]]).collect();
    assert_eq!(curvatures, array.values);

    let text = place.ok("dump torus.barchan");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("# curvature, k1, k2 per unit, 1225 vertices"));
    let first: Vec<f32> = lines.next().unwrap().split_whitespace().map(|word| word.parse().unwrap()).collect();
    assert!(first.iter().zip(&array.values).all(|(text, exact)| (text - exact).abs() < 1e-3), "{first:?}");
    assert_eq!(lines.count(), 1224);
}

/// The forms of a torus in its own parameters are known: E = (2π (R + r cos v))², F = 0, G = (2π r)², and e, g like them.
#[test]
fn forms_are_those_of_the_closed_form() {
    let place = place();
    let forms = place.array("torus.barchan", "curvature --column forms");
    let (turn, [major, minor]) = (std::f64::consts::TAU, [Torus::MAJOR, Torus::MINOR]);
    // Vertex 0 is on the outer equator.
    let from_axis = major + minor;
    let expected =
        [(turn * from_axis).powi(2), 0.0, (turn * minor).powi(2), turn.powi(2) * from_axis, 0.0, turn.powi(2) * minor];
    let scale = expected[0];
    for (found, expected) in forms.values[..6].iter().zip(expected) {
        assert!((f64::from(*found) - expected).abs() < 0.01 * scale, "{:?}", &forms.values[..6]);
    }
}

/// A vertex of a PLY file as it is dumped.
struct ColouredVertex {
    rgb: [u8; 3],
    curvature: [f32; 2],
}

fn coloured_vertices(ply: &[u8], count: usize) -> Vec<ColouredVertex> {
    const STRIDE: usize = 3 * 8 + 3 + 2 * 4;
    let end = ply.windows(11).position(|window| window == b"end_header\n").unwrap() + 11;
    let number = |bytes: &[u8]| f32::from_le_bytes(bytes.try_into().unwrap());
    let vertex = |bytes: &[u8]| ColouredVertex {
        rgb: bytes[24..27].try_into().unwrap(),
        curvature: [number(&bytes[27..31]), number(&bytes[31..35])],
    };
    ply[end..].chunks_exact(STRIDE).take(count).map(vertex).collect()
}

#[test]
fn ply_is_the_mesh_in_colour() {
    let place = place();
    let words = place.ok("dump torus.barchan curvature --format ply --mesh torus.obj --by k2 -o coloured.ply");
    assert!(
        words.starts_with("dumped    curvature to coloured.ply: 1225 vertices, k1, k2\ncolours   least curvature k2: ")
    );
    let ply = place.read("coloured.ply");
    let mesh = |bytes: &[u8]| decode_mesh(bytes, &MeshOptions::default(), &mut no_buffers).unwrap().mesh;
    let (given, coloured) = (mesh(&place.read("torus.obj")), mesh(&ply));
    assert_eq!((coloured.positions(), coloured.triangles()), (given.positions(), given.triangles()));

    let vertices = coloured_vertices(&ply, 1225);
    let stored: Vec<f32> = vertices.iter().flat_map(|vertex| vertex.curvature).collect();
    assert_eq!(stored, place.array("torus.barchan", "curvature").values);
    // Convex on the outer equator, concave on the inner one, and neither on top.
    let [outer, top, inner] = [0, 6, 12].map(|vertex: usize| vertices[vertex].rgb);
    assert!(outer[0] > outer[2].saturating_add(50), "red: {outer:?}");
    assert!(inner[2] > inner[0].saturating_add(50), "blue: {inner:?}");
    assert!(top.iter().all(|&channel| channel > 240), "white: {top:?}");
    let header = String::from_utf8_lossy(&ply[..400]).into_owned();
    assert!(header.contains("comment colour: least curvature k2; blue -0."), "{header}");
    let report = place.json("dump torus.barchan curvature --format ply --mesh torus.obj -o coloured.ply");
    assert_eq!(report["schema"], "barchan.dump_curvature/1");
    assert_eq!((&report["vertices"], &report["numbers"]), (&json!(1225), &json!(["k1", "k2"])));
    assert_eq!(report["colouring"]["words"], "mean curvature (k1 + k2) / 2");
}

#[test]
fn png_is_a_picture_of_the_mesh_in_colour() {
    let place = place();
    let draw = "dump torus.barchan curvature --format png --mesh torus.obj --up z --by k2 -o torus.png";
    let words = place.ok(draw);
    let first = "dumped    curvature to torus.png: 1225 vertices, 800 × 452 pixels\ncolours   least curvature k2: ";
    assert!(words.starts_with(first), "{words}");
    let picture = rgb(&place.read("torus.png"));
    // A width of 5 and a height of 4 sin 25° + 1, and 24 pixels around.
    assert_eq!(picture.dimensions(), (800, 452));
    assert_eq!(picture.get_pixel(0, 0).0, [16, 18, 22]);
    // Convex in front, concave on what is seen of the inside behind the hole.
    let [front, inside] = [300, 130].map(|row| picture.get_pixel(400, row).0);
    assert!(front[0] > front[2].saturating_add(50), "red: {front:?}");
    assert!(inside[2] > inside[0].saturating_add(50), "blue: {inside:?}");

    let before = place.read("torus.png");
    let report = place.json(draw);
    assert_eq!((&report["pixels"], &report["vertices"]), (&json!([800, 452]), &json!(1225)));
    assert_eq!(place.read("torus.png"), before, "the same again");
    // From above it is round, and the hole is in its middle.
    place.ok(&format!("{draw} --view -90,90 --size 64"));
    let picture = rgb(&place.read("torus.png"));
    assert_eq!((picture.dimensions(), picture.get_pixel(32, 32).0), ((64, 64), [16, 18, 22]));
    // The mesh of a file has y up where nothing else is said: from its front the ring's plane is the picture's.
    place.ok("dump torus.barchan --format png --mesh torus.obj --view 0,0 --size 64 -o torus.png");
    assert_eq!(rgb(&place.read("torus.png")).dimensions(), (64, 64));
}

#[test]
fn a_surface_of_a_recipe_needs_no_mesh_to_be_coloured() {
    let place = Place::with(
        "saddle.ron",
        "(mesh: (surface: Helicoid(inner_radius: 0.5, outer_radius: 2.0, pitch: 3.0, turns: 1.0), vertices: 300))",
    );
    place.ok("bake saddle.ron");
    place.ok("dump saddle.barchan --format ply --by gaussian -o saddle.ply");
    let mesh = decode_mesh(&place.read("saddle.ply"), &MeshOptions::default(), &mut no_buffers).unwrap().mesh;
    let vertices = place.json("inspect saddle.barchan")["sections"][0]["curvature"]["vertices"].clone();
    assert_eq!(json!(mesh.positions().len()), vertices);
    // It has z up: from the side it is as high as one turn, 3, and as wide as its diameter, 4.
    place.ok("dump saddle.barchan --format png --view 0,0 --size 100 -o saddle.png");
    assert_eq!(rgb(&place.read("saddle.png")).dimensions(), (100, 77));
}

#[test]
fn a_gltf_file_is_known_by_the_buffers_beside_it_and_the_mesh_that_was_named() {
    let (mut document, mut buffer) = Torus::USUAL.gltf();
    document["buffers"][0]["uri"] = json!("torus.bin");
    document["meshes"][0]["name"] = json!("body");
    let other = json!({ "name": "other", "primitives": document["meshes"][0]["primitives"] });
    document["meshes"].as_array_mut().unwrap().push(other);
    let place = Place::with("torus.gltf", document.to_string());
    place.write("torus.bin", &buffer);
    let message = place.fails(2, "bake torus.gltf");
    assert!(message.starts_with("torus.gltf: ") && message.contains("`mesh`") && message.contains("body"), "{message}");

    place.ok("bake torus.gltf --mesh body");
    let coloured = "dump torus.barchan --format ply --mesh torus.gltf -o coloured.ply";
    place.ok(coloured);
    // Another coordinate, and the document as it was.
    buffer[3] ^= 0x80;
    place.write("torus.bin", &buffer);
    let message = place.fails(2, coloured);
    assert!(message.starts_with("torus.gltf: not the mesh that torus.barchan was baked from: "), "{message}");
}
