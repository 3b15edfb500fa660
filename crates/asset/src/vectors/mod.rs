//! The published vectors of `formats/vectors/v1`, as this version makes them, and how to make damaged ones.
//!
//! A published vector never changes. The vectors are the conformance suite: a reader in any language must read those in
//! the folder itself to the values that `tests/vectors.rs` states, and refuse those under `refused/`.

mod curvature;
mod relief;

use core::f64::consts::FRAC_PI_4;
use core::ops::Range;
use std::vec;
use std::vec::Vec;

use crate::asset::{
    FILE_SIZE_AT, HEADER_BYTES, HEADER_CRC_AT, MAJOR_AT, MINOR_AT, OPTIONAL_AT, REQUIRED_AT, RESERVED_AT,
    SECTION_COUNT_AT, table_end,
};
use crate::bytes::{put, u32_at};
use crate::entry::{ENTRY_BYTES, Entry, VERSION_AT};
use crate::{
    ApertureConeTable, AssetWriter, Azimuths, BentNormalTable, Codec, CurvatureSweep, DistanceTable, Encoding,
    HeightTable, HorizonTable, LengthUnit, MAX_ELEVATION, MAX_SECTIONS, RawSection, SectionKind, SkyVisibilityTable,
    SweptDistanceTable, SweptHorizonTable, TableGrid, Wrap, WriteError, crc,
};

pub use curvature::{CURVED, CurvedVertex, PRINCIPAL};
pub use relief::{RELIEF, RELIEF_RANGE, cone_ratio, hemisphere_depth, maxima};

/// One published file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Vector {
    /// Its path below `formats/vectors/v1`, with `/` and without `.barchan`.
    pub name: &'static str,
    /// Its bytes.
    pub bytes: Vec<u8>,
}

/// The heights of every `height-…` vector, row by row from the top of the picture.
pub const HEIGHTS: [f32; 6] = [0.0, 1.0, 2.5, -1.0, 0.25, 4.0];

/// Every published vector.
///
/// # Errors
/// None, unless this crate is broken.
pub fn all() -> Result<Vec<Vector>, WriteError> {
    let vector = |name, bytes| Vector { name, bytes };
    Ok(vec![
        vector("height-f32-repeat", heights(grid(Wrap::Repeat, Wrap::Repeat), Encoding::F32)?),
        vector("height-f16-clamp", heights(grid(Wrap::Clamp, Wrap::Clamp), Encoding::F16)?),
        vector("height-u8-repeat-clamp", heights(grid(Wrap::Repeat, Wrap::Clamp), Encoding::U8)?),
        vector("height-u8-constant", constant()?),
        vector("height-f32-stored-zstd-block", stored_zstd_block()?),
        vector("horizon-f32-extremes", extremes()?),
        vector("horizon-distance-f16", directional(Encoding::F16, Codec::Raw)?),
        vector("horizon-distance-u8-zstd", directional(Encoding::U8, Codec::Zstd)?),
        vector("horizon-distance-compact", directional(Encoding::Compact, Codec::Raw)?),
        vector("horizon-arc", arc()?),
        vector("swept-horizon", swept()?),
        vector("sky-f32", sky(Encoding::F32)?),
        vector("sky-f16", sky(Encoding::F16)?),
        vector("sky-compact", sky(Encoding::Compact)?),
        vector("curvature-f32", curvature::everything(Encoding::F32)?),
        vector("curvature-f16", curvature::everything(Encoding::F16)?),
        vector("curvature-principal", curvature::principal()?),
        vector("relief-f32", relief::everything(Encoding::F32)?),
        vector("relief-f16", relief::everything(Encoding::F16)?),
        vector("relief-compact", relief::everything(Encoding::Compact)?),
        vector("hemisphere-arc", relief::arc()?),
        vector("unknown-ancillary", with_note(false)?),
        vector("newer-minor", newer_minor()?),
        vector("refused/unknown-critical", with_note(true)?),
        vector("refused/newer-section", newer_section()?),
        vector("refused/unknown-major", patched(&[(MAJOR_AT, &[2, 0])])?),
        vector("refused/required-feature", patched(&[(REQUIRED_AT, &[0, 0, 1])])?),
        vector("refused/newline-damage", newline_damage()?),
    ])
}

