//! Horizon shadows on the GPU and on the CPU.

use barchan_asset::{Azimuths, Encoding, HorizonTable, HorizonView, MAX_ELEVATION, Semantic, TextureTable, Wrap};
use barchan_field::shapes::Dunes;
use barchan_field::{Edge, Shape};
use barchan_pipeline::Table;
use barchan_shade::{DirectionalLight, HorizonShadow};
use barchan_view::{Probe, ProbePass};
use barchan_wgpu::{Sampling, Shader, ShaderOptions, Technique};

use crate::band::{Band, Filtered};
use crate::compare::agree;
use crate::support::{self, ENCODINGS, Loaded, SAMPLINGS, WRAPS, gpu, light, noise, numbers, places};

/// How far elevations on the GPU may be from the twin's, in radians: rounding of f32, of the azimuth most of all, between layers that
/// differ by up to 160°.
const TOLERANCE: f64 = 4e-6;

/// Elevations between ±80° from texel to texel: steeper than any relief.
fn table(
    encoding: Encoding,
    azimuths: Azimuths,
    size: (u32, u32),
    wraps: (Wrap, Wrap),
    elevation_radians: impl Fn(u32) -> f32,
) -> TextureTable {
    let values: Vec<f32> = (0..size.0 * size.1 * azimuths.count()).map(elevation_radians).collect();
    let grid = support::grid(size, (0.75, 1.25), wraps);
    HorizonTable { grid, azimuths, radius: 10.0, values: &values }.encode(encoding).unwrap()
}

fn rough(index: u32) -> f32 {
    2.8 * (noise(7, index) - 0.5)
}

/// Horizons on the GPU, and what they are held against.
struct Horizons<'a> {
    name: String,
    view: HorizonView<'a>,
    pass: ProbePass<'a>,
    /// The layers, where the sampler filters them.
    filtered: Option<Vec<Filtered>>,
    tolerance: f64,
    worst: f64,
}

impl<'a> Horizons<'a> {
    fn new(name: String, loaded: &'a Loaded, sampling: Sampling) -> Self {
        let view = loaded.view(Semantic::HorizonElevation, HorizonView::new);
        let filtered = loaded.filters(Semantic::HorizonElevation, sampling);
        let layer = |layer| Filtered::new(&view.table(), layer, 0);
        Self {
            name: format!("horizon_{name}_{sampling:?}"),
            view,
            pass: loaded.pass(&[Technique::HorizonShadow], sampling),
            filtered: filtered.then(|| (0..view.directions()).map(layer).collect()),
            tolerance: TOLERANCE,
            worst: 0.0,
        }
    }

    /// Elevations and shadows of a light.
    fn check(&mut self, light: &DirectionalLight, probe: &Probe) {
        let probe = Probe { light: light.towards.as_vec3().to_array(), ..*probe };
        let found = self.pass.draw(&probe).unwrap();
        self.hold(light, &probe, &found);
    }

    fn hold(&mut self, light: &DirectionalLight, probe: &Probe, found: &[[f32; 4]]) {
        let twin = HorizonShadow::new(&self.view, light);
        let places = places(probe);
        let bands: Vec<Band> = places.iter().map(|&(x, y)| self.band(&twin, light, x, y)).collect();
        let (elevations, shadows) = (numbers(found, 0), numbers(found, 1));
        let nearest: Vec<f64> = bands.iter().zip(&elevations).map(|(band, &found)| band.nearest(found)).collect();
        let worst = agree(&self.name, probe.size, &elevations, &nearest, self.tolerance, 0.0);
        self.worst = self.worst.max(worst);

        // Where the light is as high as the horizon, as far as can be told, it may be seen or not.
        let height = libm::atan2(light.towards.z, light.level_length());
        let expected: Vec<f64> = (0..places.len())
            .map(|index| match (bands[index].holds(height, self.tolerance), &self.filtered) {
                (true, _) => shadows[index],
                (false, None) => f64::from(twin.in_shadow(places[index].0, places[index].1)),
                (false, Some(_)) => f64::from(bands[index].low > height),
            })
            .collect();
        agree(&format!("{}_shadow", self.name), probe.size, &shadows, &expected, 0.0, 0.0);
    }

    fn band(&self, twin: &HorizonShadow, light: &DirectionalLight, x: f64, y: f64) -> Band {
        let Some(layers) = &self.filtered else { return Band::only(twin.elevation_radians(x, y)) };
        let (first, second, weight) = self.view.neighbours(light.azimuth_radians);
        layers[first as usize].at(x, y).mix(layers[second as usize].at(x, y), f64::from(weight))
    }

