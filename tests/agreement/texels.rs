//! What is stored, decoded on the GPU and on the CPU: every table, every byte, every half.

use std::array::from_fn;

use barchan_asset::{
    Azimuths, DistanceTable, Encoding, Format, HorizonTable, Semantic, TableView, TextureDescriptor, TextureTable,
    Transfer, Wrap,
};
use barchan_field::shapes::FractalTerrain;
use barchan_field::{Edge, Shape};
use barchan_pipeline::{Scene, Table, TableEncoding};
use barchan_view::{Probe, ProbePass};
use barchan_wgpu::{ReliefSearch, Sampling, Shader, ShaderOptions, Technique};

use crate::compare::agree;
use crate::support::{self, ENCODINGS, Loaded, WRAPS, gpu, numbers, report};

/// A technique that reads a table.
fn reader_of(table: Semantic) -> Technique {
    match table {
        Semantic::Height => Technique::Surface,
        Semantic::HorizonElevation => Technique::HorizonShadow,
        Semantic::HorizonDistance => Technique::Penumbra,
        Semantic::SweptElevation | Semantic::SweptDistance => Technique::CurvedShadow,
        Semantic::SkyVisibility | Semantic::BentNormal => Technique::Sky,
        Semantic::ApertureCone => Technique::ApertureCone,
        Semantic::ConeMap => Technique::Relief(ReliefSearch::ConeSteps),
        Semantic::RelaxedConeMap => Technique::Relief(ReliefSearch::RelaxedConeSteps { bisections: 1 }),
        Semantic::MaximumHeight => Technique::Relief(ReliefSearch::MaximumMip),
        _ => Technique::Relief(ReliefSearch::Linear { steps: 1, bisections: 0 }),
    }
}

/// The pass that draws the decoded texels of a layer, whose number stands in place of the radius of the light's disc.
fn decoded(loaded: &Loaded, table: Semantic) -> ProbePass<'static> {
    let options = ShaderOptions { group: 0, sampling: Sampling::Loaded, probes: true };
    let shader = Shader::compose(&loaded.plan, &[reader_of(table)], &options).unwrap();
    let four = ["value, 0.0, 0.0, 0.0", "value, 0.0, 0.0", "value", "value"][table.channels() as usize - 1];
    let name = table.kind().name().unwrap();
    let more = format!(
        "
@fragment
fn decoded(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {{
    let place = vec2<i32>(floor(barchan_probe_place(position)));
    let value = barchan_{name}_texel(place, i32(barchan_probe.angular_radius));
    return vec4<f32>({four});
}}
"
    );
    ProbePass::of_shader(gpu(), &loaded.asset, &shader, &more, "decoded").unwrap()
}

fn address(wrap: Wrap, index: i64, size: u32) -> u32 {
    match wrap {
        Wrap::Repeat => index.rem_euclid(i64::from(size)) as u32,
        Wrap::Clamp => index.clamp(0, i64::from(size) - 1) as u32,
    }
}

/// Every channel of every layer or level, inside and beyond the edges; returns the greatest difference.
fn check_table(name: &str, loaded: &Loaded, table: Semantic, tolerance: f64) -> f64 {
    let view: TableView<'_> = loaded.view(table, TableView::new);
    let descriptor = *view.descriptor();
    let pass = decoded(loaded, table);
    let mut worst = 0.0_f64;
    for layer in 0..descriptor.pictures() {
        let (width, height) = descriptor.picture_extent(layer);
        let size = (3 * width + 2, 3 * height + 2);
        let start = [-i64::from(width) - 1, -i64::from(height) - 1];
        let place = start.map(|texel| texel as f32);
        let probe = Probe { size, place, angular_radius: layer as f32, ..Probe::default() };
        let found = pass.draw(&probe).unwrap();
        for channel in 0..table.channels() {
            let texel = |index: u32| {
                let column = address(descriptor.wrap_u, start[0] + i64::from(index % size.0), width);
                let row = address(descriptor.wrap_v, start[1] + i64::from(index / size.0), height);
                f64::from(view.channel(layer, column, row, channel))
            };
            let expected: Vec<f64> = (0..size.0 * size.1).map(texel).collect();
            worst = worst.max(agree(name, size, &numbers(&found, channel as usize), &expected, tolerance, 0.0));
        }
    }
    worst
}

/// Every table that is baked from heights.
fn all_tables(edge: Edge, encoding: TableEncoding) -> Loaded {
    let terrain = FractalTerrain { height: 6.0, hurst: 0.8, features_across: 2, octaves: 3, seed: 5 };
    let mut recipe = support::recipe(Shape::FractalTerrain(terrain), (12, 9), edge, encoding);
    recipe.scene = Some(Scene { curvature: Some((-0.02, 0.04)), ..Scene::default() });
    (recipe.curved.points, recipe.horizon.directions) = (Some(3), 4);
    (recipe.hemisphere.rings, recipe.hemisphere.azimuths, recipe.hemisphere.size) = (3, 4, Some((6, 5)));
    let tables: Vec<Table> = Table::ALL.into_iter().filter(|table| !table.is_of_a_mesh()).collect();
    Loaded::baked(recipe, &tables)
}

