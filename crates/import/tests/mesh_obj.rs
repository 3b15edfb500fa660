//! OBJ: rows, seams, indices, polygons, and what is refused.

mod common;

use std::f64::consts::TAU;

use barchan_import::{Format, MeshOptions, decode_mesh, no_buffers};
use common::{damage::Random, mesh, refusal};
use glam::{DVec2, DVec3};

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn row_i_is_the_ith_v_used_or_not() {
    let read = mesh("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 8 8 8\nv 0 1 0\nf 5 2 3\n");
    assert_eq!(read.mesh.positions()[3], DVec3::splat(8.0));
    assert_eq!((read.mesh.positions().len(), read.mesh.triangles()), (5, &[[4, 1, 2]][..]));
    assert_eq!((read.source.vertices, read.source.seam_vertices), (5, 0));
}

#[test]
fn further_pairs_follow_behind_the_last_v_in_order_of_first_use() {
    // Two triangles on one edge; along it, each side has a texture coordinate of its own.
    let read = mesh(format!(
        "{SQUARE}vt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 0.25\nvt 0 1\nvt 0.25 0.5\nf 1/1 2/2 3/3\nf 3/6 4/5 1/4\nf 1/4 2/2 3/6\n"
    ));
    assert_eq!(read.mesh.triangles(), [[0, 1, 2], [4, 3, 5], [5, 1, 4]]);
    assert_eq!(read.source.seam_vertices, 2);
    assert_eq!(read.mesh.positions()[4..], [DVec3::new(1.0, 1.0, 0.0), DVec3::ZERO]);
    let uvs = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.25, 0.5], [0.5, 0.25]].map(DVec2::from_array);
    assert_eq!(read.mesh.uvs(), Some(&uvs[..]));
}

#[test]
fn pairs_are_told_apart_by_value() {
    let by_number = format!("{SQUARE}vn 0 0 1\nvn 0 0 1\nvn 0 -0 1\nf 1//1 2//1 3//1\nf 1//2 3//3 4//2\n");
    assert_eq!(mesh(by_number).source.seam_vertices, 0);
    let crease = format!("{SQUARE}vn 0 0 1\nvn 0 1 0\nf 1//1 2//1 3//1\nf 1//2 3//2 4//2\n");
    let read = mesh(crease);
    assert_eq!(read.source.seam_vertices, 2);
    assert_eq!(read.mesh.triangles()[1], [4, 5, 3]);
    assert_eq!(read.mesh.normals().unwrap()[4], DVec3::Y);
}

#[test]
fn every_way_to_write_a_corner() {
    for faces in [
        "f 1 2 3\nf 1 3 4",
        "f -4 -3 -2\nf -4 -2 -1",
        "f +1 02 3\nf 1 3 -1",
        "f 1// 2// 3//\nf 1/ 3/ 4/",
        "f 1 2 \\\n 3\nf 1 \\\r\n3 4",
        "o a\ng b c\ns off\nusemtl x\nf 1 2 3 # a comment\no d\n  f\t1  3 4  ",
        "f 1/7/9 2/7/9 3/7/9\nf 1/7/9 3/7/9 4/7/9",
    ] {
        let read = mesh(format!("{SQUARE}{faces}"));
        assert_eq!(read.mesh.triangles(), [[0, 1, 2], [0, 2, 3]], "{faces}");
        assert_eq!((read.mesh.uvs(), read.mesh.normals(), read.source.seam_vertices), (None, None, 0), "{faces}");
    }
    // Negative numbers count back from where they stand, positive ones may look ahead.
    let read = mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nf 4 5 6\nv 2 0 0\nv 3 0 0\nv 2 1 0\n");
    assert_eq!(read.mesh.triangles(), [[0, 1, 2], [3, 4, 5]]);
}

#[test]
fn line_ends_comments_and_marks_do_not_matter() {
    let text = "# C:\\models\\\nv 0 0 0 1.0\nv 1 0 0 0.2 0.4 0.6\n\nv 0 1 0\nvt 0.5\nf 1/1 2/1 3/1";
    let plain = mesh(text);
    assert_eq!(plain.mesh.uvs().unwrap()[0], DVec2::new(0.5, 0.0));
    for other in [text.replace('\n', "\r\n"), text.replace('\n', "\r"), format!("\u{feff}{text}\n")] {
        assert_eq!(mesh(&other), plain, "{other:?}");
    }
}

