//! The curvature-swept horizon against the exact one: RMS error of the angle per shape and curvature. Markdown on
//! stdout, or CSV.
//!
//! ```text
//! cargo run --release -p barchan-bakers --example kappa -- [--csv]
//! ```
//!
//! Every example shape that repeats, 256² texels of length 1, standing on the base surface (its lowest texel is at
//! height 0); search radius 200, every fourth column and row, five azimuths. One table of each shape is baked for all
//! curvatures of a range and read as a run time reads it, by `barchan_shade`. What it is held against is brute force
//! over all distances.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "an example's output is its purpose")]

use std::error::Error;
use std::time::Instant;

use barchan_bakers::horizon::{Azimuths, HorizonParams, Method};
use barchan_bakers::swept::reference::{BentReference, CurvedReference};
use barchan_bakers::swept::{
    CandidateLayer, CurvatureRange, MAX_POINTS, Nodes, PointLayerMut, SelectionErrors, Tie, measure_band, select_band,
};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};
use barchan_metrics::ErrorStats;
use barchan_shade::{StoredPoint, curved_horizon, paper_horizon};

/// Texels of a shape's side.
const SIZE: u32 = 256;
/// Every how many columns and rows.
const STRIDE: usize = 4;
/// In texels: within half round the most concave surface.
const RADIUS: f64 = 200.0;
/// Of 16 azimuths: 0°, 22.5°, 45°, 112.5°, 247.5°.
const DIRECTIONS: [u32; 5] = [0, 1, 2, 5, 11];
/// Per texel length.
const CURVATURES: [f64; 5] = [-0.015, -0.005, 0.0, 0.005, 0.015];
const RANGES: [CurvatureRange; 2] =
    [CurvatureRange { min: -0.015, max: 0.015 }, CurvatureRange { min: 0.0, max: 0.015 }];
const COLUMNS: [&str; 8] =
    ["flat map", "paper", "paper, nearest", "K = 1, exact", "K = 2", "K = 3", "K = 4", "all candidates"];

fn main() -> Result<(), Box<dyn Error>> {
    let csv = std::env::args().any(|argument| argument == "--csv");
    if csv {
        println!("range_min,range_max,bends,field,curvature,method,rms_degrees,max_degrees");
    }
    for range in RANGES {
        let nodes = Nodes::recommended(&range, RADIUS);
        if !csv {
            print_heading(&range, &nodes);
        }
        for (name, field) in fields()? {
            let study = Study::new(&field, &nodes, range.tie());
            eprintln!("{name}: {}", study.remarks);
            for curvature in CURVATURES.into_iter().filter(|curvature| (range.min..=range.max).contains(curvature)) {
                let errors = study.errors(curvature);
                if csv {
                    print_csv(&range, &nodes, name, curvature, &errors);
                } else {
                    let cells: Vec<_> = errors.iter().map(|error| degrees(error.rms())).collect();
                    println!("| {name}, {curvature} | {} |", cells.join(" | "));
                }
            }
        }
    }
    if !csv {
        print_bytes();
    }
    Ok(())
}

fn print_heading(range: &CurvatureRange, nodes: &Nodes) {
    println!(
        "\nκ from {} to {}, {} bends: RMS error of the angle in degrees\n",
        range.min,
        range.max,
        nodes.bends().len()
    );
    println!("| relief, κ | {} |", COLUMNS.join(" | "));
    println!("|---|{}", "---:|".repeat(COLUMNS.len()));
}

fn print_csv(range: &CurvatureRange, nodes: &Nodes, name: &str, curvature: f64, errors: &[ErrorStats]) {
    for (method, error) in COLUMNS.iter().zip(errors) {
        let (rms, max) = (error.rms().to_degrees(), error.max().to_degrees());
        let CurvatureRange { min, max: range_max } = *range;
        println!("{min},{range_max},{},{name},{curvature},\"{method}\",{rms:.6},{max:.6}", nodes.bends().len());
    }
}

fn print_bytes() {
    println!("\nBytes per texel and direction, angle and distance of each point:\n");
    println!("| encoding | K = 1 | K = 2 | K = 3 | K = 4 |\n|---|---:|---:|---:|---:|");
    for (name, bytes) in [("u8", 2), ("f16", 4)] {
        let cells: Vec<_> = (1..=4).map(|points| (points * bytes).to_string()).collect();
        println!("| {name} | {} |", cells.join(" | "));
    }
}

/// Two digits that mean something.
fn degrees(radians: f64) -> String {
    match radians.to_degrees() {
        small if small < 0.0995 => format!("{small:.3}"),
        middle if middle < 0.995 => format!("{middle:.2}"),
        large => format!("{large:.1}"),
    }
}

fn fields() -> Result<Vec<(&'static str, HeightField)>, Box<dyn Error>> {
    let shapes = Shape::examples().into_iter().filter(Shape::tiles);
    shapes.map(|shape| Ok((shape.name(), on_the_base(&shape)?))).collect()
}

/// A shape with its lowest texel on the base surface.
fn on_the_base(shape: &Shape) -> Result<HeightField, Box<dyn Error>> {
    let grid =
        Grid { width: SIZE, height: SIZE, spacing: Spacing::UNIT, unit: LengthUnit::SceneUnit, edge: Edge::Wrap };
    let field = shape.rasterize(grid)?;
    let lowest = field.range().0;
    Ok(HeightField::new(grid, field.samples().iter().map(|height| height - lowest).collect())?)
}

