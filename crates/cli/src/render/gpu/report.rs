//! What is said of a picture by the GPU.

use barchan_shade::Fetches;
use barchan_view::{GpuPicture, GpuPixel};
use serde::Serialize;

use super::Scene;
use crate::args::{BaseName, RenderArguments};
use crate::render::relief_report::Cost;

#[derive(Serialize)]
pub(super) struct Report {
    schema: &'static str,
    file: String,
    output: String,
    pub(super) width: u32,
    pub(super) height: u32,
    /// What drew it.
    adapter: String,
    /// Where there is one.
    sun: Option<Sun>,
    /// Of an overcast sky seen from above, on average.
    mean_visibility: Option<f64>,
    /// Seen from a side.
    relief: Option<Relief>,
    /// Against the CPU's picture, with `--compare`.
    pub(super) comparison: Option<Comparison>,
}

#[derive(Serialize)]
struct Sun {
    azimuth_degrees: f64,
    elevation_degrees: f64,
    shadow_share: f64,
}

#[derive(Serialize)]
struct Relief {
    base: &'static str,
    eye_azimuth_degrees: f64,
    eye_elevation_degrees: f64,
    search: &'static str,
    start: &'static str,
    /// The part of the pixels of one picture that see relief.
    seen_share: f64,
    /// Of a pixel that sees relief.
    view: Cost,
    /// The part of the sky's light that is cut off, on average.
    mean_occlusion: Option<f64>,
}

#[derive(Serialize)]
pub(super) struct Comparison {
    /// Of 255, of any pixel and colour.
    largest_difference: u8,
    /// The part of the pixels that differ at all.
    differing_share: f64,
    /// The part that differ by more than 1 of 255.
    differing_share_beyond_1: f64,
    /// The difference, of 255, from which on the third picture has its last colour.
    scale_end: u8,
}

impl Comparison {
    /// Of the differences of pixels, of 255.
    pub(super) fn new(differences: &[u8], scale_end: u8) -> Self {
        let share = |least: u8| {
            differences.iter().filter(|&&difference| difference >= least).count() as f64 / differences.len() as f64
        };
        Self {
            largest_difference: differences.iter().copied().max().unwrap_or(0),
            differing_share: share(1),
            differing_share_beyond_1: share(2),
            scale_end,
        }
    }
}

impl Report {
    pub(super) fn new(arguments: &RenderArguments, scene: &Scene<'_>, adapter: &str, drawn: &GpuPicture) -> Self {
        let seen = || drawn.pixels.iter().flatten();
        let mean = |of: &dyn Fn(&GpuPixel) -> f64| seen().map(of).sum::<f64>() / seen().count().max(1) as f64;
        let mean_share = || mean(&|pixel| f64::from(pixel.share));
        let has_sun = !matches!(scene, Scene::Overcast { .. } | Scene::Relief(super::ReliefScene { sun: None, .. }));
        let relief = |scene: &super::ReliefScene<'_>| {
            let (eye_azimuth_degrees, eye_elevation_degrees) = arguments.view.eye().unwrap_or_default();
            let fetches =
                |pixel: &GpuPixel| Fetches { heights: pixel.fetches.0.into(), tables: pixel.fetches.1.into() };
            Relief {
                base: match arguments.view.on {
                    BaseName::Plane => "plane",
                    BaseName::Sphere => "sphere",
                },
                eye_azimuth_degrees,
                eye_elevation_degrees,
                search: scene.search.name(),
                start: if scene.from_map { "depth_map" } else { "top" },
                seen_share: seen().count() as f64 / drawn.pixels.len() as f64,
                view: Cost::of(seen().map(fetches)),
                mean_occlusion: scene.occlusion.is_some().then(mean_share),
            }
        };
        Self {
            schema: "barchan.render_gpu/1",
            file: arguments.file.display().to_string(),
            output: arguments.output.display().to_string(),
            width: drawn.size.0,
            height: drawn.size.1,
            adapter: adapter.to_owned(),
            sun: has_sun.then(|| Sun {
                azimuth_degrees: arguments.azimuth,
                elevation_degrees: arguments.elevation,
                shadow_share: mean(&|pixel| f64::from(u8::from(pixel.in_shadow))),
            }),
            mean_visibility: matches!(scene, Scene::Overcast { .. }).then(mean_share),
            relief: match scene {
                Scene::Relief(scene) => Some(relief(scene)),
                _ => None,
            },
            comparison: None,
        }
    }

    pub(super) fn describe(&self) -> String {
        let Self { output, width, height, adapter, .. } = self;
        let mut text = format!("drew      {output}, {width} × {height} pixels\ngpu       {adapter}\n");
        if let Some(relief) = &self.relief {
            text += &relief.words();
        }
        if let Some(Sun { azimuth_degrees, elevation_degrees, shadow_share }) = &self.sun {
            let share = 100.0 * shadow_share;
            text += &format!(
                "sun       azimuth {azimuth_degrees}°, elevation {elevation_degrees}°, {share:.1} % in shadow\n"
            );
        }
        if let Some(visibility) = self.mean_visibility {
            text += &format!("sky       overcast, {:.1} % of it seen on average\n", 100.0 * visibility);
        }
        if let Some(occlusion) = self.relief.as_ref().and_then(|relief| relief.mean_occlusion) {
            text += &format!("sky       {:.1} % of its light cut off on average\n", 100.0 * occlusion);
        }
        self.comparison.as_ref().map_or(text.clone(), |comparison| text + &comparison.words())
    }
}

impl Relief {
    fn words(&self) -> String {
        let Self { base, eye_azimuth_degrees, eye_elevation_degrees, search, start, view, .. } = self;
        format!(
            "eye       azimuth {eye_azimuth_degrees}°, elevation {eye_elevation_degrees}°, relief on a {base}\n\
             search    {search} from {start}: {}\n",
            view.words()
        )
    }
}

impl Comparison {
    fn words(&self) -> String {
        let Self { largest_difference, differing_share, differing_share_beyond_1, scale_end } = self;
        format!(
            "compared  left: CPU, middle: GPU, right: difference; yellow is {scale_end} of 255 and more\n\
             differs   by {largest_difference} of 255 at most; {:.3} % of pixels at all, {:.3} % by more than 1\n",
            100.0 * differing_share,
            100.0 * differing_share_beyond_1
        )
    }
}
