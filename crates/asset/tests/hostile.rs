//! Files made to hurt: sealed with right checksums, so that every check behind them is exercised. Nothing panics, and
//! nothing is allocated beyond the limits. One test in this file, since it measures the whole process.

use std::alloc::System;

use barchan_asset::{
    ApertureConeView, Asset, BentNormalView, ConeMapView, CurvatureColumn, CurvatureView, DistanceView, HeightView,
    HemisphereView, HorizonView, Limits, MaximumMipView, RelaxedConeMapView, Section, SkyVisibilityView,
    SweptDistanceView, SweptHorizonView, TableView, content_identity, validate,
    vectors::{self, reseal},
};
use cap::Cap;

#[global_allocator]
static MEMORY: Cap<System> = Cap::new(System, usize::MAX);

const LIMITS: Limits = Limits { max_decoded_bytes: 1 << 20, max_zstd_window_bytes: 1 << 20 };
/// Decoded bytes, window and the decoder's own tables; twice over, for its ring buffer.
const MOST_MEMORY: usize = 8 << 20;
const MUTANTS: u32 = 60_000;

/// Marsaglia's xorshift: the same mutants on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound as u64) as usize
    }
}

/// Everything a program could do with a file.
fn exercise(file: &[u8]) {
    let _ = validate(file, &LIMITS);
    let Ok(asset) = Asset::open(file) else { return };
    let _ = content_identity(&asset, &LIMITS);
    for section in asset.sections() {
        let (_, _) = (section.is_intact(), section.descriptor_bytes());
        exercise_curvature(&section);
        let (Ok(payload), Ok(descriptor)) = (section.payload(&LIMITS), section.texture()) else { continue };
        let Ok(view) = TableView::new(descriptor, &payload) else { continue };
        for layer in 0..descriptor.pictures() {
            let _ = view.row(layer, descriptor.picture_extent(layer).1 - 1).sum::<f32>();
        }
        let last = (descriptor.layers - 1, descriptor.width - 1, descriptor.height - 1);
        let _ = HeightView::new(descriptor, &payload).map(|view| view.height_at(last.1, last.2));
        let _ = HorizonView::new(descriptor, &payload).map(|view| view.elevation_radians(last.0, last.1, last.2));
        let _ = DistanceView::new(descriptor, &payload).map(|view| view.distance(last.0, last.1, last.2));
        exercise_newer_views(&view);
        exercise_relief_views(&view);
    }
}

/// The views that came with version 2 of the descriptor.
fn exercise_newer_views(view: &TableView<'_>) {
    let (descriptor, payload) = (*view.descriptor(), view.payload());
    let (column, row) = (descriptor.width - 1, descriptor.height - 1);
    if let Some(azimuths) = descriptor.azimuths() {
        for azimuth in [0.0, -7.5, 1e300, f64::NAN, f64::INFINITY, azimuths.radians(descriptor.layers)] {
            let (first, second, _) = azimuths.neighbours(azimuth);
            assert!(first < azimuths.count() && second < azimuths.count());
            let _ = azimuths.covers(azimuth);
        }
    }
    if let Ok(view) = HorizonView::new(descriptor, payload) {
        let _ = view.sine_of_elevation(view.directions() - 1, column, row);
    }
    if let Ok(view) = SweptHorizonView::new(descriptor, payload) {
        let last = (view.candidates() - 1, view.directions() - 1);
        let _ = (view.elevation_radians(last.0, last.1, column, row), view.sine_of_elevation(0, 0, column, row));
    }
    let _ = SweptDistanceView::new(descriptor, payload).map(|view| view.distance(0, 0, column, row));
    let _ = SkyVisibilityView::new(descriptor, payload).map(|view| view.visibility(column, row));
    let _ = BentNormalView::new(descriptor, payload).map(|view| view.normal(column, row));
    if let Ok(view) = ApertureConeView::new(descriptor, payload) {
        let _ = (view.axis(column, row), view.cosine_of_half_angle(column, row));
    }
}

/// The views that came with version 3 of the descriptor.
fn exercise_relief_views(view: &TableView<'_>) {
    let (descriptor, payload) = (*view.descriptor(), view.payload());
    let (column, row) = (descriptor.width - 1, descriptor.height - 1);
    if let Ok(view) = HemisphereView::new(descriptor, payload) {
        let directions = view.directions();
        assert_eq!(directions.layers(), descriptor.layers);
        for number in [0.0, 0.7, 1e300, -7.5, f64::NAN, f64::INFINITY] {
            assert!(directions.ring_of_tangent(number).is_none_or(|ring| ring < directions.rings));
            assert!(directions.azimuth_cell(number).is_none_or(|cell| cell < directions.azimuths.count()));
        }
        let _ = (view.depth(descriptor.layers - 1, column, row), view.mode(), view.relief().depth(0.0));
    }
    let _ = ConeMapView::new(descriptor, payload).map(|view| (view.depth(column, row), view.ratio(column, row)));
    let _ = RelaxedConeMapView::new(descriptor, payload).map(|view| (view.depth(column, row), view.ratio(0, 0)));
    if let Ok(view) = MaximumMipView::new(descriptor, payload) {
        assert_eq!(view.extent(view.levels() - 1), (1, 1));
        let _ = (view.value(0, column, row), view.value(view.levels() - 1, 0, 0));
    }
}