/// A shape, its candidates and the tables chosen from them.
struct Study<'a> {
    field: &'a HeightField,
    texels: Vec<(u32, u32)>,
    heights: Vec<f32>,
    directions: Vec<DirectionTables>,
    remarks: String,
}

/// Of one direction: the flat horizon by either rule for ties, what every bend found, and tables of 2, 3 and 4 points.
struct DirectionTables {
    direction: u32,
    flat: [Layer; 2],
    candidates: Vec<Layer>,
    tables: [Vec<Layer>; 3],
}

#[derive(Clone)]
struct Layer {
    slope: Vec<f32>,
    distance: Vec<f32>,
}

impl Layer {
    fn view(&self) -> CandidateLayer<'_> {
        CandidateLayer { slope: &self.slope, distance: &self.distance }
    }

    fn point(&self, texel: usize) -> StoredPoint {
        StoredPoint { slope: f64::from(self.slope[texel]), distance: f64::from(self.distance[texel]) }
    }
}

fn params() -> HorizonParams {
    HorizonParams { azimuths: Azimuths::full_circle(16), radius: RADIUS, distance: true, method: Method::default() }
}

impl<'a> Study<'a> {
    fn new(field: &'a HeightField, nodes: &Nodes, tie: Tie) -> Self {
        let lines = || (0..SIZE).step_by(STRIDE);
        let texels: Vec<(u32, u32)> = lines().flat_map(|row| lines().map(move |column| (column, row))).collect();
        let heights: Vec<f32> = texels.iter().map(|&(c, r)| field.texel(i64::from(c), i64::from(r))).collect();
        let mut errors = SelectionErrors::default();
        let (mut seconds, mut directions) = (0.0, Vec::new());
        for direction in DIRECTIONS {
            let candidates = found(field, &texels, direction, nodes.bends(), tie);
            let flat = [Tie::Farthest, Tie::Nearest].map(|tie| found(field, &texels, direction, &[0.0], tie).remove(0));
            let views: Vec<_> = candidates.iter().map(Layer::view).collect();
            measure_band(nodes, &heights, &views, &mut errors);
            let start = Instant::now();
            let tables = [2, 3, 4].map(|points| chosen(nodes, &heights, &views, points));
            seconds += start.elapsed().as_secs_f64() / (3 * DIRECTIONS.len() * texels.len()) as f64;
            directions.push(DirectionTables { direction, flat, candidates, tables });
        }
        let kept: Vec<_> =
            (1..=MAX_POINTS).map(|points| format!("{:.2}°", errors.percentile_degrees(points))).collect();
        let remarks = format!("select {:.0} ns; 99 % lose at most {}", 1e9 * seconds, kept.join(" "));
        Self { field, texels, heights, directions, remarks }
    }

    /// The error of every column, at one curvature.
    fn errors(&self, curvature: f64) -> [ErrorStats; COLUMNS.len()] {
        let mut errors = [ErrorStats::default(); COLUMNS.len()];
        for tables in &self.directions {
            let truth = CurvedReference::new(self.field, &params(), tables.direction, curvature);
            for (texel, &(column, row)) in self.texels.iter().enumerate() {
                let expected = truth.horizon(column, row).slope.atan();
                let found = tables.horizons(texel, curvature, f64::from(self.heights[texel]));
                for (error, slope) in errors.iter_mut().zip(found) {
                    error.add(slope.atan() - expected);
                }
            }
        }
        errors
    }
}

impl DirectionTables {
    fn horizons(&self, texel: usize, curvature: f64, height: f64) -> [f64; COLUMNS.len()] {
        let horizon = |layers: &[Layer]| {
            let points: Vec<_> = layers.iter().map(|layer| layer.point(texel)).collect();
            curved_horizon(&points, curvature, height)
        };
        let [flat, nearest] = self.flat.each_ref().map(|layer| layer.point(texel));
        let [two, three, four] = &self.tables;
        [
            flat.slope,
            paper_horizon(flat, curvature, height),
            paper_horizon(nearest, curvature, height),
            horizon(&self.candidates[..1]),
            horizon(two),
            horizon(three),
            horizon(four),
            horizon(&self.candidates),
        ]
    }
}

fn found(field: &HeightField, texels: &[(u32, u32)], direction: u32, bends: &[f64], tie: Tie) -> Vec<Layer> {
    let layer = |&bend: &f64| {
        let bent = BentReference::new(field, &params(), direction, bend, tie);
        let points = texels.iter().map(|&(column, row)| bent.point(column, row));
        let (slope, distance) = points.map(|point| (point.slope as f32, point.distance as f32)).unzip();
        Layer { slope, distance }
    };
    bends.iter().map(layer).collect()
}

fn chosen(nodes: &Nodes, heights: &[f32], candidates: &[CandidateLayer], points: usize) -> Vec<Layer> {
    let zeros = vec![0.0; heights.len()];
    let mut layers = vec![Layer { slope: zeros.clone(), distance: zeros }; points];
    let mut places: Vec<_> =
        layers.iter_mut().map(|l| PointLayerMut { slope: &mut l.slope, distance: &mut l.distance }).collect();
    select_band(nodes, heights, candidates, &mut places);
    layers
}
