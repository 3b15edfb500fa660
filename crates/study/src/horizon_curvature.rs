//! Horizons on curved bases: the flat map, the paper's correction of it, and curvature-swept points, in every encoding.
//!
//! # What is compared
//!
//! All of it is baked by the fast sweeps at the default method, as a user would have it, and read as a run time reads it,
//! by `barchan_shade`: the flat horizon as it is; the paper's eq 2 and eq 3 of its one point, with equal points at their
//! far end, as a horizon map has them, and at their near end; and 1 to 4 points by the exact form, from tables baked for a
//! whole range of curvatures, of which one serves every row. "All" is what all bends found together. Against it stands
//! brute force over all distances in f64: [`CurvedReference`].
//!
//! # What is looked at
//!
//! The examples of shapes that repeat, their lowest texel on the base surface; search radius 200, within half round the most
//! concave base; five azimuths, and of each every so many columns and rows. Curvatures are per length unit, of which a
//! scene has 256 along a side.

use barchan_asset::{CurvatureSweep, Encoding};
use barchan_bakers::Exec;
use barchan_bakers::horizon::{Azimuths, BentLayer, HorizonParams, Method, bake_bent};
use barchan_bakers::swept::reference::CurvedReference;
use barchan_bakers::swept::{CurvatureRange, Points, SweptBaker, SweptParams};
use barchan_field::{HeightField, Shape};
use barchan_shade::{StoredPoint, curved_horizon, paper_horizon};

use crate::runner::Study;
use crate::tables::StoredPoints;
use crate::{Norms, Quantity, Record, Scale, Scene, Setting, Stopwatch, StudyError, scenes};

/// How far horizons are searched.
const RADIUS: f64 = 200.0;

/// Of 16 azimuths: 0°, 22.5°, 45°, 112.5°, 247.5°.
const DIRECTIONS: [u32; 5] = [0, 1, 2, 5, 11];

/// The curvatures looked at, where a range has them.
const CURVATURES: [f64; 5] = [-0.015, -0.005, 0.0, 0.005, 0.015];

/// The most points kept.
const MOST_POINTS: u32 = 4;

/// The study: what each range of curvatures costs and saves.
pub struct Curvature<'a> {
    /// Every how many columns and rows are looked at.
    pub stride: usize,
    /// How bakes run.
    pub exec: &'a Exec<'a>,
}

/// What brute force says.
pub struct Truth {
    places: Vec<Place>,
    /// Of each of [`CURVATURES`], the slope seen from each place.
    slopes: [Vec<f64>; CURVATURES.len()],
}

/// Where horizons are looked at.
struct Place {
    /// Which of [`DIRECTIONS`].
    direction: usize,
    column: u32,
    row: u32,
    /// Above the base surface.
    height: f64,
}

/// Layers of points, and the time they took.
struct Baked {
    /// `[point][direction]`.
    points: Vec<Vec<BentLayer>>,
    seconds: f64,
}

/// How points become a horizon.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Reading {
    /// The first one's slope as it is.
    Flat,
    /// The first one, corrected by eq 2 and eq 3 of the paper.
    Paper,
    /// All of them, exactly.
    Exact,
}

/// What a run time has, and how it reads it.
struct Contestant {
    /// `method`, `points` and `encoding`, as records say it.
    words: [(&'static str, String); 3],
    reading: Reading,
    /// `[place][point]`.
    stored: Vec<Vec<StoredPoint>>,
    bytes: Option<u64>,
    bake_seconds: f64,
}

/// The study and its scenes.
///
/// # Errors
/// A scene that cannot be made.
pub fn parts<'a>(scale: Scale, exec: &'a Exec<'a>) -> Result<(Curvature<'a>, Vec<Scene>), StudyError> {
    let (size, stride) = match scale {
        Scale::Full => (256, 4),
        Scale::Quick => (32, 4),
    };
    let shapes = Shape::examples().into_iter().filter(Shape::tiles);
    let scenes =
        shapes.map(|shape| scenes::on_the_base(scenes::by_name(shape.name(), size)?)).collect::<Result<_, _>>()?;
    Ok((Curvature { stride, exec }, scenes))
}

fn params() -> HorizonParams {
    HorizonParams { azimuths: Azimuths::full_circle(16), radius: RADIUS, distance: true, method: Method::default() }
}

impl Study for Curvature<'_> {
    type Setting = CurvatureRange;
    type Truth = Truth;

    fn settings(&self) -> Vec<CurvatureRange> {
        let convex = CurvatureRange { min: 0.0, max: 0.015 };
        vec![convex, CurvatureRange { min: -convex.max, ..convex }]
    }

