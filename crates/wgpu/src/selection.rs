//! What of a file is to be loaded.

use barchan_asset::{CurvatureColumn, Semantic};

use crate::{Reader, Technique};

/// What part of a table is loaded. What a table does not have is not looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TablePart {
    /// The first azimuth and how many from there on, past the last one round to the first on a full circle; all of them if nothing is
    /// said. What is left is an arc: a sun that stands still needs the two beside it. A hemisphere table wants two or more.
    pub azimuths: Option<(u32, u32)>,
    /// How many points per texel and azimuth of a swept table, the most important first; all of them if nothing is said.
    pub candidates: Option<u32>,
    /// How many rings of a hemisphere table, from the normal outwards; all of them if nothing is said.
    pub rings: Option<u32>,
    /// The finest mip level, counted in the table.
    pub first_level: u32,
}

/// Which tables of a file are loaded, and what part of each.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Selection {
    only: Option<Vec<Semantic>>,
    parts: Vec<(Semantic, TablePart)>,
    columns: Option<Vec<CurvatureColumn>>,
}

impl Selection {
    /// All that a file has.
    #[must_use]
    pub fn everything() -> Self {
        Self::default()
    }

    /// Of the tables of texels these, all of each. Those that a file does not have are refused by name when the upload is planned.
    #[must_use]
    pub fn tables(tables: &[Semantic]) -> Self {
        Self { only: Some(tables.to_vec()), ..Self::default() }
    }

    /// The tables that these techniques read: those that they require, and of those that they use where they are loaded the ones that
    /// the file has. Maximum heights without level 0, which no search reads; curvature if a shadow on a curved base asks for it.
    #[must_use]
    pub fn of_techniques(reader: &Reader<'_>, techniques: &[Technique]) -> Self {
        let mut tables: Vec<Semantic> = Vec::new();
        for technique in techniques {
            tables.extend(technique.required());
            if technique.optional().iter().all(|&table| reader.texture(table).is_some()) {
                tables.extend(technique.optional());
            }
        }
        let levels = reader.texture(Semantic::MaximumHeight).map_or(1, |texture| texture.descriptor.mips);
        let part = TablePart { first_level: 1.min(levels - 1), ..TablePart::default() };
        let selection = Self::tables(&tables).with_part(Semantic::MaximumHeight, part);
        if techniques.contains(&Technique::CurvedShadow) { selection } else { selection.with_columns(&[]) }
    }

    /// The same with a part of a table.
    #[must_use]
    pub fn with_part(mut self, table: Semantic, part: TablePart) -> Self {
        self.parts.retain(|(other, _)| *other != table);
        self.parts.push((table, part));
        self
    }

    /// The same with an arc of the horizon tables, elevations and distances alike: [`TablePart::azimuths`].
    #[must_use]
    pub fn with_azimuths(self, first: u32, count: u32) -> Self {
        let horizons =
            [Semantic::HorizonElevation, Semantic::HorizonDistance, Semantic::SweptElevation, Semantic::SweptDistance];
        horizons.into_iter().fold(self, |selection, table| {
            let part = TablePart { azimuths: Some((first, count)), ..selection.part(table) };
            selection.with_part(table, part)
        })
    }

    /// The same with that many points per texel and azimuth of the swept tables: [`TablePart::candidates`].
    #[must_use]
    pub fn with_candidates(self, candidates: u32) -> Self {
        [Semantic::SweptElevation, Semantic::SweptDistance].into_iter().fold(self, |selection, table| {
            let part = TablePart { candidates: Some(candidates), ..selection.part(table) };
            selection.with_part(table, part)
        })
    }

    /// The same with these columns of curvature alone; none of them leaves the curvature out.
    #[must_use]
    pub fn with_columns(mut self, columns: &[CurvatureColumn]) -> Self {
        self.columns = Some(columns.to_vec());
        self
    }

    /// The tables that were asked for by name.
    pub(crate) fn named(&self) -> &[Semantic] {
        self.only.as_deref().unwrap_or_default()
    }

    pub(crate) fn has_table(&self, table: Semantic) -> bool {
        self.only.as_ref().is_none_or(|only| only.contains(&table))
    }

    pub(crate) fn part(&self, table: Semantic) -> TablePart {
        self.parts.iter().find(|(other, _)| *other == table).map_or_else(TablePart::default, |(_, part)| *part)
    }

    pub(crate) fn has_column(&self, column: CurvatureColumn) -> bool {
        self.columns.as_ref().is_none_or(|columns| columns.contains(&column))
    }
}
