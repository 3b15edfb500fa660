//! What is written is read back, whatever the encoding, codec, edge and kind; and the same calls give the same bytes.

use barchan_asset::{
    ApertureConeTable, Asset, AssetWriter, Azimuths, BentNormalTable, Codec, CurvatureSweep, DistanceTable,
    DistanceView, EncodeError, Encoding, HeightTable, HeightView, HorizonTable, HorizonView, LengthUnit, Limits,
    RawSection, SectionKind, SkyVisibilityTable, SweptDistanceTable, SweptHorizonTable, TableGrid, Wrap, WriteError,
    content_identity, validate,
};

fn grid(width: u32, height: u32, wrap: Wrap) -> TableGrid {
    let length_unit = LengthUnit::Metre;
    TableGrid { width, height, spacing_u: 2.0, spacing_v: 0.5, length_unit, wrap_u: wrap, wrap_v: wrap }
}

/// `count` values between `low` and `high` in no particular order.
fn values(count: usize, low: f32, high: f32) -> Vec<f32> {
    (0..count).map(|i| low + (high - low) * ((i * 37 % 101) as f32 / 100.0)).collect()
}

#[test]
fn every_encoding_codec_and_edge_reads_back_within_its_error() {
    let (width, height, azimuths, radius) = (5, 3, Azimuths::full_circle(4), 9.0);
    let elevations = values(60, -0.7, 1.4);
    let distances = values(60, 0.0, 9.0);
    for encoding in Encoding::ALL {
        for codec in [Codec::Raw, Codec::Zstd] {
            for wrap in [Wrap::Repeat, Wrap::Clamp] {
                let grid = grid(width, height, wrap);
                let mut writer = AssetWriter::new();
                let horizon = HorizonTable { grid, azimuths, radius, values: &elevations };
                let distance = DistanceTable { grid, azimuths, radius, values: &distances };
                let heights = HeightTable { grid, values: &elevations[..15] };
                writer.add_table(heights.encode(encoding).unwrap(), codec).unwrap();
                writer.add_table(horizon.encode(encoding).unwrap(), codec).unwrap();
                writer.add_table(distance.encode(encoding).unwrap(), codec).unwrap();
                let file = writer.finish().unwrap();
                assert_eq!(validate(&file, &Limits::default()), []);
                check(&file, &elevations, &distances, wrap);
            }
        }
    }
}

fn check(file: &[u8], elevations: &[f32], distances: &[f32], wrap: Wrap) {
    let asset = Asset::open(file).unwrap();
    let part = |kind| {
        let section = asset.section(kind).unwrap();
        (section.texture().unwrap(), section.payload(&Limits::default()).unwrap())
    };
    let ((hd, hp), (ed, ep), (dd, dp)) =
        (part(SectionKind::HEIGHT), part(SectionKind::HORIZON), part(SectionKind::DISTANCE));
    let height = HeightView::new(hd, &hp).unwrap();
    let horizon = HorizonView::new(ed, &ep).unwrap();
    let distance = DistanceView::new(dd, &dp).unwrap();
    assert_eq!(horizon.wrap(), (wrap, wrap));
    let near = |decoded: f32, value: f32, error: f64| (f64::from(decoded) - f64::from(value)).abs() <= error;
    for (i, (k, row, column)) in (0..60).map(|i| (i, (i / 15, i % 15 / 5, i % 5))) {
        let (value, at) = (elevations[i as usize], horizon.elevation_radians(k, column, row));
        assert!(near(at, value, ed.worst_case_error), "elevation {i}: {at} for {value}");
        let (value, at) = (distances[i as usize], distance.distance(k, column, row));
        assert!(near(at, value, dd.worst_case_error), "distance {i}: {at} for {value}");
        if k == 0 {
            let (value, at) = (elevations[i as usize], height.height_at(column, row));
            assert!(near(at, value, hd.worst_case_error), "height {i}: {at} for {value}");
        }
    }
}

