//! What several tests need.
#![allow(dead_code)] // Each test program uses its own part.

pub(crate) mod damage;

use std::{fs, path::PathBuf};

use barchan_import::{DecodeError, HeightMapOptions, ImportedMesh, MeshOptions, decode_mesh, no_buffers};

/// The folder of small files by other software.
pub(crate) fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/files")
}

/// The bytes of one of them.
pub(crate) fn file(name: &str) -> Vec<u8> {
    fs::read(folder().join(name)).expect(name)
}

/// Samples as they are.
pub(crate) fn options() -> HeightMapOptions {
    HeightMapOptions::default()
}

/// A version 1.0 NPY file.
pub(crate) fn npy(descr: &str, fortran_order: bool, rows: u64, columns: u64, data: &[u8]) -> Vec<u8> {
    let order = if fortran_order { "True" } else { "False" };
    npy_with(&format!("{{'descr': '{descr}', 'fortran_order': {order}, 'shape': ({rows}, {columns}), }}\n"), data)
}

/// A version 1.0 NPY file with this header.
pub(crate) fn npy_with(text: &str, data: &[u8]) -> Vec<u8> {
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((text.len() as u16).to_le_bytes());
    bytes.extend(text.as_bytes());
    bytes.extend(data);
    bytes
}

/// An NPY file of f32.
pub(crate) fn npy_f32(columns: usize, samples: &[f32]) -> Vec<u8> {
    let data: Vec<u8> = samples.iter().flat_map(|s| s.to_le_bytes()).collect();
    npy("<f4", false, (samples.len() / columns) as u64, columns as u64, &data)
}

/// The folder of small meshes by other software.
pub(crate) fn meshes() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/meshes")
}

/// A mesh from memory.
pub(crate) fn decoded(bytes: impl AsRef<[u8]>) -> Result<ImportedMesh, DecodeError> {
    decode_mesh(bytes.as_ref(), &MeshOptions::default(), &mut no_buffers)
}

/// A mesh from memory that is in order.
pub(crate) fn mesh(bytes: impl AsRef<[u8]>) -> ImportedMesh {
    decoded(bytes).expect("the test's own mesh")
}

/// Why a mesh from memory is refused.
pub(crate) fn refusal(bytes: impl AsRef<[u8]>) -> String {
    decoded(bytes).expect_err("the test's own mesh").to_string()
}
