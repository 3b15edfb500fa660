//! glTF: which mesh, shared accessors, files beside it, and what is refused.

mod common;

use std::{fs, io};

use barchan_field::LengthUnit;
use barchan_import::{MeshOptions, decode_mesh, read_mesh};
use common::{mesh, refusal};
use glam::{DVec2, DVec3};

/// Three positions of f32, their texture coordinates as bytes in rows of four, and the indices 0, 1, 2 as bytes.
fn buffer() -> Vec<u8> {
    let positions = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.5];
    let mut bytes: Vec<u8> = positions.iter().flat_map(|number| number.to_le_bytes()).collect();
    bytes.extend([0, 255, 9, 9, 255, 255, 9, 9, 0, 51, 9, 9]);
    bytes.extend([0, 1, 2]);
    bytes
}

const VIEWS: &str = r#"
    "bufferViews": [
        {"buffer": 0, "byteLength": 36},
        {"buffer": 0, "byteOffset": 36, "byteLength": 12, "byteStride": 4},
        {"buffer": 0, "byteOffset": 48, "byteLength": 3}
    ],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5121, "count": 3, "type": "VEC2", "normalized": true},
        {"bufferView": 2, "componentType": 5121, "count": 3, "type": "SCALAR"},
        {"bufferView": 0, "componentType": 5126, "count": 2, "type": "VEC3"}
    ]"#;