/// Gives every section of `file` whose place is inside it, and the header, the CRC-32 of their bytes, so that a change
/// made on purpose is not taken for damage. The content identity and all else stay as they are.
pub fn reseal(file: &mut [u8]) {
    if file.len() < HEADER_BYTES {
        return;
    }
    let count = u32_at(file, SECTION_COUNT_AT).min(MAX_SECTIONS);
    let Some(table) = usize::try_from(table_end(count)).ok().filter(|&end| end <= file.len()) else { return };
    for row in (HEADER_BYTES..table).step_by(ENTRY_BYTES) {
        let entry = Entry::read(&file[row..row + ENTRY_BYTES]);
        let end = entry.end().filter(|&end| end <= file.len() as u64);
        if let Some(end) = end {
            let crc = crc::update(0, &file[entry.offset as usize..end as usize]);
            put(file, row + 40, &crc.to_le_bytes());
        }
    }
    let crc = crc::of_header(&file[..table], HEADER_CRC_AT);
    put(file, HEADER_CRC_AT, &crc.to_le_bytes());
}

/// 3 × 2 texels of 0.5 m × 0.25 m.
fn grid(wrap_u: Wrap, wrap_v: Wrap) -> TableGrid {
    let length_unit = LengthUnit::Metre;
    TableGrid { width: 3, height: 2, spacing_u: 0.5, spacing_v: 0.25, length_unit, wrap_u, wrap_v }
}

fn heights(grid: TableGrid, encoding: Encoding) -> Result<Vec<u8>, WriteError> {
    let mut writer = AssetWriter::new();
    writer.add_table(HeightTable { grid, values: &HEIGHTS }.encode(encoding)?, Codec::Raw)?;
    writer.finish()
}

fn constant() -> Result<Vec<u8>, WriteError> {
    let grid = TableGrid { length_unit: LengthUnit::Kilometre, ..grid(Wrap::Clamp, Wrap::Clamp) };
    let mut writer = AssetWriter::new();
    writer.add_table(HeightTable { grid, values: &[7.3; 6] }.encode(Encoding::U8)?, Codec::Raw)?;
    writer.finish()
}

/// One texel, one direction each way from level to a wall.
fn extremes() -> Result<Vec<u8>, WriteError> {
    let grid = TableGrid { width: 1, height: 1, length_unit: LengthUnit::SceneUnit, ..grid(Wrap::Clamp, Wrap::Clamp) };
    let values = [MAX_ELEVATION, 0.0, -MAX_ELEVATION];
    let mut writer = AssetWriter::new();
    let table = HorizonTable { grid, azimuths: Azimuths::full_circle(3), radius: 1e-3, values: &values };
    writer.add_table(table.encode(Encoding::F32)?, Codec::Raw)?;
    writer.finish()
}

/// Elevation −0.5 + k/4 + column/16 and distance k + row/4 in direction k of 4, on 16 × 4 texels, and a provenance.
fn directional(encoding: Encoding, codec: Codec) -> Result<Vec<u8>, WriteError> {
    let grid = TableGrid { width: 16, height: 4, ..grid(Wrap::Repeat, Wrap::Repeat) };
    let texels = |value: fn(f32, f32, f32) -> f32| -> Vec<f32> {
        (0..=255_u8).map(|i| value(f32::from(i / 64), f32::from(i % 16), f32::from(i / 16 % 4))).collect()
    };
    let elevations = texels(|k, column, _| -0.5 + k / 4.0 + column / 16.0);
    let distances = texels(|k, _, row| k + row / 4.0);
    let (azimuths, radius) = (Azimuths::full_circle(4), 8.0);
    let mut writer = AssetWriter::new();
    writer.add_table(HorizonTable { grid, azimuths, radius, values: &elevations }.encode(encoding)?, codec)?;
    writer.add_table(DistanceTable { grid, azimuths, radius, values: &distances }.encode(encoding)?, codec)?;
    writer.provenance("{\"made_by\":\"barchan vectors\"}")?;
    writer.finish()
}

