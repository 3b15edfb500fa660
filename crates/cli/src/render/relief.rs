//! Relief seen from a side: every pixel by a relief ray.

use barchan_asset::HeightView;
use barchan_metrics::{MaskDisagreement, false_colour};
use barchan_pipeline::Table;
use barchan_shade::{
    DirectionalLight, HemisphereOcclusion, HemisphereQuadrature, Palette, Picture, Relief, ReliefLight, ReliefPixels,
    ReliefRoad, ReliefShadow, ReliefStage, SHADOW_TOLERANCE, StageEye, Surface, TracedRelief, heat_map,
};

#[cfg(feature = "gpu")]
use super::gpu;
use super::relief_report::{Comparison, Cost, Heat, Report, Sun};
use super::{GAP_PIXELS, agreement_colour, search};
use crate::args::{BaseName, ProgressStyleName, RenderArguments, SearchName, StartName};
use crate::asset_file::AssetFile;
use crate::console;
use crate::failure::{ExitStatus, Failure};
use crate::output;
use crate::png;
use crate::progress::ProgressDisplay;

/// What is farther off than that, as a part of the relief's depth, is another point of the relief.
const SAME_POINT: f64 = 1.0 / 256.0;

/// Rings and azimuths of the rays that look for the sky: of the same weight, so that few do.
const OCCLUSION_DIRECTIONS: (u32, u32) = (8, 16);

/// Where another point of the relief is seen.
const OTHER_POINT: [u8; 3] = [0, 158, 115];

pub(super) fn run(
    file: &AssetFile,
    arguments: &RenderArguments,
    eye: (f64, f64),
    progress: ProgressStyleName,
    json: bool,
) -> Result<ExitStatus, Failure> {
    let height = file.decode(Table::Height)?;
    let heights = HeightView::new(height.descriptor, &height.payload).map_err(|error| file.content(error))?;
    let surface = Surface::new(&heights);
    let relief = Relief::new(&surface);
    let name = match arguments.view.search {
        Some(name) => name,
        None => SearchName::best_of(file)?,
    };
    let search = name.open(file, &relief)?;
    let hemisphere = search::hemisphere(file, arguments)?;
    let depth_map = hemisphere.as_ref().map(|table| search::depth_map(file, &relief, table)).transpose()?;
    let start = depth_map.as_ref().filter(|_| arguments.view.start != Some(StartName::Top));
    let display = ProgressDisplay::new(progress);
    let scene = Scene {
        arguments,
        relief,
        stage: stage(file, arguments, eye, &surface)?,
        road: ReliefRoad { depth_map: start, search: &*search },
        has_hemisphere: depth_map.is_some(),
        display: &display,
    };
    #[cfg(feature = "gpu")]
    if arguments.gpu {
        let by_cpu = || scene.lit(&scene.look(&scene.road), &mut Report::default());
        return gpu::run(file, arguments, &gpu::Scene::Relief(scene.of_gpu(name)), by_cpu, json);
    }
    let seen = scene.look(&scene.road);
    let mut report = Report::new(arguments, eye, &seen, (name, start.is_some()));
    let picture = match () {
        () if arguments.view.heat => scene.heat(&seen, &mut report),
        () if arguments.compare => scene.compared(&seen, &mut report),
        () => scene.lit(&seen, &mut report),
    };
    display.finish();
    (report.width, report.height) = (picture.width, picture.height);
    output::write_whole(&arguments.output, &png::encode(&picture)?)?;
    console::present(&report, json, Report::describe)?;
    Ok(ExitStatus::Success)
}

