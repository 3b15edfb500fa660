//! PLY: headers, lists, strips, and what is refused.

mod common;

use common::{mesh, refusal};
use glam::{DVec2, DVec3};

/// A text of three vertices, with more properties and rows.
fn text(properties: &str, vertices: [&str; 3], rest: &str) -> String {
    let [a, b, c] = vertices;
    let (elements, rows) = rest.split_once('|').expect("a bar between header and rows");
    format!(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n{properties}\
         {elements}end_header\n0 0 0 {a}\n1 0 0 {b}\n0 1 0 {c}\n{rows}"
    )
}

const FACE: &str = "element face 1\nproperty list uchar int vertex_indices\n|3 0 1 2\n";

#[test]
fn each_pair_of_names_for_texture_coordinates() {
    for [u, v] in [["s", "t"], ["u", "v"], ["texture_u", "texture_v"], ["texture_s", "texture_t"]] {
        let read = mesh(text(&format!("property float {u}\nproperty double {v}\n"), ["0 1", "2 3", "4 5"], FACE));
        let expected = [DVec2::new(0.0, 1.0), DVec2::new(2.0, 3.0), DVec2::new(4.0, 5.0)];
        assert_eq!(read.mesh.uvs(), Some(&expected[..]), "{u}, {v}");
    }
    let alone = mesh(text("property float s\nproperty float v\n", ["0 1", "2 3", "4 5"], FACE));
    assert_eq!(alone.mesh.uvs(), None);
}

#[test]
fn unusable_normals_say_nothing() {
    let properties = "property float nx\nproperty float ny\nproperty float nz\n";
    let read = mesh(text(properties, ["0 0 0", "0 2 0", "nan 0 1"], FACE));
    assert_eq!(read.mesh.normals(), Some(&[DVec3::ZERO, 2.0 * DVec3::Y, DVec3::ZERO][..]));
    assert_eq!(read.source.normals_missing, 2);
}

#[test]
fn indices_of_any_integer_type() {
    for (name, bytes) in [("char", 1), ("uint8", 1), ("short", 2), ("uint16", 2), ("int32", 4), ("uint", 4)] {
        for order in ["big", "little"] {
            let mut file = format!(
                "ply\nformat binary_{order}_endian 1.0\nelement vertex 3\nproperty short x\nproperty char y\n\
                 property double z\nelement face 1\nproperty list {name} {name} vertex_index\nend_header\n"
            )
            .into_bytes();
            let mut put = |number: &[u8]| match order {
                "big" => file.extend(number.iter().rev()),
                _ => file.extend(number),
            };
            for (x, y, z) in [(-300_i16, -2_i8, 1e100_f64 / 1e90), (1, 2, 3.0), (0, 0, 0.5)] {
                put(&x.to_le_bytes());
                put(&y.to_le_bytes());
                put(&z.to_le_bytes());
            }
            for number in [3_u32, 0, 1, 2] {
                put(&number.to_le_bytes()[..bytes]);
            }
            let read = mesh(&file);
            assert_eq!(read.mesh.positions()[0], DVec3::new(-300.0, -2.0, 1e100 / 1e90), "{name} {order}");
            assert_eq!(read.mesh.triangles(), [[0, 1, 2]], "{name} {order}");
        }
    }
}

#[test]
fn a_first_number_that_looks_like_a_line_end_is_a_number() {
    for ends in ["\n", "\r\n", "\r"] {
        let header = "ply\nformat binary_little_endian 1.0\nelement face 1\nproperty list uchar uchar vertex_indices\n\
                      element vertex 14\nproperty uchar x\nproperty uchar y\nproperty uchar z\nend_header\n";
        let mut file = header.replace('\n', ends).into_bytes();
        // A polygon of ten corners begins with 10, the line feed; then 13, the carriage return.
        file.extend([10, 13, 1, 2, 3, 4, 5, 6, 7, 8, 9]);
        file.extend([0; 42]);
        assert_eq!(mesh(&file).mesh.triangles()[0], [13, 1, 2], "{ends:?}");
    }
}

