//! Shadows on curved surfaces, as a shader decides them from stored tables, against rays traced over the displaced surface
//! itself: the paper's [`figures`].
//!
//! # What is compared
//!
//! Every named method of `barchan_shade`, reading leading points of one table as a file stores it, in the default
//! encoding. The truth is [`DisplacedShadow`]: no table, no curvature, no chart, but P + hN in f64.
//!
//! # What is looked at
//!
//! Places spread evenly over the texture, each in one direction of the tangent plane: at texel centres in directions that
//! the map has baked, where the correction itself is seen; and anywhere in any direction, where a picture's pixels lie, with
//! what interpolation between texels and azimuths adds. What a chart's own bend adds, straight lines of the texture that are
//! no geodesics, is in both.
//!
//! # What is counted
//!
//! In such a direction a place is in the shadow of all suns below its horizon and of none above, so the true horizon is found by
//! halving the range of elevations, to 0.006°, and every question about suns has its answer:
//!
//! - the **wrong share** under a sun at an elevation above the base's tangent plane, negative behind the terminator: the
//!   part of places whose true horizon and found horizon are not on the same side of it;
//! - beside it the **error of the shadow's edge**: of the places that are wrong, by how many degrees the sun stands beyond
//!   their true horizon, `rms` and `max`: as far does the true edge of the shadow lie from them, on the way of the sun;
//! - over all suns: the horizon's error in degrees, and the wrong share of a ball as in
//!   [`curved_effect`](crate::curved_effect);
//! - how many places a sun truly reaches: behind the terminator, lit bumps.
//!
//! # What it weighs and costs
//!
//! Bytes are those of the points that a method reads and of heights in 8 bit, as the paper counts them. Times are
//! those of the CPU twin on decoded values, per place, directions and curvature given; those of tracing, per ray.

use std::f64::consts::{FRAC_PI_2, TAU};

use barchan_bakers::Exec;
use barchan_shade::{BaseSurface, CurvedMethod, DisplacedShadow, Place, Surface};
use glam::{DVec2, DVec3};

use crate::figure_tables::FigureTables;
use crate::figures::{self, Figure};
use crate::runner::{Observer, Step};
use crate::sample::unit;
use crate::timer::{Contestant, Pace, race};
use crate::{Item, Norms, Quantity, Record, Scale, Setting, StudyError};

/// Elevations of the suns above the base's tangent plane, degrees.
const ELEVATIONS: [f64; 9] = [-20.0, -10.0, -5.0, 0.0, 5.0, 10.0, 20.0, 30.0, 45.0];

/// How often the range of elevations is halved.
const HALVINGS: u32 = 15;

/// Under which sun times are taken.
const TIMED_ELEVATION: f64 = 10.0;

/// Pixels across and down of the part of a picture that is timed.
const TIMED_PIXELS: u32 = 64;

/// Of this many places one is traced when times are taken.
const TRACED_SHARE: usize = 20;

/// The study.
pub struct Shadows<'a> {
    /// Places of each kind.
    pub places: u64,
    /// How bakes run.
    pub exec: &'a Exec<'a>,
    /// How long tests are timed.
    pub pace: Pace,
}

/// Where places lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Centres,
    Anywhere,
}

/// A place that looks in one direction.
struct View {
    /// Under a sun in the tangent plane.
    place: Place,
    /// The unit tangent towards the sun.
    towards: DVec3,
    /// Along it, as a run time has it.
    curvature: f64,
}

/// Views of one kind, and their true horizons in radians.
struct Truth {
    kind: Kind,
    views: Vec<View>,
    horizons: Vec<f64>,
}

/// The study and its figures.
///
/// # Errors
/// A figure that cannot be made.
pub fn parts<'a>(scale: Scale, exec: &'a Exec<'a>) -> Result<(Shadows<'a>, Vec<Figure>), StudyError> {
    let (places, seconds) = match scale {
        Scale::Full => (4000, 1.0),
        Scale::Quick => (40, 0.01),
    };
    Ok((Shadows { places, exec, pace: Pace { seconds, max_rounds: 7 } }, figures::all(scale)?))
}

/// The records of all figures.
///
/// # Errors
/// A bake that is refused.
pub fn measure(study: &Shadows<'_>, figures: &[Figure], observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let mut records = Vec::new();
    for (done, figure) in figures.iter().enumerate() {
        observe(&Step { done, total: figures.len(), what: &figure.relief.name });
        let tables = FigureTables::bake(figure, study.exec)?;
        let truths = [Kind::Centres, Kind::Anywhere].map(|kind| study.truth(figure, &tables.surface, kind));
        for truth in &truths {
            records.extend(truth.lit(figure));
            for method in CurvedMethod::ALL {
                records.extend(errors(figure, &tables, truth, method));
            }
        }
        records.extend(study.times(figure, &tables)?);
    }
    Ok(records)
}

