//! `barchan render`: a picture that shows at once whether a bake is right.

#[cfg(feature = "gpu")]
mod gpu;
mod relief;
mod relief_report;
mod search;

use barchan_asset::{BentNormalView, HeightView, HorizonView, SkyVisibilityView};
use barchan_metrics::{MaskDisagreement, signed_colour};
use barchan_pipeline::Table;
use barchan_shade::{DirectionalLight, HorizonShadow, Palette, Picture, Pixels, SkyLight, Surface, TracedShadow};
use serde::Serialize;

use crate::args::{ProgressStyleName, RenderArguments};
use crate::asset_file::AssetFile;
use crate::console;
use crate::failure::{ExitStatus, Failure};
use crate::output;
use crate::png;
use crate::progress::ProgressDisplay;

/// White pixels between pictures that stand side by side.
const GAP_PIXELS: u32 = 8;

/// The most pixels drawn: a 16k square.
const MAX_PIXELS: u64 = 1 << 28;

/// To be said where the program was built without a GPU.
const NO_GPU: &str = "--gpu: this program was built without the feature `gpu`; build it with \
                      `cargo build --release --features gpu`, or leave --gpu out";

#[derive(Serialize)]
struct Report {
    schema: &'static str,
    file: String,
    output: String,
    azimuth_degrees: f64,
    elevation_degrees: f64,
    width: u32,
    height: u32,
    shadow_share: f64,
    /// Against the ray-traced shadow, with `--compare`.
    comparison: Option<Comparison>,
}

#[derive(Serialize)]
struct Comparison {
    wrong_share: f64,
    false_shadow_pixels: u64,
    missed_shadow_pixels: u64,
    /// Between texel centres the horizon is interpolated; there lies most of the rest.
    wrong_share_at_texel_centres: f64,
}

pub(crate) fn run(arguments: &RenderArguments, progress: ProgressStyleName, json: bool) -> Result<ExitStatus, Failure> {
    if arguments.gpu && !cfg!(feature = "gpu") {
        return Err(Failure::Usage(NO_GPU.to_owned()));
    }
    check_comparable(arguments)?;
    output::check_writable(&arguments.output, &arguments.file)?;
    let file = AssetFile::read(&arguments.file)?;
    if file.tables()? == [Table::Curvature] {
        return Err(file.content(
            "the file has the curvature of a mesh alone; a picture needs the relief of a height map, and `dump --format png` \
             draws the mesh in colour",
        ));
    }
    if let Some(eye) = arguments.view.eye() {
        return relief::run(&file, arguments, eye, progress, json);
    }
    if arguments.ambient {
        return ambient(&file, arguments, json);
    }
    let (height, horizon) = (file.decode(Table::Height)?, file.decode(Table::Horizon)?);
    let heights = HeightView::new(height.descriptor, &height.payload).map_err(|error| file.content(error))?;
    let horizon = HorizonView::new(horizon.descriptor, &horizon.payload).map_err(|error| file.content(error))?;
    if (heights.width(), heights.height()) != (horizon.width(), horizon.height()) {
        return Err(file.content("height and horizon differ in extent; a picture needs them to agree"));
    }
    let surface = Surface::new(&heights);
    check_covered(&file, &horizon, arguments.azimuth)?;
    let light = DirectionalLight::from_degrees(arguments.azimuth, arguments.elevation);
    let scene = Scene { pixels: pixels(&file, &surface, arguments.scale)?, surface: &surface, horizon, light };
    #[cfg(feature = "gpu")]
    if arguments.gpu {
        let of_gpu = gpu::Scene::Sunlit { pixels: &scene.pixels, light: &scene.light, palette: Palette::SAND };
        return gpu::run(&file, arguments, &of_gpu, || scene.lit(&scene.mask(&scene.pixels)), json);
    }
    let display = ProgressDisplay::new(progress);
    let drawing = scene.draw(arguments.compare, &display);
    display.finish();
    output::write_whole(&arguments.output, &png::encode(&drawing.picture)?)?;
    console::present(&report(arguments, drawing), json, describe)?;
    Ok(ExitStatus::Success)
}

#[derive(Serialize)]
struct AmbientReport {
    schema: &'static str,
    file: String,
    output: String,
    width: u32,
    height: u32,
    mean_visibility: f64,
}

