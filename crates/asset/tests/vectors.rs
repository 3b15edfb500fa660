//! The published vectors: still written byte for byte, still read to the values they were made from.

use std::fs;
use std::path::PathBuf;

use barchan_asset::{
    ApertureConeView, Asset, BentNormalView, ConeMapView, CurvatureColumn, CurvatureView, DepthMode, DistanceView,
    HeightView, HemisphereView, HorizonView, LengthUnit, Limits, MAX_ELEVATION, MaximumMipView, OpenError,
    RelaxedConeMapView, RingSpacing, SectionFault, SectionKind, Severity, SkyVisibilityView, SweptDistanceView,
    SweptHorizonView, TextureDescriptor, Transfer, Wrap, validate, vectors,
};

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../formats/vectors/v1")
}

/// A published file; a missing one fails.
fn published(name: &str) -> Vec<u8> {
    let path = folder().join(name).with_extension("barchan");
    fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The decoded values of the height section, row by row.
fn heights(file: &[u8]) -> Vec<f32> {
    let section = Asset::open(file).unwrap().section(SectionKind::HEIGHT).unwrap();
    let payload = section.payload(&Limits::default()).unwrap();
    let view = HeightView::new(section.texture().unwrap(), &payload).unwrap();
    (0..view.height()).flat_map(|row| view.table().row(0, row).collect::<Vec<_>>()).collect()
}

#[test]
fn the_writer_still_writes_every_published_byte() {
    for vector in vectors::all().unwrap() {
        let published = published(vector.name);
        // Another libzstd may compress otherwise: then the content is what must not have changed.
        let same_zstd = zstd_version() == 10507;
        if same_zstd || !vector.name.contains("zstd") {
            assert!(published == vector.bytes, "{} is not written as published", vector.name);
        } else {
            let identity = |bytes: &[u8]| Asset::open(bytes).unwrap().identity();
            assert_eq!(identity(&published), identity(&vector.bytes), "{}", vector.name);
        }
    }
}

fn zstd_version() -> u32 {
    zstd::zstd_safe::version_number()
}

#[test]
fn every_file_in_the_folder_is_listed() {
    let listed: Vec<PathBuf> =
        vectors::all().unwrap().iter().map(|v| folder().join(v.name).with_extension("barchan")).collect();
    for sub in [folder(), folder().join("refused")] {
        for file in fs::read_dir(sub).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file()) {
            assert!(listed.contains(&file), "{} is not listed in src/vectors", file.display());
        }
    }
}

#[test]
fn vectors_in_the_folder_itself_have_no_error() {
    for vector in vectors::all().unwrap().iter().filter(|vector| !vector.name.contains('/')) {
        let findings = validate(&published(vector.name), &Limits::default());
        let warnings: Vec<_> = findings.iter().map(|finding| (finding.id, finding.severity)).collect();
        let expected: &[_] = match vector.name {
            "unknown-ancillary" => &[("B0214", Severity::Warning)],
            "newer-minor" => &[("B0109", Severity::Warning), ("B0110", Severity::Warning)],
            _ => &[],
        };
        assert_eq!(warnings, expected, "{}", vector.name);
    }
}

#[test]
fn f32_heights_are_exact() {
    assert_eq!(heights(&published("height-f32-repeat")), vectors::HEIGHTS);
    assert_eq!(heights(&published("height-f32-stored-zstd-block")), vectors::HEIGHTS);
}

#[test]
fn f16_heights_decode_to_these_values() {
    // bias 1.5, scale 2.5; the halves nearest to −0.6, −0.2, 0.4 are not exact.
    let expected = [-0.000_244_140_63, 1.000_122_1, 2.499_755_9, -1.0, 0.25, 4.0];
    assert_eq!(heights(&published("height-f16-clamp")), expected);
    assert_eq!(heights(&published("newer-minor")), expected);
    assert_eq!(heights(&published("unknown-ancillary")), expected);
}

#[test]
fn u8_heights_decode_to_these_values() {
    // bias −1, scale 5; bytes 51, 51·2, 178, 0, 64, 255.
    assert_eq!(heights(&published("height-u8-repeat-clamp")), [0.0, 1.0, 2.490_196_2, -1.0, 0.254_902, 4.0]);
    assert_eq!(heights(&published("height-u8-constant")), [7.3; 6]);
}

#[test]
fn the_grid_is_read_as_it_was_written() {
    let file = published("height-u8-repeat-clamp");
    let section = Asset::open(&file).unwrap().section(SectionKind::HEIGHT).unwrap();
    let view = HeightView::new(section.texture().unwrap(), section.raw_payload().unwrap()).unwrap();
    assert_eq!((view.width(), view.height()), (3, 2));
    assert_eq!(view.spacing(), (0.5, 0.25));
    assert_eq!(view.wrap(), (Wrap::Repeat, Wrap::Clamp));
    assert_eq!(view.length_unit(), LengthUnit::Metre);
}