#[test]
fn strips_turn_and_end() {
    let rest = "element tristrips 1\nproperty list int int vertex_indices\n|9 0 1 2 0 -1 2 1 0 0\n";
    // The second triangle runs backwards; the last, which names a vertex twice, only joins.
    assert_eq!(mesh(text("", [""; 3], rest)).mesh.triangles(), [[0, 1, 2], [2, 1, 0], [2, 1, 0]]);
}

#[test]
fn rows_of_a_text_may_be_broken_and_may_be_longer_than_the_header_says() {
    let plain = mesh(text("", [""; 3], FACE));
    assert_eq!(
        mesh(text("", ["7 7", "", "8"], "element face 1\nproperty list uchar int vertex_indices\n|3 0\n1\n2 9 9")),
        plain
    );
}

#[test]
fn faces_of_fewer_than_three_corners_are_counted() {
    let read = mesh(text("", [""; 3], "element face 3\nproperty list uchar int vertex_indices\n|2 0 1\n3 0 1 2\n0\n"));
    assert_eq!((read.source.ignored, read.source.triangles), (2, 1));
}

#[test]
fn what_is_refused_is_named() {
    let ply = |header: &str| format!("ply\n{header}\nend_header\n");
    for (file, message) in [
        (ply("format ascii 1.0"), "the PLY file is damaged: there is no element `vertex`"),
        ("ply\nformat ascii 1.0\n".to_owned(), "the PLY file is damaged: the header has no `end_header` line"),
        (ply("element vertex 0"), "the PLY file is damaged: the header has no `format` line"),
        (
            ply("format binary_middle_endian 1.0"),
            "the PLY file has the format `binary_middle_endian`; \
             ascii, binary_little_endian or binary_big_endian would be accepted",
        ),
        (ply("property int x"), "the PLY file is damaged at line 2: a property comes before the first element"),
        (ply("element vertex -1"), "the PLY file is damaged at line 2: `-1` is not a count"),
        (ply("element a 1\nproperty int64 x"), "the PLY file is damaged at line 3: `int64` is not a type"),
        (ply("element a 1\nelement a 1"), "the PLY file is damaged at line 3: there are two elements `a`"),
        (
            ply("element a 1\nproperty list float int x"),
            "the PLY file is damaged at line 3: a list counts its items in whole numbers",
        ),
        (
            ply("format ascii 1.0\nelement vertex 0\nproperty float x\nproperty float z"),
            "the PLY file is damaged: the element `vertex` does not have the properties x, y and z",
        ),
        (
            text("", ["", "", ""], "element face 1\nproperty list uchar float vertex_indices\n|3 0 1 2"),
            "the PLY file is damaged: the element `face` has no list of integers `vertex_indices`",
        ),
        (
            text("", [""; 3], "element face 2\nproperty list uchar int vertex_indices\n|3 0 1 2\n3 0 3 1"),
            "face 1 of the PLY file names vertex 3; 0 to 2 would be accepted",
        ),
        (
            text("", [""; 3], "element face 1\nproperty list uchar int vertex_indices\n|3 0 -1 1"),
            "the PLY file is damaged: face 0 names vertex -1; a whole number from 0 is needed",
        ),
        (
            text("property float s\nproperty float t\n", ["0 0", "0 nan", "0 0"], FACE),
            "the texture coordinates of vertex 1 are not finite; finite numbers are needed",
        ),
        (
            text("", [""; 3], FACE).replace("\n1 0 0", "\n1 inf 0"),
            "vertex 1 has the coordinate inf; finite coordinates up to 1e30 would be accepted",
        ),
        (text("", [""; 3], FACE).replace("1 0 0", "1 x 0"), "the PLY file is damaged: `x` is not a number"),
        (
            text("", [""; 3], "|"),
            "the PLY file has no triangle (vertices: 3); a surface of at least one triangle is needed",
        ),
    ] {
        assert_eq!(refusal(&file), message, "{file}");
    }
}