/// The light of an overcast sky is not ray-traced, so that there is nothing but another device to compare it with.
fn check_comparable(arguments: &RenderArguments) -> Result<(), Failure> {
    if arguments.ambient && arguments.compare && !arguments.gpu {
        let advice = "leave one of them out, or compare CPU and GPU with --gpu";
        return Err(Failure::Usage(format!("--ambient and --compare: an overcast sky is not ray-traced; {advice}")));
    }
    Ok(())
}

/// A picture under an overcast sky.
fn ambient(file: &AssetFile, arguments: &RenderArguments, json: bool) -> Result<ExitStatus, Failure> {
    let (height, visibility) = (file.decode(Table::Height)?, file.decode(Table::SkyVisibility)?);
    let bent_normal = match file.tables()?.contains(&Table::BentNormal) {
        true => Some(file.decode(Table::BentNormal)?),
        false => None,
    };
    let heights = HeightView::new(height.descriptor, &height.payload).map_err(|error| file.content(error))?;
    let visibility =
        SkyVisibilityView::new(visibility.descriptor, &visibility.payload).map_err(|error| file.content(error))?;
    let bent_normal = bent_normal.as_ref().map(|table| BentNormalView::new(table.descriptor, &table.payload));
    let bent_normal = bent_normal.transpose().map_err(|error| file.content(error))?;
    let extents =
        [Some((visibility.width(), visibility.height())), bent_normal.map(|bent| (bent.width(), bent.height()))];
    if extents.into_iter().flatten().any(|extent| extent != (heights.width(), heights.height())) {
        return Err(file.content("height and sky differ in extent; a picture needs them to agree"));
    }
    let (surface, sky) = (Surface::new(&heights), SkyLight::new(&visibility, bent_normal.as_ref()));
    let pixels = pixels(file, &surface, arguments.scale)?;
    let drawn = || Picture::overcast(&pixels, &sky, &Palette::OVERCAST_SAND);
    #[cfg(feature = "gpu")]
    if arguments.gpu {
        let has_bent_normal = bent_normal.is_some();
        let scene = gpu::Scene::Overcast { pixels: &pixels, has_bent_normal, palette: Palette::OVERCAST_SAND };
        return gpu::run(file, arguments, &scene, drawn, json);
    }
    let shares = pixels.map(|x, y| sky.visibility(x, y));
    let report = AmbientReport {
        schema: "barchan.render_ambient/1",
        file: arguments.file.display().to_string(),
        output: arguments.output.display().to_string(),
        width: pixels.width,
        height: pixels.height,
        mean_visibility: shares.iter().sum::<f64>() / shares.len() as f64,
    };
    output::write_whole(&arguments.output, &png::encode(&drawn())?)?;
    console::present(&report, json, |report| {
        let AmbientReport { output, width, height, mean_visibility, .. } = report;
        let share = 100.0 * mean_visibility;
        format!(
            "drew      {output}, {width} × {height} pixels\nsky       overcast, {share:.1} % of it seen on average\n"
        )
    })?;
    Ok(ExitStatus::Success)
}

/// Beyond the arc of a table its nearer end would be shown, which is no shadow of that sun.
fn check_covered(file: &AssetFile, horizon: &HorizonView<'_>, azimuth_degrees: f64) -> Result<(), Failure> {
    let descriptor = *horizon.table().descriptor();
    match console::covered_arc(&descriptor) {
        Some(arc) if !horizon.azimuths().covers(azimuth_degrees.rem_euclid(360.0).to_radians()) => {
            let (file, arc) = (file.path.display(), console::arc(arc));
            Err(Failure::Usage(format!("{file}: --azimuth is {azimuth_degrees}; its horizon is baked {arc}")))
        }
        _ => Ok(()),
    }
}

fn report(arguments: &RenderArguments, drawing: Drawing) -> Report {
    Report {
        schema: "barchan.render/1",
        file: arguments.file.display().to_string(),
        output: arguments.output.display().to_string(),
        azimuth_degrees: arguments.azimuth,
        elevation_degrees: arguments.elevation,
        width: drawing.picture.width,
        height: drawing.picture.height,
        shadow_share: drawing.shadow_share,
        comparison: drawing.comparison,
    }
}

fn pixels(file: &AssetFile, surface: &Surface, scale: u32) -> Result<Pixels, Failure> {
    let pixels = Pixels::over(surface, scale);
    if u64::from(pixels.width) * u64::from(pixels.height) > MAX_PIXELS {
        let (width, height) = (pixels.width, pixels.height);
        return Err(file.content(format!("the picture would be {width} × {height} pixels; at most 2^28 are drawn")));
    }
    Ok(pixels)
}