#[test]
fn directional_tables_decode_within_their_worst_case_error() {
    for name in ["horizon-distance-f16", "horizon-distance-u8-zstd", "horizon-distance-compact"] {
        let file = published(name);
        let asset = Asset::open(&file).unwrap();
        let [horizon, distance] = [SectionKind::HORIZON, SectionKind::DISTANCE].map(|k| asset.section(k).unwrap());
        let payloads = [horizon, distance].map(|section| section.payload(&Limits::default()).unwrap());
        let horizon = HorizonView::new(horizon.texture().unwrap(), &payloads[0]).unwrap();
        let distance = DistanceView::new(distance.texture().unwrap(), &payloads[1]).unwrap();
        assert_eq!((horizon.directions(), horizon.radius()), (4, 8.0));
        assert_eq!(horizon.azimuth_radians(1), std::f64::consts::FRAC_PI_2);
        for (k, column, row) in (0..256).map(|i| (i / 64, i % 16, i / 16 % 4)) {
            let elevation = -0.5 + f64::from(k) / 4.0 + f64::from(column) / 16.0;
            let error = f64::from(horizon.elevation_radians(k, column, row)) - elevation;
            assert!(error.abs() <= horizon.descriptor().worst_case_error, "{name} {k} {column} {row}: {error}");
            let error = f64::from(distance.distance(k, column, row)) - (f64::from(k) + f64::from(row) / 4.0);
            assert!(error.abs() <= distance.descriptor().worst_case_error, "{name} {k} {column} {row}: {error}");
        }
        let provenance = asset.section(SectionKind::PROVENANCE).unwrap();
        assert_eq!(provenance.raw_payload(), Some(&br#"{"made_by":"barchan vectors"}"#[..]));
    }
}

#[test]
fn compact_tables_hold_sines_and_roots() {
    let file = published("horizon-distance-compact");
    let asset = Asset::open(&file).unwrap();
    let [horizon, distance] = [SectionKind::HORIZON, SectionKind::DISTANCE].map(|kind| asset.section(kind).unwrap());
    assert_eq!((horizon.version(), distance.version()), (2, 2));
    let horizon = HorizonView::new(horizon.texture().unwrap(), horizon.raw_payload().unwrap()).unwrap();
    let distance = DistanceView::new(distance.texture().unwrap(), distance.raw_payload().unwrap()).unwrap();
    let transfers = [horizon.descriptor().transfer, distance.descriptor().transfer];
    assert_eq!(transfers, [Transfer::Sine, Transfer::Square]);
    // Bytes 0 and 255: the sines of −0.5 and 1.1875 to f32.
    assert_eq!(horizon.sine_of_elevation(0, 0, 0), -0.479_425_55);
    assert_eq!(horizon.sine_of_elevation(3, 15, 0), 0.927_436_95);
    assert_eq!([horizon.elevation_radians(0, 0, 0), horizon.elevation_radians(3, 15, 0)], [-0.5, 1.187_500_1]);
    assert_eq!([distance.distance(0, 0, 0), distance.distance(3, 0, 3)], [0.0, 3.750_000_2]);
    // Byte 147: (√3.75 · 147/255)².
    assert_eq!(distance.distance(1, 0, 1), 1.246_194);
}

#[test]
fn an_arc_knows_its_ends() {
    let file = published("horizon-arc");
    let section = Asset::open(&file).unwrap().section(SectionKind::HORIZON).unwrap();
    let view = HorizonView::new(section.texture().unwrap(), section.raw_payload().unwrap()).unwrap();
    assert_eq!((section.version(), view.directions(), view.azimuths().is_full_circle()), (2, 3, false));
    assert_eq!(view.neighbours(std::f64::consts::FRAC_PI_8), (1, 2, 0.5));
    assert!(view.covers(-0.5) && !view.covers(1.0));
    for (k, column) in [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)] {
        let error = view.elevation_radians(k, column, 0) - vectors::arc_elevation(k, column);
        assert!(f64::from(error.abs()) <= view.descriptor().worst_case_error, "{error}");
    }
}

#[test]
fn swept_candidates_follow_the_horizon() {
    let file = published("swept-horizon");
    let asset = Asset::open(&file).unwrap();
    let part = |kind| asset.section(kind).map(|s| (s.texture().unwrap(), s.raw_payload().unwrap())).unwrap();
    let (horizon, distance) = (part(SectionKind::SWEPT_HORIZON), part(SectionKind::SWEPT_DISTANCE));
    assert!(!asset.section(SectionKind::SWEPT_HORIZON).unwrap().is_critical());
    let horizon = SweptHorizonView::new(horizon.0, horizon.1).unwrap();
    let distance = SweptDistanceView::new(distance.0, distance.1).unwrap();
    assert_eq!((horizon.candidates(), horizon.directions()), (2, 3));
    assert_eq!(horizon.curvature_range(), (-0.5, 0.25));
    for (candidate, direction) in [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2)] {
        let (elevation, length) = vectors::swept_point(candidate + 1, direction);
        let error = horizon.elevation_radians(candidate, direction, 0, 0) - elevation;
        assert!(f64::from(error.abs()) <= horizon.descriptor().worst_case_error, "{error}");
        let error = horizon.sine_of_elevation(candidate, direction, 0, 0) - elevation.sin();
        assert!(error.abs() < 0.002, "{error}");
        let error = distance.distance(candidate, direction, 0, 0) - length;
        assert!(f64::from(error.abs()) <= distance.descriptor().worst_case_error, "{error}");
    }
}

