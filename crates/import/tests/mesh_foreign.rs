//! Meshes that other software wrote (`meshes/README.md`): every vertex is as its formula says.

mod common;

use barchan_field::LengthUnit;
use barchan_import::{Format, ImportedMesh, MeshOptions, read_mesh};
use common::meshes;
use glam::{DVec2, DVec3};

fn load(name: &str) -> ImportedMesh {
    read_mesh(&meshes().join(name), &MeshOptions::default()).expect(name)
}

/// Column and row of each vertex of the patch.
fn vertices() -> impl Iterator<Item = [f64; 2]> {
    (0..12).map(|at| [f64::from(at % 4), f64::from(at / 4)])
}

fn positions(offset: f64) -> Vec<DVec3> {
    vertices().map(|[i, j]| DVec3::new(i / 2.0 + offset, j / 4.0, i * j / 8.0)).collect()
}

fn uvs() -> Vec<DVec2> {
    vertices().map(|[i, j]| DVec2::new(i, j) / 4.0).collect()
}

/// Each cell as two triangles; fans and what the files say are the same.
fn triangles() -> Vec<[u32; 3]> {
    let cells = (0..2).flat_map(|j| (0..3).map(move |i| i + 4 * j));
    cells.flat_map(|a| [[a, a + 1, a + 5], [a, a + 5, a + 4]]).collect()
}

#[test]
fn positions_and_triangles_are_those_of_the_file() {
    for (name, polygons) in [
        ("trimesh.obj", 0),
        ("trimesh.ply", 0),
        ("trimesh_text.ply", 0),
        ("trimesh.glb", 0),
        ("trimesh.gltf", 0),
        ("meshio.obj", 6),
        ("meshio.ply", 6),
        ("pygltflib_sparse.gltf", 0),
    ] {
        let read = load(name);
        assert_eq!(read.mesh.positions(), positions(0.0), "{name}");
        assert_eq!(read.mesh.triangles(), triangles(), "{name}");
        assert_eq!((read.source.vertices, read.source.triangles, read.source.polygons), (12, 12, polygons), "{name}");
        assert_eq!(read.source.ignored + read.source.uvs_missing + read.source.normals_missing, 0, "{name}");
    }
}

#[test]
fn doubles_keep_their_bits() {
    for name in ["plyfile_big.ply", "plyfile_little.ply", "plyfile_text.ply"] {
        let read = load(name);
        assert_eq!(read.mesh.positions(), positions(1e7), "{name}");
        assert_eq!(read.mesh.triangles(), triangles(), "{name}");
        assert_eq!(read.mesh.uvs(), Some(&uvs()[..]), "{name}");
        assert_eq!(read.mesh.normals(), Some(&[DVec3::Z; 12][..]), "{name}");
        assert_eq!((read.source.format, read.source.polygons), (Format::Ply, 6), "{name}");
    }
}

#[test]
fn v_is_up_in_every_format() {
    for name in ["trimesh.obj", "trimesh.ply", "trimesh_text.ply", "trimesh.glb", "trimesh.gltf"] {
        assert_eq!(load(name).mesh.uvs(), Some(&uvs()[..]), "{name}");
    }
    let normalised = load("pygltflib_strip.gltf");
    for (found, expected) in normalised.mesh.uvs().unwrap().iter().zip(uvs()) {
        assert!((found - expected).abs().max_element() <= 0.5 / 65535.0 + 1e-12, "{found}, not {expected}");
    }
    assert_eq!(load("meshio.obj").mesh.uvs(), None);
}

#[test]
fn normals_are_as_stated() {
    for name in ["trimesh.obj", "trimesh.ply", "trimesh.glb", "trimesh.gltf", "pygltflib_quantised.gltf"] {
        assert_eq!(load(name).mesh.normals(), Some(&[DVec3::Z; 12][..]), "{name}");
    }
    assert_eq!(load("meshio.ply").mesh.normals(), None);
}

#[test]
fn seams_by_value_and_not_by_number() {
    // One `vn` per vertex, all the same; one `vt` per vertex, all different.
    assert_eq!(load("trimesh.obj").source.seam_vertices, 0);
}

#[test]
fn quantised_positions_stay_in_the_units_of_the_attribute() {
    let read = load("pygltflib_quantised.gltf");
    let eighths: Vec<DVec3> = positions(0.0).iter().map(|position| position * 8.0).collect();
    assert_eq!(read.mesh.positions(), eighths);
    assert_eq!(read.mesh.triangles(), triangles());
}

#[test]
fn a_strip_is_the_same_surface_with_its_joints_left_out() {
    let read = load("pygltflib_strip.gltf");
    assert_eq!(read.mesh.positions(), positions(0.0));
    // Cut along the other diagonal: each cell faces +z all the same, and its halves make its area.
    let area = |[a, b, c]: [u32; 3]| {
        let [a, b, c] = [a, b, c].map(|corner| read.mesh.positions()[corner as usize]);
        (b - a).cross(c - a).z / 2.0
    };
    assert_eq!(read.mesh.triangles().len(), 12);
    for pair in read.mesh.triangles().chunks(2) {
        assert_eq!((area(pair[0]), area(pair[1])), (0.0625, 0.0625));
    }
}

#[test]
fn cubes_by_blender_and_meshlab() {
    for (name, polygons) in [("blender.ply", 6), ("meshlab.ply", 0)] {
        let read = load(name);
        assert_eq!((read.source.vertices, read.source.triangles, read.source.polygons), (24, 12, polygons), "{name}");
        assert!(read.mesh.positions().iter().all(|position| position.abs() == DVec3::splat(0.5)), "{name}");
        let six_volumes: f64 = read
            .mesh
            .triangles()
            .iter()
            .map(|corners| corners.map(|corner| read.mesh.positions()[corner as usize]))
            .map(|[a, b, c]| a.dot(b.cross(c)))
            .sum();
        assert!((six_volumes - 6.0).abs() < 1e-12, "{name}: every face looks outwards");
        let uvs = read.mesh.uvs().expect(name);
        assert!(uvs.iter().all(|uv| (0.0..=1.0).contains(&uv.x) && (0.0..=1.0).contains(&uv.y)), "{name}");
        assert_eq!(uvs[0], DVec2::new(0.625, 0.5), "{name}");
    }
}

#[test]
fn the_source_says_where_the_mesh_came_from() {
    let read = load("trimesh.gltf");
    assert_eq!(read.source.format, Format::Gltf);
    assert_eq!(read.source.name.as_deref(), Some("geometry_0"));
    assert_eq!(read.source.buffers, ["trimesh-buffer.bin"]);
    assert_eq!(read.unit, LengthUnit::Metre);
    let read = load("trimesh.obj");
    assert_eq!((read.source.format, read.unit), (Format::Obj, LengthUnit::SceneUnit));
}

#[test]
fn the_scanned_sample_is_as_its_page_says() {
    let samples = std::path::PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../samples");
    let page = std::fs::read_to_string(samples.join("README.md")).unwrap();
    let read = read_mesh(&samples.join("demosthenes.ply"), &MeshOptions::default()).unwrap();
    let counts =
        format!("{} vertices, {} triangles, no texture coordinates", read.source.vertices, read.source.triangles);
    assert!(page.contains(&counts), "{counts}");
    assert_eq!((read.mesh.uvs(), read.mesh.normals(), read.source.ignored), (None, None, 0));
}
