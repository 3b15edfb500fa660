//! What of a file is to be loaded.

use barchan_asset::{CurvatureColumn, Semantic};

/// What part of a table is loaded. What a table does not have is not looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TablePart {
    /// The first azimuth and how many from there on, past the last one round to the first on a full circle; all of them if nothing is
    /// said. What is left is an arc: a sun that stands still needs the two beside it.
    pub azimuths: Option<(u32, u32)>,
    /// How many points per texel and azimuth of a swept table, the most important first.
    pub candidates: Option<u32>,
    /// How many rings of a hemisphere table, from the normal outwards.
    pub rings: Option<u32>,
    /// The finest mip level.
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

    /// The same with a part of a table.
    #[must_use]
    pub fn with_part(mut self, table: Semantic, part: TablePart) -> Self {
        self.parts.retain(|(other, _)| *other != table);
        self.parts.push((table, part));
        self
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