#[test]
fn what_a_texel_sees_of_the_sky() {
    for (name, tolerance) in [("sky-f32", 0.0), ("sky-f16", 3e-4), ("sky-compact", 4e-3)] {
        let file = published(name);
        let asset = Asset::open(&file).unwrap();
        let part = |kind| asset.section(kind).map(|s| (s.texture().unwrap(), s.raw_payload().unwrap())).unwrap();
        let kinds = [SectionKind::SKY_VISIBILITY, SectionKind::BENT_NORMAL, SectionKind::APERTURE_CONE];
        let [sky, bent, cone] = kinds.map(part);
        assert_eq!([sky.0, bent.0, cone.0].map(|descriptor| descriptor.format.channels()), [1, 2, 4]);
        let sky = SkyVisibilityView::new(sky.0, sky.1).unwrap();
        let bent = BentNormalView::new(bent.0, bent.1).unwrap();
        let cone = ApertureConeView::new(cone.0, cone.1).unwrap();
        let near = |found: f32, expected: f32| (found - expected).abs() <= tolerance;
        for (texel, (column, row)) in vectors::SKY.into_iter().zip([(0, 0), (1, 0), (0, 1), (1, 1)]) {
            assert!(near(sky.visibility(column, row), texel.visibility), "{name}");
            assert!(near(cone.cosine_of_half_angle(column, row), texel.cosine), "{name}");
            let (axis, normal) = (cone.axis(column, row), bent.normal(column, row));
            for i in 0..3 {
                assert!(near(axis[i], texel.axis[i]), "{name}: {axis:?}");
                // The height is a root: near the tangent plane it magnifies what its square is off by.
                let slack = if i == 2 { tolerance.sqrt() * 2.0 + 4e-4 } else { 0.0 };
                assert!((normal[i] - texel.axis[i]).abs() <= tolerance + slack, "{name}: {normal:?}");
            }
        }
    }
}

/// The descriptor and the raw payload of a section.
fn part(file: &[u8], kind: SectionKind) -> (TextureDescriptor, &[u8]) {
    let section = Asset::open(file).unwrap().section(kind).unwrap();
    (section.texture().unwrap(), section.raw_payload().unwrap())
}

#[test]
fn hemisphere_depths_lie_in_their_cells() {
    let third = std::f64::consts::FRAC_PI_3;
    for (name, layers, mode, spacing) in [
        ("relief-f32", 6, DepthMode::Conservative, RingSpacing::SquaredTangents),
        ("relief-f16", 6, DepthMode::Conservative, RingSpacing::SquaredTangents),
        ("relief-compact", 6, DepthMode::Conservative, RingSpacing::SquaredTangents),
        ("hemisphere-arc", 4, DepthMode::Nearest, RingSpacing::EqualAngles),
    ] {
        let file = published(name);
        let (descriptor, payload) = part(&file, SectionKind::HEMISPHERE);
        let view = HemisphereView::new(descriptor, payload).unwrap();
        let directions = view.directions();
        assert_eq!((directions.layers(), view.mode(), directions.spacing), (layers, mode, spacing));
        assert_eq!((directions.max_polar_radians, view.relief()), (third, vectors::RELIEF_RANGE));
        for (layer, column) in (0..layers).flat_map(|layer| [(layer, 0), (layer, 1)]) {
            let (depth, given) = (view.depth(layer, column, 0), vectors::hemisphere_depth(layer, column));
            assert!(mode == DepthMode::Nearest || depth <= given, "{name}: {depth} for {given}");
            assert!(f64::from((depth - given).abs()) <= descriptor.worst_case_error, "{name}: {depth} for {given}");
        }
    }
    let file = published("relief-f32");
    let (descriptor, payload) = part(&file, SectionKind::HEMISPHERE);
    let directions = HemisphereView::new(descriptor, payload).unwrap().directions();
    // The second ring starts at a quarter of tan 60°, the second azimuth is around 120°.
    assert_eq!([0.433, 0.434, 1.733].map(|tangent| directions.ring_of_tangent(tangent)), [Some(0), Some(1), None]);
    assert_eq!([61_f64, -59.0].map(|degrees| directions.azimuth_cell(degrees.to_radians())), [Some(1), Some(0)]);
}

