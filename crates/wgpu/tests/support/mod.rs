//! Files and engines of tests.
#![allow(dead_code, reason = "each test uses a part of it")]

use barchan_asset::{
    AssetWriter, Azimuths, Codec, Encoding, HeightTable, HorizonTable, LengthUnit, Semantic, TableGrid, TextureTable,
    Wrap, vectors,
};
use barchan_wgpu::{DeviceLimits, Reader, Selection, TexturePlan, UploadPlan};

/// A published vector.
pub(crate) fn vector(name: &str) -> Vec<u8> {
    vectors::all().unwrap().into_iter().find(|vector| vector.name == name).unwrap().bytes
}

/// Every published vector that is to be read, with its name.
pub(crate) fn accepted() -> Vec<vectors::Vector> {
    let mut all = vectors::all().unwrap();
    all.retain(|vector| !vector.name.starts_with("refused/"));
    all
}

/// A device that holds whatever a file can.
pub(crate) const ROOMY: DeviceLimits = DeviceLimits {
    max_2d: 65_536,
    max_3d: 16_384,
    max_layers: 2048,
    filters_float32: true,
    max_buffer: u64::MAX,
    guesses_cubes: false,
};

pub(crate) fn plan(reader: &Reader<'_>, selection: &Selection) -> UploadPlan {
    UploadPlan::new(reader, selection, &ROOMY).unwrap()
}

pub(crate) fn square(side: u32, wrap: Wrap) -> TableGrid {
    TableGrid {
        width: side,
        height: side,
        spacing_u: 1.0,
        spacing_v: 1.0,
        length_unit: LengthUnit::Metre,
        wrap_u: wrap,
        wrap_v: wrap,
    }
}

pub(crate) fn file(tables: Vec<TextureTable>) -> Vec<u8> {
    let mut writer = AssetWriter::new();
    for table in tables {
        writer.add_table(table, Codec::Raw).unwrap();
    }
    writer.finish().unwrap()
}

/// Heights that differ from texel to texel.
pub(crate) fn heights(side: u32, wrap: Wrap, encoding: Encoding) -> TextureTable {
    let values: Vec<f32> = (0..side * side).map(|i| (i % 11) as f32).collect();
    HeightTable { grid: square(side, wrap), values: &values }.encode(encoding).unwrap()
}

/// Elevations that differ from azimuth to azimuth.
pub(crate) fn horizon(side: u32, azimuths: u32, wrap: Wrap, encoding: Encoding) -> TextureTable {
    let layer = |k| (0..side * side).map(move |i| 0.01 * k as f32 + 0.001 * (i % 7) as f32);
    let values: Vec<f32> = (0..azimuths).flat_map(layer).collect();
    let azimuths = Azimuths::full_circle(azimuths);
    HorizonTable { grid: square(side, wrap), azimuths, radius: 9.0, values: &values }.encode(encoding).unwrap()
}

/// What an engine's images hold after the copies of a plan: the bytes of each layer, or of each level.
pub(crate) fn carried_out(reader: &Reader<'_>, texture: &TexturePlan) -> Vec<Vec<u8>> {
    let payload = reader.payload(texture.table.kind()).unwrap();
    let mut images = vec![None; (texture.layers.max(texture.levels)) as usize];
    for copy in &texture.copies {
        let bytes = copy.of(&payload).unwrap();
        assert_eq!(copy.bytes_per_row, copy.extent.0 * texture.format.texel_bytes());
        let picture = copy.bytes_per_row as usize * copy.extent.1 as usize;
        assert_eq!(bytes.len(), picture * copy.layers as usize);
        let halved = |texels: u32| (texels >> copy.level).max(1);
        assert_eq!(copy.extent, (halved(texture.extent.0), halved(texture.extent.1)));
        for (k, layer) in bytes.chunks_exact(picture).enumerate() {
            let place = copy.level as usize + copy.first_layer as usize + k;
            assert!(images[place].replace(layer.to_vec()).is_none(), "picture {place} is written twice");
        }
    }
    images.into_iter().map(Option::unwrap).collect()
}

/// The bytes of a picture of a table, straight from the file.
pub(crate) fn stored(reader: &Reader<'_>, table: Semantic, picture: u32) -> Vec<u8> {
    let descriptor = reader.texture(table).unwrap().descriptor;
    let payload = reader.payload(table.kind()).unwrap();
    let start = descriptor.picture_offset(picture) as usize;
    payload[start..][..descriptor.picture_bytes(picture) as usize].to_vec()
}