    fn report(&self) {
        support::report(&self.name, self.worst, self.tolerance);
    }
}

/// Texel centres beyond the edges, places between them, and places far away on all sides, of a table of some size.
fn probes((width, height): (u32, u32)) -> [Probe; 3] {
    let (width, height) = (width as f32, height as f32);
    let far = |texels: f32| (texels * 2.5).floor() + 0.328_125;
    [
        Probe { size: (width as u32 + 8, height as u32 + 8), place: [-4.0, -4.0], ..Probe::default() },
        Probe { size: (64, 48), place: [-3.125, -2.375], step: [0.4375, 0.3125], ..Probe::default() },
        Probe {
            size: (32, 32),
            place: [-40.0 * width, -40.0 * height],
            step: [far(width), far(height)],
            ..Probe::default()
        },
    ]
}

/// On baked azimuths, half-way between them, a little beside them and across the seam; high, low, level, below the base, straight up and
/// straight down.
fn lights(directions: u32) -> Vec<DirectionalLight> {
    let step = 360.0 / f64::from(directions);
    let seam = [359.99, -1e-4, 1e-4, 360.0, 725.0, -360.0 * 11.0 - 0.5 * step];
    let places =
        [0.0, 0.5, 0.97].into_iter().flat_map(|part| (0..directions).map(move |k| step * (f64::from(k) + part)));
    let elevations = [0.0, 30.0, -12.0, 4.0, 71.0];
    let mut lights: Vec<_> = places
        .chain(seam)
        .zip(elevations.into_iter().cycle())
        .map(|(azimuth, elevation)| light(azimuth, elevation))
        .collect();
    lights.extend([support::towards(glam::DVec3::Z), support::towards(glam::DVec3::NEG_Z)]);
    lights
}

#[test]
fn every_encoding_edge_and_sampling_agrees() {
    let size = (33, 17);
    for encoding in Encoding::ALL {
        for (edges, wraps) in WRAPS {
            let loaded = Loaded::of_tables([table(encoding, Azimuths::full_circle(7), size, wraps, rough)]);
            for sampling in SAMPLINGS {
                let mut horizons = Horizons::new(format!("{}_{edges}", encoding.name()), &loaded, sampling);
                for light in lights(7) {
                    probes(size).iter().for_each(|probe| horizons.check(&light, probe));
                }
                horizons.report();
            }
        }
    }
}

#[test]
fn tables_of_few_texels_agree() {
    let wraps = (Wrap::Repeat, Wrap::Clamp);
    for (width, height) in [(1, 1), (7, 1), (1, 5), (2, 31)] {
        let loaded =
            Loaded::of_tables([table(Encoding::Compact, Azimuths::full_circle(3), (width, height), wraps, rough)]);
        for sampling in SAMPLINGS {
            let mut horizons = Horizons::new(format!("{width}_by_{height}"), &loaded, sampling);
            for light in lights(3) {
                probes((width, height)).iter().for_each(|probe| horizons.check(&light, probe));
            }
            horizons.report();
        }
    }
}

#[test]
fn walls_agree() {
    let wall = |index| [MAX_ELEVATION, 0.0, -MAX_ELEVATION, 1.5][(4.0 * noise(3, index)) as usize];
    for encoding in Encoding::ALL {
        let loaded = Loaded::of_tables([table(encoding, Azimuths::full_circle(4), (9, 9), WRAPS[1].1, wall)]);
        for sampling in SAMPLINGS {
            let mut horizons = Horizons::new(format!("walls_{}", encoding.name()), &loaded, sampling);
            for (azimuth, elevation) in
                [(0.0, 0.0), (90.0, 60.0), (45.0, 89.0), (200.0, -30.0), (0.0, 90.0), (0.0, -90.0)]
            {
                probes((9, 9)).iter().for_each(|probe| horizons.check(&light(azimuth, elevation), probe));
            }
            horizons.report();
        }
    }
}