#[test]
fn cones_are_no_deeper_and_no_wider_than_given() {
    for name in ["relief-f32", "relief-f16", "relief-compact"] {
        let file = published(name);
        let (cones, relaxed) = (part(&file, SectionKind::CONE_MAP), part(&file, SectionKind::RELAXED_CONE_MAP));
        let errors = [cones.0.worst_case_error, relaxed.0.worst_case_error];
        let cones = ConeMapView::new(cones.0, cones.1).unwrap();
        let relaxed = RelaxedConeMapView::new(relaxed.0, relaxed.1).unwrap();
        assert_eq!((cones.relief(), relaxed.relief()), (vectors::RELIEF_RANGE, vectors::RELIEF_RANGE));
        let lower = |found: f32, given: f32, error| found <= given && f64::from(given - found) <= error;
        for (i, (column, row)) in (0..15).map(|i| (i as usize, (i % 5, i / 5))) {
            let (depth, ratio) = ((4.0 - vectors::RELIEF[i]) / 5.0, vectors::cone_ratio(column, row));
            assert!(lower(cones.depth(column, row), depth, errors[0]), "{name} {i}");
            assert!(lower(cones.ratio(column, row), ratio, errors[0]), "{name} {i}");
            assert!(lower(relaxed.ratio(column, row), 2.0 * ratio, errors[1]), "{name} {i}");
            assert_eq!(relaxed.depth(column, row), cones.depth(column, row));
        }
    }
}

#[test]
fn maxima_lead_to_the_top_of_the_relief() {
    // Of 1 m at (1, 0) with 2.5 m, 0.5 m and 0 m; across the edge that repeats, and below the one that does not.
    let [cells, halves, all] = vectors::maxima();
    assert_eq!((cells[1], cells[4], cells[14], halves, all), (2.5, 4.0, 0.125, vec![4.0, 4.0], vec![4.0]));
    for (name, error) in [("relief-f32", 0.0), ("relief-f16", 1e-3), ("relief-compact", 1e-3)] {
        let file = published(name);
        let (descriptor, payload) = part(&file, SectionKind::MAXIMUM_MIP);
        let view = MaximumMipView::new(descriptor, payload).unwrap();
        assert_eq!([0, 1, 2].map(|level| view.extent(level)), [(5, 3), (2, 1), (1, 1)]);
        for (level, values) in (0..).zip(vectors::maxima()) {
            for (i, given) in (0..).zip(values) {
                let width = view.extent(level).0;
                let found = view.value(level, i % width, i / width);
                assert!(found >= given && found - given <= error, "{name}: {found} for {given}");
            }
        }
    }
}

#[test]
fn walls_keep_their_elevation() {
    let file = published("horizon-f32-extremes");
    let section = Asset::open(&file).unwrap().section(SectionKind::HORIZON).unwrap();
    let view = HorizonView::new(section.texture().unwrap(), section.raw_payload().unwrap()).unwrap();
    assert_eq!([0, 1, 2].map(|k| view.elevation_radians(k, 0, 0)), [MAX_ELEVATION, 0.0, -MAX_ELEVATION]);
}

/// The curvature table of a published file.
fn curvature(file: &[u8]) -> CurvatureView<'_> {
    let section = Asset::open(file).unwrap().section(SectionKind::CURVATURE).unwrap();
    CurvatureView::new(section.curvature().unwrap(), section.raw_payload().unwrap()).unwrap()
}

#[test]
fn f32_curvature_is_exact() {
    let file = published("curvature-f32");
    let view = curvature(&file);
    assert_eq!((view.vertices(), view.descriptor().length_unit()), (5, LengthUnit::Metre));
    assert_eq!(view.descriptor().curvature_range(), (-300.0, 2.0));
    for (i, vertex) in (0..5).zip(vectors::CURVED) {
        assert_eq!(view.principal(i), vertex.principal);
        assert_eq!(view.directions(i), Some(vertex.directions));
        assert_eq!(view.forms(i), Some(vertex.forms()));
        assert_eq!(view.uv_directions(i), Some(vertex.uv_directions()));
        assert_eq!(view.flags(i), vertex.flags);
    }
}

