//! A file written layer by layer is the file written at once, and a failing disk is a clear error.

use std::io::{Cursor, Error, ErrorKind, Read, Seek, SeekFrom, Write};

use barchan_asset::{
    Asset, AssetStream, AssetWriter, Azimuths, Codec, DistanceTable, Encoding, HorizonTable, LengthUnit, Limits,
    RawSection, SectionKind, TableEncoder, TableGrid, TextureTable, Wrap, WriteError, content_identity, validate,
};
use proptest::prelude::*;

fn grid(width: u32, height: u32) -> TableGrid {
    let (length_unit, wrap) = (LengthUnit::Metre, Wrap::Repeat);
    TableGrid { width, height, spacing_u: 2.0, spacing_v: 0.5, length_unit, wrap_u: wrap, wrap_v: wrap }
}

/// `count` values between 0 and 1 in no particular order.
fn values(count: u32) -> Vec<f32> {
    (0..count).map(|i| (i * 37 % 101) as f32 / 100.0).collect()
}

/// Elevations and distances in memory.
fn tables(grid: TableGrid, azimuths: Azimuths, values: &[f32], encoding: Encoding) -> [TextureTable; 2] {
    let horizon = HorizonTable { grid, azimuths, radius: 2.0, values };
    let distance = DistanceTable { grid, azimuths, radius: 2.0, values };
    [horizon.encode(encoding).unwrap(), distance.encode(encoding).unwrap()]
}

/// The same through encoders and a stream, direction by direction from the last to the first.
fn streamed(grid: TableGrid, azimuths: Azimuths, values: &[f32], encoding: Encoding, codec: Codec) -> Vec<u8> {
    let horizon = HorizonTable { grid, azimuths, radius: 2.0, values };
    let distance = DistanceTable { grid, azimuths, radius: 2.0, values };
    let least = values.iter().copied().fold(f32::INFINITY, f32::min);
    let greatest = values.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    let mut encoders =
        [horizon.facts(), distance.facts()].map(|facts| TableEncoder::new(&facts, encoding, least..=greatest).unwrap());
    let mut stream = AssetStream::new(Cursor::new(Vec::new()));
    for encoder in &encoders {
        stream.open_table(encoder.descriptor(), codec).unwrap();
    }
    let layer_values = (grid.width * grid.height) as usize;
    for k in (0..azimuths.count()).rev() {
        for encoder in &mut encoders {
            let layer = encoder.layer(k, &values[k as usize * layer_values..][..layer_values]).unwrap();
            stream.layer(encoder.descriptor().semantic.kind(), k, &layer).unwrap();
        }
    }
    for encoder in encoders {
        stream.close_table(&encoder.finish().unwrap().0).unwrap();
    }
    stream.provenance("{}").unwrap();
    let finished = stream.finish().unwrap();
    let file = finished.out.into_inner();
    assert_eq!(finished.bytes, file.len() as u64);
    assert_eq!(finished.identity, Asset::open(&file).unwrap().identity());
    file
}

fn written(tables: [TextureTable; 2], codec: Codec) -> Vec<u8> {
    let mut writer = AssetWriter::new();
    for table in tables {
        writer.add_table(table, codec).unwrap();
    }
    writer.provenance("{}").unwrap();
    writer.finish().unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn streaming_gives_the_bytes_of_the_writer(
        width in 1..90_u32, height in 1..5_u32, count in 1..6_u32, arc in any::<bool>(),
        encoding in prop::sample::select(Encoding::ALL.to_vec()),
        codec in prop::sample::select(vec![Codec::Raw, Codec::Zstd]),
    ) {
        let grid = grid(width, height);
        let azimuths = if arc { Azimuths::arc(-0.3, 1.2, count) } else { Azimuths::full_circle(count) };
        let values = values(width * height * count);
        let file = streamed(grid, azimuths, &values, encoding, codec);
        prop_assert!(file == written(tables(grid, azimuths, &values, encoding), codec));
        prop_assert_eq!(validate(&file, &Limits::default()), []);
        let asset = Asset::open(&file).unwrap();
        prop_assert_eq!(content_identity(&asset, &Limits::default()).unwrap(), asset.identity());
    }
}

#[test]
fn what_was_in_the_file_before_its_padding_is_overwritten() {
    let [table, _] = tables(grid(3, 2), Azimuths::full_circle(2), &values(12), Encoding::U8);
    let write = |out: Vec<u8>| {
        let mut stream = AssetStream::new(Cursor::new(out));
        stream.provenance("{}").unwrap().add_table(&table, Codec::Raw).unwrap();
        stream.finish().unwrap().out.into_inner()
    };
    let clean = write(Vec::new());
    assert!(write(vec![0xAA; clean.len()]) == clean);
}