/// The elevation of the arc vector's one row: layer k of azimuths −45°, 0° and 45°, `column` 0 or 1.
#[must_use]
pub fn arc_elevation(layer: u32, column: u32) -> f32 {
    layer as f32 / 4.0 - column as f32 / 8.0
}

fn arc() -> Result<Vec<u8>, WriteError> {
    let grid = TableGrid { width: 2, height: 1, ..grid(Wrap::Clamp, Wrap::Clamp) };
    let values: Vec<f32> = (0..3).flat_map(|k| [0, 1].map(|column| arc_elevation(k, column))).collect();
    let azimuths = Azimuths::arc(-FRAC_PI_4, FRAC_PI_4, 3);
    let mut writer = AssetWriter::new();
    writer
        .add_table(HorizonTable { grid, azimuths, radius: 2.0, values: &values }.encode(Encoding::F16)?, Codec::Raw)?;
    writer.finish()
}

/// Elevation and distance of the swept vector's one texel: the horizon is candidate 0, the others follow.
#[must_use]
pub fn swept_point(candidate: u32, direction: u32) -> (f32, f32) {
    (0.75 - candidate as f32 / 4.0 + direction as f32 / 16.0, (1 + candidate + direction) as f32 / 2.0)
}

fn swept() -> Result<Vec<u8>, WriteError> {
    let grid = TableGrid { width: 1, height: 1, ..grid(Wrap::Repeat, Wrap::Repeat) };
    let points = |candidates: Range<u32>| -> (Vec<f32>, Vec<f32>) {
        candidates.flat_map(|candidate| [0, 1, 2].map(|direction| swept_point(candidate, direction))).unzip()
    };
    let (azimuths, radius) = (Azimuths::full_circle(3), 4.0);
    let sweep = CurvatureSweep { candidates: 2, curvature_min: -0.5, curvature_max: 0.25 };
    let ((first, first_distance), (others, distances)) = (points(0..1), points(1..3));
    let encoding = Encoding::Compact;
    let horizon = HorizonTable { grid, azimuths, radius, values: &first }.encode(encoding)?;
    let distance = DistanceTable { grid, azimuths, radius, values: &first_distance }.encode(encoding)?;
    let swept_horizon = SweptHorizonTable { grid, azimuths, radius, sweep, values: &others }.encode(encoding)?;
    let swept_distance = SweptDistanceTable { grid, azimuths, radius, sweep, values: &distances }.encode(encoding)?;
    let mut writer = AssetWriter::new();
    for table in [horizon, distance, swept_horizon, swept_distance] {
        writer.add_table(table, Codec::Raw)?;
    }
    writer.finish()
}

/// What the four texels of the sky vectors see: everything, half, a slanted cone, nothing.
pub const SKY: [SkyTexel; 4] = [
    SkyTexel { visibility: 1.0, axis: [0.0, 0.0, 1.0], cosine: 0.0 },
    SkyTexel { visibility: 0.5, axis: [-0.6, 0.0, 0.8], cosine: 0.25 },
    SkyTexel { visibility: 0.125, axis: [0.28, 0.96, 0.0], cosine: 0.875 },
    SkyTexel { visibility: 0.0, axis: [0.0, 0.0, 1.0], cosine: 1.0 },
];

/// A texel of the sky vectors; the bent normal is the cone's axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkyTexel {
    /// The visible share of the sky.
    pub visibility: f32,
    /// The mean direction: u, v, height.
    pub axis: [f32; 3],
    /// The cosine of the cone's half-angle.
    pub cosine: f32,
}