/// What the page promises of every table: along V1 the forms give κ1, along V2 κ2, and both are unit lengths.
#[test]
fn the_forms_of_the_vectors_give_their_principal_curvatures() {
    for (name, tolerance) in [("curvature-f32", 1e-6), ("curvature-f16", 4e-3)] {
        let file = published(name);
        let view = curvature(&file);
        for i in 0..view.vertices() {
            let forms = view.forms(i).unwrap();
            for ([u, v], kappa) in view.uv_directions(i).unwrap().into_iter().zip(view.principal(i)) {
                let along = |[a, b, c]: [f32; 3]| a * u * u + 2.0 * b * u * v + c * v * v;
                let (length, bend) = (along(forms.first), along(forms.second));
                assert!((length - 1.0).abs() <= tolerance, "{name} {i}: {length}");
                // The second form of vertex 4 is the difference of numbers that are 300 times as large.
                let size = view.principal(i).map(f32::abs).into_iter().fold(kappa.abs(), f32::max);
                assert!((bend / length - kappa).abs() <= tolerance * size, "{name} {i}: {bend} / {length}, {kappa}");
            }
        }
    }
}

#[test]
fn f16_curvature_decodes_to_these_values() {
    let file = published("curvature-f16");
    let view = curvature(&file);
    // Scale 2⁻⁶: 0.1 is 6.3984375 of it, 300 is 19 200, 0.003 is 0.19201660….
    let expected = [[0.5, -0.25], [2.0, 1.0], [0.099_975_586, 0.099_975_586], [0.0, 0.0], [-0.003_000_259_4, -300.0]];
    assert_eq!([0, 1, 2, 3, 4].map(|i| view.principal(i)), expected);
    for (i, vertex) in (0..5).zip(vectors::CURVED) {
        let error = |column| view.descriptor().column(column).unwrap().worst_case_error;
        let near = |found: &[f32], given: &[f32], column| {
            found.iter().zip(given).all(|(found, given)| (found - given).abs() <= error(column))
        };
        let [first, second] = view.directions(i).unwrap();
        assert!(near(&first, &vertex.directions[0], CurvatureColumn::Direction1));
        assert!(near(&second, &vertex.directions[1], CurvatureColumn::Direction2));
        let (forms, given) = (view.forms(i).unwrap(), vertex.forms());
        assert!(near(&forms.first, &given.first, CurvatureColumn::FirstForm));
        assert!(near(&forms.second, &given.second, CurvatureColumn::SecondForm));
        let (found, given) = (view.uv_directions(i).unwrap(), vertex.uv_directions());
        assert!(near(found.as_flattened(), given.as_flattened(), CurvatureColumn::UvDirections));
        assert_eq!(view.flags(i), vertex.flags);
    }
}

#[test]
fn principal_curvature_stands_alone() {
    let file = published("curvature-principal");
    let view = curvature(&file);
    // Scale 2⁻⁵. The millionth is a subnormal half: beside 1000 it is too small for all of its eleven bits.
    let expected = [[1000.0, -0.001_000_404_4], [0.099_975_586, 1.000_240_4e-6], [0.0, -0.333_251_95]];
    assert_eq!([0, 1, 2].map(|i| view.principal(i)), expected);
    assert_eq!(view.descriptor().columns().count(), 1);
    assert_eq!(view.column(CurvatureColumn::Principal).map(<[u8]>::len), Some(12));
}

#[test]
fn refused_vectors_are_refused_by_name() {
    let refusal = |name: &str| Asset::open(&published(name)).unwrap_err();
    assert_eq!(
        refusal("refused/unknown-critical"),
        OpenError::Section { index: 1, kind: SectionKind(*b"NOTE"), fault: SectionFault::UnknownCritical }
    );
    assert_eq!(
        refusal("refused/newer-section"),
        OpenError::Section {
            index: 0,
            kind: SectionKind::HORIZON,
            fault: SectionFault::Version { found: 3, newest: 2 }
        }
    );
    assert_eq!(refusal("refused/unknown-major"), OpenError::Major { found: 2 });
    assert_eq!(refusal("refused/required-feature"), OpenError::RequiredFeatures { unknown: 0x1_0000 });
    let damage = refusal("refused/newline-damage");
    assert!(damage.to_string().ends_with("newlines or 8-bit characters were altered in a transfer"), "{damage}");
}
