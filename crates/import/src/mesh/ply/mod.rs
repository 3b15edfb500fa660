//! The Stanford polygon format, in text and in both byte orders.
//!
//! Own code, since the `ply-rs-bw` crate builds a value for each row on the word of the header (an element without
//! properties and with a count of 10¹⁸ fills the memory), and asks for each number by name.
//!
//! What is read: of the element `vertex` the properties x, y, z, then nx, ny, nz, and the first of the pairs (s, t),
//! (u, v), (texture_u, texture_v) that is there, in any type; of `face` the list `vertex_indices` or `vertex_index`; of
//! `tristrips` the same list, in which a negative number ends a strip. Everything else is stepped over. In a text, a
//! row may go on over several lines, and numbers behind it on its last line, of which the header knows nothing, are
//! passed over.

mod header;
mod values;

use barchan_field::FieldError;
use glam::{DVec2, DVec3};

use self::{
    header::{Element, Header, Kind},
    values::Values,
};
use super::{
    MeshError, MeshOptions,
    build::{NO_NORMAL, RawMesh},
    polygon::Polygons,
};
use crate::{DecodeError, Format, limits::reserved};

const FORMAT: Format = Format::Ply;

pub(crate) fn decode(bytes: &[u8], options: &MeshOptions) -> Result<RawMesh, DecodeError> {
    let header = Header::read(bytes)?;
    let mut values = Values::new(&bytes[header.len..], header.encoding);
    let mut vertices = None;
    let mut faces = Faces::default();
    for element in &header.elements {
        element.check_plausible(&values)?;
        match element.name.as_str() {
            "vertex" => vertices = Some(read_vertices(element, &mut values, options)?),
            "face" => faces.read_faces(element, &mut values)?,
            "tristrips" => faces.read_strips(element, &mut values)?,
            _ if element.properties.is_empty() => {}
            _ => (0..element.count).try_for_each(|_| values.skip_row(element))?,
        }
    }
    let Some(vertices) = vertices else {
        return Err(damaged("there is no element `vertex`"));
    };
    faces.check(vertices.positions.len() as u64)?;
    let (triangles, polygons) = faces.polygons.triangles(FORMAT, &vertices.positions, options)?;
    Ok(RawMesh {
        format: FORMAT,
        name: None,
        positions: vertices.positions,
        triangles,
        uvs: vertices.uvs,
        normals: vertices.normals,
        polygons,
        seam_vertices: 0,
        ignored: faces.ignored,
        buffers: Vec::new(),
    })
}

struct Vertices {
    positions: Vec<DVec3>,
    uvs: Vec<DVec2>,
    normals: Vec<DVec3>,
}

/// Names of texture coordinates that programs write.
const UV_NAMES: [[&str; 2]; 4] = [["s", "t"], ["u", "v"], ["texture_u", "texture_v"], ["texture_s", "texture_t"]];

fn read_vertices(element: &Element, values: &mut Values<'_>, options: &MeshOptions) -> Result<Vertices, DecodeError> {
    options.check_vertices(FORMAT, element.count)?;
    let [x, y, z] = ["x", "y", "z"].map(|name| element.scalar(name));
    let (Some(x), Some(y), Some(z)) = (x, y, z) else {
        return Err(damaged("the element `vertex` does not have the properties x, y and z"));
    };
    let all = |names: &[&str]| names.iter().map(|name| element.scalar(name)).collect::<Option<Vec<usize>>>();
    let normal = all(&["nx", "ny", "nz"]);
    let uv = UV_NAMES.iter().find_map(|names| all(names));
    let count = element.count as usize;
    let mut vertices = Vertices {
        positions: reserved(count)?,
        uvs: reserved(if uv.is_some() { count } else { 0 })?,
        normals: reserved(if normal.is_some() { count } else { 0 })?,
    };
    let mut row = vec![0.0; element.properties.len()];
    for vertex in 0..element.count {
        values.read_row(element, &mut row)?;
        vertices.positions.push(DVec3::new(row[x], row[y], row[z]));
        if let Some(uv) = &uv {
            let uv = DVec2::new(row[uv[0]], row[uv[1]]);
            if !uv.is_finite() {
                return Err(FieldError::AttributeNotFinite { attribute: "texture coordinates", vertex }.into());
            }
            vertices.uvs.push(uv);
        }
        if let Some(normal) = &normal {
            let normal = DVec3::new(row[normal[0]], row[normal[1]], row[normal[2]]);
            vertices.normals.push(if normal.is_finite() { normal } else { NO_NORMAL });
        }
    }
    Ok(vertices)
}

