//! Where values go: encoded, measured and written, a layer at a time.

use std::io::{Read, Seek, Write};
use std::ops::RangeInclusive;

use barchan_asset::{
    AssetStream, Azimuths, Codec, EncodeError, EncodedCurvature, Encoding, EncodingLoss, TableEncoder, TableFacts,
    TableView, TextureDescriptor, TextureTable,
};

use crate::clock::Clock;
use crate::{PipelineError, Table};

/// The file being written, what is known of the tables it has, and the time that goes into it.
pub(crate) struct Sink<'a, W> {
    pub(crate) stream: AssetStream<W>,
    pub(crate) clock: Clock<'a>,
    pub(crate) written: Vec<WrittenTable>,
    codec: Codec,
}

/// A table that is in the file.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WrittenTable {
    pub(crate) table: Table,
    pub(crate) descriptor: TextureDescriptor,
    pub(crate) loss: EncodingLoss,
}

/// A table whose layers are still coming.
pub(crate) struct OpenTable {
    table: Table,
    encoder: TableEncoder,
    bounds: RangeInclusive<f32>,
    /// The stored form of the last layer; kept, so that memory is asked for once.
    bytes: Vec<u8>,
}

fn refused(table: Table) -> impl Fn(EncodeError) -> PipelineError {
    move |error| PipelineError::Encode { table: table.name(), error }
}

impl<'a, W: Read + Write + Seek> Sink<'a, W> {
    pub(crate) fn new(out: W, codec: Codec, clock: Clock<'a>) -> Self {
        Self { stream: AssetStream::new(out), clock, written: Vec::new(), codec }
    }

    /// Encodes and writes a table that is there as a whole: `encode` gives its stored form.
    pub(crate) fn whole(
        &mut self,
        table: Table,
        encode: impl FnOnce() -> Result<TextureTable, EncodeError>,
    ) -> Result<(), PipelineError> {
        let encoded = self.encode(table, encode)?;
        self.encoded(table, &encoded)
    }

    /// Encodes a table.
    pub(crate) fn encode(
        &mut self,
        table: Table,
        encode: impl FnOnce() -> Result<TextureTable, EncodeError>,
    ) -> Result<TextureTable, PipelineError> {
        self.clock.time("encode", encode).map_err(refused(table))
    }

    /// Writes a table in its stored form.
    pub(crate) fn encoded(&mut self, table: Table, encoded: &TextureTable) -> Result<(), PipelineError> {
        self.clock.time("write", || self.stream.add_table(encoded, self.codec).map(|_| ()))?;
        let loss = encoded.loss().unwrap_or_default();
        self.written.push(WrittenTable { table, descriptor: *encoded.descriptor(), loss });
        Ok(())
    }

    /// Writes the curvature of a mesh.
    pub(crate) fn curvature(&mut self, encoded: &EncodedCurvature) -> Result<(), PipelineError> {
        self.clock.time("write", || self.stream.add_curvature(encoded, self.codec).map(|_| ()))?;
        Ok(())
    }

    /// Makes room for a table whose values are known to be within `bounds`.
    pub(crate) fn open(
        &mut self,
        table: Table,
        facts: &TableFacts,
        encoding: Encoding,
        bounds: RangeInclusive<f32>,
    ) -> Result<OpenTable, PipelineError> {
        let encoder = TableEncoder::new(facts, encoding, bounds.clone()).map_err(refused(table))?;
        self.stream.open_table(encoder.descriptor(), self.codec)?;
        Ok(OpenTable { table, encoder, bounds, bytes: Vec::new() })
    }

    /// Encodes and writes a layer.
    pub(crate) fn layer(&mut self, open: &mut OpenTable, layer: u32, values: &[f32]) -> Result<(), PipelineError> {
        open.bytes.clear();
        let encode = || {
            let measure = open.encoder.encode(values, &mut open.bytes)?;
            open.encoder.record(layer, measure)
        };
        self.clock.time("encode", encode).map_err(refused(open.table))?;
        self.clock.time("write", || self.stream.layer(open.table.kind(), layer, &open.bytes))?;
        Ok(())
    }

    /// Closes a table that has all its layers.
    pub(crate) fn close(&mut self, open: OpenTable) -> Result<(), PipelineError> {
        let (descriptor, loss) = open.encoder.finish().map_err(refused(open.table))?;
        self.clock.time("write", || self.stream.close_table(&descriptor))?;
        self.written.push(WrittenTable { table: open.table, descriptor, loss });
        Ok(())
    }
}

impl OpenTable {
    /// What values are cut to.
    pub(crate) fn bounds(&self) -> &RangeInclusive<f32> {
        &self.bounds
    }

    /// The last layer as a reader will decode it.
    pub(crate) fn last_layer(&self) -> TableView<'_> {
        let alone = Azimuths::full_circle(1);
        let descriptor = self.encoder.descriptor();
        let descriptor = TextureDescriptor {
            layers: 1,
            candidates: descriptor.candidates.min(1),
            rings: descriptor.rings.min(1),
            first_azimuth: alone.first_radians(),
            azimuth_step: alone.step_radians(),
            ..*descriptor
        };
        TableView::new(descriptor, &self.bytes).expect("a layer of a table is a table of one layer")
    }
}