    fn truth(&self, scene: &Scene) -> Result<Truth, StudyError> {
        let places = self.places(&scene.field);
        let slopes = CURVATURES.map(|curvature| {
            let twins = DIRECTIONS.map(|direction| CurvedReference::new(&scene.field, &params(), direction, curvature));
            places.iter().map(|place| twins[place.direction].horizon(place.column, place.row).slope).collect()
        });
        Ok(Truth { places, slopes })
    }

    fn measure(&self, scene: &Scene, truth: &Truth, range: &CurvatureRange) -> Result<Vec<Record>, StudyError> {
        let mut records = Vec::new();
        for contestant in self.contestants(&scene.field, &truth.places, range)? {
            for (curvature, slopes) in CURVATURES.iter().zip(&truth.slopes) {
                if (range.min..=range.max).contains(curvature) {
                    let norms = contestant.norms(&truth.places, slopes, *curvature);
                    records.push(contestant.record(scene, range, *curvature, &norms));
                }
            }
        }
        Ok(records)
    }
}

impl Curvature<'_> {
    fn places(&self, field: &HeightField) -> Vec<Place> {
        let (width, height) = (field.grid().width, field.grid().height);
        let place = |direction, column, row| {
            let height = f64::from(field.texel(i64::from(column), i64::from(row)));
            Place { direction, column, row, height }
        };
        let rows = || (0..height).step_by(self.stride);
        let columns = || (0..width).step_by(self.stride);
        let of_direction =
            |direction| rows().flat_map(move |row| columns().map(move |column| (direction, column, row)));
        (0..DIRECTIONS.len()).flat_map(of_direction).map(|(d, column, row)| place(d, column, row)).collect()
    }

    /// All that is read for one range of curvatures.
    fn contestants(
        &self,
        field: &HeightField,
        places: &[Place],
        range: &CurvatureRange,
    ) -> Result<Vec<Contestant>, StudyError> {
        let of = |read, baked: &Baked, encoding| contestant(field, places, range, read, baked, encoding);
        let flat = self.flat(field)?;
        let mut contestants = vec![
            of(("flat", Reading::Flat), &flat, Encoding::F32)?,
            of(("paper", Reading::Paper), &flat, Encoding::F32)?,
        ];
        let mut all = None;
        for count in 1..=MOST_POINTS {
            let (kept, found) = self.swept(field, range, count)?;
            if count == 1 {
                contestants.push(of(("paper-nearest", Reading::Paper), &kept, Encoding::F32)?);
            }
            for encoding in Encoding::ALL {
                contestants.push(of(("exact", Reading::Exact), &kept, encoding)?);
            }
            all = Some(found);
        }
        contestants.extend(all.map(|found| everything_found(&found, field.grid().width, places)));
        Ok(contestants)
    }

    /// The horizon map, with slopes for elevations.
    fn flat(&self, field: &HeightField) -> Result<Baked, StudyError> {
        let watch = Stopwatch::start();
        let mut layers = layers(field, DIRECTIONS.len())?;
        for (direction, layer) in DIRECTIONS.iter().zip(&mut layers) {
            bake_bent(field, &params(), *direction, 0.0, self.exec, layer)?;
        }
        Ok(Baked { points: vec![layers], seconds: watch.elapsed().core_seconds() })
    }

    /// The points kept, and what they were chosen from.
    fn swept(&self, field: &HeightField, range: &CurvatureRange, count: u32) -> Result<(Baked, Baked), StudyError> {
        let params = SweptParams { range: *range, points: Points::Count(count) };
        let mut baker = SweptBaker::new(field, &self::params(), &params, self.exec)?;
        let (mut kept, mut found, mut seconds) = (Vec::new(), Vec::new(), 0.0);
        for direction in DIRECTIONS {
            let mut layers = layers(field, baker.points())?;
            let watch = Stopwatch::start();
            baker.bake_direction(direction, self.exec, &mut layers)?;
            seconds += watch.elapsed().core_seconds();
            kept.push(layers);
            found.push(baker.candidates().to_vec());
        }
        Ok((Baked { points: by_point(kept), seconds }, Baked { points: by_point(found), seconds }))
    }
}

fn layers(field: &HeightField, count: usize) -> Result<Vec<BentLayer>, StudyError> {
    (0..count).map(|_| Ok(BentLayer::new(field)?)).collect()
}

/// `[direction][point]` as `[point][direction]`.
fn by_point(by_direction: Vec<Vec<BentLayer>>) -> Vec<Vec<BentLayer>> {
    let mut directions: Vec<_> = by_direction.into_iter().map(Vec::into_iter).collect();
    let mut points = Vec::new();
    loop {
        let layers: Vec<BentLayer> = directions.iter_mut().filter_map(Iterator::next).collect();
        if layers.is_empty() {
            return points;
        }
        points.push(layers);
    }
}