fn exercise_curvature(section: &Section<'_>) {
    let (Ok(payload), Ok(descriptor)) = (section.payload(&LIMITS), section.curvature()) else { return };
    let view = CurvatureView::new(descriptor, &payload).unwrap();
    for vertex in [0, view.vertices() - 1] {
        let (_, _) = (view.principal(vertex), view.flags(vertex));
        let _ = (view.directions(vertex), view.forms(vertex), view.uv_directions(vertex));
    }
    for column in CurvatureColumn::ALL {
        let bytes = view.column(column).unwrap_or(&[]);
        assert!(bytes.len() + view.column_padding(column).len() <= payload.len());
    }
}

/// Places where a number decides something: header, table rows, descriptors, the start of each payload.
fn targets(file: &[u8]) -> Vec<usize> {
    let mut targets: Vec<usize> = (0..128 + 64 * 4).collect();
    for at in (4096..file.len()).step_by(4096) {
        targets.extend(at..(at + 600).min(file.len()));
    }
    targets.retain(|&at| at < file.len());
    targets
}

/// Overwrites one number with a small, a huge or a slightly wrong one.
fn mutate(file: &mut [u8], targets: &[usize], random: &mut Random) {
    let extremes = [0, 1, 2, 255, 256, 4095, 4096, 65_536, 1 << 31, 1 << 62, u64::MAX - 4095, u64::MAX];
    let at = targets[random.below(targets.len())];
    let width = [1, 2, 4, 8][random.below(4)].min(file.len() - at);
    let mut number = [0; 8];
    number[..width].copy_from_slice(&file[at..at + width]);
    let old = u64::from_le_bytes(number);
    let new = match random.below(4) {
        0 => extremes[random.below(extremes.len())],
        1 => old.wrapping_add(random.next() % 9).wrapping_sub(4),
        2 => old ^ 1 << random.below(8 * width),
        _ => random.next(),
    };
    file[at..at + width].copy_from_slice(&new.to_le_bytes()[..width]);
}

/// Sets the stated size and, half the time, cuts the file: then only the table is wrong.
fn resize(file: &mut Vec<u8>, random: &mut Random) {
    let length = 1 + random.below(file.len() + 64);
    file.resize(length, random.next() as u8);
    if file.len() >= 24 {
        let size = (file.len() as u64).to_le_bytes();
        file[16..24].copy_from_slice(&size);
    }
}

/// A raw length and a frame of 64 GiB: refused before anything is allocated for it.
fn bomb(source: &[u8]) -> Vec<u8> {
    let mut file = source.to_vec();
    let size = (64_u64 << 30).to_le_bytes();
    file[128 + 32..128 + 40].copy_from_slice(&size);
    let payload = 4096 + 256;
    file[payload + 4] = 0xC0; // content size of 8 bytes, with a window descriptor
    file[payload + 5] = 0;
    file[payload + 6..payload + 14].copy_from_slice(&size);
    reseal(&mut file);
    file
}

#[test]
fn hostile_files_neither_panic_nor_eat_memory() {
    let sources = vectors::all().unwrap();
    let before = MEMORY.allocated();
    MEMORY.set_limit(before + MOST_MEMORY).unwrap();

    let stored_block = sources.iter().find(|source| source.name == "height-f32-stored-zstd-block").unwrap();
    let file = bomb(&stored_block.bytes);
    assert!(Asset::open(&file).is_ok());
    assert!(validate(&file, &LIMITS).iter().any(|finding| finding.id == "B0304"));

    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let mut opened = 0;
    let mut seen = std::collections::BTreeSet::new();
    for round in 0..MUTANTS {
        let source = &sources[round as usize % sources.len()].bytes;
        let targets = targets(source);
        let mut file = source.clone();
        for _ in 0..1 + random.below(4) {
            mutate(&mut file, &targets, &mut random);
        }
        if random.below(16) == 0 {
            resize(&mut file, &mut random);
        }
        reseal(&mut file);
        exercise(&file);
        opened += u32::from(Asset::open(&file).is_ok());
        seen.extend(validate(&file, &LIMITS).iter().map(|finding| finding.id));
    }
    assert!(opened > MUTANTS / 4, "only {opened} of {MUTANTS} mutants were opened");
    assert!(seen.len() > 44, "only {seen:?} were found");
}
