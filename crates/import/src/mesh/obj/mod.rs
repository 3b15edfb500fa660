//! Wavefront OBJ: `v`, `vt`, `vn` and `f` lines of all objects and groups make one mesh.
//!
//! Own code, since the `tobj` crate keeps only the positions that faces use, in the order of use: the i-th row of a
//! table would not be the i-th `v` of the file. It also loses on which line a number is bad.
//!
//! What is read: numbers in f64; a `\` at the end of a line; positive and negative indices, also of lines further on; a
//! byte order mark. What is passed over: the fourth and further numbers of a `v` (weights and colours), materials,
//! groups, smoothing groups. What is passed over and counted: points, lines, curves, and faces of fewer than three
//! corners.

mod text;

use glam::{DVec2, DVec3};

use self::text::{Line, lines};
use super::{
    MeshError, MeshOptions,
    build::RawMesh,
    polygon::Polygons,
    seams::{Corner, NONE, Rows, first_of_its_like},
};
use crate::{DecodeError, Format, limits::reserved};

const FORMAT: Format = Format::Obj;

pub(crate) fn decode(bytes: &[u8], options: &MeshOptions) -> Result<RawMesh, DecodeError> {
    let mut file = File::default();
    for line in lines(bytes) {
        file.read(&line, options)?;
    }
    file.check_indices()?;
    file.into_mesh(options)
}

/// Everything the lines say.
#[derive(Default)]
struct File {
    positions: Vec<DVec3>,
    uvs: Vec<DVec2>,
    normals: Vec<DVec3>,
    corners: Vec<Corner>,
    sizes: Vec<u32>,
    /// The largest index of each kind, and its line: a face may name what only follows.
    highest: [Highest; 3],
    ignored: u64,
}

#[derive(Default, Clone, Copy)]
struct Highest {
    /// One more than the largest index, counted from 0.
    end: u64,
    line: u64,
}

const KINDS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

impl File {
    fn read(&mut self, line: &Line<'_>, options: &MeshOptions) -> Result<(), DecodeError> {
        let mut words = line.words();
        match words.next() {
            Some(b"v") => self.position(line, words, options)?,
            Some(b"vt") => self.uv(line, words)?,
            Some(b"vn") => self.normal(line, words)?,
            Some(b"f" | b"fo") => self.face(line, words)?,
            Some(b"l" | b"p" | b"curv" | b"curv2" | b"surf") => self.ignored += 1,
            _ => {}
        }
        Ok(())
    }

