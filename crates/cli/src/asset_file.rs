//! A `.barchan` file on disk, and its tables decoded.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use barchan_asset::{
    Asset, CurvatureDescriptor, CurvatureView, Limits, Section, SectionKind, TableView, TextureDescriptor,
};
use barchan_pipeline::Table;

use crate::failure::Failure;

/// A file's bytes, with their name for messages.
pub(crate) struct AssetFile {
    pub(crate) path: PathBuf,
    pub(crate) bytes: Vec<u8>,
}

/// A table's descriptor and decoded payload.
pub(crate) struct DecodedTable<'a> {
    pub(crate) table: Table,
    pub(crate) descriptor: TextureDescriptor,
    pub(crate) payload: Cow<'a, [u8]>,
}

impl AssetFile {
    pub(crate) fn read(path: &Path) -> Result<Self, Failure> {
        if path.is_dir() {
            return Err(Failure::Io(format!("{}: this is a folder; a .barchan file is needed", path.display())));
        }
        let unreadable = |error| Failure::io(path, "cannot be read", &error);
        // A pipe or a device may have no end.
        if !path.metadata().map_err(unreadable)?.is_file() {
            let shown = path.display();
            return Err(Failure::Io(format!("{shown}: this is a pipe or a device; a .barchan file is needed")));
        }
        let bytes = std::fs::read(path).map_err(unreadable)?;
        Ok(Self { path: path.to_owned(), bytes })
    }

    pub(crate) fn open(&self) -> Result<Asset<'_>, Failure> {
        Asset::open(&self.bytes).map_err(|error| self.content(error))
    }

    /// What is decoded at most: no more than any bake writes, and no more than zstd, whose densest block is 4 bytes that
    /// stand for 128 KiB, can have packed into a file of this size.
    pub(crate) fn limits(&self) -> Limits {
        let packed_at_most = (self.bytes.len() as u64).saturating_mul((128 << 10) / 4);
        Limits { max_decoded_bytes: packed_at_most.min(1 << 36), ..Limits::default() }
    }

    /// A complaint about this file's content.
    pub(crate) fn content(&self, error: impl std::fmt::Display) -> Failure {
        Failure::content(&self.path, error)
    }

    /// The tables that are there, in the order of the file's kinds.
    pub(crate) fn tables(&self) -> Result<Vec<Table>, Failure> {
        let asset = self.open()?;
        Ok(Table::ALL.into_iter().filter(|table| asset.section(table.kind()).is_some()).collect())
    }

    /// Decodes a texture, checking its bytes; an error if the file does not have it.
    pub(crate) fn decode(&self, table: Table) -> Result<DecodedTable<'_>, Failure> {
        let (section, payload) = self.payload(table)?;
        let descriptor = section.texture().map_err(|error| self.damaged(table, error))?;
        // Checked here once, so that views made from it later cannot fail.
        TableView::new(descriptor, &payload).map_err(|error| self.damaged(table, error))?;
        Ok(DecodedTable { table, descriptor, payload })
    }

    /// Decodes the curvature of a mesh, checking its bytes; an error if the file has none.
    pub(crate) fn curvature(&self) -> Result<DecodedCurvature<'_>, Failure> {
        let (section, payload) = self.payload(Table::Curvature)?;
        let descriptor = section.curvature().map_err(|error| self.damaged(Table::Curvature, error))?;
        CurvatureView::new(descriptor, &payload).map_err(|error| self.damaged(Table::Curvature, error))?;
        Ok(DecodedCurvature { descriptor, payload })
    }

    /// The provenance as it is stored: a newer program may have written more than this one knows.
    pub(crate) fn provenance(&self) -> Option<serde_json::Value> {
        let payload = self.open().ok()?.section(SectionKind::PROVENANCE)?.payload(&self.limits()).ok()?;
        serde_json::from_slice(&payload).ok()
    }

    fn payload(&self, table: Table) -> Result<(Section<'_>, Cow<'_, [u8]>), Failure> {
        let missing = || {
            let present = self.tables().map(|tables| list_tables(&tables)).unwrap_or_default();
            self.content(format!("there is no {} table; the file has {present}", table.name()))
        };
        let section = self.open()?.section(table.kind()).ok_or_else(missing)?;
        if !section.is_intact() {
            return Err(self.damaged(table, "the checksum does not match; the file is damaged"));
        }
        let payload = section.payload(&self.limits()).map_err(|error| self.damaged(table, error))?;
        Ok((section, payload))
    }

    fn damaged(&self, table: Table, error: impl std::fmt::Display) -> Failure {
        self.content(format!("{}: {error}", table.name()))
    }
}

/// The curvature of a mesh, decoded.
pub(crate) struct DecodedCurvature<'a> {
    pub(crate) descriptor: CurvatureDescriptor,
    payload: Cow<'a, [u8]>,
}

impl DecodedCurvature<'_> {
    /// The table as numbers.
    pub(crate) fn view(&self) -> CurvatureView<'_> {
        CurvatureView::new(self.descriptor, &self.payload).expect("checked when it was decoded")
    }
}

impl DecodedTable<'_> {
    /// The table as numbers.
    pub(crate) fn view(&self) -> TableView<'_> {
        TableView::new(self.descriptor, &self.payload).expect("checked when it was decoded")
    }

    /// The azimuth of a layer in degrees; 0 where there is no direction.
    pub(crate) fn azimuth_degrees(&self, layer: u32) -> f64 {
        let radians = self.descriptor.azimuths().map_or(0.0, |azimuths| azimuths.radians(self.direction(layer)));
        // As somebody wrote it, where it was written in degrees.
        (radians.to_degrees() * 1e9).round() / 1e9
    }

    /// The direction of a layer, counted from 0.
    pub(crate) fn direction(&self, layer: u32) -> u32 {
        layer % self.directions()
    }

    /// The candidate of a layer of a swept table, or the ring of one of a hemisphere table, counted from 0.
    pub(crate) fn candidate_or_ring(&self, layer: u32) -> u32 {
        layer / self.directions()
    }

    /// Where a ring of a hemisphere table begins, in degrees from the normal.
    pub(crate) fn polar_degrees(&self, ring: u32) -> f64 {
        self.descriptor.directions().map_or(0.0, |directions| libm::atan(directions.tangent_of_edge(ring)).to_degrees())
    }

    fn directions(&self) -> u32 {
        self.descriptor.azimuths().map_or(1, |azimuths| azimuths.count()).max(1)
    }
}

/// `height, horizon and distance`, or `no table`.
pub(crate) fn list_tables(tables: &[Table]) -> String {
    list(&tables.iter().map(|table| table.name()).collect::<Vec<_>>())
}

/// [`list_tables`] of names.
pub(crate) fn list(names: &[&str]) -> String {
    match names.split_last() {
        None => "no table".to_owned(),
        Some((last, [])) => (*last).to_owned(),
        Some((last, first)) => format!("{} and {last}", first.join(", ")),
    }
}