#[test]
fn every_kind_encoding_and_codec_is_valid() {
    let (grid, azimuths, radius) = (grid(5, 2, Wrap::Repeat), Azimuths::arc(-1.0, 2.5, 3), 9.0);
    let sweep = CurvatureSweep { candidates: 2, curvature_min: -1.0, curvature_max: 1.0 };
    let (elevations, distances) = (values(60, -1.5, 1.4), values(60, 0.0, 9.0));
    // A unit vector and a half-angle, over and over; as (u, v) pairs they are within the unit disc as well.
    let directions: Vec<f32> = [0.6, 0.0, 0.8, 0.5, 0.0, -1.0, 0.0, 0.25].into_iter().cycle().take(40).collect();
    for encoding in Encoding::ALL {
        for codec in [Codec::Raw, Codec::Zstd] {
            let mut writer = AssetWriter::new();
            for table in [
                HorizonTable { grid, azimuths, radius, values: &elevations[..30] }.encode(encoding),
                DistanceTable { grid, azimuths, radius, values: &distances[..30] }.encode(encoding),
                SweptHorizonTable { grid, azimuths, radius, sweep, values: &elevations }.encode(encoding),
                SweptDistanceTable { grid, azimuths, radius, sweep, values: &distances }.encode(encoding),
                SkyVisibilityTable { grid, radius, values: &values(10, 0.0, 1.0) }.encode(encoding),
                BentNormalTable { grid, radius, values: &directions[..20] }.encode(encoding),
                ApertureConeTable { grid, radius, values: &directions }.encode(encoding),
            ] {
                let table = table.unwrap();
                assert!(table.loss().unwrap().max <= table.descriptor().worst_case_error);
                writer.add_table(table, codec).unwrap();
            }
            let file = writer.finish().unwrap();
            assert_eq!(validate(&file, &Limits::default()), [], "{encoding:?} {codec:?}");
            let critical: Vec<_> = Asset::open(&file).unwrap().sections().map(|s| s.is_critical()).collect();
            assert_eq!(critical, [true, true, false, false, false, false, false]);
        }
    }
}

#[test]
fn a_row_is_the_values_of_its_texels() {
    let heights = values(15, -3.0, 8.0);
    let table = HeightTable { grid: grid(5, 3, Wrap::Clamp), values: &heights }.encode(Encoding::F16).unwrap();
    let view = table.view().unwrap();
    for row in 0..3 {
        let texels: Vec<f32> = (0..5).map(|column| view.value(0, column, row)).collect();
        assert_eq!(view.row(0, row).collect::<Vec<_>>(), texels);
    }
}

#[test]
fn a_long_row_of_bytes_is_the_values_of_its_texels() {
    let (width, elevations) = (700, values(700, -1.2, 1.5));
    let (grid, azimuths) = (grid(width, 1, Wrap::Clamp), Azimuths::full_circle(1));
    let table = HorizonTable { grid, azimuths, radius: 1.0, values: &elevations };
    for encoding in [Encoding::U8, Encoding::Compact] {
        let table = table.encode(encoding).unwrap();
        let view = table.view().unwrap();
        let texels: Vec<f32> = (0..width).map(|column| view.value(0, column, 0)).collect();
        assert_eq!(view.row(0, 0).collect::<Vec<_>>(), texels);
        let sines: Vec<f32> = (0..width).map(|column| view.before_transfer(0, column, 0, 0)).collect();
        assert_eq!(view.row_before_transfer(0, 0).collect::<Vec<_>>(), sines);
    }
}

#[test]
fn layers_are_256_aligned_and_rows_tight() {
    let table = HorizonTable {
        grid: grid(3, 2, Wrap::Clamp),
        azimuths: Azimuths::full_circle(3),
        radius: 1.0,
        values: &values(18, 0.0, 1.0),
    };
    let table = table.encode(Encoding::F32).unwrap();
    assert_eq!(table.payload().len(), 256 + 256 + 24);
    assert_eq!(table.descriptor().layer_offset(2), 512);
    assert_eq!(table.view().unwrap().layer(1), &table.payload()[256..280]);
}

#[test]
fn the_codec_changes_the_bytes_but_not_the_identity() {
    let heights = vec![1.0; 4096].into_iter().chain(values(4096, 0.0, 9.0)).collect::<Vec<_>>();
    let write = |codec| {
        let mut writer = AssetWriter::new();
        let table = HeightTable { grid: grid(128, 64, Wrap::Repeat), values: &heights };
        writer.add_table(table.encode(Encoding::U8).unwrap(), codec).unwrap().provenance("{}").unwrap();
        writer.finish().unwrap()
    };
    let (raw, zstd) = (write(Codec::Raw), write(Codec::Zstd));
    assert_eq!(zstd, write(Codec::Zstd), "the same calls give the same bytes");
    assert!(zstd.len() < raw.len());
    let [raw, zstd] = [&raw, &zstd].map(|file| Asset::open(file).unwrap());
    assert_eq!(zstd.section(SectionKind::HEIGHT).unwrap().codec(), Some(Codec::Zstd));
    assert_eq!(raw.identity(), zstd.identity());
    assert_eq!(content_identity(&zstd, &Limits::default()).unwrap(), raw.identity());
}

#[test]
fn zstd_that_does_not_help_is_left_out() {
    let mut writer = AssetWriter::new();
    let table = HeightTable { grid: grid(3, 1, Wrap::Clamp), values: &[0.0, 1.0, 5.0] };
    writer.add_table(table.encode(Encoding::F16).unwrap(), Codec::Zstd).unwrap();
    let file = writer.finish().unwrap();
    assert_eq!(Asset::open(&file).unwrap().section(SectionKind::HEIGHT).unwrap().codec(), Some(Codec::Raw));
}

