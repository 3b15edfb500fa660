//! Bytes that lie: never a panic, never memory on the word of a header.

mod common;

use std::{fs, io::Cursor};

use barchan_import::{Fill, HeightMapOptions, decode_height_map};
use common::{
    damage::{Random, mutate, peak_bytes},
    file, folder, npy, options,
};

/// Overwrites bytes.
fn patched(mut bytes: Vec<u8>, patches: &[(usize, &[u8])]) -> Vec<u8> {
    for (at, patch) in patches {
        bytes[*at..at + patch.len()].copy_from_slice(patch);
    }
    bytes
}

/// PNG chunks with the checksums their contents ask for: a decoder that checks them sees little else of a mutation.
fn with_checksums(mut png: Vec<u8>) -> Vec<u8> {
    let mut at = 8;
    while let Some(head) = png.get(at..at + 4) {
        let len = u32::from_be_bytes([head[0], head[1], head[2], head[3]]) as usize;
        let Some(content) = png.get(at + 4..at + 8 + len) else { break };
        let sum = crc32fast::hash(content).to_be_bytes();
        let Some(place) = png.get_mut(at + 8 + len..at + 12 + len) else { break };
        place.copy_from_slice(&sum);
        at += 12 + len;
    }
    png
}

#[test]
fn a_header_alone_allocates_nothing() {
    let side = 60_000_u32;
    let png = with_checksums(patched(file("grey16.png"), &[(16, &side.to_be_bytes()), (20, &side.to_be_bytes())]));
    let exr = file("window.exr");
    let window = exr.windows(11).position(|name| name == b"dataWindow\0").unwrap() + 11 + 6 + 4;
    let corners = [0, 0, side - 1, side - 1].map(u32::to_le_bytes).concat();
    let exr = patched(exr, &[(window, &corners)]);
    let tiff = file("gdal_nodata.tif");
    let value = |tag: u16| tiff.windows(4).position(|e| e == [tag as u8, (tag >> 8) as u8, 4, 0]).unwrap() + 8;
    let (width, height) = (value(256), value(257));
    let tiff = patched(tiff, &[(width, &side.to_le_bytes()), (height, &side.to_le_bytes())]);
    let npy = npy("<f4", false, side.into(), side.into(), &[0; 64]);

    for (format, bytes, sample_bytes) in [("PNG", png, 2), ("EXR", exr, 4), ("TIFF", tiff, 4), ("NPY", npy, 4)] {
        let texels = 3_600_000_000_u64;
        assert_eq!(
            decode_height_map(&bytes, &options()).unwrap_err().to_string(),
            format!("the {format} image has 60000 × 60000 texels; `max_texels` accepts 1073741824")
        );
        let options = HeightMapOptions { max_texels: u64::MAX, ..options() };
        assert_eq!(
            decode_height_map(&bytes, &options).unwrap_err().to_string(),
            format!(
                "the {format} header promises 60000 × 60000 texels, {} bytes of samples; \
                 a file of {} bytes can hold {} at most",
                texels * sample_bytes,
                bytes.len(),
                bytes.len() * 2048
            )
        );
    }
}

#[test]
fn max_texels_is_the_callers() {
    let options = |max_texels| HeightMapOptions { max_texels, ..options() };
    for name in ["grey16.png", "f32_tiled_lzw_p3.tif", "tiled.exr", "f32.npy"] {
        assert!(decode_height_map(&file(name), &options(35)).is_ok(), "{name}");
        let refused = decode_height_map(&file(name), &options(34)).unwrap_err().to_string();
        assert!(refused.ends_with("has 7 × 5 texels; `max_texels` accepts 34"), "{refused}");
    }
}

/// A constant map is what compressors shrink most; it must not be taken for a lie.
#[test]
fn the_densest_honest_files_pass() {
    let side = 1500;
    let mut png = Cursor::new(Vec::new());
    let encoder = image::codecs::png::PngEncoder::new_with_quality(
        &mut png,
        image::codecs::png::CompressionType::Best,
        image::codecs::png::FilterType::NoFilter,
    );
    image::ImageBuffer::<image::Luma<u16>, _>::from_pixel(side, side, image::Luma([0]))
        .write_with_encoder(encoder)
        .unwrap();
    assert!(decode_height_map(png.get_ref(), &options()).is_ok());

    use tiff::encoder::{Compression, DeflateLevel, TiffEncoder, colortype::Gray32Float};
    for (name, compression) in [("LZW", Compression::Lzw), ("deflate", Compression::Deflate(DeflateLevel::Best))] {
        let mut bytes = Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut bytes).unwrap().with_compression(compression);
        let mut image = encoder.new_image::<Gray32Float>(side, side).unwrap();
        image.rows_per_strip(side).unwrap();
        image.write_data(&vec![0.0; (side * side) as usize]).unwrap();
        let file = bytes.into_inner();
        assert!(file.len() < 10_000, "{name} wrote {} bytes", file.len());
        assert!(decode_height_map(&file, &options()).is_ok(), "{name}");
    }
}

/// Every file of the folder, cut at every length, and thousands of times changed in a few places.
#[test]
fn no_damage_makes_a_panic() {
    let options = HeightMapOptions { fill: Some(Fill::Nearest), ..options() };
    let before = peak_bytes();
    let mut names: Vec<_> = fs::read_dir(folder()).unwrap().map(|entry| entry.unwrap().path()).collect();
    names.sort();
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut files, mut whole) = (0, 0);
    for path in names.iter().filter(|path| !matches!(path.extension().unwrap().to_str(), Some("md" | "py"))) {
        let original = fs::read(path).unwrap();
        let is_png = path.extension().unwrap() == "png";
        for len in 0..original.len() {
            let cut = decode_height_map(&original[..len], &options);
            let is_unread_tail = is_png && len > original.len() - 16;
            assert!(cut.is_err() || is_unread_tail || path.extension().unwrap() == "tif", "{path:?} cut to {len}");
        }
        for _ in 0..3000 {
            let mutated = mutate(&original, &mut random);
            let mutated = if is_png { with_checksums(mutated) } else { mutated };
            whole += usize::from(decode_height_map(&mutated, &options).is_ok());
        }
        files += 1;
    }
    assert!(files > 25 && whole > 0);
    if let (Some(before), Some(after)) = (before, peak_bytes()) {
        assert!(after - before < 256 << 20, "{} MiB more", (after - before) >> 20);
    }
}
