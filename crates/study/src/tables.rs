//! Fields and maps as a file stores them: the road from a bake to what a shader reads.

use barchan_asset::{
    Azimuths, CurvatureSweep, DistanceTable, DistanceView, Encoding, HeightTable, HeightView, HorizonTable,
    HorizonView, LengthUnit as AssetUnit, MAX_ELEVATION, SweptDistanceTable, SweptDistanceView, SweptHorizonTable,
    SweptHorizonView, TableGrid, TableView, TextureTable, Wrap,
};
use barchan_bakers::horizon::{BentLayer, HorizonMap};
use barchan_field::{Edge, Grid, HeightField};
use barchan_shade::{CurvedShadow, StoredPoint, Surface};

use crate::StudyError;

/// The surface that shadow rays are traced over, exact to f32.
pub(crate) fn surface(field: &HeightField) -> Result<Surface, StudyError> {
    let table = heights(field)?;
    Ok(Surface::new(&HeightView::new(*table.descriptor(), table.payload())?))
}

/// Heights in their stored form, exact.
pub(crate) fn heights(field: &HeightField) -> Result<TextureTable, StudyError> {
    Ok(HeightTable { grid: table_grid(field.grid()), values: field.samples() }.encode(Encoding::F32)?)
}

/// A horizon map in its stored form.
pub(crate) fn horizon(map: &HorizonMap, encoding: Encoding) -> Result<TextureTable, StudyError> {
    let grid = table_grid(&map.grid);
    let (azimuths, radius) = (Azimuths::full_circle(map.params.directions()), map.params.radius);
    Ok(HorizonTable { grid, azimuths, radius, values: &map.elevation_radians }.encode(encoding)?)
}

/// Points in their stored form: the first in the horizon's tables, the others in swept ones.
pub(crate) struct StoredPoints {
    directions: u32,
    /// Of the first point and of the others: elevations and distances.
    tables: Vec<[TextureTable; 2]>,
}

/// The same, as a run time looks at it.
pub(crate) struct PointViews<'a> {
    directions: u32,
    views: Vec<[TableView<'a>; 2]>,
}

impl StoredPoints {
    /// `layers` are `[point][direction]`, `sweep` what the points after the first were chosen for.
    pub(crate) fn new(
        grid: &Grid,
        radius: f64,
        sweep: CurvatureSweep,
        layers: &[Vec<BentLayer>],
        encoding: Encoding,
    ) -> Result<Self, StudyError> {
        let (grid, (first, others)) = (table_grid(grid), layers.split_at(1));
        let directions = first[0].len() as u32;
        let azimuths = Azimuths::full_circle(directions);
        let (elevations, distances) = values(first);
        let horizon = HorizonTable { grid, azimuths, radius, values: &elevations }.encode(encoding)?;
        let distance = DistanceTable { grid, azimuths, radius, values: &distances }.encode(encoding)?;
        let mut tables = vec![[horizon, distance]];
        if !others.is_empty() {
            let (elevations, distances) = values(others);
            let horizon = SweptHorizonTable { grid, azimuths, radius, sweep, values: &elevations }.encode(encoding)?;
            let distance = SweptDistanceTable { grid, azimuths, radius, sweep, values: &distances }.encode(encoding)?;
            tables.push([horizon, distance]);
        }
        Ok(Self { directions, tables })
    }

    /// Bytes of the elevations.
    pub(crate) fn elevation_bytes(&self) -> u64 {
        self.tables.iter().map(|[elevations, _]| elevations.payload().len() as u64).sum()
    }

    /// Bytes of elevations and distances.
    pub(crate) fn bytes(&self) -> u64 {
        self.tables.iter().flatten().map(|table| table.payload().len() as u64).sum()
    }

    /// Elevations and distances, the first point's before the others'.
    pub(crate) fn into_tables(self) -> impl Iterator<Item = TextureTable> {
        self.tables.into_iter().flatten()
    }

    pub(crate) fn views(&self) -> Result<PointViews<'_>, StudyError> {
        let views = self.tables.iter().map(|[elevations, distances]| Ok([elevations.view()?, distances.view()?]));
        let views = views.collect::<Result<_, StudyError>>()?;
        Ok(PointViews { directions: self.directions, views })
    }
}

impl StoredPoints {
    /// What shades curved surfaces by these points, over the relief they were baked from.
    pub(crate) fn curved_shadow(&self, field: &HeightField) -> Result<CurvedShadow, StudyError> {
        let [horizon, distance] = &self.tables[0];
        let horizon = HorizonView::new(*horizon.descriptor(), horizon.payload())?;
        let distance = DistanceView::new(*distance.descriptor(), distance.payload())?;
        let swept = match self.tables.get(1) {
            Some([horizon, distance]) => Some((
                SweptHorizonView::new(*horizon.descriptor(), horizon.payload())?,
                SweptDistanceView::new(*distance.descriptor(), distance.payload())?,
            )),
            None => None,
        };
        let heights = heights(field)?;
        let heights = HeightView::new(*heights.descriptor(), heights.payload())?;
        let swept = swept.as_ref().map(|(horizon, distance)| (horizon, distance));
        Ok(CurvedShadow::new(&horizon, &distance, swept, &heights)?)
    }
}

impl PointViews<'_> {
    pub(crate) fn point(&self, point: u32, direction: u32, column: u32, row: u32) -> StoredPoint {
        let (table, candidate) = if point == 0 { (0, 0) } else { (1, point - 1) };
        let layer = candidate * self.directions + direction;
        let [elevation, distance] = self.views[table].map(|view| f64::from(view.value(layer, column, row)));
        StoredPoint { slope: libm::tan(elevation), distance }
    }
}

/// Elevations and distances of layers, one after the other.
fn values(layers: &[Vec<BentLayer>]) -> (Vec<f32>, Vec<f32>) {
    let elevation = |slope: &f32| libm::atanf(*slope).clamp(-MAX_ELEVATION, MAX_ELEVATION);
    let elevations = layers.iter().flatten().flat_map(|layer| layer.slope.iter().map(elevation)).collect();
    (elevations, layers.iter().flatten().flat_map(|layer| layer.distance.iter().copied()).collect())
}

/// Lengths are only compared with each other here, so all units are the scene's.
pub(crate) fn table_grid(grid: &Grid) -> TableGrid {
    let wrap = match grid.edge {
        Edge::Wrap => Wrap::Repeat,
        Edge::Clamp => Wrap::Clamp,
    };
    TableGrid {
        width: grid.width,
        height: grid.height,
        spacing_u: grid.spacing.u(),
        spacing_v: grid.spacing.v(),
        length_unit: AssetUnit::SceneUnit,
        wrap_u: wrap,
        wrap_v: wrap,
    }
}
