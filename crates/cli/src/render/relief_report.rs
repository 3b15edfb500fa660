//! What is said of a picture of relief seen from a side.

use barchan_metrics::MaskDisagreement;
use barchan_shade::{Fetches, ReliefPixels, ShadowAnswer};
use serde::Serialize;

use crate::args::{BaseName, RenderArguments, SearchName};
use crate::console::number;

#[derive(Default, Serialize)]
pub(super) struct Report {
    schema: &'static str,
    file: String,
    output: String,
    pub(super) width: u32,
    pub(super) height: u32,
    base: &'static str,
    eye_azimuth_degrees: f64,
    eye_elevation_degrees: f64,
    search: &'static str,
    start: &'static str,
    /// The part of the pixels of one picture that see relief.
    seen_share: f64,
    /// Of a pixel that sees relief.
    view: Cost,
    pub(super) sun: Option<Sun>,
    /// The part of the sky's light that is cut off, on average.
    pub(super) mean_occlusion: Option<f64>,
    pub(super) heat: Option<Heat>,
    pub(super) comparison: Option<Comparison>,
}

/// What a ray reads.
#[derive(Default, Serialize)]
pub(super) struct Cost {
    mean_height_fetches: f64,
    mean_table_fetches: f64,
    greatest_fetches: u32,
}

#[derive(Serialize)]
pub(super) struct Sun {
    azimuth_degrees: f64,
    elevation_degrees: f64,
    shadow_share: f64,
    rays: Cost,
}

#[derive(Serialize)]
pub(super) struct Heat {
    pub(super) baseline: Cost,
    /// The count at the right end of the legend.
    pub(super) scale_end: u32,
}

#[derive(Serialize)]
pub(super) struct Comparison {
    /// Parts of the relief's whole depth.
    rms_depth_error: f64,
    max_depth_error: f64,
    /// The part of what is seen that is another point of the relief.
    other_point_share: f64,
    wrong_shadow_share: f64,
    false_shadow_pixels: u64,
    missed_shadow_pixels: u64,
}

impl Cost {
    pub(super) fn of(fetches: impl Iterator<Item = Fetches> + Clone) -> Self {
        let count = fetches.clone().count().max(1) as f64;
        let mean = |of: fn(Fetches) -> u32| fetches.clone().map(|all| u64::from(of(all))).sum::<u64>() as f64 / count;
        Self {
            mean_height_fetches: mean(|fetches| fetches.heights),
            mean_table_fetches: mean(|fetches| fetches.tables),
            greatest_fetches: fetches.map(|all| all.total()).max().unwrap_or(0),
        }
    }

    pub(super) fn of_view(seen: &ReliefPixels<'_>) -> Self {
        Self::of(seen.pixels().iter().flatten().map(|pixel| pixel.fetches))
    }

    fn total(&self) -> f64 {
        self.mean_height_fetches + self.mean_table_fetches
    }

    pub(super) fn words(&self) -> String {
        let Self { mean_height_fetches, mean_table_fetches, greatest_fetches } = self;
        format!(
            "{} fetches a ray ({} of heights, {} of tables), {greatest_fetches} at most",
            number(self.total()),
            number(*mean_height_fetches),
            number(*mean_table_fetches)
        )
    }
}

impl Sun {
    pub(super) fn new(arguments: &RenderArguments, answers: &[Option<ShadowAnswer>]) -> Self {
        let seen = answers.iter().flatten();
        let dark = seen.clone().filter(|answer| answer.in_shadow).count();
        Self {
            azimuth_degrees: arguments.azimuth,
            elevation_degrees: arguments.elevation,
            shadow_share: dark as f64 / seen.clone().count().max(1) as f64,
            rays: Cost::of(seen.map(|answer| answer.fetches)),
        }
    }
}

impl Comparison {
    /// Of errors of depth where both see relief, and of shadows.
    pub(super) fn new(errors: &[Option<f64>], same_point: f64, shadows: MaskDisagreement) -> Self {
        let seen = || errors.iter().flatten();
        let count = seen().count().max(1) as f64;
        Self {
            rms_depth_error: (seen().map(|error| error * error).sum::<f64>() / count).sqrt(),
            max_depth_error: seen().fold(0.0, |greatest, error| error.abs().max(greatest)),
            other_point_share: seen().filter(|error| error.abs() > same_point).count() as f64 / count,
            wrong_shadow_share: (shadows.false_shadow + shadows.missed_shadow) as f64 / count,
            false_shadow_pixels: shadows.false_shadow,
            missed_shadow_pixels: shadows.missed_shadow,
        }
    }
}

impl Report {
    pub(super) fn new(
        arguments: &RenderArguments,
        (eye_azimuth_degrees, eye_elevation_degrees): (f64, f64),
        seen: &ReliefPixels<'_>,
        (search, from_map): (SearchName, bool),
    ) -> Self {
        Self {
            schema: "barchan.render_relief/1",
            file: arguments.file.display().to_string(),
            output: arguments.output.display().to_string(),
            base: match arguments.view.on {
                BaseName::Plane => "plane",
                BaseName::Sphere => "sphere",
            },
            eye_azimuth_degrees,
            eye_elevation_degrees,
            search: search.name(),
            start: if from_map { "depth_map" } else { "top" },
            seen_share: seen.pixels().iter().flatten().count() as f64 / seen.pixels().len() as f64,
            view: Cost::of_view(seen),
            ..Self::default()
        }
    }

    pub(super) fn describe(&self) -> String {
        let Self { output, width, height, base, eye_azimuth_degrees, eye_elevation_degrees, search, start, .. } = self;
        let mut text = format!(
            "drew      {output}, {width} × {height} pixels\n\
             eye       azimuth {eye_azimuth_degrees}°, elevation {eye_elevation_degrees}°, relief on a {base}\n\
             search    {search} from {start}: {}\n",
            self.view.words()
        );
        if let Some(Heat { baseline, scale_end }) = &self.heat {
            let ratio = number(self.view.total() / baseline.total());
            text += &format!(
                "heat      left: linear from top, {}; right: the search above, {ratio} times as many; yellow is {scale_end}\n",
                baseline.words()
            );
        }
        if let Some(Sun { azimuth_degrees, elevation_degrees, shadow_share, rays }) = &self.sun {
            let (share, rays) = (100.0 * shadow_share, rays.words());
            text += &format!(
                "sun       azimuth {azimuth_degrees}°, elevation {elevation_degrees}°, {share:.1} % in shadow: {rays}\n"
            );
        }
        if let Some(occlusion) = self.mean_occlusion {
            text += &format!("sky       {:.1} % of its light cut off on average\n", 100.0 * occlusion);
        }
        self.comparison.as_ref().map_or(text.clone(), |comparison| text + &comparison.words())
    }
}

impl Comparison {
    fn words(&self) -> String {
        format!(
            "compared  left: this search, middle: ray-traced, right: difference; the sky is open in both\n\
             depth     {} RMS, {} at most, of the relief's depth; {:.3} % of pixels see another point (green)\n\
             wrong     {:.3} % of shadows, {} too dark (red), {} too light (blue)\n",
            number(self.rms_depth_error),
            number(self.max_depth_error),
            100.0 * self.other_point_share,
            100.0 * self.wrong_shadow_share,
            self.false_shadow_pixels,
            self.missed_shadow_pixels
        )
    }
}
