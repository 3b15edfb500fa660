//! A table goes to disk without being held in memory. One test in this file, since it measures the whole process.

use std::alloc::System;

use barchan_asset::{
    AssetStream, Azimuths, Codec, Encoding, LengthUnit, SectionKind, TableEncoder, TableFacts, TableGrid, Wrap,
};
use cap::Cap;

#[global_allocator]
static MEMORY: Cap<System> = Cap::new(System, usize::MAX);

const SIZE: u32 = 512;
const DIRECTIONS: u32 = 256;
/// A layer of values, its bytes, and what is read back at once; twice over.
const MOST_MEMORY: usize = 2 * ((SIZE * SIZE * 5) as usize + (1 << 20));

#[test]
fn a_table_is_written_layer_by_layer() {
    let (length_unit, wrap) = (LengthUnit::Metre, Wrap::Clamp);
    let grid = TableGrid {
        width: SIZE,
        height: SIZE,
        spacing_u: 1.0,
        spacing_v: 1.0,
        length_unit,
        wrap_u: wrap,
        wrap_v: wrap,
    };
    let facts = TableFacts::horizon(grid, Azimuths::full_circle(DIRECTIONS), 100.0);
    let out = tempfile::tempfile().unwrap();
    MEMORY.set_limit(MEMORY.allocated() + MOST_MEMORY).unwrap();

    let mut encoder = TableEncoder::new(&facts, Encoding::U8, 0.0..=1.0).unwrap();
    let mut stream = AssetStream::new(out);
    stream.open_table(encoder.descriptor(), Codec::Raw).unwrap();
    for k in 0..DIRECTIONS {
        let values: Vec<f32> = (0..SIZE * SIZE).map(|i| ((i + k) % 1000) as f32 / 1000.0).collect();
        stream.layer(SectionKind::HORIZON, k, &encoder.layer(k, &values).unwrap()).unwrap();
    }
    let (descriptor, loss) = encoder.finish().unwrap();
    stream.close_table(&descriptor).unwrap();
    let finished = stream.finish().unwrap();
    // A failing assertion wants memory of its own.
    MEMORY.set_limit(usize::MAX).unwrap();
    let payload = u64::from(SIZE) * u64::from(SIZE) * u64::from(DIRECTIONS);
    assert!(payload > 8 * MOST_MEMORY as u64);
    assert_eq!((finished.bytes, loss.values), (4096 + 256 + payload, payload));
    assert_eq!(finished.out.metadata().unwrap().len(), finished.bytes);
}