#[derive(Default)]
struct Faces {
    polygons: Polygons,
    ignored: u64,
    /// The largest vertex named, and by which face.
    highest: Option<(u32, u64)>,
}

impl Faces {
    fn read_faces(&mut self, element: &Element, values: &mut Values<'_>) -> Result<(), DecodeError> {
        let list = corner_list(element)?;
        for face in 0..element.count {
            let start = self.polygons.corners.len();
            values.read_list_row(element, list, |value| {
                let corner = self.corner(face, value)?;
                self.polygons.corners.push(corner);
                Ok(())
            })?;
            match self.polygons.corners.len() - start {
                size @ 3.. => {
                    let size = u32::try_from(size).map_err(|_| damaged("a face has more than 4294967295 corners"))?;
                    self.polygons.sizes.push(size);
                }
                _ => {
                    self.polygons.corners.truncate(start);
                    self.ignored += 1;
                }
            }
        }
        Ok(())
    }

    /// Every corner after the second ends a triangle; every other triangle runs backwards. Those that name a corner
    /// twice only join.
    fn read_strips(&mut self, element: &Element, values: &mut Values<'_>) -> Result<(), DecodeError> {
        let list = corner_list(element)?;
        for face in 0..element.count {
            let mut strip: Vec<u32> = Vec::new();
            values.read_list_row(element, list, |value| {
                if value < 0.0 {
                    strip.clear();
                    return Ok(());
                }
                let corner = self.corner(face, value)?;
                if let [.., a, b] = strip[..]
                    && a != b
                    && b != corner
                    && corner != a
                {
                    let triangle = if strip.len().is_multiple_of(2) { [a, b, corner] } else { [b, a, corner] };
                    self.polygons.corners.extend(triangle);
                    self.polygons.sizes.push(3);
                }
                strip.push(corner);
                Ok(())
            })?;
        }
        Ok(())
    }

    fn corner(&mut self, face: u64, value: f64) -> Result<u32, DecodeError> {
        // Whole, since the list is of an integer type, unless a text says otherwise.
        if !(value >= 0.0 && value < f64::from(u32::MAX) && value.fract() == 0.0) {
            return Err(damaged(&format!("face {face} names vertex {value}; a whole number from 0 is needed")));
        }
        let corner = value as u32;
        if self.highest.is_none_or(|(highest, _)| corner > highest) {
            self.highest = Some((corner, face));
        }
        Ok(corner)
    }

    fn check(&self, vertices: u64) -> Result<(), DecodeError> {
        match self.highest {
            Some((vertex, face)) if u64::from(vertex) >= vertices => {
                Err(MeshError::Corner { format: FORMAT, face, vertex: vertex.into(), vertices }.into())
            }
            _ => Ok(()),
        }
    }
}

/// Which property lists the corners.
fn corner_list(element: &Element) -> Result<usize, DecodeError> {
    let is_corners = |name: &str| name == "vertex_indices" || name == "vertex_index";
    let found = element.properties.iter().position(|property| is_corners(&property.name));
    match found.map(|at| (at, element.properties[at].kind)) {
        Some((at, Kind::List { item, .. })) if item.is_integer() => Ok(at),
        _ if element.count == 0 => Ok(0),
        _ => Err(damaged(&format!("the element `{}` has no list of integers `vertex_indices`", element.name))),
    }
}

fn damaged(reason: &str) -> DecodeError {
    DecodeError::damaged(FORMAT, &reason)
}