fn stage(
    file: &AssetFile,
    arguments: &RenderArguments,
    (azimuth, elevation): (f64, f64),
    surface: &Surface,
) -> Result<ReliefStage, Failure> {
    let view = &arguments.view;
    let eye = StageEye { azimuth, elevation, size: view.size };
    match view.on {
        BaseName::Plane => Ok(ReliefStage::plane(surface, eye, view.tiles.unwrap_or(2))),
        BaseName::Sphere if ReliefStage::repeats(surface) => {
            Ok(ReliefStage::ball(surface, eye, view.tiles.unwrap_or(8)))
        }
        BaseName::Sphere => {
            let file = file.path.display();
            Err(Failure::Usage(format!("{file}: --on sphere needs a tile whose edges wrap; these are clamped")))
        }
    }
}

/// Relief before a camera, and how it is found.
struct Scene<'a> {
    arguments: &'a RenderArguments,
    relief: Relief<'a>,
    stage: ReliefStage,
    road: ReliefRoad<'a>,
    /// Whether the sky's light is dimmed: without depth maps that takes long.
    has_hemisphere: bool,
    display: &'a ProgressDisplay,
}

impl<'a> Scene<'a> {
    fn look(&self, road: &ReliefRoad<'_>) -> ReliefPixels<'a> {
        ReliefPixels::new(&self.stage.camera, self.stage.base.surface(), &self.relief, road)
    }

    /// What the GPU needs to know.
    #[cfg(feature = "gpu")]
    fn of_gpu(&self, search: SearchName) -> gpu::ReliefScene<'_> {
        gpu::ReliefScene {
            stage: &self.stage,
            search,
            from_map: self.road.depth_map.is_some(),
            sun: (!self.arguments.ambient).then(|| self.sun()),
            occlusion: self.has_hemisphere.then(occlusion_directions),
            palette: self.palette(),
        }
    }

    /// How often each pixel reads, by the baseline and as chosen.
    fn heat(&self, seen: &ReliefPixels<'_>, report: &mut Report) -> Picture {
        let search = search::baseline(&self.relief);
        let baseline = self.look(&ReliefRoad { depth_map: None, search: &*search });
        let pair = [&baseline, seen];
        let counts = pair.map(|seen| seen.map(&None, |pixel| Some(pixel.fetches.total())));
        let greatest = counts[0].iter().flatten().copied().max().unwrap_or(0);
        report.heat = Some(Heat { baseline: Cost::of_view(&baseline), scale_end: greatest });
        let pictures = counts.map(|counts| heat_map(&counts, seen.width(), greatest, false_colour));
        Picture::side_by_side(&pictures, GAP_PIXELS)
    }

    /// Sun and sky, or the sky alone.
    fn lit(&self, seen: &ReliefPixels<'_>, report: &mut Report) -> Picture {
        let (light, ambient) = (self.sun(), self.arguments.ambient);
        let shadow = if ambient { vec![true; seen.pixels().len()] } else { self.shadow(seen, &self.road, report) };
        let occlusion = self.occlusion(seen);
        if let Some(occlusion) = &occlusion {
            report.mean_occlusion = Some(mean(seen, occlusion));
        }
        let light = ReliefLight { sun: light.towards, shadow: &shadow, occlusion: occlusion.as_deref() };
        seen.picture(&light, &self.palette())
    }