/// A surface under a sun, and the pixels it is seen through.
struct Scene<'a> {
    surface: &'a Surface,
    horizon: HorizonView<'a>,
    light: DirectionalLight,
    pixels: Pixels,
}

/// What was drawn of a scene.
struct Drawing {
    picture: Picture,
    shadow_share: f64,
    comparison: Option<Comparison>,
}

impl Scene<'_> {
    fn draw(&self, compare: bool, display: &ProgressDisplay) -> Drawing {
        let mask = self.mask(&self.pixels);
        let shadow_share = mask.iter().filter(|&&dark| dark).count() as f64 / mask.len() as f64;
        let picture = self.lit(&mask);
        if !compare {
            return Drawing { picture, shadow_share, comparison: None };
        }
        let traced = TracedShadow::new(self.surface, &self.light, self.horizon.radius());
        let truth = trace(&traced, &self.pixels, display);
        let pictures = [picture, self.lit(&truth), difference(&self.pixels, &mask, &truth)];
        let wrong = MaskDisagreement::between(&truth, &mask);
        let at_centres = match Pixels::one_per_texel(self.surface) {
            centres if centres == self.pixels => wrong,
            centres => {
                let mask = self.mask(&centres);
                MaskDisagreement::between(&trace(&traced, &centres, display), &mask)
            }
        };
        let comparison = Some(Comparison::new(wrong, at_centres));
        Drawing { picture: Picture::side_by_side(&pictures, GAP_PIXELS), shadow_share, comparison }
    }

    /// Where the horizon hides the sun.
    fn mask(&self, pixels: &Pixels) -> Vec<bool> {
        let baked = HorizonShadow::new(&self.horizon, &self.light);
        pixels.map(|x, y| baked.in_shadow(x, y))
    }

    fn lit(&self, shadow: &[bool]) -> Picture {
        Picture::lit(self.surface, &self.light, &self.pixels, shadow, &Palette::SAND)
    }
}

/// Traces a shadow ray for every pixel, which on a large picture takes a while.
fn trace(traced: &TracedShadow<'_>, pixels: &Pixels, display: &ProgressDisplay) -> Vec<bool> {
    let (width, rows) = (pixels.width as usize, pixels.height as usize);
    let mut done = 0;
    pixels.map(|x, y| {
        done += 1;
        if done % width == 0 {
            display.step("trace", done / width, rows);
        }
        traced.in_shadow(x, y)
    })
}

impl Comparison {
    fn new(wrong: MaskDisagreement, at_centres: MaskDisagreement) -> Self {
        Self {
            wrong_share: wrong.rate(),
            false_shadow_pixels: wrong.false_shadow,
            missed_shadow_pixels: wrong.missed_shadow,
            wrong_share_at_texel_centres: at_centres.rate(),
        }
    }
}

/// Where a mask and the truth differ, pixel by pixel.
fn difference(pixels: &Pixels, mask: &[bool], truth: &[bool]) -> Picture {
    let colours = mask.iter().zip(truth).map(|(&mask, &truth)| agreement_colour(mask, truth));
    Picture { width: pixels.width, height: pixels.height, rgb: colours.flatten().collect() }
}

/// Red where a shadow mask is too dark, blue where it is too light, white where it agrees with a lit truth and grey
/// where it agrees with a dark one.
fn agreement_colour(mask: bool, truth: bool) -> [u8; 3] {
    const AGREED_SHADOW: [u8; 3] = [205; 3];
    match (mask, truth) {
        (true, false) => signed_colour(1.0),
        (false, true) => signed_colour(-1.0),
        (true, true) => AGREED_SHADOW,
        (false, false) => signed_colour(0.0),
    }
}

fn describe(report: &Report) -> String {
    let Report { output, azimuth_degrees, elevation_degrees, width, height, shadow_share, .. } = report;
    let mut text = format!(
        "drew      {output}, {width} × {height} pixels\n\
         sun       azimuth {azimuth_degrees}°, elevation {elevation_degrees}°, {:.1} % in shadow\n",
        100.0 * shadow_share
    );
    if let Some(comparison) = &report.comparison {
        text += &format!(
            "compared  left: horizon map, middle: ray-traced, right: difference\n\
             wrong     {:.2} % of pixels, {} too dark (red), {} too light (blue); {:.2} % of texel centres\n",
            100.0 * comparison.wrong_share,
            comparison.false_shadow_pixels,
            comparison.missed_shadow_pixels,
            100.0 * comparison.wrong_share_at_texel_centres
        );
    }
    text
}
