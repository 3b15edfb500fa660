//! Tables for relief search: written, read back, rounded to the side that keeps a bound a bound, and refused.

use barchan_asset::{
    Asset, AssetStream, AssetWriter, Azimuths, Codec, ConeMapTable, ConeMapView, DepthMode, EncodeError, Encoding,
    HeightTable, HemisphereDirections, HemisphereTable, HemisphereView, LengthUnit, Limits, MaximumMipTable,
    MaximumMipView, RelaxedConeMapTable, RelaxedConeMapView, ReliefRange, RingSpacing, SectionKind, TableEncoder,
    TableGrid, TextureTable, Transfer, Wrap, validate,
};

const RELIEF: ReliefRange = ReliefRange { top: 8.0, thickness: 10.0 };

fn grid(width: u32, height: u32) -> TableGrid {
    let (length_unit, wrap) = (LengthUnit::Metre, Wrap::Repeat);
    TableGrid { width, height, spacing_u: 2.0, spacing_v: 0.5, length_unit, wrap_u: wrap, wrap_v: wrap }
}

fn directions(rings: u32, azimuths: Azimuths) -> HemisphereDirections {
    HemisphereDirections { rings, azimuths, spacing: RingSpacing::SquaredTangents, max_polar_radians: 1.3 }
}

/// `count` values between `low` and `high` in no particular order; both ends are among the first hundred.
fn values(count: usize, low: f32, high: f32) -> Vec<f32> {
    (0..count).map(|i| low + (high - low) * ((i * 37 % 101) as f32 / 100.0)).collect()
}

/// Depth and ratio in turn.
fn cones(texels: usize) -> Vec<f32> {
    values(texels, 0.0, 1.0).into_iter().zip(values(texels, 0.0, 3.0)).flat_map(|(d, r)| [d, r * r]).collect()
}

/// Levels of maxima of those heights, as a baker would make them but for the corners.
fn levels(width: usize, height: usize, finest: Vec<f32>) -> Vec<Vec<f32>> {
    let (mut levels, mut extent) = (vec![finest], (width, height));
    while extent != (1, 1) {
        let (fine, coarse) = (levels.last().unwrap(), ((extent.0 / 2).max(1), (extent.1 / 2).max(1)));
        let mut level = vec![f32::NEG_INFINITY; coarse.0 * coarse.1];
        for (i, &value) in fine.iter().enumerate() {
            let (column, row) = ((i % extent.0 / 2).min(coarse.0 - 1), (i / extent.0 / 2).min(coarse.1 - 1));
            level[row * coarse.0 + column] = level[row * coarse.0 + column].max(value);
        }
        (extent, _) = (coarse, levels.push(level));
    }
    levels
}

fn slices(levels: &[Vec<f32>]) -> Vec<&[f32]> {
    levels.iter().map(Vec::as_slice).collect()
}

#[test]
fn every_kind_encoding_and_codec_is_valid_and_ancillary() {
    let heights = values(35, -2.0, 8.0);
    let (levels, cones) = (levels(7, 5, heights.clone()), cones(35));
    let (azimuths, relief) = (Azimuths::arc(-1.0, 2.5, 3), RELIEF);
    for encoding in Encoding::ALL {
        for (codec, mode) in [(Codec::Raw, DepthMode::Nearest), (Codec::Zstd, DepthMode::Conservative)] {
            let (grid, directions, depths) = (grid(7, 5), directions(4, azimuths), values(12 * 35, 0.0, 1.0));
            let mut writer = AssetWriter::new();
            for table in [
                HeightTable { grid, values: &heights }.encode(Encoding::F32),
                HemisphereTable { grid, directions, mode, relief, values: &depths }.encode(encoding),
                ConeMapTable { grid, relief, values: &cones }.encode(encoding),
                RelaxedConeMapTable { grid, relief, values: &cones }.encode(encoding),
                MaximumMipTable { grid, levels: &slices(&levels) }.encode(encoding),
            ] {
                let table = table.unwrap();
                assert!(table.loss().unwrap().max <= table.descriptor().worst_case_error);
                writer.add_table(table, codec).unwrap();
            }
            let file = writer.finish().unwrap();
            assert_eq!(validate(&file, &Limits::default()), [], "{encoding:?} {codec:?}");
            let sections: Vec<_> =
                Asset::open(&file).unwrap().sections().map(|s| (s.is_critical(), s.version())).collect();
            assert_eq!(sections, [(true, 1), (false, 3), (false, 3), (false, 3), (false, 3)]);
        }
    }
}