#[test]
fn arcs_end_at_both_ends() {
    let size = (5, 4);
    let arcs = [
        ("half", Azimuths::arc(-90_f64.to_radians(), 90_f64.to_radians(), 5)),
        ("across_the_seam", Azimuths::arc(6.0, 8.0, 2)),
        ("nearly_all_round", Azimuths::arc(-3.0, 3.0, 9)),
        ("one_azimuth", Azimuths::arc(1.0, 1.0, 1)),
        ("one_all_round", Azimuths::full_circle(1)),
        ("many", Azimuths::full_circle(64)),
    ];
    for (name, azimuths) in arcs {
        let loaded = Loaded::of_tables([table(Encoding::F32, azimuths, size, WRAPS[0].1, rough)]);
        let mut horizons = Horizons::new(name.to_owned(), &loaded, Sampling::Loaded);
        // What f32 keeps of the azimuth, 2⁻²¹ rad, over a step of a tenth.
        horizons.tolerance = if azimuths.count() == 64 { 2e-5 } else { TOLERANCE };
        let (first, last) = (azimuths.radians(0), azimuths.radians(azimuths.count() - 1));
        let gap = core::f64::consts::TAU - (last - first);
        let ends = [first, last, last + 0.49 * gap, last + 0.51 * gap];
        let beside = ends.into_iter().flat_map(|end| [-0.3, -1e-3, 0.0, 1e-3, 0.3].map(|beside| end + beside));
        let half_way = (0..azimuths.count()).map(|k| azimuths.radians(k) + 0.5 * azimuths.step_radians());
        for azimuth in beside.chain(half_way) {
            let is_in_the_middle_of_the_gap =
                (libm::remainder(azimuth - last - 0.5 * gap, core::f64::consts::TAU)).abs() < 1e-3;
            if !is_in_the_middle_of_the_gap {
                horizons.check(&light(azimuth.to_degrees(), 10.0), &probes(size)[1]);
            }
        }
        horizons.report();
    }
}

#[test]
fn turns_do_not_count() {
    let size = (4, 3);
    let loaded = Loaded::of_tables([table(Encoding::F32, Azimuths::full_circle(6), size, WRAPS[0].1, rough)]);
    let options = ShaderOptions { group: 0, sampling: Sampling::Loaded, probes: true };
    let shader = Shader::compose(&loaded.plan, &[Technique::HorizonShadow], &options).unwrap();
    // The azimuth as it is, in place of the radius of the light's disc.
    let more = "
@fragment
fn of_azimuth(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = barchan_probe_place(position);
    return vec4<f32>(barchan_horizon_elevation(place, barchan_probe.angular_radius), 0.0, 0.0, 0.0);
}
";
    let pass = ProbePass::of_shader(gpu(), &loaded.asset, &shader, more, "of_azimuth").unwrap();
    let view = loaded.view(Semantic::HorizonElevation, HorizonView::new);
    for azimuth in [0.0, -1e-7, 1e-7, 6.283_185_4, -6.283_185_4, 3.0, 40.0, -40.0, 640.0, -640.0_f32] {
        let probe = Probe { angular_radius: azimuth, ..probes(size)[1] };
        let light = DirectionalLight { azimuth_radians: f64::from(azimuth), ..light(0.0, 0.0) };
        let twin = HorizonShadow::new(&view, &light);
        let expected: Vec<f64> = places(&probe).iter().map(|&(x, y)| twin.elevation_radians(x, y)).collect();
        // What f32 keeps of the azimuth, over a step, between layers that differ by up to 2.8 rad.
        let tolerance = TOLERANCE + 2.8 * 2.4e-7 * f64::from(azimuth.abs());
        agree("horizon_turns", probe.size, &numbers(&pass.draw(&probe).unwrap(), 0), &expected, tolerance, 0.0);
    }
}

#[test]
fn baked_dunes_agree() {
    let shape = Shape::Dunes(Dunes {
        dune_height: 4.0,
        dunes_across: 2,
        ripple_height: 0.5,
        ripples_across: 9,
        sinuosity: 0.6,
        slip_degrees: 32.0,
        seed: 7,
    });
    for edge in [Edge::Wrap, Edge::Clamp] {
        for encoding in ENCODINGS {
            let loaded = Loaded::baked(support::recipe(shape, (48, 40), edge, encoding), &[Table::Horizon]);
            for sampling in SAMPLINGS {
                let mut horizons = Horizons::new(format!("dunes_{encoding:?}_{edge:?}"), &loaded, sampling);
                // Layers of neighbouring azimuths are alike.
                horizons.tolerance = 5e-7;
                for light in [(0.0, 3.0), (33.0, 5.0), (350.0, 10.0), (202.5, 0.0)].map(|(a, e)| light(a, e)) {
                    probes((48, 40)).iter().for_each(|probe| horizons.check(&light, probe));
                }
                horizons.report();
            }
        }
    }
}
