//! What a file is, by its content and never by its name.

mod common;

use std::fs;

use barchan_import::{Format, HeightMapOptions, decode_height_map, detect};
use common::{file, folder, meshes, refusal};

#[test]
fn every_file_by_other_software_is_told() {
    let (mut images, mut found) = (0, 0);
    for entry in fs::read_dir(folder()).unwrap().chain(fs::read_dir(meshes()).unwrap()) {
        let path = entry.unwrap().path();
        let expected = match path.extension().unwrap().to_str().unwrap() {
            "png" => Format::Png,
            "exr" => Format::Exr,
            "tif" => Format::Tiff,
            "npy" => Format::Npy,
            "obj" => Format::Obj,
            "ply" => Format::Ply,
            "gltf" | "glb" => Format::Gltf,
            _ => continue,
        };
        let format = detect(&fs::read(&path).unwrap()).unwrap();
        assert_eq!(format, expected, "{path:?}");
        found += u32::from(format.is_mesh());
        images += u32::from(!format.is_mesh());
    }
    assert!(images > 25 && found > 12);
}

#[test]
fn an_obj_is_told_by_its_first_meaningful_line() {
    for text in ["v 0 0 0", "# by hand\r\n\r\n  o thing\r\n", "\u{feff}mtllib a.mtl\n", "#\rvn 0 0 1\r", "f 1 2 3"] {
        assert_eq!(detect(text.as_bytes()), Ok(Format::Obj), "{text:?}");
    }
    for text in ["Dear diary", "# only a comment\n", "vertex 0 0 0", "\n\n", "(source: Shape)"] {
        assert!(detect(text.as_bytes()).is_err(), "{text:?}");
    }
}

#[test]
fn the_other_kind_is_refused_by_name() {
    assert_eq!(refusal(file("grey16.png")), "the file is a PNG image; an OBJ, PLY or glTF file is needed");
    assert_eq!(refusal(file("i16.npy")), "the file is an NPY image; an OBJ, PLY or glTF file is needed");
    assert_eq!(refusal(""), "the file is empty; an OBJ, PLY or glTF file is needed");
    let as_height_map = |bytes: &[u8]| decode_height_map(bytes, &HeightMapOptions::default()).unwrap_err().to_string();
    assert_eq!(as_height_map(b"v 0 0 0"), "the file is an OBJ mesh; a PNG, EXR, TIFF or NPY file is needed");
    assert_eq!(as_height_map(b"ply\n"), "the file is a PLY mesh; a PNG, EXR, TIFF or NPY file is needed");
    let either = detect(b"solid cube").unwrap_err().to_string();
    assert_eq!(either, "the file is an STL; a PNG, EXR, TIFF, NPY, OBJ, PLY or glTF file is needed");
}