#[test]
fn every_texel_of_every_table_is_what_the_file_says() {
    let all_encodings = ENCODINGS.map(|encoding| (Edge::Wrap, encoding));
    for (edge, encoding) in all_encodings.into_iter().chain([(Edge::Clamp, TableEncoding::Compact)]) {
        let loaded = all_tables(edge, encoding);
        assert_eq!(loaded.plan.textures().len(), Semantic::ALL.len(), "a table of each kind");
        for table in Semantic::ALL {
            let name = format!("texels_{}_{encoding:?}_{edge:?}", table.kind());
            let descriptor = loaded.plan.texture(table).unwrap().descriptor;
            // Rounding of a product and a sum, of a square, and of the arc of a sine.
            let tolerance = 4e-7 * descriptor.range_min.abs().max(descriptor.range_max.abs()).max(1.0);
            report(&name, check_table(&name, &loaded, table, tolerance), tolerance);
        }
    }
}

/// A horizon and a distance of one azimuth, whose texels are other ones than were encoded.
fn with_payloads(
    encoding: Encoding,
    side: u32,
    change: impl Fn(TextureDescriptor) -> TextureDescriptor,
    payload: &[u8],
) -> Loaded {
    let (grid, azimuths) = (support::grid((side, side), (1.0, 1.0), WRAPS[0].1), Azimuths::arc(0.0, 0.0, 1));
    let along = |from: f32, to: f32| move |texel: u32| from + (to - from) * texel as f32 / (side * side - 1) as f32;
    let elevations: Vec<f32> = (0..side * side).map(along(-1.5, 1.5)).collect();
    let distances: Vec<f32> = (0..side * side).map(along(0.0, 9.0)).collect();
    let tables = [
        HorizonTable { grid, azimuths, radius: 9.0, values: &elevations }.encode(encoding).unwrap(),
        DistanceTable { grid, azimuths, radius: 9.0, values: &distances }.encode(encoding).unwrap(),
    ];
    Loaded::of_tables(tables.map(|table| TextureTable::new(change(*table.descriptor()), payload.to_vec()).unwrap()))
}

#[test]
fn every_byte_is_what_the_file_says() {
    let bytes: [u8; 256] = from_fn(|byte| byte as u8);
    for encoding in [Encoding::U8, Encoding::Compact] {
        let loaded = with_payloads(encoding, 16, |descriptor| descriptor, &bytes);
        // At 1.43 rad the last bit of a sine is 4e-7 rad.
        for (table, tolerance) in [(Semantic::HorizonElevation, 1e-6), (Semantic::HorizonDistance, 2e-6)] {
            let name = format!("bytes_{}_{}", table.kind(), encoding.name());
            report(&name, check_table(&name, &loaded, table, tolerance), tolerance);
        }
    }
}

#[test]
fn every_half_is_what_the_file_says() {
    let halves: Vec<u8> = (0..=u16::MAX).flat_map(u16::to_le_bytes).collect();
    let plain = |descriptor| TextureDescriptor { scale: 1.0, bias: 0.0, ..descriptor };
    let loaded = with_payloads(Encoding::F16, 256, plain, &halves);
    let curved = |descriptor: TextureDescriptor| {
        let is_distance = descriptor.semantic == Semantic::HorizonDistance;
        let transfer = if is_distance { Transfer::Square } else { Transfer::Sine };
        TextureDescriptor { transfer, ..plain(descriptor) }
    };
    let of_transfer = with_payloads(Encoding::F16, 256, curved, &halves);
    // A half is an f32 as it is; the arc of a sine is rounded; of a square the last bit may be another.
    check_halves("halves", &loaded, Semantic::HorizonElevation, |_| 0.0);
    check_halves("halves_of_sines", &of_transfer, Semantic::HorizonElevation, |_| 4e-7);
    check_halves("halves_of_roots", &of_transfer, Semantic::HorizonDistance, |square| 1.2e-7 * square);
}

fn check_halves(name: &str, loaded: &Loaded, table: Semantic, tolerance: impl Fn(f64) -> f64) {
    let view: TableView<'_> = loaded.view(table, TableView::new);
    assert_eq!(view.descriptor().format, Format::R16Float);
    let probe = Probe { size: (256, 256), ..Probe::default() };
    let found = numbers(&decoded(loaded, table).draw(&probe).unwrap(), 0);
    let mut worst = 0.0_f64;
    let expected: Vec<f64> = (0..256 * 256)
        .map(|half| {
            let (column, row) = (half % 256, half / 256);
            let (found, stored) = (found[half as usize], view.before_transfer(0, column, row, 0));
            let expected = f64::from(view.value(0, column, row));
            // Of halves that are no number shaders promise nothing, but that they end.
            if !stored.is_finite() {
                return found;
            }
            worst = worst.max((found - expected).abs() / expected.abs().max(1e-30));
            if (found - expected).abs() <= tolerance(expected) { found } else { expected }
        })
        .collect();
    agree(name, probe.size, &found, &expected, 0.0, 0.0);
    report(&format!("{name}, relative"), worst, tolerance(1.0));
}

#[test]
fn halves_that_are_no_number_end_too() {
    let halves: Vec<u8> = (0..=u16::MAX).flat_map(u16::to_le_bytes).collect();
    let loaded = with_payloads(Encoding::F16, 256, |descriptor| descriptor, &halves);
    for sampling in support::SAMPLINGS {
        let pass = loaded.pass(&[Technique::HorizonShadow], sampling);
        let probe = Probe {
            size: (128, 128),
            place: [-0.5, 0.25],
            step: [2.0, 2.0],
            light: [0.6, 0.0, 0.8],
            ..Probe::default()
        };
        assert_eq!(pass.draw(&probe).unwrap().len(), 128 * 128);
    }
}
