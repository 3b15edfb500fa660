//! Files of the study's own scenes, in memory, and what of them is on a GPU.

use barchan_asset::{
    ApertureConeTable, AssetWriter, Azimuths, BentNormalTable, Codec, CurvatureSweep, Encoding, HorizonTable, Semantic,
    SkyVisibilityTable, TextureTable,
};
use barchan_bakers::Exec;
use barchan_bakers::horizon::{HorizonParams, Method};
use barchan_bakers::sky::{self, SkyParams};
use barchan_bakers::swept::CurvatureRange;
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

/// Heights, horizons and distances of three points, and the sky.
pub(crate) fn of_horizons(scene: &Scene, encoding: Encoding, exec: &Exec<'_>) -> Result<Vec<u8>, StudyError> {
    let (field, grid) = (&scene.field, table_grid(scene.field.grid()));
    let azimuths = barchan_bakers::horizon::Azimuths::full_circle(DIRECTIONS);
    let params = HorizonParams { azimuths, radius: RADIUS, distance: true, method: Method::default() };
    let baked = points::bake(field, &params, CURVATURES, 0..DIRECTIONS, exec)?;
    let (curvature_min, curvature_max) = (CURVATURES.min, CURVATURES.max);
    let sweep = CurvatureSweep { candidates: MOST_POINTS - 1, curvature_min, curvature_max };
    let points = StoredPoints::new(field.grid(), RADIUS, sweep, &baked, encoding)?;
    let sky = sky::bake(field, &params, SkyParams::ALL, exec)?;
    let values = |table: Option<Vec<f32>>| table.unwrap_or_default();
    let (visibility, bent, cone) = (values(sky.visibility), values(sky.bent_normal), values(sky.aperture_cone));
    let radius = RADIUS;
    let sky = [
        SkyVisibilityTable { grid, radius, values: &visibility }.encode(encoding)?,
        BentNormalTable { grid, radius, values: &bent }.encode(encoding)?,
        ApertureConeTable { grid, radius, values: &cone }.encode(encoding)?,
    ];
    file([tables::heights(field)?].into_iter().chain(points.into_tables()).chain(sky))
}

/// Heights, and what rays start and search by, in the compact encoding; hemispheres of `depths` texels along each side, to
/// `max_polar_degrees` from the normal.
pub(crate) fn of_relief(
    scene: &Scene,
    (depths, max_polar_degrees): (u32, f64),
    exec: &Exec<'_>,
) -> Result<Vec<u8>, StudyError> {
    let field = &scene.field;
    let spec = HemisphereSpec { size: depths, ..HemisphereSpec::conservative(max_polar_degrees) };
    let mut all = vec![tables::heights(field)?, spec.bake(field, Layers::All, exec)?.table];
    for search in Search::ALL {
        all.extend(StoredSearch::bake(search, field, exec)?.into_table());
    }
    file(all)
}

/// A horizon of so many texels along each side and azimuths, stored raw in 32-bit floats: its bytes are what counts.
pub(crate) fn of_size(side: u32, layers: u32) -> Result<Vec<u8>, StudyError> {
    let grid = barchan_field::Grid {
        width: side,
        height: side,
        spacing: barchan_field::Spacing::square(1.0)?,
        unit: barchan_field::LengthUnit::SceneUnit,
        edge: barchan_field::Edge::Wrap,
    };
    let count = side as usize * side as usize * layers as usize;
    let values: Vec<f32> = (0..count).map(|index| (index % 1024) as f32 / 1024.0).collect();
    let azimuths = Azimuths::full_circle(layers);
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