/// The JSON around meshes; the buffer is the one of the .glb.
fn json(meshes: &str) -> String {
    format!(r#"{{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": 51}}], {VIEWS}, "meshes": [{meshes}]}}"#)
}

/// The container.
fn glb(json: &str) -> Vec<u8> {
    let mut bytes = b"glTF\x02\0\0\0".to_vec();
    let binary = buffer();
    bytes.extend((12 + 8 + json.len() as u32 + 8 + binary.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", json.as_bytes()), (b"BIN\0", &binary)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

const TRIANGLE: &str = r#"{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2}"#;

fn one(primitives: &str) -> String {
    json(&format!(r#"{{"primitives": [{primitives}]}}"#))
}

#[test]
fn v_is_turned_up() {
    let read = mesh(glb(&one(TRIANGLE)));
    assert_eq!(read.mesh.positions()[2], DVec3::new(0.0, 1.0, 0.5));
    let uvs = [DVec2::ZERO, DVec2::X, DVec2::new(0.0, 1.0 - 51.0 / 255.0)];
    assert_eq!((read.mesh.triangles(), read.mesh.uvs()), (&[[0, 1, 2]][..], Some(&uvs[..])));
}

#[test]
fn primitives_that_share_accessors_share_vertices() {
    let plain = r#"{"attributes": {"POSITION": 0}}"#;
    let fan = r#"{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "mode": 6}"#;
    let points = r#"{"attributes": {"POSITION": 0}, "mode": 0}"#;
    let read = mesh(glb(&one(&[TRIANGLE, points, plain, fan].join(","))));
    assert_eq!(read.mesh.triangles(), [[0, 1, 2], [3, 4, 5], [0, 1, 2]]);
    assert_eq!((read.source.vertices, read.source.uvs_missing, read.source.ignored), (6, 3, 1));
    assert_eq!(read.mesh.uvs().unwrap()[3..], [DVec2::ZERO; 3]);
}

#[test]
fn which_mesh_is_asked_by_name_or_number() {
    let plain = r#"{"attributes": {"POSITION": 0}}"#;
    let file = glb(&json(&format!(
        r#"{{"name": "left", "primitives": [{TRIANGLE}]}}, {{"primitives": [{plain}, {TRIANGLE}]}}"#
    )));
    let decode = |mesh: Option<&str>| {
        let options =
            MeshOptions { mesh: mesh.map(str::to_owned), unit: Some(LengthUnit::Millimetre), ..MeshOptions::default() };
        decode_mesh(&file, &options, &mut |_| Err(io::Error::other("none")))
    };
    for (mesh, triangles) in [("left", 1), ("0", 1), ("1", 2)] {
        let read = decode(Some(mesh)).unwrap();
        assert_eq!((read.source.triangles, read.unit), (triangles, LengthUnit::Millimetre), "{mesh}");
    }
    assert_eq!(
        decode(None).unwrap_err().to_string(),
        "the glTF file does not say which mesh is meant; name `mesh` as one of 0 (`left`), 1"
    );
    assert_eq!(
        decode(Some("right")).unwrap_err().to_string(),
        "`mesh` is `right`, which the glTF file does not have; 0 (`left`), 1 would be accepted"
    );
}

/// A .gltf whose buffer is at `uri`.
fn at(uri: &str) -> String {
    one(TRIANGLE).replace(r#"{"byteLength": 51}"#, &format!(r#"{{"byteLength": 51, "uri": "{uri}"}}"#))
}

#[test]
fn buffers_beside_the_file_are_asked_for_once_and_by_their_plain_names() {
    let two = at("./a%20b/%C3%BC.bin")
        .replace(r#"{"byteLength": 51,"#, r#"{"byteLength": 51, "uri": "a b/ü.bin"}, {"byteLength": 51,"#)
        .replace(r#"{"buffer": 0, "byteLength": 36}"#, r#"{"buffer": 1, "byteLength": 36}"#);
    let mut asked = Vec::new();
    let read = decode_mesh(two.as_bytes(), &MeshOptions::default(), &mut |name| {
        asked.push(name.to_owned());
        Ok(buffer())
    });
    assert_eq!(read.unwrap().source.buffers, ["a b/ü.bin"]);
    assert_eq!(asked, ["a b/ü.bin"]);
}

/// What a file may hold is measured with the files beside it.
#[test]
fn a_short_gltf_may_have_a_long_buffer() {
    let [from, to] = [r#""byteLength": 36}"#, r#""byteLength": 1200000}"#];
    let json = at("x.bin").replace(from, to).replace(r#""byteLength": 51"#, r#""byteLength": 1200003"#);
    let json = json.replace(r#""byteOffset": 48"#, r#""byteOffset": 1200000"#).replace(r#", "TEXCOORD_0": 1"#, "");
    let json = json.replacen(r#""count": 3"#, r#""count": 100000"#, 1);
    let long = [vec![0; 1_200_000], vec![0, 1, 2]].concat();
    let read = decode_mesh(json.as_bytes(), &MeshOptions::default(), &mut |_| Ok(long.clone()));
    assert_eq!(read.unwrap().source.vertices, 100_000);
}

#[test]
fn no_path_leads_out_of_the_folder() {
    for uri in [
        "../x.bin",
        "a/../../x.bin",
        "%2e%2e/x.bin",
        "/etc/passwd",
        "C:x.bin",
        "file:///x.bin",
        "a\\\\b",
        "http://a/b",
        ".",
        "a//b",
        "",
        "%zz",
        "%00",
    ] {
        let refused = decode_mesh(at(uri).as_bytes(), &MeshOptions::default(), &mut |name| panic!("asked for {name}"));
        let message = refused.unwrap_err().to_string();
        assert!(message.ends_with("a file beside it, in its folder or below, is needed"), "{uri}: {message}");
    }
}

#[test]
fn files_are_read_from_the_folder_of_the_gltf() {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("model");
    fs::create_dir_all(folder.join("data")).unwrap();
    fs::write(folder.join("data/x.bin"), buffer()).unwrap();
    fs::write(place.path().join("outside.bin"), buffer()).unwrap();
    let read = |uri: &str| {
        let path = folder.join("x.gltf");
        fs::write(&path, at(uri)).unwrap();
        read_mesh(&path, &MeshOptions::default()).map_err(|error| {
            let message = error.to_string();
            message.strip_prefix(&format!("{}: ", path.display())).expect("the path comes first").to_owned()
        })
    };
    assert_eq!(read("data/x.bin").unwrap().source.triangles, 1);
    let refused = |name: &str, reason: &str| {
        format!(
            "the glTF file keeps its numbers in `{name}`, which cannot be read ({reason}); \
             a file beside it, in its folder or below, is needed"
        )
    };
    assert!(
        read("none.bin")
            .unwrap_err()
            .starts_with("the glTF file keeps its numbers in `none.bin`, which cannot be read (")
    );
    assert_eq!(read("../outside.bin"), Err(refused("../outside.bin", "it does not name a file below the folder")));
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../outside.bin", folder.join("link.bin")).unwrap();
        assert_eq!(read("link.bin"), Err(refused("link.bin", "it lies outside the folder of the glTF file")));
    }
}

#[test]
fn what_is_refused_is_named() {
    let with = |from: &str, to: &str| {
        let sound = one(TRIANGLE);
        assert!(sound.contains(from), "{from}");
        glb(&sound.replacen(from, to, 1))
    };
    let required = |name: &str| with(r#""buffers""#, &format!(r#""extensionsRequired": ["{name}"], "buffers""#));
    for (file, message) in [
        (
            required("KHR_draco_mesh_compression"),
            "the glTF file has geometry that needs `KHR_draco_mesh_compression`; plain or quantised geometry would be accepted",
        ),
        (
            required("EXT_meshopt_compression"),
            "the glTF file has geometry that needs `EXT_meshopt_compression`; plain or quantised geometry would be accepted",
        ),
        (with(r#""2.0""#, r#""1.0""#), "the glTF file has the version `1.0`; 2.0 would be accepted"),
        (glb(&json("")), "the glTF file is damaged: there is no mesh"),
        (
            glb(&json(r#"{"primitives": []}"#)),
            "the glTF file has no triangle (vertices: 0); a surface of at least one triangle is needed",
        ),
        (
            with(r#""POSITION": 0"#, r#""POSITION": 9"#),
            "the glTF file is damaged: accessors 9 and 1 of a primitive differ in length",
        ),
        (with(r#""POSITION": 0, "#, ""), "the glTF file is damaged: a primitive has no POSITION"),
        (
            with(r#""POSITION": 0"#, r#""POSITION": 3"#),
            "the glTF file is damaged: accessors 3 and 1 of a primitive differ in length",
        ),
        (
            with(r#""VEC3""#, r#""VEC4""#),
            "the glTF file is damaged: accessor 0 is of the type VEC4, where VEC3 is needed",
        ),
        (with("5126", "5130"), "the glTF file is damaged: an accessor has the component type 5130"),
        (with("5126", "5125"), "the glTF file is damaged: accessor 0 has vertices of unsigned ints"),
        (
            with(r#""bufferView": 0, "#, ""),
            "the glTF file is damaged: accessor 0 has neither a buffer view nor sparse values",
        ),
        (
            with(r#""byteStride": 4"#, r#""byteStride": 1"#),
            "the glTF file is damaged: buffer view 1 has a stride of 1 for elements of 2 bytes",
        ),
        (
            with(r#""byteOffset": 48"#, r#""byteOffset": 49"#),
            "the glTF file is damaged: buffer view 2 ends beyond its buffer",
        ),
        (
            with(r#""byteLength": 51"#, r#""byteLength": 52"#),
            "the glTF file is damaged: buffer 0 has 51 of its 52 bytes",
        ),
        (
            with(
                r#""bufferView": 2, "componentType": 5121, "count": 3"#,
                r#""bufferView": 2, "componentType": 5121, "count": 4"#,
            ),
            "the glTF file promises 4 of elements of buffer view 2; the 3 bytes left for them can hold 3 at most",
        ),
        (
            with(r#""byteOffset": 48"#, r#""byteOffset": 39"#),
            "face 0 of the glTF file names vertex 9; 0 to 2 would be accepted",
        ),
        (
            with(r#""indices": 2"#, r#""indices": 2, "mode": 7"#),
            "the glTF file is damaged: a primitive has the mode 7; 0 to 6 would be accepted",
        ),
        (
            with(r#"{"byteLength": 51}"#, r#"{"byteLength": 51, "uri": "data:text/plain,abc"}"#),
            "the glTF file is damaged: the data of buffer 0 is not in base64",
        ),
        (glb("{}"), "the glTF file is damaged: missing field `asset` at line 1 column 2"),
        (b"{ \"a\": ".to_vec(), "the glTF file is damaged: EOF while parsing a value at line 1 column 7"),
        (one(TRIANGLE).into_bytes(), "the glTF file is damaged: buffer 0 has no `uri`"),
        (b"glTF\x01\0\0\0\x0c\0\0\0".to_vec(), "the glTF file has the container version 1; 2 would be accepted"),
        (b"glTF\x02\0\0\0\x10\0\0\0".to_vec(), "the glTF file is damaged: it is 12 bytes long and says 16"),
    ] {
        assert_eq!(refusal(&file), message);
    }
}

#[test]
fn a_position_that_is_not_finite_is_named() {
    let mut file = glb(&one(TRIANGLE));
    let start = file.len() - buffer().len();
    file[start + 16..start + 20].copy_from_slice(&f32::NAN.to_le_bytes());
    assert_eq!(refusal(&file), "vertex 1 has the coordinate NaN; finite coordinates up to 1e30 would be accepted");
}
