//! OBJ numbers positions, texture coordinates and normals apart; a mesh has one row for all three.
//!
//! Row i is the i-th position with the first pair of texture coordinate and normal that a corner gives it. Every
//! further pair makes a row behind the last position, in order of first use. Pairs are told apart by value and not by
//! number, since many programs write the same normal once per corner.

use std::collections::HashMap;

use glam::{DVec2, DVec3};

use super::build::{NO_NORMAL, NO_UV};

/// Stands for "the corner gives none".
pub(crate) const NONE: u32 = u32::MAX;

/// What a corner of a face names, counted from 0.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Corner {
    pub(crate) position: u32,
    /// Or [`NONE`].
    pub(crate) uv: u32,
    /// Or [`NONE`].
    pub(crate) normal: u32,
}

/// Rows behind those of the positions, and what each row has.
pub(crate) struct Rows {
    /// The position, texture coordinate and normal of every row.
    rows: Vec<Corner>,
    positions: usize,
    further: HashMap<Corner, u32>,
}

/// Marks a row that no corner has used yet.
const UNUSED: u32 = u32::MAX - 1;

impl Rows {
    /// One row per position, unused.
    pub(crate) fn new(positions: usize) -> Self {
        let row = |position| Corner { position, uv: UNUSED, normal: UNUSED };
        Self { rows: (0..positions as u32).map(row).collect(), positions, further: HashMap::new() }
    }

    /// The row of a corner, made if there is none.
    pub(crate) fn row(&mut self, corner: Corner) -> u32 {
        let first = &mut self.rows[corner.position as usize];
        if first.uv == UNUSED {
            *first = corner;
        }
        if *first == corner {
            return corner.position;
        }
        *self.further.entry(corner).or_insert_with(|| {
            self.rows.push(corner);
            self.rows.len() as u32 - 1
        })
    }

    /// Rows in all.
    pub(crate) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Rows behind those of the positions.
    pub(crate) fn further(&self) -> u64 {
        (self.rows.len() - self.positions) as u64
    }

    /// Appends the positions of the further rows.
    pub(crate) fn extend(&self, positions: &mut Vec<DVec3>) {
        positions.reserve_exact(self.rows.len() - self.positions);
        for row in &self.rows[self.positions..] {
            positions.push(positions[row.position as usize]);
        }
    }

    /// The texture coordinate of every row.
    pub(crate) fn uvs(&self, uvs: &[DVec2]) -> Vec<DVec2> {
        self.rows.iter().map(|row| uvs.get(row.uv as usize).copied().unwrap_or(NO_UV)).collect()
    }

    /// The normal of every row.
    pub(crate) fn normals(&self, normals: &[DVec3]) -> Vec<DVec3> {
        self.rows.iter().map(|row| normals.get(row.normal as usize).copied().unwrap_or(NO_NORMAL)).collect()
    }
}

/// For each of `values` the number of the first that is the same.
pub(crate) fn first_of_its_like<const N: usize>(values: impl ExactSizeIterator<Item = [f64; N]>) -> Vec<u32> {
    let mut firsts = HashMap::with_capacity(values.len());
    // Adding 0 makes −0 and 0 the same.
    let bits = values.map(|value| value.map(|number| (number + 0.0).to_bits()));
    bits.zip(0..).map(|(bits, at)| *firsts.entry(bits).or_insert(at)).collect()
}