    /// What was found, what is traced, and where they differ. The sky is open in both.
    fn compared(&self, seen: &ReliefPixels<'_>, report: &mut Report) -> Picture {
        let tracer = TracedRelief::new(&self.relief);
        let road = ReliefRoad { depth_map: None, search: &tracer };
        let traced = self.look(&road);
        let shadow = self.shadow(seen, &self.road, report);
        let truth = self.shadow(&traced, &road, &mut Report::default());
        let lit = |seen: &ReliefPixels<'_>, shadow: &[bool]| {
            let light = ReliefLight { sun: self.sun().towards, shadow, occlusion: None };
            seen.picture(&light, &self.palette())
        };
        let errors: Vec<_> = (seen.pixels().iter().zip(traced.pixels()))
            .map(|(found, truth)| found.as_ref().zip(truth.as_ref()).map(|(found, truth)| found.depth - truth.depth))
            .collect();
        report.comparison = Some(Comparison::new(&errors, SAME_POINT, MaskDisagreement::between(&truth, &shadow)));
        let colours = errors.iter().zip(shadow.iter().zip(&truth)).map(|(error, (&mask, &truth))| match error {
            Some(error) if error.abs() > SAME_POINT => OTHER_POINT,
            _ => agreement_colour(mask, truth),
        });
        let difference = Picture { width: seen.width(), height: seen.height(), rgb: colours.flatten().collect() };
        let pictures = [lit(seen, &shadow), lit(&traced, &truth), difference];
        Picture::side_by_side(&pictures, GAP_PIXELS)
    }

    fn sun(&self) -> DirectionalLight {
        DirectionalLight::from_degrees(self.arguments.azimuth, self.arguments.elevation)
    }

    fn palette(&self) -> Palette {
        let sand = Palette::SAND;
        match self.arguments.view.on {
            _ if self.arguments.ambient => Palette::OVERCAST_SAND,
            // As pictures from above: level ground in the sun is as bright at dawn as at noon.
            BaseName::Plane => sand.exposed_for(&self.sun()),
            BaseName::Sphere => sand,
        }
    }

    fn shadow(&self, seen: &ReliefPixels<'_>, road: &ReliefRoad<'_>, report: &mut Report) -> Vec<bool> {
        let shadow = ReliefShadow { relief: self.relief, road: *road, tolerance: SHADOW_TOLERANCE };
        let light = self.sun();
        let mut rows = Rows::new(self.display, "shadow", seen);
        let answers = seen.map(&None, |pixel| {
            rows.step();
            Some(seen.in_shadow(pixel, &shadow, light.towards))
        });
        report.sun = Some(Sun::new(self.arguments, &answers));
        answers.iter().map(|answer| answer.is_some_and(|answer| answer.in_shadow)).collect()
    }

    /// What part of the sky's light every pixel lacks, where there is a depth map.
    fn occlusion(&self, seen: &ReliefPixels<'_>) -> Option<Vec<f64>> {
        if !self.has_hemisphere {
            return None;
        }
        let shadow = ReliefShadow { relief: self.relief, road: self.road, tolerance: SHADOW_TOLERANCE };
        let occlusion = HemisphereOcclusion::of_rays(occlusion_directions(), shadow);
        let mut rows = Rows::new(self.display, "occlusion", seen);
        Some(seen.map(&0.0, |pixel| {
            rows.step();
            seen.occlusion(pixel, &occlusion).share
        }))
    }
}

/// Where the sky is looked for.
fn occlusion_directions() -> HemisphereQuadrature {
    let (rings, azimuths) = OCCLUSION_DIRECTIONS;
    HemisphereQuadrature::even(rings, azimuths)
}

/// Shows that work goes on, a row of pixels at a time.
struct Rows<'a> {
    display: &'a ProgressDisplay,
    stage: &'static str,
    done: usize,
    width: usize,
    total: usize,
}

impl<'a> Rows<'a> {
    fn new(display: &'a ProgressDisplay, stage: &'static str, seen: &ReliefPixels<'_>) -> Self {
        let pixels = seen.pixels().iter().flatten().count();
        let width = seen.width() as usize;
        Self { display, stage, done: 0, width, total: pixels.div_ceil(width) }
    }

    fn step(&mut self) {
        self.done += 1;
        if self.done.is_multiple_of(self.width) {
            self.display.step(self.stage, self.done / self.width, self.total);
        }
    }
}

/// The mean over what is seen.
fn mean(seen: &ReliefPixels<'_>, values: &[f64]) -> f64 {
    let of_relief = || seen.pixels().iter().zip(values).filter(|(pixel, _)| pixel.is_some());
    let count = of_relief().count().max(1) as f64;
    of_relief().map(|(_, value)| value).sum::<f64>() / count
}