#[test]
fn numbers_are_f64() {
    let read = mesh("v 10000000.000001 -1e-300 .5\nv 1e+7 0 0\nv 0 1. 0\nf 1 2 3");
    assert_eq!(read.mesh.positions()[0], DVec3::new(10_000_000.000_001, -1e-300, 0.5));
}

#[test]
fn what_is_no_surface_is_counted() {
    let read = mesh(format!("{SQUARE}p 1\nl 1 2\nl 2 3 4\nf 1 2\nf\nf 1 2 3\n"));
    assert_eq!((read.source.ignored, read.source.triangles), (5, 1));
}

#[test]
fn missing_texture_coordinates_are_zero_and_counted() {
    let read = mesh(format!("{SQUARE}vt 0.5 0.5\nf 1/1 2/1 3/1\nf 1 3 4\n"));
    // 1 and 3 again, and 4, have none.
    assert_eq!((read.source.uvs_missing, read.source.seam_vertices), (3, 2));
    assert_eq!(read.mesh.uvs().unwrap()[3], DVec2::ZERO);
}

#[test]
fn unusable_normals_do_not_stop_a_bake() {
    let read =
        mesh(format!("{SQUARE}vn 0 3 4\nvn 0 0 0\nvn nan 0 1\nvn -nan(ind) 0 1\nf 1//1 2//2 3//3\nf 1//1 3//9 4//4\n"));
    // 2, 3, 3 again, and 4.
    assert_eq!(read.source.normals_missing, 4);
    let normals = read.mesh.normals().unwrap();
    assert_eq!(normals[0], DVec3::new(0.0, 3.0, 4.0), "as stated, of any length");
    assert!(normals[1..].iter().all(|normal| *normal == DVec3::ZERO), "{normals:?}");
    let none = mesh(format!("{SQUARE}vn 0 0 0\nf 1//1 2//1 3//1\n"));
    assert_eq!((none.mesh.normals(), none.source.normals_missing), (None, 0));
}

#[test]
fn a_convex_polygon_is_a_fan() {
    let read = mesh("v 0 0 0\nv 2 0 1\nv 3 1 0\nv 2 2 1\nv 0 2 0\nf 1 2 3 4 5\n");
    assert_eq!(read.mesh.triangles(), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    assert_eq!(read.source.polygons, 1);
}

/// Star-shaped outlines, so concave that a fan from a corner would leave them, in any plane and far from the origin.
#[test]
fn a_concave_polygon_is_cut_without_overlap() {
    let mut random = Random(0x1234_5678_9abc_def1);
    let mut unit = move || random.below(1 << 30) as f64 / f64::from(1 << 30);
    for corners in 4..60 {
        let [x, y] = [DVec3::new(unit(), unit(), unit()).normalize(), DVec3::new(unit(), -unit(), unit())];
        let y = (y - x * x.dot(y)).normalize();
        let (normal, centre) = (x.cross(y), DVec3::splat(1e4 * unit()));
        let outline: Vec<DVec3> = (0..corners)
            .map(|corner| {
                let (sin, cos) = libm::sincos((f64::from(corner) + 0.5 * unit()) / f64::from(corners) * TAU);
                centre + (x * cos + y * sin) * (0.1 + unit())
            })
            .collect();
        let text: String = outline.iter().map(|p| format!("v {} {} {}\n", p.x, p.y, p.z)).collect();
        let face: String = (1..=corners).map(|corner| format!(" {corner}")).collect();
        let read = mesh(format!("{text}f{face}\n"));
        let area = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - a).dot(normal) / 2.0;
        let n = outline.len();
        let whole: f64 = (0..n).map(|i| area([centre, outline[i], outline[(i + 1) % n]])).sum();
        let areas: Vec<f64> = read
            .mesh
            .triangles()
            .iter()
            .map(|triangle| area(triangle.map(|corner| outline[corner as usize])))
            .collect();
        assert_eq!(areas.len(), n - 2);
        assert!(areas.iter().all(|area| *area > 0.0), "{corners} corners: {areas:?}");
        assert!((areas.iter().sum::<f64>() / whole - 1.0).abs() < 1e-9, "{corners} corners");
    }
}