#[test]
fn what_is_written_exactly_is_read_back() {
    let directions = directions(3, Azimuths::full_circle(4));
    let (depths, mode) = (values(12 * 6, 0.0, 1.0), DepthMode::Conservative);
    let table = HemisphereTable { grid: grid(3, 2), directions, mode, relief: RELIEF, values: &depths };
    let table = table.encode(Encoding::F32).unwrap();
    let view = HemisphereView::new(*table.descriptor(), table.payload()).unwrap();
    assert_eq!((view.directions(), view.mode(), view.relief()), (directions, mode, RELIEF));
    for (i, (layer, row, column)) in (0..72).map(|i| (i as usize, (i / 6, i % 6 / 3, i % 3))) {
        assert_eq!(view.depth(layer, column, row), depths[i]);
    }

    let numbers = cones(6);
    let table = ConeMapTable { grid: grid(3, 2), relief: RELIEF, values: &numbers }.encode(Encoding::F32).unwrap();
    let view = ConeMapView::new(*table.descriptor(), table.payload()).unwrap();
    let found: Vec<f32> = (0..6).flat_map(|i| [view.depth(i % 3, i / 3), view.ratio(i % 3, i / 3)]).collect();
    assert_eq!((found, view.relief()), (numbers.clone(), RELIEF));
    let table = RelaxedConeMapTable { grid: grid(3, 2), relief: RELIEF, values: &numbers };
    let table = table.encode(Encoding::F32).unwrap();
    assert!(RelaxedConeMapView::new(*table.descriptor(), table.payload()).is_ok());
    assert!(ConeMapView::new(*table.descriptor(), table.payload()).is_err());
}

#[test]
fn mip_levels_follow_each_other_256_aligned_down_to_one_texel() {
    let levels = levels(37, 3, values(111, -4.0, 9.0));
    let table = MaximumMipTable { grid: grid(37, 3), levels: &slices(&levels) }.encode(Encoding::F32).unwrap();
    let view = MaximumMipView::new(*table.descriptor(), table.payload()).unwrap();
    let extents: Vec<_> = (0..view.levels()).map(|level| view.extent(level)).collect();
    assert_eq!(extents, [(37, 3), (18, 1), (9, 1), (4, 1), (2, 1), (1, 1)]);
    let offsets: Vec<_> = (0..6).map(|level| table.descriptor().picture_offset(level)).collect();
    assert_eq!(offsets, [0, 512, 768, 1024, 1280, 1536]);
    assert_eq!(table.payload().len(), 1540);
    for (level, values) in (0..).zip(&levels) {
        let (width, height) = view.extent(level);
        let texels = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        let found: Vec<f32> = texels.map(|(column, row)| view.value(level, column, row)).collect();
        assert_eq!(&found, values);
        assert_eq!(view.table().row(level, height - 1).len(), width as usize);
    }
}

#[test]
fn a_table_that_comes_layer_by_layer_is_the_same() {
    let (directions, grid) = (directions(3, Azimuths::full_circle(2)), grid(5, 3));
    let depths = values(6 * 15, 0.0, 1.0);
    let table = HemisphereTable { grid, directions, mode: DepthMode::Conservative, relief: RELIEF, values: &depths };
    let levels = levels(5, 3, values(15, 0.0, 5.0));
    let mips = MaximumMipTable { grid, levels: &slices(&levels) };
    for encoding in Encoding::ALL {
        let pieces: Vec<&[f32]> = depths.chunks(15).collect();
        assert_eq!(streamed(TableEncoder::new(&table.facts(), encoding, 0.0..=1.0).unwrap(), &pieces), {
            let mut writer = AssetWriter::new();
            writer.add_table(table.encode(encoding).unwrap(), Codec::Raw).unwrap();
            writer.finish().unwrap()
        });
    }
    // Levels go into a stream as layers do.
    let whole = mips.encode(Encoding::F16).unwrap();
    let mut stream = AssetStream::new(std::io::Cursor::new(Vec::new()));
    stream.open_table(whole.descriptor(), Codec::Raw).unwrap();
    for level in [2, 0, 1] {
        stream.layer(SectionKind::MAXIMUM_MIP, level, whole.view().unwrap().layer(level)).unwrap();
    }
    stream.close_table(whole.descriptor()).unwrap();
    let mut writer = AssetWriter::new();
    writer.add_table(whole, Codec::Raw).unwrap();
    assert_eq!(stream.finish().unwrap().out.into_inner(), writer.finish().unwrap());
}

fn streamed(mut encoder: TableEncoder, layers: &[&[f32]]) -> Vec<u8> {
    let mut stream = AssetStream::new(std::io::Cursor::new(Vec::new()));
    let (opened, kind) = (*encoder.descriptor(), SectionKind::HEMISPHERE);
    stream.open_table(&opened, Codec::Raw).unwrap();
    for (k, layer) in (0..layers.len() as u32).zip(layers).rev() {
        stream.layer(kind, k, &encoder.layer(k, layer).unwrap()).unwrap();
    }
    stream.close_table(&encoder.finish().unwrap().0).unwrap();
    stream.finish().unwrap().out.into_inner()
}