/// What a run time reads from a table in one encoding.
fn contestant(
    field: &HeightField,
    places: &[Place],
    range: &CurvatureRange,
    (method, reading): (&str, Reading),
    baked: &Baked,
    encoding: Encoding,
) -> Result<Contestant, StudyError> {
    let count = baked.points.len();
    let sweep = CurvatureSweep { candidates: count as u32 - 1, curvature_min: range.min, curvature_max: range.max };
    let tables = StoredPoints::new(field.grid(), RADIUS, sweep, &baked.points, encoding)?;
    let views = tables.views()?;
    let read = |place: &Place| {
        let Place { direction, column, row, .. } = *place;
        (0..count).map(|point| views.point(point as u32, direction as u32, column, row)).collect()
    };
    Ok(Contestant {
        words: [("method", method.to_owned()), ("points", count.to_string()), ("encoding", encoding.name().to_owned())],
        reading,
        stored: places.iter().map(read).collect(),
        // Without correction, no distance is asked for.
        bytes: Some(if reading == Reading::Flat { tables.elevation_bytes() } else { tables.bytes() }),
        bake_seconds: baked.seconds,
    })
}

/// What all bends found, as no table has it.
fn everything_found(found: &Baked, width: u32, places: &[Place]) -> Contestant {
    let read = |place: &Place| {
        let texel = (place.row * width + place.column) as usize;
        let point = |layers: &Vec<BentLayer>| {
            let layer = &layers[place.direction];
            StoredPoint { slope: f64::from(layer.slope[texel]), distance: f64::from(layer.distance[texel]) }
        };
        found.points.iter().map(point).collect()
    };
    Contestant {
        words: [("method", "exact"), ("points", "all"), ("encoding", "none")]
            .map(|(name, value)| (name, value.to_owned())),
        reading: Reading::Exact,
        stored: places.iter().map(read).collect(),
        bytes: None,
        bake_seconds: found.seconds,
    }
}

impl Contestant {
    /// Errors of the elevation in degrees, on bases of one curvature.
    fn norms(&self, places: &[Place], truth: &[f64], curvature: f64) -> Norms {
        let errors = self.stored.iter().zip(places).zip(truth).map(|((points, place), expected)| {
            let slope = self.reading.slope(points, curvature, place.height);
            (libm::atan(slope) - libm::atan(*expected)).to_degrees()
        });
        Norms::of(&errors.collect::<Vec<_>>())
    }

    fn record(&self, scene: &Scene, range: &CurvatureRange, curvature: f64, norms: &Norms) -> Record {
        let ends = Setting::default().with("range_min", range.min).with("range_max", range.max);
        let setting = ends.with("curvature", curvature).with("directions", DIRECTIONS.len());
        let setting = self.words.iter().fold(setting, |setting, (name, value)| setting.with(name, value));
        let record = Record::new("curved_horizon", setting, scene).with_norms(Quantity::ElevationDegrees, norms);
        Record { bytes: self.bytes, bake_seconds: Some(self.bake_seconds), ..record }
    }
}

impl Reading {
    fn slope(self, points: &[StoredPoint], curvature: f64, height: f64) -> f64 {
        match self {
            Self::Flat => points[0].slope,
            Self::Paper => paper_horizon(points[0], curvature, height),
            Self::Exact => curved_horizon(points, curvature, height),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run;

    #[test]
    fn more_points_are_nearer_the_truth_and_more_bytes() {
        let exec = Exec::new(1).unwrap();
        let (study, scenes) = parts(Scale::Quick, &exec).unwrap();
        let dunes: Vec<_> = scenes.into_iter().filter(|scene| scene.name == "dunes").collect();
        let records = run(&study, &dunes, &mut |_| ()).unwrap();
        let of = |words: &str| {
            let wanted: Setting = words.parse().unwrap();
            let has = |record: &&Record| {
                ["range_min", "curvature", "method", "points", "encoding"]
                    .iter()
                    .all(|name| record.setting.get(name) == wanted.get(name))
            };
            records.iter().find(has).unwrap()
        };
        let exact = |points: u32| of(&format!("range_min=0 curvature=0.015 method=exact points={points} encoding=f32"));
        let errors = [1, 2, 3, 4].map(|points| exact(points).rms.unwrap());
        assert!(errors[0] > 2.0 * errors[1] && errors.is_sorted_by(|a, b| a >= b), "{errors:?}");
        let texels = 32 * 32 * DIRECTIONS.len() as u64;
        assert_eq!([1, 2, 3, 4].map(|points| exact(points).bytes.unwrap() / texels), [8, 16, 24, 32]);
        assert_eq!(of("range_min=0 curvature=0.015 method=flat points=1 encoding=f32").bytes, Some(4 * texels));
        // On the flat base the flat map is right, and costs the encoding's rounding only.
        assert!(of("range_min=0 curvature=0 method=exact points=1 encoding=u8").max.unwrap() < 1.0);
        assert_eq!(exact(1).samples, Some(8 * 8 * DIRECTIONS.len() as u64));
    }
}