#[test]
fn a_corner_on_an_edge_makes_no_empty_triangle() {
    let read = mesh("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
    for corners in read.mesh.triangles() {
        let [a, b, c] = corners.map(|corner| read.mesh.positions()[corner as usize]);
        assert!((b - a).cross(c - a).z > 0.0, "{corners:?}");
    }
}

#[test]
fn a_polygon_without_area_is_a_fan() {
    for text in ["v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n", "v 0 0 0\nv 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3 4\n"] {
        assert_eq!(mesh(text).mesh.triangles(), [[0, 1, 2], [0, 2, 3]], "{text}");
    }
}

#[test]
fn what_is_refused_is_named() {
    for (text, message) in [
        ("v 0 0\nf 1 1 1", "the OBJ file is damaged at line 1: there are 2 numbers; 3 are needed"),
        ("\nv 0 0,5 0\n", "the OBJ file is damaged at line 2: `0,5` is not a number"),
        (
            "v 0 0 0\n# nothing\nv 0 nan 0\n",
            "vertex 1 (line 3) has a coordinate of NaN; finite numbers up to 1e30 would be accepted",
        ),
        (
            "v 0 0 0\nv -1e31 0 0\n",
            "vertex 1 (line 2) has a coordinate of -1e31; finite numbers up to 1e30 would be accepted",
        ),
        (
            "v 0 0 0\nvt 0 0\nvt 0 inf\n",
            "texture coordinate 1 (line 3) is inf; finite numbers, or no texture coordinates at all, would be accepted",
        ),
        (
            "v 0 0 0\nv 1 0 0\nf 1 2 3\nf 1 2 1\n",
            "the OBJ file is damaged at line 3: a corner names vertex 3, of which there are 2; numbers count from 1",
        ),
        (
            "v 0 0 0\nf 1 1 -2\n",
            "the OBJ file is damaged at line 2: the corner `-2` names vertex -2, where 1 were given so far; \
             numbers count from 1, and from -1 backwards",
        ),
        (
            "v 0 0 0\nvt 0 0\nf 1/1 1/0 1/1\n",
            "the OBJ file is damaged at line 3: the corner `1/0` names texture coordinate 0, where 1 were given so far; \
             numbers count from 1, and from -1 backwards",
        ),
        (
            "v 0 0 0\nf 1 1 1/1/1/1\n",
            "the OBJ file is damaged at line 2: `1/1/1/1` is not the corner of a face; \
             v, v/vt, v//vn or v/vt/vn in whole numbers would be accepted",
        ),
        (
            "v 0 0 0\nf 1 1.5 1\n",
            "the OBJ file is damaged at line 2: `1.5` is not the corner of a face; \
             v, v/vt, v//vn or v/vt/vn in whole numbers would be accepted",
        ),
        ("v 0 0 0\np 1\n", "the OBJ file has no triangle (vertices: 1); a surface of at least one triangle is needed"),
    ] {
        assert_eq!(refusal(text), message);
    }
}

#[test]
fn an_obj_holds_one_mesh() {
    let options = MeshOptions { mesh: Some("left".into()), ..MeshOptions::default() };
    let refused = decode_mesh(SQUARE.as_bytes(), &options, &mut no_buffers).unwrap_err().to_string();
    assert_eq!(
        refused,
        "`mesh` is `left`, which the OBJ file does not have; none (it holds one mesh) would be accepted"
    );
}

#[test]
fn limits_are_the_callers() {
    let text = format!("{SQUARE}vt 0 0\nvt 1 1\nf 1/1 2/1 3/1 4/1\nf 1/2 2/2 3/2\n");
    let options = |max_vertices, max_triangles| MeshOptions { max_vertices, max_triangles, ..MeshOptions::default() };
    let decode = |options| decode_mesh(text.as_bytes(), &options, &mut no_buffers);
    assert_eq!(decode(options(7, 3)).unwrap().source.format, Format::Obj);
    assert_eq!(
        decode(options(6, 3)).unwrap_err().to_string(),
        "the OBJ mesh has 7 vertices or more; `max_vertices` accepts 6"
    );
    assert_eq!(
        decode(options(7, 2)).unwrap_err().to_string(),
        "the OBJ mesh has 3 triangles or more; `max_triangles` accepts 2"
    );
}
