//! The functions of angles in `functions.wgsl`, against f64: how far their results are off, over all that they are asked for.

use barchan_asset::{Encoding, HeightTable, MAX_ELEVATION, Semantic, Wrap};
use barchan_wgpu::{Shader, ShaderOptions, Technique};

use crate::support::{Loaded, gpu, grid};

/// What is computed for each pair of numbers: arcsine of x, arctangent of x, azimuth of (x, y), sine and cosine of x.
const ENTRY: &str = "
@group(0) @binding(0) var<storage, read> asked: array<vec2<f32>>;
@group(0) @binding(1) var<storage, read_write> answers: array<array<f32, 5>>;

@compute @workgroup_size(64)
fn answer(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < arrayLength(&asked) {
        let x = asked[id.x].x;
        let turned = barchan_sine_cosine(x);
        answers[id.x] =
            array<f32, 5>(barchan_arcsine(x), barchan_arctangent(x), barchan_azimuth(asked[id.x]), turned.x, turned.y);
    }
}
";

/// The first part of every shader, as it is composed.
fn functions() -> String {
    let heights = HeightTable { grid: grid((1, 1), (1.0, 1.0), (Wrap::Clamp, Wrap::Clamp)), values: &[0.0] };
    let loaded = Loaded::of_tables([heights.encode(Encoding::F32).unwrap()]);
    assert!(loaded.plan.texture(Semantic::Height).is_some());
    let shader = Shader::compose(&loaded.plan, &[Technique::Surface], &ShaderOptions::default()).unwrap();
    let (functions, _) = shader.source().split_once("// What an asset's tables are").unwrap();
    functions.to_owned()
}

/// The answers of the GPU.
fn answers(asked: &[[f32; 2]]) -> Vec<[f32; 5]> {
    let device = &gpu().device;
    let buffer = |bytes: usize, usage| {
        let (label, size) = (None, bytes as u64);
        device.create_buffer(&wgpu::BufferDescriptor { label, size, usage, mapped_at_creation: false })
    };
    let (storage, count) = (wgpu::BufferUsages::STORAGE, asked.len());
    let asked_buffer = buffer(8 * count, storage | wgpu::BufferUsages::COPY_DST);
    let answer_buffer = buffer(20 * count, storage | wgpu::BufferUsages::COPY_SRC);
    let read_back = buffer(20 * count, wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ);
    let bytes: Vec<u8> = asked.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect();
    gpu().queue.write_buffer(&asked_buffer, 0, &bytes);
    let source = wgpu::ShaderSource::Wgsl((functions() + ENTRY).into());
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: None,
        layout: None,
        module: &module,
        entry_point: Some("answer"),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        cache: None,
    });
    let entries = [&asked_buffer, &answer_buffer].map(|buffer| buffer.as_entire_binding());
    let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[0, 1].map(|i| wgpu::BindGroupEntry { binding: i, resource: entries[i as usize].clone() }),
    });
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &group, &[]);
    pass.dispatch_workgroups(count.div_ceil(64) as u32, 1, 1);
    drop(pass);
    encoder.copy_buffer_to_buffer(&answer_buffer, 0, &read_back, 0, None);
    gpu().queue.submit([encoder.finish()]);
    read_back.slice(..).map_async(wgpu::MapMode::Read, |mapped| mapped.unwrap());
    gpu().finish().unwrap();
    let bytes = read_back.slice(..).get_mapped_range().unwrap();
    let number = |bytes: &[u8]| f32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
    bytes.chunks_exact(20).map(|five| [0, 4, 8, 12, 16].map(|at| number(&five[at..]))).collect()
}

/// By how many times the distance from the exact number to the next f32 a result is off.
fn ulps(found: f32, exact: f64) -> f64 {
    let nearest = (exact as f32).abs();
    let spacing = f64::from(nearest.next_up()) - f64::from(nearest);
    (f64::from(found) - exact).abs() / spacing
}

/// Numbers over a range, ends and middle included, more of them than there are texels in a row of any picture.
fn over(low: f32, high: f32) -> Vec<f32> {
    (0..=1 << 16).map(|i| low + (high - low) * (i as f32 / 65536.0)).collect()
}

/// Numbers of both signs and of every size.
fn of_every_size() -> impl Iterator<Item = f32> {
    (-80..80).flat_map(|power| [1.0, 1.2, 1.41, 1.7].map(|part| part * 2f32.powi(power))).flat_map(|x| [x, -x])
}