#[test]
fn a_payload_larger_than_the_window_keeps_to_the_window_of_the_format() {
    let payload: Vec<u8> = (0..12_u32 << 20).map(|i| (i / 1000 * 37) as u8).collect();
    let large =
        RawSection { kind: SectionKind(*b"LONG"), critical: false, version: 1, descriptor: &[], payload: &payload };
    let mut writer = AssetWriter::new();
    writer.raw_section(&large, Codec::Zstd).unwrap();
    let file = writer.finish().unwrap();
    let section = Asset::open(&file).unwrap().section(large.kind).unwrap();
    assert_eq!(section.codec(), Some(Codec::Zstd));
    assert!(section.payload(&Limits::default()).unwrap() == payload);
    let small = Limits { max_zstd_window_bytes: 1 << 20, ..Limits::default() };
    assert_eq!(section.payload(&small).unwrap_err().id(), "B0305");
    let tight = Limits { max_decoded_bytes: (12 << 20) - 1, ..Limits::default() };
    assert_eq!(section.payload(&tight).unwrap_err().id(), "B0304");
}

#[test]
fn a_rewrite_keeps_what_it_does_not_know() {
    let note =
        RawSection { kind: SectionKind(*b"NOTE"), critical: false, version: 7, descriptor: b"x", payload: &[9; 999] };
    let mut writer = AssetWriter::new();
    writer.raw_section(&note, Codec::Zstd).unwrap().provenance("{}").unwrap();
    let first = writer.finish().unwrap();

    let mut writer = AssetWriter::new();
    writer.provenance("{\"rewritten\":true}").unwrap();
    writer.copy_unknown(&Asset::open(&first).unwrap(), &Limits::default()).unwrap();
    let second = writer.finish().unwrap();

    let [before, after] = [&first, &second].map(|file| Asset::open(file).unwrap().section(note.kind).unwrap());
    assert_eq!((after.version(), after.is_critical(), after.codec()), (7, false, Some(Codec::Zstd)));
    assert_eq!(after.descriptor_bytes(), before.descriptor_bytes());
    assert_eq!(after.stored_payload(), before.stored_payload());
    assert!(validate(&second, &Limits::default()).iter().all(|finding| finding.id == "B0214"));
}

#[test]
fn illegal_values_are_refused_with_their_place() {
    let grid = grid(2, 1, Wrap::Clamp);
    let height = |values: &[f32]| HeightTable { grid, values }.encode(Encoding::F16);
    let horizon = |values: &[f32]| {
        HorizonTable { grid, azimuths: Azimuths::full_circle(1), radius: 2.0, values }.encode(Encoding::U8)
    };
    let distance = |values: &[f32]| {
        DistanceTable { grid, azimuths: Azimuths::full_circle(1), radius: 0.1, values }.encode(Encoding::U8)
    };
    let refused = |table: Result<_, EncodeError>| matches!(table, Err(EncodeError::Value { index: 1, .. }));
    assert!(refused(height(&[0.0, f32::NAN])));
    assert!(refused(height(&[0.0, f32::INFINITY])));
    assert!(refused(horizon(&[0.0, std::f32::consts::FRAC_PI_2])), "the f32 nearest to π/2 is above it");
    assert!(refused(distance(&[0.0, 0.1])), "the f32 nearest to 0.1 is above it");
    assert!(refused(distance(&[0.0, -1e-9])));
    assert!(matches!(height(&[0.0]), Err(EncodeError::Count { found: 1, expected: 2 })));
    assert!(height(&[f32::MIN, f32::MAX]).is_ok(), "half the range still fits f32");
    let wide = HeightTable { grid, values: &[f32::MIN, f32::MAX] }.encode(Encoding::U8);
    assert!(matches!(wide, Err(EncodeError::TooWide { .. })));
}

#[test]
fn an_empty_extent_or_spacing_is_refused_before_anything_is_made() {
    let refuse = |grid| HeightTable { grid, values: &[] }.encode(Encoding::F32).unwrap_err().to_string();
    assert_eq!(refuse(grid(0, 4, Wrap::Clamp)), "width is 0; 1 to 65536 is accepted");
    let flat = TableGrid { spacing_v: 0.0, ..grid(1, 1, Wrap::Clamp) };
    assert_eq!(refuse(flat), "spacing_v is 0; accepted: 1e-30 to 1e30");
}

#[test]
fn the_writer_refuses_what_no_file_may_hold() {
    let section = |kind, payload| RawSection { kind, critical: false, version: 1, descriptor: &[], payload };
    let mut writer = AssetWriter::new();
    writer.provenance("{}").unwrap();
    assert!(matches!(writer.provenance("{}"), Err(WriteError::Duplicate { .. })));
    let bad = section(SectionKind(*b"a b!"), b"x");
    assert!(matches!(writer.raw_section(&bad, Codec::Raw), Err(WriteError::Kind { .. })));
    let empty = section(SectionKind(*b"NONE"), b"");
    assert!(matches!(writer.raw_section(&empty, Codec::Raw), Err(WriteError::Empty { .. })));
    assert!(matches!(AssetWriter::new().finish(), Err(WriteError::SectionCount { found: 0, .. })));
}
