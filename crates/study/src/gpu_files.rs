//! Files of the study's own scenes, in memory, and what of them is on a GPU.

use barchan_asset::{
    ApertureConeTable, AssetWriter, BentNormalTable, Codec, CurvatureSweep, Encoding, HorizonTable, Semantic,
    SkyVisibilityTable, TextureTable,
};
use barchan_bakers::Exec;
use barchan_bakers::horizon::{Azimuths, BentLayer, HorizonParams, Method};
use barchan_bakers::sky::{self, SkyMap, SkyParams};
use barchan_bakers::swept::CurvatureRange;
use barchan_field::{Edge, Grid, LengthUnit, Spacing};
use barchan_view::Gpu;
use barchan_wgpu::{DeviceLimits, GpuAsset, Reader, Selection, UploadPlan};

use crate::hemisphere_spec::{HemisphereSpec, Layers};
use crate::reading::MOST_POINTS;
use crate::relief_method::Search;
use crate::relief_tables::StoredSearch;
use crate::tables::{self, StoredPoints, table_grid};
use crate::{Scene, StudyError, points};

/// Azimuths of horizons.
const DIRECTIONS: u32 = 16;

/// How far they are searched, in the scenes' length unit.
const RADIUS: f64 = 200.0;

/// The curvatures that points are chosen for.
pub(crate) const CURVATURES: CurvatureRange = CurvatureRange { min: 0.0, max: 0.015 };

/// What of a file is on a GPU.
pub(crate) struct OnGpu {
    pub(crate) plan: UploadPlan,
    pub(crate) asset: GpuAsset,
}

impl OnGpu {
    /// These tables of a file.
    pub(crate) fn load(gpu: &Gpu, bytes: &[u8], tables: &[Semantic]) -> Result<Self, StudyError> {
        let reader = Reader::open(bytes)?;
        let plan = UploadPlan::new(&reader, &Selection::tables(tables), &DeviceLimits::of(&gpu.device))?;
        let asset = pollster::block_on(GpuAsset::upload(&gpu.device, &gpu.queue, &reader, &plan))?;
        gpu.finish()?;
        Ok(Self { plan, asset })
    }
}

/// Heights, horizons and distances of three points, and the sky, before any encoding.
pub(crate) struct Horizons<'a> {
    scene: &'a Scene,
    points: Vec<Vec<BentLayer>>,
    sky: SkyMap,
}

impl<'a> Horizons<'a> {
    pub(crate) fn bake(scene: &'a Scene, exec: &Exec<'_>) -> Result<Self, StudyError> {
        let azimuths = Azimuths::full_circle(DIRECTIONS);
        let params = HorizonParams { azimuths, radius: RADIUS, distance: true, method: Method::default() };
        let points = points::bake(&scene.field, &params, CURVATURES, 0..DIRECTIONS, exec)?;
        Ok(Self { scene, points, sky: sky::bake(&scene.field, &params, SkyParams::ALL, exec)? })
    }

    /// The file, all tables but the heights in one encoding.
    pub(crate) fn file(&self, encoding: Encoding) -> Result<Vec<u8>, StudyError> {
        let (field, grid, radius) = (&self.scene.field, table_grid(self.scene.field.grid()), RADIUS);
        let (curvature_min, curvature_max) = (CURVATURES.min, CURVATURES.max);
        let sweep = CurvatureSweep { candidates: MOST_POINTS - 1, curvature_min, curvature_max };
        let points = StoredPoints::new(field.grid(), radius, sweep, &self.points, encoding)?;
        let mut tables = vec![tables::heights(field)?];
        tables.extend(points.into_tables());
        if let Some(values) = &self.sky.visibility {
            tables.push(SkyVisibilityTable { grid, radius, values }.encode(encoding)?);
        }
        if let Some(values) = &self.sky.bent_normal {
            tables.push(BentNormalTable { grid, radius, values }.encode(encoding)?);
        }
        if let Some(values) = &self.sky.aperture_cone {
            tables.push(ApertureConeTable { grid, radius, values }.encode(encoding)?);
        }
        file(tables)
    }
}

/// Heights, and what rays start and search by, in the compact encoding; hemispheres of `depths` texels along each side, to
/// `max_polar_degrees` from the normal.
pub(crate) fn of_relief(
    scene: &Scene,
    (depths, max_polar_degrees): (u32, f64),
    searches: &[Search],
    exec: &Exec<'_>,
) -> Result<Vec<u8>, StudyError> {
    let field = &scene.field;
    let spec = HemisphereSpec { size: depths, ..HemisphereSpec::conservative(max_polar_degrees) };
    let mut all = vec![tables::heights(field)?, spec.bake(field, Layers::All, exec)?.table];
    for &search in searches {
        all.extend(StoredSearch::bake(search, field, exec)?.into_table());
    }
    file(all)
}

/// A horizon of so many texels along each side and azimuths, stored raw in 32-bit floats: its bytes are what counts.
pub(crate) fn of_size(side: u32, layers: u32) -> Result<Vec<u8>, StudyError> {
    let (spacing, unit, edge) = (Spacing::square(1.0)?, LengthUnit::SceneUnit, Edge::Wrap);
    let grid = Grid { width: side, height: side, spacing, unit, edge };
    let count = side as usize * side as usize * layers as usize;
    let values: Vec<f32> = (0..count).map(|index| (index % 1024) as f32 / 1024.0).collect();
    let azimuths = barchan_asset::Azimuths::full_circle(layers);
    let table = HorizonTable { grid: table_grid(&grid), azimuths, radius: 1.0, values: &values };
    file([table.encode(Encoding::F32)?])
}

fn file(tables: impl IntoIterator<Item = TextureTable>) -> Result<Vec<u8>, StudyError> {
    let mut writer = AssetWriter::new();
    for table in tables {
        writer.add_table(table, Codec::Raw)?;
    }
    Ok(writer.finish()?)
}
