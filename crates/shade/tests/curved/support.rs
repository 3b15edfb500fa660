//! Relief, its tables as a file holds them, and surfaces to lay it over.

use barchan_asset::{
    CurvatureSweep, DistanceTable, DistanceView, Encoding, HeightTable, HeightView, HorizonTable, HorizonView,
    MAX_ELEVATION, SweptDistanceTable, SweptDistanceView, SweptHorizonTable, SweptHorizonView, TextureTable,
};
use barchan_bakers::Exec;
use barchan_bakers::horizon::{Azimuths, BentLayer, HorizonParams, Method, bake_bent};
use barchan_bakers::swept::{CurvatureRange, Points, SweptBaker, SweptParams};
use barchan_field::shapes::{Axis, CylinderBumps};
use barchan_field::{Edge, Grid, HeightField, Shape, Spacing};
use barchan_shade::{CurvedShadow, Sphere, SphereChart, Surface};
use glam::{DVec2, DVec3};

use crate::common::{self, table_grid};
pub(crate) use crate::common::{assert_near, noise};

/// A field of square texels of length 1.
pub(crate) fn field(size: (u32, u32), edge: Edge, at: impl Fn(u32, u32) -> f32) -> HeightField {
    common::field(size, (1.0, 1.0), edge, at)
}

/// A shape over a square tile of texels of length 1, its lowest texel at height 0.
pub(crate) fn shape(shape: Shape, size: u32) -> HeightField {
    let unit = barchan_field::LengthUnit::Metre;
    let grid = Grid { width: size, height: size, spacing: Spacing::square(1.0).unwrap(), unit, edge: Edge::Wrap };
    let field = shape.rasterize(grid).unwrap();
    let lowest = field.range().0;
    HeightField::new(grid, field.samples().iter().map(|height| height - lowest).collect()).unwrap()
}

fn heights(field: &HeightField) -> TextureTable {
    HeightTable { grid: table_grid(field.grid()), values: field.samples() }.encode(Encoding::F32).unwrap()
}

pub(crate) fn relief(field: &HeightField) -> Surface {
    let table = heights(field);
    Surface::new(&HeightView::new(*table.descriptor(), table.payload()).unwrap())
}

/// The tables of a relief.
pub(crate) struct Map {
    pub(crate) heights: TextureTable,
    pub(crate) flat: [TextureTable; 2],
    pub(crate) swept: Option<[TextureTable; 2]>,
}

impl Map {
    /// The map for flat surfaces alone.
    pub(crate) fn flat(field: &HeightField, directions: u32, radius: f64) -> Self {
        let params = params(directions, radius);
        let exec = Exec::new(1).unwrap();
        let of = |direction| {
            let mut layer = BentLayer::new(field).unwrap();
            bake_bent(field, &params, direction, 0.0, &exec, &mut layer).unwrap();
            layer
        };
        let layers: Vec<_> = (0..directions).map(of).collect();
        Self { heights: heights(field), flat: flat_tables(field, radius, &layers), swept: None }
    }

    /// The map with up to `points` points for a range of curvatures.
    pub(crate) fn swept(field: &HeightField, directions: u32, radius: f64, range: CurvatureRange, points: u32) -> Self {
        let exec = Exec::new(1).unwrap();
        let sweep = SweptParams { range, points: Points::Count(points) };
        let mut baker = SweptBaker::new(field, &params(directions, radius), &sweep, &exec).unwrap();
        let mut by_point: Vec<Vec<BentLayer>> = (0..points).map(|_| Vec::new()).collect();
        for direction in 0..directions {
            let mut layers: Vec<_> = (0..points).map(|_| BentLayer::new(field).unwrap()).collect();
            baker.bake_direction(direction, &exec, &mut layers).unwrap();
            by_point.iter_mut().zip(layers).for_each(|(all, layer)| all.push(layer));
        }
        let (grid, azimuths) = (table_grid(field.grid()), barchan_asset::Azimuths::full_circle(directions));
        let (elevations, distances) = values(by_point[1..].iter().flatten());
        let sweep = CurvatureSweep { candidates: points - 1, curvature_min: range.min, curvature_max: range.max };
        let horizon = SweptHorizonTable { grid, azimuths, radius, sweep, values: &elevations };
        let distance = SweptDistanceTable { grid, azimuths, radius, sweep, values: &distances };
        let swept = [horizon.encode(Encoding::F32).unwrap(), distance.encode(Encoding::F32).unwrap()];
        Self { heights: heights(field), flat: flat_tables(field, radius, &by_point[0]), swept: Some(swept) }
    }