    fn position<'a>(
        &mut self,
        line: &Line<'_>,
        words: impl Iterator<Item = &'a [u8]>,
        options: &MeshOptions,
    ) -> Result<(), DecodeError> {
        let position = DVec3::from_array(line.numbers(words, 3)?);
        if let Some(value) = position.to_array().into_iter().find(|value| value.is_nan() || value.abs() > 1e30) {
            return Err(MeshError::Position { vertex: self.positions.len() as u64, line: line.number, value }.into());
        }
        self.positions.push(position);
        options.check_vertices(FORMAT, self.positions.len() as u64)
    }

    fn uv<'a>(&mut self, line: &Line<'_>, words: impl Iterator<Item = &'a [u8]>) -> Result<(), DecodeError> {
        let uv = DVec2::from_array(line.numbers(words, 1)?);
        if let Some(value) = uv.to_array().into_iter().find(|value| !value.is_finite()) {
            return Err(MeshError::TextureCoordinate { index: self.uvs.len() as u64, line: line.number, value }.into());
        }
        self.uvs.push(uv);
        Ok(())
    }

    fn normal<'a>(&mut self, line: &Line<'_>, words: impl Iterator<Item = &'a [u8]>) -> Result<(), DecodeError> {
        self.normals.push(DVec3::from_array(line.numbers(words, 3)?));
        Ok(())
    }

    fn face<'a>(&mut self, line: &Line<'_>, words: impl Iterator<Item = &'a [u8]>) -> Result<(), DecodeError> {
        let start = self.corners.len();
        for word in words {
            let corner = self.corner(line, word)?;
            self.corners.push(corner);
        }
        let size = self.corners.len() - start;
        if size < 3 {
            self.corners.truncate(start);
            self.ignored += 1;
            return Ok(());
        }
        let size = u32::try_from(size).map_err(|_| line.damaged("a face has more than 4294967295 corners"))?;
        self.sizes.push(size);
        Ok(())
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    fn corner(&mut self, line: &Line<'_>, word: &[u8]) -> Result<Corner, DecodeError> {
        let counts = [self.positions.len(), self.uvs.len(), self.normals.len()];
        let mut named = [NONE; 3];
        for (kind, part) in word.split(|&b| b == b'/').enumerate() {
            if kind > 2 || (kind == 0 && part.is_empty()) {
                return Err(line.not_a_corner(word));
            }
            if !part.is_empty() {
                let Some(index) = text::integer(part) else { return Err(line.not_a_corner(word)) };
                named[kind] = match text::from_zero(index, counts[kind]) {
                    Some(named) => named,
                    None if self.may_lack(kind) => NONE,
                    None => return Err(line.not_there(word, index, counts[kind], KINDS[kind])),
                };
                if named[kind] != NONE && u64::from(named[kind]) >= self.highest[kind].end {
                    self.highest[kind] = Highest { end: u64::from(named[kind]) + 1, line: line.number };
                }
            }
        }
        let [position, uv, normal] = named;
        Ok(Corner { position, uv, normal })
    }

    /// Whether a corner may name what is not there: no normal stops a bake, and some programs leave out all `vt` lines.
    fn may_lack(&self, kind: usize) -> bool {
        kind == 2 || (kind == 1 && self.uvs.is_empty())
    }

    fn check_indices(&self) -> Result<(), DecodeError> {
        let counts = [self.positions.len(), self.uvs.len(), self.normals.len()];
        for (kind, (highest, count)) in self.highest.iter().zip(counts).enumerate() {
            if highest.end > count as u64 && !self.may_lack(kind) {
                let (named, kind) = (highest.end, KINDS[kind]);
                let reason = format!("a corner names {kind} {named}, of which there are {count}; numbers count from 1");
                return Err(MeshError::Line { format: FORMAT, line: highest.line, reason }.into());
            }
        }
        Ok(())
    }

    fn into_mesh(self, options: &MeshOptions) -> Result<RawMesh, DecodeError> {
        let Self { mut positions, uvs, normals, corners, sizes, ignored, .. } = self;
        let first_uv = first_of_its_like(uvs.iter().map(DVec2::to_array));
        let first_normal = first_of_its_like(normals.iter().map(DVec3::to_array));
        // What is not there counts as not given.
        let alike = |firsts: &[u32], named: u32| firsts.get(named as usize).copied().unwrap_or(NONE);
        let mut rows = Rows::new(positions.len());
        let mut polygons = Polygons { corners: reserved(corners.len())?, sizes };
        for Corner { position, uv, normal } in corners {
            let corner = Corner { position, uv: alike(&first_uv, uv), normal: alike(&first_normal, normal) };
            polygons.corners.push(rows.row(corner));
            options.check_vertices(FORMAT, rows.len() as u64)?;
        }
        rows.extend(&mut positions);
        let (triangles, cut) = polygons.triangles(FORMAT, &positions, options)?;
        Ok(RawMesh {
            format: FORMAT,
            name: None,
            uvs: if uvs.is_empty() { Vec::new() } else { rows.uvs(&uvs) },
            normals: if normals.is_empty() { Vec::new() } else { rows.normals(&normals) },
            positions,
            triangles,
            polygons: cut,
            seam_vertices: rows.further(),
            ignored,
            buffers: Vec::new(),
        })
    }
}