/// The greatest error among those answers, in ulp, and where.
fn worst(asked: &[[f32; 2]], exact: impl Fn([f32; 2]) -> f64, index: usize) -> (f64, [f32; 2]) {
    let errors = answers(asked).into_iter().zip(asked).map(|(found, &asked)| (ulps(found[index], exact(asked)), asked));
    errors.fold((0.0, [0.0; 2]), |worst, next| if next.0 <= worst.0 { worst } else { next })
}

fn alone(numbers: impl IntoIterator<Item = f32>) -> Vec<[f32; 2]> {
    numbers.into_iter().map(|x| [x, 0.0]).collect()
}

#[test]
fn arcsines_are_within_4_ulp() {
    let sines = alone(over(-1.0, 1.0).into_iter().chain(of_every_size().filter(|x| x.abs() <= 1.0)));
    let (error, at) = worst(&sines, |[x, _]| f64::from(x).asin(), 0);
    assert!(error <= 4.0, "{error} ulp at {at:?}");
}

#[test]
fn arctangents_are_within_4_ulp_of_any_tangent() {
    let tangents = alone(over(-3.0, 3.0).into_iter().chain(of_every_size()));
    let (error, at) = worst(&tangents, |[x, _]| f64::from(x).atan(), 1);
    assert!(error <= 4.0, "{error} ulp at {at:?}");
}

#[test]
fn azimuths_are_within_4_ulp_all_round_and_of_vectors_of_any_length() {
    let round = over(-3.1415925, 3.1415925).into_iter();
    let circle = round.map(|angle| [f64::from(angle).cos() as f32, f64::from(angle).sin() as f32]);
    let lengths = of_every_size().flat_map(|x| [[x, 1.0], [1.0, x], [x, x], [0.0, x], [x, 0.0], [-x, 0.5 * x]]);
    let vectors: Vec<_> = circle.chain(lengths).collect();
    let (error, at) = worst(&vectors, |[x, y]| f64::from(y).atan2(f64::from(x)), 2);
    assert!(error <= 4.0, "{error} ulp at {at:?}");
}

#[test]
fn sines_and_cosines_are_within_1_2e_7_beyond_a_whole_turn() {
    let angles = alone(over(-7.0, 7.0));
    for (found, [x, _]) in answers(&angles).into_iter().zip(&angles) {
        let (sine, cosine) = f64::from(*x).sin_cos();
        let error = (f64::from(found[3]) - sine).abs().max((f64::from(found[4]) - cosine).abs());
        assert!(error <= 1.2e-7, "{error} at {x}");
    }
}

#[test]
fn the_ends_of_ranges_are_what_they_must_be() {
    let half_turn = std::f32::consts::PI;
    let asked = [
        [1.0, 0.0],
        [-1.0, 0.0],
        [0.0, 0.0],
        [-0.0, 0.0],
        // A filtered sine may be a little more than 1.
        [1.5, 0.0],
        [0.0, -1.0],
        [0.0, 1.0],
        [0.0, f32::MIN_POSITIVE],
    ];
    let found = answers(&asked);
    // No elevation is a right angle.
    let arcsines: Vec<_> = found.iter().map(|five| five[0]).take(5).collect();
    assert_eq!(arcsines, [MAX_ELEVATION, -MAX_ELEVATION, 0.0, 0.0, MAX_ELEVATION]);
    let azimuths: Vec<_> = found.iter().map(|five| five[2]).collect();
    assert_eq!(azimuths[..4], [0.0, half_turn, 0.0, 0.0]);
    assert_eq!(azimuths[5..7], [-half_turn / 2.0, half_turn / 2.0]);
    // The smallest normal number may count as 0.
    assert!(azimuths[7] == half_turn / 2.0 || azimuths[7] == 0.0, "{}", azimuths[7]);
    assert_eq!(found[2][3..], [0.0, 1.0]);
}

#[test]
fn what_is_no_number_gives_an_answer_too() {
    // WGSL leaves open which: only the end is promised.
    let asked = [[f32::NAN, 1.0], [1.0, f32::NAN], [f32::INFINITY, 1.0], [f32::NEG_INFINITY, f32::INFINITY]];
    assert_eq!(answers(&asked).len(), asked.len());
}
