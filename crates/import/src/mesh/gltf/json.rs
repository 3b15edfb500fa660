//! What of the JSON matters here. Numbers are checked where they are used.

use serde::Deserialize;

use super::{FORMAT, MeshError};
use crate::DecodeError;

/// A file, or that part of it which describes meshes.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Document {
    asset: Asset,
    #[serde(default)]
    extensions_required: Vec<String>,
    #[serde(default)]
    pub(super) buffers: Vec<Buffer>,
    #[serde(default)]
    pub(super) buffer_views: Vec<BufferView>,
    #[serde(default)]
    pub(super) accessors: Vec<Accessor>,
    #[serde(default)]
    meshes: Vec<Mesh>,
}

#[derive(Deserialize)]
struct Asset {
    version: String,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Buffer {
    pub(super) byte_length: u64,
    pub(super) uri: Option<String>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub(super) buffer: usize,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) byte_length: u64,
    pub(super) byte_stride: Option<u64>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<usize>,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) component_type: u32,
    #[serde(default)]
    pub(super) normalized: bool,
    pub(super) count: u64,
    #[serde(rename = "type")]
    pub(super) shape: String,
    pub(super) sparse: Option<Sparse>,
}

/// Elements that differ from those of the buffer view.
#[derive(Deserialize)]
pub(super) struct Sparse {
    pub(super) count: u64,
    pub(super) indices: SparseIndices,
    pub(super) values: SparseValues,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparseIndices {
    pub(super) buffer_view: usize,
    #[serde(default)]
    pub(super) byte_offset: u64,
    pub(super) component_type: u32,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparseValues {
    pub(super) buffer_view: usize,
    #[serde(default)]
    pub(super) byte_offset: u64,
}

#[derive(Deserialize)]
pub(super) struct Mesh {
    pub(super) name: Option<String>,
    #[serde(default)]
    pub(super) primitives: Vec<Primitive>,
}

#[derive(Deserialize)]
pub(super) struct Primitive {
    pub(super) attributes: Attributes,
    pub(super) indices: Option<usize>,
    #[serde(default = "triangles")]
    pub(super) mode: u32,
}

fn triangles() -> u32 {
    4
}

/// The accessors of a primitive's vertices: those that share them share vertices.
#[derive(Deserialize, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub(super) position: Option<usize>,
    #[serde(rename = "NORMAL")]
    pub(super) normal: Option<usize>,
    #[serde(rename = "TEXCOORD_0")]
    pub(super) uv: Option<usize>,
}

/// Extensions without which no position can be read.
const COMPRESSED: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

/// Reads and checks what concerns the file as a whole.
pub(super) fn parse(json: &[u8]) -> Result<Document, DecodeError> {
    let document: Document = serde_json::from_slice(json).map_err(|cause| DecodeError::damaged(FORMAT, &cause))?;
    if !document.asset.version.starts_with("2.") {
        let found = format!("the version `{}`", document.asset.version);
        return Err(DecodeError::Unsupported { format: FORMAT, found, accepted: "2.0" });
    }
    match document.extensions_required.iter().find(|name| COMPRESSED.contains(&name.as_str())) {
        Some(name) => Err(DecodeError::Unsupported {
            format: FORMAT,
            found: format!("geometry that needs `{name}`"),
            accepted: "plain or quantised geometry",
        }),
        None => Ok(document),
    }
}

impl Document {
    /// The mesh of this name, or else number; the only one if none is `wanted`.
    pub(super) fn mesh(&self, wanted: Option<&str>) -> Result<&Mesh, DecodeError> {
        let Some(wanted) = wanted else {
            return match &self.meshes[..] {
                [only] => Ok(only),
                [] => Err(DecodeError::damaged(FORMAT, &"there is no mesh")),
                _ => Err(MeshError::WhichMesh { format: FORMAT, present: self.choices() }.into()),
            };
        };
        let named = self.meshes.iter().find(|mesh| mesh.name.as_deref() == Some(wanted));
        let numbered = || self.meshes.get(wanted.parse::<usize>().ok()?);
        named.or_else(numbered).ok_or_else(|| {
            MeshError::NoSuchMesh { format: FORMAT, wanted: wanted.to_owned(), present: self.choices() }.into()
        })
    }

    /// The first meshes, for a message.
    fn choices(&self) -> String {
        const SHOWN: usize = 10;
        let choice = |(number, mesh): (usize, &Mesh)| match &mesh.name {
            Some(name) => format!("{number} (`{}`)", name.escape_debug()),
            None => number.to_string(),
        };
        let mut choices: Vec<String> = self.meshes.iter().enumerate().take(SHOWN).map(choice).collect();
        if self.meshes.len() > SHOWN {
            choices.push(format!("up to {}", self.meshes.len() - 1));
        }
        if choices.is_empty() { "no mesh".to_owned() } else { choices.join(", ") }
    }
}