#[test]
fn compact_cones_are_bytes_of_a_depth_and_of_the_root_of_a_ratio() {
    // Roots 0, ½, 1, 2: bytes 0, 63, 127, 255, rounded down.
    let values = [0.0, 0.0, 0.25, 0.25, 0.5, 1.0, 1.0, 4.0];
    for encoding in [Encoding::U8, Encoding::Compact] {
        let table = ConeMapTable { grid: grid(4, 1), relief: RELIEF, values: &values }.encode(encoding).unwrap();
        assert_eq!((table.descriptor().transfer, table.descriptor().scale), (Transfer::Square, 2.0));
        assert_eq!(table.payload(), [0, 0, 63, 63, 127, 127, 255, 255]);
        let view = ConeMapView::new(*table.descriptor(), table.payload()).unwrap();
        assert_eq!([view.depth(3, 0), view.ratio(3, 0)], [1.0, 4.0]);
        assert_eq!(view.depth(1, 0), 63.0 / 255.0);
    }
}

fn refusal(table: Result<TextureTable, EncodeError>) -> String {
    table.unwrap_err().to_string()
}

#[test]
fn cells_that_no_table_holds_are_refused_in_one_sentence() {
    let message = |change: &dyn Fn(&mut HemisphereDirections)| {
        let mut directions = directions(2, Azimuths::full_circle(2));
        change(&mut directions);
        let (grid, mode) = (grid(1, 1), DepthMode::Conservative);
        refusal(HemisphereTable { grid, directions, mode, relief: RELIEF, values: &[0.5; 4] }.encode(Encoding::U8))
    };
    assert_eq!(message(&|d| d.rings = 0), "rings is 0; 1 to 2048 is accepted");
    assert_eq!(message(&|d| d.azimuths = Azimuths::full_circle(0)), "layers is 0; 1 to 2048 is accepted");
    assert_eq!(message(&|d| d.rings = 1025), "layers is 2050; 1 to 2048 is accepted");
    assert_eq!(message(&|d| d.rings = u32::MAX), "rings is 4294967295; 1 to 2048 is accepted");
    let right_angle = std::f64::consts::FRAC_PI_2;
    for (max, printed) in [(right_angle, "1.5707963267948966"), (0.0, "0"), (-1.0, "-1"), (f64::NAN, "NaN")] {
        let expected = format!("max_polar is {printed}; accepted: above 0 and below π/2");
        assert_eq!(message(&|d| d.max_polar_radians = max), expected);
    }
    assert_eq!(
        message(&|d| d.azimuths = Azimuths::arc(0.5, 0.5, 1)),
        "azimuth_step is 0; accepted: above 0: hemisphere depths want an arc of two azimuths or more"
    );
    assert!(message(&|d| d.azimuths = Azimuths::arc(0.0, 7.0, 3)).starts_with("3 azimuths from 0 by 3.5; accepted"));
}

#[test]
fn values_that_no_table_holds_are_refused_with_their_place() {
    let (relief, mode) = (RELIEF, DepthMode::Nearest);
    let directions = directions(1, Azimuths::full_circle(2));
    for encoding in Encoding::ALL {
        for depth in [-0.25, 1.000_001, f32::NAN] {
            let values = [0.0, 1.0, 0.5, depth];
            let table = HemisphereTable { grid: grid(2, 1), directions, mode, relief, values: &values };
            assert_eq!(refusal(table.encode(encoding)), format!("value 3 is {depth}; 0 to 1 is accepted"));
            let table = ConeMapTable { grid: grid(2, 1), relief, values: &[0.5, 2.0, depth, 1.0] };
            assert_eq!(refusal(table.encode(encoding)), format!("value 2 is {depth}; 0 to 1 is accepted"));
        }
        for ratio in [-0.25, f32::INFINITY, f32::NAN] {
            let table = RelaxedConeMapTable { grid: grid(2, 1), relief, values: &[0.5, 2.0, 0.5, ratio] };
            assert!(refusal(table.encode(encoding)).starts_with(&format!("value 3 is {ratio}; 0 to ")));
        }
        let table = MaximumMipTable { grid: grid(2, 1), levels: &[&[0.0, f32::NAN], &[1.0]] };
        assert!(refusal(table.encode(encoding)).starts_with("value 1 is NaN"));
    }
    let table = ConeMapTable { grid: grid(2, 1), relief, values: &[0.5; 3] };
    assert_eq!(refusal(table.encode(Encoding::F32)), "there are 3 values; the extent asks for 4");
    let relief = ReliefRange { top: 0.0, thickness: -1.0 };
    let table = ConeMapTable { grid: grid(2, 1), relief, values: &[0.5; 4] };
    assert_eq!(refusal(table.encode(Encoding::F32)), "relief_thickness is -1; accepted: 0 or more and finite");
}

#[test]
fn levels_that_do_not_lead_to_one_texel_are_refused() {
    let encode = |levels: &[&[f32]]| refusal(MaximumMipTable { grid: grid(3, 2), levels }.encode(Encoding::F16));
    assert_eq!(encode(&[&[0.0; 6]]), "there are 1 mip levels; 2 is accepted, the last of one texel");
    assert_eq!(encode(&[&[0.0; 6], &[0.0], &[0.0]]), "there are 3 mip levels; 2 is accepted, the last of one texel");
    assert_eq!(encode(&[&[0.0; 6], &[0.0; 2]]), "there are 2 values; the extent asks for 1");
    assert_eq!(encode(&[&[0.0; 5], &[0.0]]), "there are 5 values; the extent asks for 6");
}