    pub(crate) fn shadow(&self) -> CurvedShadow {
        let horizon = HorizonView::new(*self.flat[0].descriptor(), self.flat[0].payload()).unwrap();
        let distance = DistanceView::new(*self.flat[1].descriptor(), self.flat[1].payload()).unwrap();
        let heights = HeightView::new(*self.heights.descriptor(), self.heights.payload()).unwrap();
        let swept = self.swept.as_ref().map(|[horizon, distance]| {
            let horizon = SweptHorizonView::new(*horizon.descriptor(), horizon.payload()).unwrap();
            (horizon, SweptDistanceView::new(*distance.descriptor(), distance.payload()).unwrap())
        });
        CurvedShadow::new(&horizon, &distance, swept.as_ref().map(|(h, d)| (h, d)), &heights).unwrap()
    }
}

fn params(directions: u32, radius: f64) -> HorizonParams {
    HorizonParams { azimuths: Azimuths::full_circle(directions), radius, distance: true, method: Method::default() }
}

fn flat_tables(field: &HeightField, radius: f64, layers: &[BentLayer]) -> [TextureTable; 2] {
    let azimuths = barchan_asset::Azimuths::full_circle(layers.len() as u32);
    let (grid, (elevations, distances)) = (table_grid(field.grid()), values(layers.iter()));
    let horizon = HorizonTable { grid, azimuths, radius, values: &elevations }.encode(Encoding::F32).unwrap();
    let distance = DistanceTable { grid, azimuths, radius, values: &distances }.encode(Encoding::F32).unwrap();
    [horizon, distance]
}

/// Elevations and distances, one layer after the other.
fn values<'a>(layers: impl Iterator<Item = &'a BentLayer>) -> (Vec<f32>, Vec<f32>) {
    let (mut elevations, mut distances) = (Vec::new(), Vec::new());
    for layer in layers {
        elevations.extend(layer.slope.iter().map(|slope| libm::atanf(*slope).clamp(-MAX_ELEVATION, MAX_ELEVATION)));
        distances.extend_from_slice(&layer.distance);
    }
    (elevations, distances)
}

/// Half-cylinders side by side, as in figure 4 of the paper: `rows` across a tile of `size` texels of length 1.
pub(crate) fn cylinder_bumps(size: u32, rows: u32) -> HeightField {
    let height = 0.5 * f64::from(size) / f64::from(rows);
    let bumps = CylinderBumps { height, rows, coverage: 1.0, across: Axis::U };
    shape(Shape::CylinderBumps(bumps), size)
}

pub(crate) fn example(name: &str, size: u32) -> HeightField {
    shape(Shape::examples().into_iter().find(|shape| shape.name() == name).unwrap(), size)
}

/// Texture coordinates of a texel's centre.
pub(crate) fn centre(field: &HeightField, column: u32, row: u32) -> DVec2 {
    let (column, row) = (f64::from(column) + 0.5, f64::from(row) + 0.5);
    DVec2::new(column / f64::from(field.grid().width), 1.0 - row / f64::from(field.grid().height))
}

/// A ball whose texture is that of `field` in its own lengths at (0, 0).
pub(crate) fn ball(field: &HeightField, radius: f64, chart: SphereChart) -> Sphere {
    let tile = DVec2::new(field.grid().extent_u(), field.grid().extent_v());
    Sphere { radius, hollow: false, chart, tile }
}

/// A unit vector in the plane of +x, the normal at (0, 0) of the surfaces here, and a direction `azimuth` degrees from +y
/// towards +z: `elevation` degrees above the tangent plane at (0, 0).
pub(crate) fn towards(azimuth: f64, elevation: f64) -> DVec3 {
    let (azimuth, elevation) = (azimuth.to_radians(), elevation.to_radians());
    DVec3::new(elevation.sin(), elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin())
}
