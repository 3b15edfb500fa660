//! Meshes that lie: never a panic, never memory on the word of a header.

mod common;

use std::{
    fs,
    time::{Duration, Instant},
};

use barchan_import::{MeshOptions, buffers_beside, decode_mesh};
use common::{
    damage::{Random, mutate, peak_bytes},
    decoded, mesh, meshes, refusal,
};

/// Every file of the folder, cut at every length, and thousands of times changed in a few places.
#[test]
fn no_damage_makes_a_panic() {
    let before = peak_bytes();
    let mut paths: Vec<_> = fs::read_dir(meshes()).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut files, mut whole) = (0, 0);
    for path in paths.iter().filter(|path| !matches!(path.extension().unwrap().to_str(), Some("md" | "py" | "bin"))) {
        let original = fs::read(path).unwrap();
        let decode = |bytes: &[u8]| decode_mesh(bytes, &MeshOptions::default(), &mut buffers_beside(path));
        let is_binary = !original.is_ascii();
        for len in 0..original.len() {
            let cut = decode(&original[..len]);
            // A text may lose its last digits and stay a text.
            assert!(cut.is_err() || !is_binary, "{path:?} cut to {len}");
        }
        for _ in 0..2000 {
            whole += usize::from(decode(&mutate(&original, &mut random)).is_ok());
        }
        files += 1;
    }
    assert!(files > 12 && whole > 0);
    if let (Some(before), Some(after)) = (before, peak_bytes()) {
        assert!(after - before < 256 << 20, "{} MiB more", (after - before) >> 20);
    }
}

#[test]
fn a_count_must_fit_the_file() {
    let header = |format: &str, count: u64, properties: &str| {
        format!("ply\nformat {format} 1.0\nelement vertex {count}\n{properties}end_header\n")
    };
    let xyz = "property float x\nproperty float y\nproperty float z\n";
    assert_eq!(
        refusal(header("binary_little_endian", 100_000_000, xyz)),
        "the PLY file promises 100000000 of `vertex`; the 0 bytes left for them can hold 0 at most"
    );
    assert_eq!(
        refusal(header("ascii", 100_000_000, xyz) + "0 0 0\n"),
        "the PLY file promises 100000000 of `vertex`; the 6 bytes left for them can hold 1 at most"
    );
    assert_eq!(
        refusal(header("ascii", u64::MAX, xyz)),
        "the PLY file promises 18446744073709551615 of `vertex`; the 0 bytes left for them can hold 0 at most"
    );
    let list = "property list uint double vertex_indices\n";
    let mut face = format!("ply\nformat binary_little_endian 1.0\nelement other 1\n{list}end_header\n").into_bytes();
    face.extend([0xff; 4]);
    assert_eq!(refusal(face), "the PLY file is damaged: a list has 4294967295 items; 0 to 0 fit the rest of the file");
}

/// Nothing is read for such a row, so a loop over them would have no end.
#[test]
fn rows_without_properties_cost_nothing() {
    let file = "ply\nformat binary_big_endian 1.0\nelement nothing 18446744073709551615\nend_header\n";
    assert_eq!(refusal(file), "the PLY file is damaged: there is no element `vertex`");
    let faces = file.replace("nothing", "face");
    assert_eq!(refusal(faces), "the PLY file is damaged: the element `face` has no list of integers `vertex_indices`");
}

#[test]
fn an_accessor_must_fit_its_buffer() {
    let gltf = |accessor: &str| {
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": 4, "uri": "data:;base64,AAAAAA=="}}],
               "bufferViews": [{{"buffer": 0, "byteLength": 4}}], "accessors": [{accessor}],
               "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}]}}"#
        )
    };
    let many = r#""componentType": 5120, "count": 100000000, "type": "VEC3""#;
    let message = refusal(gltf(&format!(r#"{{"bufferView": 0, {many}}}"#)));
    assert!(message.starts_with("the glTF file promises 100000000 of vertices; the "), "{message}");
    let sparse =
        r#""sparse": {"count": 0, "indices": {"bufferView": 0, "componentType": 5121}, "values": {"bufferView": 0}}"#;
    let message = refusal(gltf(&format!("{{{many}, {sparse}}}")));
    assert!(message.starts_with("the glTF file promises 100000000 of vertices; the "), "{message}");
    let offset =
        r#"{"bufferView": 0, "byteOffset": 18446744073709551615, "componentType": 5126, "count": 1, "type": "VEC3"}"#;
    assert_eq!(refusal(gltf(offset)), "the glTF file is damaged: buffer view 0 ends beyond its buffer");
}

/// A thousand primitives that name the same indices.
#[test]
fn a_small_gltf_does_not_unfold_into_a_large_mesh() {
    let primitives = [r#"{"attributes": {"POSITION": 0}, "indices": 1, "mode": 6}"#; 20_000].join(",");
    let indices = "A".repeat(40_000 / 3 * 4);
    let bytes = indices.len() / 4 * 3;
    let gltf = format!(
        r#"{{"asset": {{"version": "2.0"}}, "buffers": [{{"byteLength": {bytes}, "uri": "data:;base64,{indices}"}}],
           "bufferViews": [{{"buffer": 0, "byteLength": {bytes}}}],
           "accessors": [{{"bufferView": 0, "componentType": 5120, "count": 3, "type": "VEC3"}},
                         {{"bufferView": 0, "componentType": 5121, "count": {bytes}, "type": "SCALAR"}}],
           "meshes": [{{"primitives": [{primitives}]}}]}}"#
    );
    let message = refusal(&gltf);
    assert!(message.contains(" of triangles; the ") && message.ends_with(" at most"), "{message}");
}

/// The worst outlines of all lengths: time stays within the square of the corners.
#[test]
fn long_polygons_end() {
    let start = Instant::now();
    for corners in [1000_u32, 1024, 1025, 200_000] {
        let zigzag = |corner: u32| format!("v {} {} 0\n", corner, 100 * (corner % 2) + (corner % 1000).pow(2) % 7);
        let vertices: String = (0..corners).map(zigzag).collect();
        let face: String = (1..=corners).map(|corner| format!(" {corner}")).collect();
        assert_eq!(mesh(format!("{vertices}f{face}\n")).source.triangles, u64::from(corners) - 2);
    }
    assert!(start.elapsed() < Duration::from_secs(5), "{:?}", start.elapsed());
}

#[test]
fn deep_json_is_refused() {
    let deep = format!(r#"{{"asset": {}"#, "[".repeat(100_000));
    assert!(decoded(deep).is_err());
}
