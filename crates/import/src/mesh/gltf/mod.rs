//! glTF 2.0: one mesh of the file, all its primitives.
//!
//! Own code above `serde_json`, since the `gltf` crate reads positions of f32 only, not quantised ones, and multiplies
//! offsets, strides and counts of a file unchecked.
//!
//! Primitives that share the accessors of position, normal and texture coordinate share vertices, too; each distinct
//! set appends those of its accessors, in file order. Triangles, strips and fans are read; of strips, triangles that
//! name a vertex twice only join and are left out. Read are the attributes `POSITION`, `NORMAL` and `TEXCOORD_0`,
//! sparse accessors, and `KHR_mesh_quantization`. Not applied are the transforms of nodes (a mesh is where its
//! attributes say), morph targets, skins, and transforms of textures.

mod accessor;
mod buffers;
mod container;
mod json;

use std::{collections::HashMap, io, ops::Range};

use barchan_field::FieldError;
use glam::{DVec2, DVec3};

use self::{
    accessor::Reader,
    buffers::Buffers,
    json::{Attributes, Primitive},
};
use super::{
    MeshError, MeshOptions,
    build::{NO_NORMAL, NO_UV, RawMesh},
};
use crate::{DecodeError, Format};

const FORMAT: Format = Format::Gltf;

pub(crate) fn decode(
    bytes: &[u8],
    options: &MeshOptions,
    read_buffer: &mut dyn FnMut(&str) -> io::Result<Vec<u8>>,
) -> Result<RawMesh, DecodeError> {
    let parts = container::split(bytes)?;
    let document = json::parse(parts.json)?;
    let mesh = document.mesh(options.mesh.as_deref())?;
    let buffers = Buffers::new(&document.buffers, parts.binary, bytes.len(), read_buffer);
    let mut made = Made::new(mesh.name.clone());
    let mut reader = Reader { document: &document, buffers };
    for primitive in &mesh.primitives {
        made.add(primitive, &mut reader, options)?;
    }
    Ok(made.finish(reader.buffers.names()))
}

/// What is made so far.
struct Made {
    raw: RawMesh,
    /// Where the vertices of each set of attributes are.
    sets: HashMap<Attributes, Range<usize>>,
}

/// How indices make triangles.
#[derive(Clone, Copy)]
enum Topology {
    List,
    Strip,
    Fan,
}

impl Made {
    fn new(name: Option<String>) -> Self {
        let raw = RawMesh {
            format: FORMAT,
            name,
            positions: Vec::new(),
            triangles: Vec::new(),
            uvs: Vec::new(),
            normals: Vec::new(),
            polygons: 0,
            seam_vertices: 0,
            ignored: 0,
            buffers: Vec::new(),
        };
        Self { raw, sets: HashMap::new() }
    }

    fn add(
        &mut self,
        primitive: &Primitive,
        reader: &mut Reader<'_>,
        options: &MeshOptions,
    ) -> Result<(), DecodeError> {
        let topology = match primitive.mode {
            4 => Topology::List,
            5 => Topology::Strip,
            6 => Topology::Fan,
            0..=3 => {
                self.raw.ignored += 1;
                return Ok(());
            }
            mode => return Err(damaged(&format!("a primitive has the mode {mode}; 0 to 6 would be accepted"))),
        };
        let vertices = self.vertices(primitive.attributes, reader, options)?;
        let indices = match primitive.indices {
            Some(accessor) => reader.indices(accessor, vertices.len())?,
            None => (0..vertices.len() as u32).collect(),
        };
        let count = match topology {
            Topology::List => indices.len() / 3,
            Topology::Strip | Topology::Fan => indices.len().saturating_sub(2),
        };
        let total = self.raw.triangles.len() as u64 + count as u64;
        options.check_triangles(FORMAT, total)?;
        // Primitives may name the same indices again and again, but not with more than a byte of file for each triangle.
        reader.check_total("triangles", total)?;
        self.raw.triangles.extend(triangles(topology, &indices).map(|triangle| {
            // Both are below the limit of vertices, which u32 holds.
            triangle.map(|corner| corner + vertices.start as u32)
        }));
        Ok(())
    }

    /// The vertices of a set of attributes, appended if they are not there yet.
    fn vertices(
        &mut self,
        attributes: Attributes,
        reader: &mut Reader<'_>,
        options: &MeshOptions,
    ) -> Result<Range<usize>, DecodeError> {
        if let Some(known) = self.sets.get(&attributes) {
            return Ok(known.clone());
        }
        let position = attributes.position.ok_or_else(|| damaged("a primitive has no POSITION"))?;
        reader.fetch(position)?;
        let (start, count) = (self.raw.positions.len(), reader.count(position));
        for accessor in [attributes.uv, attributes.normal].into_iter().flatten() {
            if reader.count(accessor) != count {
                return Err(damaged(&format!("accessors {position} and {accessor} of a primitive differ in length")));
            }
        }
        let total = start as u64 + count;
        options.check_vertices(FORMAT, total)?;
        reader.check_total("vertices", total)?;
        self.raw.positions.extend(reader.vectors(position)?.into_iter().map(DVec3::from_array));
        let end = self.raw.positions.len();

        // A list is empty until an attribute turns up.
        if let Some(accessor) = attributes.uv {
            self.raw.uvs.resize(start, NO_UV);
            for (value, vertex) in reader.vectors(accessor)?.into_iter().zip(start as u64..) {
                let [u, v] = value;
                let uv = DVec2::new(u, 1.0 - v);
                if !uv.is_finite() {
                    return Err(FieldError::AttributeNotFinite { attribute: "texture coordinates", vertex }.into());
                }
                self.raw.uvs.push(uv);
            }
        } else if !self.raw.uvs.is_empty() {
            self.raw.uvs.resize(end, NO_UV);
        }
        if let Some(accessor) = attributes.normal {
            self.raw.normals.resize(start, NO_NORMAL);
            self.raw.normals.extend(reader.vectors(accessor)?.into_iter().map(DVec3::from_array));
        } else if !self.raw.normals.is_empty() {
            self.raw.normals.resize(end, NO_NORMAL);
        }
        self.sets.insert(attributes, start..end);
        Ok(start..end)
    }

    fn finish(mut self, buffers: Vec<String>) -> RawMesh {
        self.raw.buffers = buffers;
        self.raw
    }
}

/// Triangles in order; every other one of a strip runs backwards.
fn triangles(topology: Topology, indices: &[u32]) -> Box<dyn Iterator<Item = [u32; 3]> + '_> {
    match topology {
        Topology::List => Box::new(indices.chunks_exact(3).map(|corners| [corners[0], corners[1], corners[2]])),
        Topology::Strip => Box::new(
            indices
                .windows(3)
                .zip([false, true].into_iter().cycle())
                .filter(|(corners, _)| corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
                .map(|(corners, is_backward)| match is_backward {
                    false => [corners[0], corners[1], corners[2]],
                    true => [corners[1], corners[0], corners[2]],
                }),
        ),
        Topology::Fan => Box::new(indices.windows(2).skip(1).map(|pair| [indices[0], pair[0], pair[1]])),
    }
}

fn damaged(reason: &str) -> DecodeError {
    DecodeError::damaged(FORMAT, &reason)
}