#[test]
fn calls_out_of_turn_are_refused() {
    let [table, other] = tables(grid(3, 2), Azimuths::full_circle(2), &values(12), Encoding::U8);
    let horizon = SectionKind::HORIZON;
    for codec in [Codec::Raw, Codec::Zstd] {
        let mut stream = AssetStream::new(Cursor::new(Vec::new()));
        assert!(matches!(stream.layer(horizon, 0, &[0; 6]), Err(WriteError::NotOpen { .. })));
        stream.open_table(table.descriptor(), codec).unwrap();
        let again = stream.open_table(table.descriptor(), codec);
        assert!(matches!(again, Err(WriteError::Duplicate { .. })));
        assert!(matches!(stream.layer(horizon, 0, &[0; 5]), Err(WriteError::Layer { found: 5, expected: 6, .. })));
        assert!(matches!(stream.layer(horizon, 2, &[0; 6]), Err(WriteError::Layer { layer: 2, layers: 2, .. })));
        stream.layer(horizon, 1, &[0; 6]).unwrap();
        let missing = stream.close_table(table.descriptor());
        assert!(matches!(missing, Err(WriteError::MissingLayer { layer: 0, .. })));
        stream.layer(horizon, 0, &[0; 6]).unwrap();
        let mut wider = *table.descriptor();
        wider.width += 1;
        assert!(matches!(stream.close_table(&wider), Err(WriteError::Changed { .. })));
        wider.width = 0;
        assert!(matches!(stream.close_table(&wider), Err(WriteError::Descriptor { .. })));
        assert!(matches!(stream.close_table(other.descriptor()), Err(WriteError::NotOpen { .. })));
        assert!(matches!(stream.finish(), Err(WriteError::NotClosed { kind: SectionKind::HORIZON })));
    }
}

/// Sections `0000`, `0001` and so on.
fn many(writer: &mut AssetWriter, count: usize) -> Result<(), WriteError> {
    for i in 0..count {
        let name = format!("{i:04}");
        let kind = SectionKind(name.as_bytes().try_into().unwrap());
        let section = RawSection { kind, critical: false, version: 1, descriptor: b"d", payload: b"p" };
        writer.raw_section(&section, Codec::Raw)?;
    }
    Ok(())
}

#[test]
fn the_first_section_stands_where_the_number_of_sections_puts_it() {
    for (room, count) in [(1, 62), (62, 1), (63, 63), (63, 126), (1000, 1000), (u32::MAX, 1024)] {
        let mut writer = AssetWriter::with_room(room);
        many(&mut writer, count).unwrap();
        let file = writer.finish().unwrap();
        assert_eq!(Asset::open(&file).unwrap().sections().len(), count, "{room}");
    }
    let refused = many(&mut AssetWriter::new(), 63).unwrap_err();
    assert_eq!(refused.to_string(), "there are 63 sections; 1 to 62 are accepted");
    let mut writer = AssetWriter::with_room(63);
    many(&mut writer, 62).unwrap();
    assert_eq!(writer.finish().unwrap_err().to_string(), "there are 62 sections; 63 to 126 are accepted");
}

/// A disk that holds so many bytes, or that forgets how to read.
#[derive(Debug)]
struct Disk {
    bytes: Cursor<Vec<u8>>,
    room: u64,
    readable: bool,
}

impl Write for Disk {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        if self.bytes.position() + bytes.len() as u64 > self.room {
            return Err(Error::from(ErrorKind::StorageFull));
        }
        self.bytes.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

impl Read for Disk {
    fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
        if self.readable { self.bytes.read(bytes) } else { Err(Error::from(ErrorKind::PermissionDenied)) }
    }
}

impl Seek for Disk {
    fn seek(&mut self, to: SeekFrom) -> std::io::Result<u64> {
        self.bytes.seek(to)
    }
}

#[test]
fn a_full_disk_is_an_error_wherever_it_fills() {
    let [table, _] = tables(grid(64, 4), Azimuths::full_circle(3), &values(768), Encoding::F16);
    let write = |room, readable| {
        let mut stream = AssetStream::new(Disk { bytes: Cursor::default(), room, readable });
        stream.add_table(&table, Codec::Raw)?;
        stream.provenance("{}")?;
        stream.finish()
    };
    let length = write(u64::MAX, true).unwrap().bytes;
    for room in (0..length).step_by(61).chain([length - 1]) {
        let error = write(room, true).unwrap_err();
        assert!(matches!(error, WriteError::Io { action: "written", .. }), "{error}");
    }
    let full = write(4100, true).unwrap_err().to_string();
    assert_eq!(full, "the file cannot be written at byte 4096: no storage space");
    let unreadable = write(u64::MAX, false).unwrap_err().to_string();
    assert_eq!(unreadable, "the file cannot be read back at byte 4096: permission denied");
}

#[test]
fn a_failure_that_is_passed_over_spoils_the_file() {
    let [table, _] = tables(grid(64, 4), Azimuths::full_circle(3), &values(768), Encoding::F16);
    let mut stream = AssetStream::new(Disk { bytes: Cursor::default(), room: 5000, readable: true });
    assert!(stream.add_table(&table, Codec::Raw).is_err());
    assert!(matches!(stream.finish(), Err(WriteError::Failed)));
}
