//! The light of the sky, its cone, and the surface, on the GPU and on the CPU.

use barchan_asset::{
    ApertureConeTable, ApertureConeView, BentNormalTable, BentNormalView, Encoding, HeightTable, HeightView, Semantic,
    SkyVisibilityTable, SkyVisibilityView, TableGrid, TableView,
};
use barchan_shade::{SkyLight, Surface, Texture};
use barchan_view::{Probe, ProbePass};
use barchan_wgpu::{Sampling, Selection, Technique};
use glam::DVec3;

use crate::band::{Band, Filtered};
use crate::compare::agree;
use crate::support::{self, Loaded, SAMPLINGS, WRAPS, noise, numbers, places, report};

/// How far numbers without a unit, heights of up to 2 and directions may be from the twin's: rounding of f32.
const TOLERANCE: f64 = 2e-6;

const SIZE: (u32, u32) = (21, 13);

fn probes() -> [Probe; 3] {
    [
        Probe { size: (30, 22), place: [-4.0, -4.0], ..Probe::default() },
        Probe { size: (64, 48), place: [-3.125, -2.375], step: [0.4375, 0.3125], ..Probe::default() },
        Probe { size: (32, 32), place: [-840.0, -520.0], step: [52.328_125, 32.328_125], ..Probe::default() },
    ]
}

/// Heights and all that is known of the sky, different from texel to texel; bent normals as long as `rim` along the base, or shorter, and never longer than 1.
fn file(encoding: Encoding, grid: TableGrid, rim: f32) -> Loaded {
    let texels = || 0..grid.width * grid.height;
    let heights: Vec<f32> = texels().map(|texel| 2.0 * noise(1, texel)).collect();
    let visibility: Vec<f32> = texels().map(|texel| noise(2, texel)).collect();
    let level = |seed, texel, size: f32| {
        let (sine, cosine) = libm::sincosf(6.3 * noise(seed, texel));
        [size * cosine, size * sine]
    };
    let bent: Vec<f32> = texels().flat_map(|texel| level(3, texel, (rim * noise(4, texel).sqrt()).min(1.0))).collect();
    // Not so low that two could be opposite to each other.
    let cones: Vec<f32> = texels()
        .flat_map(|texel| {
            let [u, v] = level(5, texel, 0.9 * noise(6, texel));
            [u, v, (1.0 - u * u - v * v).sqrt(), 2.0 * noise(8, texel) - 1.0]
        })
        .collect();
    let radius = 10.0;
    Loaded::of_tables([
        HeightTable { grid, values: &heights }.encode(encoding).unwrap(),
        SkyVisibilityTable { grid, radius, values: &visibility }.encode(encoding).unwrap(),
        BentNormalTable { grid, radius, values: &bent }.encode(encoding).unwrap(),
        ApertureConeTable { grid, radius, values: &cones }.encode(encoding).unwrap(),
    ])
}

/// What every encoding, edge and sampling is held to.
fn of_every_file(mut check: impl FnMut(&str, &Loaded, Sampling)) {
    for encoding in Encoding::ALL {
        for (edges, wraps) in WRAPS {
            let loaded = file(encoding, support::grid(SIZE, (0.75, 1.25), wraps), 0.97);
            for sampling in SAMPLINGS {
                check(&format!("{}_{edges}_{sampling:?}", encoding.name()), &loaded, sampling);
            }
        }
    }
}

/// What may be found of a channel: the twin's number, or what a sampler makes of it.
struct Channel {
    texture: Texture,
    filtered: Option<Filtered>,
}

impl Channel {
    fn new(loaded: &Loaded, sampling: Sampling, table: &TableView<'_>, channel: u32) -> Self {
        let is_filtered = loaded.filters(table.descriptor().semantic, sampling);
        Self {
            texture: Texture::of_channel(table, 0, channel),
            filtered: is_filtered.then(|| Filtered::new(table, 0, channel as usize)),
        }
    }

    fn at(&self, (x, y): (f64, f64)) -> Band {
        self.filtered.as_ref().map_or_else(|| Band::only(self.texture.sample(x, y)), |filtered| filtered.at(x, y))
    }
}

/// Holds one of the numbers of a probe against bands.
fn hold(name: &str, probe: &Probe, found: &[f64], tolerance: f64, at: impl Fn((f64, f64)) -> Band) -> f64 {
    let nearest = |(place, &found)| Band::nearest(at(place), found);
    let expected: Vec<f64> = places(probe).into_iter().zip(found).map(nearest).collect();
    agree(name, probe.size, found, &expected, tolerance, 0.0)
}