fn sky(encoding: Encoding) -> Result<Vec<u8>, WriteError> {
    let (grid, radius) = (TableGrid { width: 2, height: 2, ..grid(Wrap::Repeat, Wrap::Clamp) }, 16.0);
    let visibility = SKY.map(|texel| texel.visibility);
    let bent: Vec<f32> = SKY.iter().flat_map(|texel| [texel.axis[0], texel.axis[1]]).collect();
    let cone: Vec<f32> = SKY.iter().flat_map(|texel| texel.axis.into_iter().chain([texel.cosine])).collect();
    let mut writer = AssetWriter::new();
    for table in [
        SkyVisibilityTable { grid, radius, values: &visibility }.encode(encoding)?,
        BentNormalTable { grid, radius, values: &bent }.encode(encoding)?,
        ApertureConeTable { grid, radius, values: &cone }.encode(encoding)?,
    ] {
        writer.add_table(table, Codec::Raw)?;
    }
    writer.finish()
}

/// A horizon in a section version that is yet to come.
fn newer_section() -> Result<Vec<u8>, WriteError> {
    let mut file = extremes()?;
    put(&mut file, HEADER_BYTES + VERSION_AT, &[3, 0]);
    reseal(&mut file);
    Ok(file)
}

/// Heights and a section of a kind that version 1 does not know.
fn with_note(critical: bool) -> Result<Vec<u8>, WriteError> {
    let grid = grid(Wrap::Repeat, Wrap::Repeat);
    let mut writer = AssetWriter::new();
    writer.add_table(HeightTable { grid, values: &HEIGHTS }.encode(Encoding::F16)?, Codec::Raw)?;
    let kind = SectionKind(*b"NOTE");
    let note = RawSection { kind, critical, version: 3, descriptor: b"text/plain", payload: b"dunes" };
    writer.raw_section(&note, Codec::Raw)?;
    writer.finish()
}

/// Heights with bytes overwritten and the checksums set right again.
fn patched(patches: &[(usize, &[u8])]) -> Result<Vec<u8>, WriteError> {
    let mut file = heights(grid(Wrap::Repeat, Wrap::Repeat), Encoding::F16)?;
    for (at, bytes) in patches {
        put(&mut file, *at, bytes);
    }
    reseal(&mut file);
    Ok(file)
}

/// Minor version 3 with an optional feature, and a meaning in all that version 1.0 reserves.
fn newer_minor() -> Result<Vec<u8>, WriteError> {
    let row = HEADER_BYTES;
    patched(&[
        (MINOR_AT, &[3, 0]),
        (OPTIONAL_AT, &[0x80]),
        (RESERVED_AT, b"a later thought"),
        (row + 5, &[0x10]),
        (row + 44, b"another"),
    ])
}

/// A transfer that turned CR LF into LF.
fn newline_damage() -> Result<Vec<u8>, WriteError> {
    let mut file = patched(&[])?;
    file.remove(8);
    Ok(file)
}

/// Heights in a zstd frame that does not compress: a window descriptor, a content size of 4 bytes, one raw block.
fn stored_zstd_block() -> Result<Vec<u8>, WriteError> {
    let mut file = heights(grid(Wrap::Clamp, Wrap::Repeat), Encoding::F32)?;
    let payload_at = file.len() - 24;
    let payload = file.split_off(payload_at);
    file.extend_from_slice(&[0x28, 0xB5, 0x2F, 0xFD, 0x80, 0x00, 24, 0, 0, 0, 24 << 3 | 1, 0, 0]);
    file.extend_from_slice(&payload);
    let (file_size, stored) = (file.len() as u64, (file.len() - payload_at) as u64);
    put(&mut file, FILE_SIZE_AT, &file_size.to_le_bytes());
    put(&mut file, HEADER_BYTES + 10, &Codec::Zstd.number().to_le_bytes());
    put(&mut file, HEADER_BYTES + 24, &stored.to_le_bytes());
    reseal(&mut file);
    Ok(file)
}