impl Shadows<'_> {
    fn truth(&self, figure: &Figure, surface: &Surface, kind: Kind) -> Truth {
        let oracle = DisplacedShadow::new(&*figure.base, surface, f64::INFINITY);
        let views: Vec<View> = (0..self.places).map(|index| kind.view(figure, surface, index)).collect();
        let horizons = views.iter().map(|view| view.true_horizon(&oracle)).collect();
        Truth { kind, views, horizons }
    }

    /// Each method, and tracing, of a part of a picture.
    fn times(&self, figure: &Figure, tables: &FigureTables) -> Result<Vec<Record>, StudyError> {
        let oracle = DisplacedShadow::new(&*figure.base, &tables.surface, f64::INFINITY);
        let (sun, pixels) = pixels(figure, &tables.surface);
        let pixels: &[(Place, f64)] = &pixels;
        let by_table = |method: CurvedMethod| {
            let decide = move |(place, curvature): &(Place, f64)| {
                tables.shadow.in_shadow(method, place.texel, &place.light, *curvature)
            };
            let work = Box::new(move || Ok(pixels.iter().map(decide).collect()));
            Contestant { name: format!("{method} shadow tests"), work }
        };
        let traced = || pixels.iter().step_by(TRACED_SHARE).map(|(place, _)| oracle.in_shadow(place.uv, sun)).collect();
        let mut contestants: Vec<Contestant<'_, Vec<bool>>> = CurvedMethod::ALL.map(by_table).into();
        contestants.push(Contestant { name: "traced shadow tests".to_owned(), work: Box::new(|| Ok(traced())) });
        let timings = race(&mut contestants, &self.pace, &mut |_| ())?;
        let all = pixels.len();
        let names = CurvedMethod::ALL.map(|method| (method.to_string(), all));
        let names = names.into_iter().chain([("traced".to_owned(), all.div_ceil(TRACED_SHARE))]);
        let record = |((name, places), timing): ((String, usize), &_)| {
            let setting = Setting::default().with("method", name).with("elevation", TIMED_ELEVATION);
            let record = Record::new("curved_shadow", setting, &figure.relief);
            record.with_timing(timing, Item::ShadowTest, places as f64)
        };
        Ok(names.zip(&timings).map(record).collect())
    }
}

/// Neighbouring places in the middle of a figure, two to a texel, row by row, under one sun, and the curvature towards it.
fn pixels(figure: &Figure, surface: &Surface) -> (DVec3, Vec<(Place, f64)>) {
    let grid = figure.relief.field.grid();
    let middle = 0.5 * (figure.part.0 + figure.part.1);
    let frame = figure.base.point(middle).frame;
    let (sin, cos) = libm::sincos(TIMED_ELEVATION.to_radians());
    let sun = frame.along_u.normalize() * cos + frame.normal * sin;
    let pixel = |row: u32, column: u32| {
        let texels = DVec2::new(f64::from(column), f64::from(row)) * 0.5;
        let uv = middle + texels / DVec2::new(f64::from(grid.width), f64::from(grid.height));
        let place = Place::new(&*figure.base, surface, uv, sun);
        let direction = place.light.direction;
        (place, figure.forms_at(uv).along(direction.x, direction.y))
    };
    let rows = (0..TIMED_PIXELS).flat_map(|row| (0..TIMED_PIXELS).map(move |column| (row, column)));
    (sun, rows.map(|(row, column)| pixel(row, column)).collect())
}

impl Kind {
    fn name(self) -> &'static str {
        match self {
            Self::Centres => "centres",
            Self::Anywhere => "anywhere",
        }
    }

    fn quantity(self) -> Quantity {
        match self {
            Self::Centres => Quantity::ShadowAtCentres,
            Self::Anywhere => Quantity::ShadowBetweenCentres,
        }
    }

    /// One of many views, the same in every run.
    fn view(self, figure: &Figure, surface: &Surface, index: u64) -> View {
        let (low, high) = figure.part;
        let uv = low + (high - low) * DVec2::new(unit(3 * index), unit(3 * index + 1));
        let turns = unit(3 * index + 2);
        let (uv, azimuth) = match self {
            Self::Anywhere => (uv, turns * TAU),
            Self::Centres => {
                let grid = figure.relief.field.grid();
                let size = DVec2::new(f64::from(grid.width), f64::from(grid.height));
                let directions = f64::from(figure.directions);
                (((uv * size).floor() + 0.5) / size, (turns * directions).floor() / directions * TAU)
            }
        };
        let (sin, cos) = libm::sincos(azimuth);
        let (extent_u, extent_v) = surface.extent();
        let frame = figure.base.point(uv).frame;
        let towards = (frame.along_u * (cos / extent_u) + frame.along_v * (sin / extent_v)).normalize();
        let place = Place::new(&*figure.base, surface, uv, towards);
        let direction = place.light.direction;
        View { place, towards, curvature: figure.forms_at(uv).along(direction.x, direction.y) }
    }
}

impl View {
    /// Towards a sun at an elevation in radians.
    fn sun(&self, elevation: f64) -> DVec3 {
        let (sin, cos) = libm::sincos(elevation);
        self.towards * cos + self.place.frame.normal * sin
    }

