//! glTF 2.0.
use super::{MeshOptions, build::RawMesh};
use crate::DecodeError;
use std::io;
pub(crate) fn decode(
    _: &[u8],
    _: &MeshOptions,
    _: &mut dyn FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<RawMesh, DecodeError> {
    Err(DecodeError::Unsupported { format: crate::Format::Gltf, found: "nothing yet".into(), accepted: "OBJ" })
}