/// Shares, irradiances and bent normals; of an even sky if there are none of the last.
fn check_sky(name: &str, loaded: &Loaded, sampling: Sampling, is_bent: bool, tolerance: f64) {
    let pass = loaded.pass(&[Technique::Sky], sampling);
    let visibility = loaded.view(Semantic::SkyVisibility, SkyVisibilityView::new);
    let bent = loaded.view(Semantic::BentNormal, BentNormalView::new);
    let twin = SkyLight::new(&visibility, is_bent.then_some(&bent));
    let share = Channel::new(loaded, sampling, &visibility.table(), 0);
    let level = is_bent.then(|| [0, 1].map(|channel| Channel::new(loaded, sampling, &bent.table(), channel)));
    let irradiance = |place: (f64, f64)| {
        if share.filtered.is_none() {
            return Band::only(twin.irradiance(place.0, place.1));
        }
        let brightness = level.as_ref().map_or(Band::only(1.0), |level| {
            let squares = level.each_ref().map(|component| component.at(place).square());
            let height = |square: f64| (1.0 + 2.0 * (1.0 - square).max(0.0).sqrt()) / 3.0;
            Band { low: squares[0].low + squares[1].low, high: squares[0].high + squares[1].high }.map(height)
        });
        share.at(place).times(brightness)
    };
    let mut worst = 0.0_f64;
    for probe in probes() {
        let found = pass.draw(&probe).unwrap();
        worst =
            worst.max(hold(&format!("{name}_share"), &probe, &numbers(&found, 0), TOLERANCE, |place| share.at(place)));
        worst = worst.max(hold(&format!("{name}_irradiance"), &probe, &numbers(&found, 1), tolerance, irradiance));
        for (which, component) in level.iter().flatten().enumerate() {
            let found = numbers(&found, 2 + which);
            worst = worst
                .max(hold(&format!("{name}_bent_{which}"), &probe, &found, TOLERANCE, |place| component.at(place)));
        }
    }
    report(name, worst, tolerance);
}

#[test]
fn the_light_of_the_sky_agrees() {
    of_every_file(|name, loaded, sampling| check_sky(&format!("sky_{name}"), loaded, sampling, true, TOLERANCE));
}

#[test]
fn an_even_sky_agrees() {
    for encoding in Encoding::ALL {
        let of_all = file(encoding, support::grid(SIZE, (0.75, 1.25), WRAPS[2].1), 0.97);
        let loaded = Loaded::selected(of_all.bytes, &Selection::tables(&[Semantic::SkyVisibility]));
        for sampling in SAMPLINGS {
            check_sky(&format!("even_sky_{}_{sampling:?}", encoding.name()), &loaded, sampling, false, TOLERANCE);
        }
    }
}

#[test]
fn a_sky_seen_along_the_base_agrees() {
    // Where the height of a bent normal vanishes, a last bit of the others makes 3e-4 of it.
    let loaded = file(Encoding::F32, support::grid(SIZE, (0.75, 1.25), WRAPS[0].1), 2.0);
    check_sky("low_sky", &loaded, Sampling::Loaded, true, 4e-4);
}

/// How far apart two directions may be if each component of one, before it is made a unit vector, is somewhere in a band.
fn spread(bands: &[Band], length: f64) -> f64 {
    let off = bands.iter().map(|band| (0.5 * (band.high - band.low)).powi(2)).sum::<f64>().sqrt();
    off / (length - off).max(1e-9)
}

fn centre(band: Band) -> f64 {
    0.5 * (band.low + band.high)
}

fn around(number: f64, spread: f64) -> Band {
    Band { low: number - spread, high: number + spread }
}

#[test]
fn the_cone_of_the_sky_agrees() {
    of_every_file(|name, loaded, sampling| {
        let name = format!("aperture_{name}");
        let pass = loaded.pass(&[Technique::ApertureCone], sampling);
        let table = loaded.view(Semantic::ApertureCone, ApertureConeView::new).table();
        let channels = [0, 1, 2, 3].map(|channel| Channel::new(loaded, sampling, &table, channel));
        let mut worst = 0.0_f64;
        for probe in probes() {
            let found = pass.draw(&probe).unwrap();
            for which in 0..4 {
                let expected = |place: (f64, f64)| {
                    let bands = [0, 1, 2].map(|channel: usize| channels[channel].at(place));
                    let axis = DVec3::from_array(bands.map(centre));
                    match which {
                        3 => channels[3].at(place),
                        _ => around(axis.normalize()[which], spread(&bands, axis.length())),
                    }
                };
                worst = worst.max(hold(&name, &probe, &numbers(&found, which), TOLERANCE, expected));
            }
        }
        report(&name, worst, TOLERANCE);
    });
}

#[test]
fn surfaces_agree() {
    of_every_file(|name, loaded, sampling| {
        let name = format!("surface_{name}");
        let pass: ProbePass<'_> = loaded.pass(&[Technique::Surface], sampling);
        let view = loaded.view(Semantic::Height, HeightView::new);
        let (twin, heights) = (Surface::new(&view), Channel::new(loaded, sampling, &view.table(), 0));
        let normal = |(x, y): (f64, f64), which: usize| {
            if heights.filtered.is_none() {
                return Band::only(twin.normal(x, y)[which]);
            }
            // To the right less to the left, above less below.
            let beside =
                [[(x + 1.0, y), (x - 1.0, y)], [(x, y - 1.0), (x, y + 1.0)]].map(|pair| pair.map(|at| heights.at(at)));
            let (spacing_u, spacing_v) = twin.spacing();
            let slopes = [(beside[0], spacing_u), (beside[1], spacing_v)].map(|([ahead, behind], spacing)| Band {
                low: (ahead.low - behind.high) / (2.0 * spacing),
                high: (ahead.high - behind.low) / (2.0 * spacing),
            });
            let upright = DVec3::new(-centre(slopes[0]), -centre(slopes[1]), 1.0);
            around(upright.normalize()[which], spread(&slopes, upright.length()))
        };
        let mut worst = 0.0_f64;
        for probe in probes() {
            let found = pass.draw(&probe).unwrap();
            worst = worst.max(hold(&name, &probe, &numbers(&found, 0), TOLERANCE, |place| heights.at(place)));
            for which in 0..3 {
                let normals = numbers(&found, 1 + which);
                worst = worst.max(hold(&name, &probe, &normals, TOLERANCE, |place| normal(place, which)));
            }
        }
        report(&name, worst, TOLERANCE);
    });
}