    fn true_horizon(&self, oracle: &DisplacedShadow<'_, dyn BaseSurface>) -> f64 {
        let (mut dark, mut lit) = (-FRAC_PI_2, FRAC_PI_2);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (dark + lit);
            if oracle.in_shadow(self.place.uv, self.sun(middle)) { dark = middle } else { lit = middle }
        }
        0.5 * (dark + lit)
    }
}

impl Truth {
    fn record(&self, figure: &Figure, method: &str, elevation: Option<f64>) -> Record {
        let setting = Setting::default().with("places", self.kind.name()).with("method", method);
        let setting = match elevation {
            Some(elevation) => setting.with("elevation", elevation),
            None => setting,
        };
        Record { samples: Some(self.views.len() as u64), ..Record::new("curved_shadow", setting, &figure.relief) }
    }

    /// How many places each sun reaches.
    fn lit(&self, figure: &Figure) -> Vec<Record> {
        let lit = |elevation: f64| {
            let reached = self.horizons.iter().filter(|horizon| elevation.to_radians() >= **horizon).count();
            let mean = Some(reached as f64 / self.horizons.len() as f64);
            let record = self.record(figure, "traced", Some(elevation));
            Record { quantity: Some(Quantity::LitShare), mean, ..record }
        };
        ELEVATIONS.map(lit).into()
    }
}

/// What a method gets wrong, under each sun and over all.
fn errors(figure: &Figure, tables: &FigureTables, truth: &Truth, method: CurvedMethod) -> Vec<Record> {
    let find =
        |view: &View| tables.shadow.elevation_radians(method, view.place.texel, &view.place.light, view.curvature);
    let found: Vec<f64> = truth.views.iter().map(find).map(f64::to_degrees).collect();
    let expected: Vec<f64> = truth.horizons.iter().map(|horizon| horizon.to_degrees()).collect();
    let bytes = Some(tables.bytes(method));
    let name = method.to_string();
    let under = |sun: f64| {
        let is_wrong = |(found, expected): &(&f64, &f64)| (sun < **found) != (sun < **expected);
        let beyond: Vec<f64> =
            found.iter().zip(&expected).filter(is_wrong).map(|(_, expected)| sun - expected).collect();
        let record = truth.record(figure, &name, Some(sun));
        let record = if beyond.is_empty() {
            record
        } else {
            let samples = record.samples;
            Record { samples, ..record.with_norms(truth.kind.quantity(), &Norms::of(&beyond)) }
        };
        let wrong_share = Some(beyond.len() as f64 / found.len() as f64);
        Record { quantity: Some(truth.kind.quantity()), wrong_share, bytes, ..record }
    };
    let differences: Vec<f64> = found.iter().zip(&expected).map(|(found, expected)| found - expected).collect();
    let over_all = truth.record(figure, &name, None);
    let over_all = over_all.with_norms(Quantity::CurvedElevationDegrees, &Norms::of(&differences));
    let wrong_share = Some(crate::curved_effect::wrong_share(&found, &expected));
    ELEVATIONS.map(under).into_iter().chain([Record { wrong_share, bytes, ..over_all }]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn records() -> Vec<Record> {
        let exec = Exec::new(1).unwrap();
        let (study, figures) = parts(Scale::Quick, &exec).unwrap();
        let study = Shadows { places: 200, pace: Pace { seconds: 0.0, max_rounds: 1 }, ..study };
        measure(&study, &figures[..1], &mut |_| ()).unwrap()
    }

    fn find<'a>(records: &'a [Record], words: &str) -> &'a Record {
        records.iter().find(|record| record.setting.to_string() == words).unwrap()
    }

    #[test]
    fn swept_points_are_nearest_to_what_rays_find() {
        let records = records();
        let rms = |method: &str| find(&records, &format!("places=centres method={method}")).rms.unwrap();
        assert!(rms("swept-3") < 0.5 * rms("paper") && rms("paper") < rms("flat"), "{}", rms("swept-3"));
        assert!(rms("flat") < rms("paper-as-printed"));
    }

    #[test]
    fn bumps_are_lit_behind_the_terminator_and_fewer_the_farther() {
        let records = records();
        let lit = |sun: &str| find(&records, &format!("places=anywhere method=traced elevation={sun}")).mean.unwrap();
        assert!(lit("-5") > 0.0 && lit("-20") < lit("-5") && lit("-5") < lit("5") && lit("5") < lit("45"));
    }

    #[test]
    fn bytes_are_those_of_the_paper_and_all_methods_are_timed() {
        let records = records();
        let bytes = |method: &str| find(&records, &format!("places=centres method={method}")).bytes;
        assert_eq!(bytes("paper"), Some(32 * 32 * (1 + 2 * 32)));
        assert_eq!(bytes("swept-3"), Some(32 * 32 * (1 + 3 * 2 * 32)));
        assert_eq!(records.iter().filter(|record| record.cpu_ns.or(record.wall_ns).is_some()).count(), 7);
    }
}
