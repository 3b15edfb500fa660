//! The GPU, assets on it, and the places that probes look at.

use std::io::Cursor;
use std::path::Path;
use std::sync::OnceLock;

use barchan_asset::{
    Asset, AssetWriter, Codec, DescriptorError, LengthUnit, Semantic, TableGrid, TextureDescriptor, TextureTable, Wrap,
};
use barchan_field::{Edge, Shape, Spacing};
use barchan_pipeline::{Plan, Recipe, Run, ShapeSource, Source, Table, TableEncoding};
use barchan_shade::DirectionalLight;
use barchan_view::{Gpu, Probe, ProbePass};
use barchan_wgpu::{DeviceLimits, GpuAsset, Reader, Sampling, Selection, Technique, UploadPlan};
use glam::DVec3;

/// Both ways to interpolate.
pub(crate) const SAMPLINGS: [Sampling; 2] = [Sampling::Loaded, Sampling::Filtered];

/// Every encoding, as recipes name them.
pub(crate) const ENCODINGS: [TableEncoding; 4] =
    [TableEncoding::F32, TableEncoding::F16, TableEncoding::U8, TableEncoding::Compact];

/// What lies beyond the edges along u and along v.
pub(crate) const WRAPS: [(&str, (Wrap, Wrap)); 3] = [
    ("repeat", (Wrap::Repeat, Wrap::Repeat)),
    ("clamp", (Wrap::Clamp, Wrap::Clamp)),
    ("mixed", (Wrap::Repeat, Wrap::Clamp)),
];

/// The GPU of this machine, opened once. Without one the test fails, and says what installs one.
pub(crate) fn gpu() -> &'static Gpu {
    static GPU: OnceLock<Gpu> = OnceLock::new();
    GPU.get_or_init(|| Gpu::open().unwrap_or_else(|error| panic!("{error}")))
}

/// A file, and what of it is on the GPU.
pub(crate) struct Loaded {
    pub(crate) bytes: Vec<u8>,
    pub(crate) plan: UploadPlan,
    pub(crate) asset: GpuAsset,
}

impl Loaded {
    /// All of a file.
    pub(crate) fn new(bytes: Vec<u8>) -> Self {
        Self::selected(bytes, &Selection::everything())
    }

    /// What is selected of a file.
    pub(crate) fn selected(bytes: Vec<u8>, selection: &Selection) -> Self {
        let gpu = gpu();
        let reader = Reader::open(&bytes).unwrap();
        let plan = UploadPlan::new(&reader, selection, &DeviceLimits::of(&gpu.device)).unwrap();
        let upload = GpuAsset::upload(&gpu.device, &gpu.queue, &reader, &plan);
        let asset = pollster::block_on(upload).unwrap();
        Self { plan, asset, bytes }
    }

    /// All of a shape's tables, baked.
    pub(crate) fn baked(recipe: Recipe, tables: &[Table]) -> Self {
        Self::new(bake(recipe, tables))
    }

    /// A file of these tables.
    pub(crate) fn of_tables(tables: impl IntoIterator<Item = TextureTable>) -> Self {
        let mut writer = AssetWriter::new();
        for table in tables {
            writer.add_table(table, Codec::Raw).unwrap();
        }
        Self::new(writer.finish().unwrap())
    }

    /// A table of the same bytes as the CPU reads it: `loaded.view(Semantic::Height, HeightView::new)`. Of the whole file, whatever was
    /// selected of it.
    pub(crate) fn view<'a, V>(
        &'a self,
        table: Semantic,
        view: impl FnOnce(TextureDescriptor, &'a [u8]) -> Result<V, DescriptorError>,
    ) -> V {
        let section = Asset::open(&self.bytes).unwrap().section(table.kind()).unwrap();
        view(section.texture().unwrap(), section.raw_payload().unwrap()).unwrap()
    }

    /// Whether the sampler interpolates a table's texels.
    pub(crate) fn filters(&self, table: Semantic, sampling: Sampling) -> bool {
        sampling == Sampling::Filtered && self.plan.texture(table).unwrap().is_filterable
    }

    /// The pass of the first of some techniques.
    pub(crate) fn pass(&self, techniques: &[Technique], sampling: Sampling) -> ProbePass<'_> {
        ProbePass::new(gpu(), &self.asset, &self.plan, techniques, sampling).unwrap()
    }
}

/// A recipe of a shape: texels that are not square, every table in one encoding, sections stored raw.
pub(crate) fn recipe(shape: Shape, (width, height): (u32, u32), edge: Edge, encoding: TableEncoding) -> Recipe {
    let mut recipe = Recipe::bare(Source::Shape(ShapeSource { shape, width, height }));
    recipe.spacing = Spacing::new(0.75, 1.25).unwrap();
    recipe.unit = Some(barchan_field::LengthUnit::Metre);
    recipe.edge = edge;
    recipe.horizon.directions = 8;
    for of_table in [
        &mut recipe.height.encoding,
        &mut recipe.horizon.encoding,
        &mut recipe.distance.encoding,
        &mut recipe.curved.encoding,
        &mut recipe.sky.encoding,
        &mut recipe.hemisphere.encoding,
        &mut recipe.cone_map.encoding,
        &mut recipe.maximum_mip.encoding,
    ] {
        *of_table = encoding;
    }
    recipe
}

/// The file of some tables of a recipe.
pub(crate) fn bake(recipe: Recipe, tables: &[Table]) -> Vec<u8> {
    let run = Run { folder: Path::new("."), threads: 1, progress: &|_, _, _| {} };
    barchan_pipeline::bake(&Plan::new(recipe, Some(tables)), &run, Cursor::new(Vec::new())).unwrap().out.into_inner()
}

/// Texels of a length along u and v, for tables that are made up.
pub(crate) fn grid((width, height): (u32, u32), (spacing_u, spacing_v): (f64, f64), wraps: (Wrap, Wrap)) -> TableGrid {
    TableGrid { width, height, spacing_u, spacing_v, length_unit: LengthUnit::Metre, wrap_u: wraps.0, wrap_v: wraps.1 }
}

/// Reproducible noise in [0, 1).
pub(crate) fn noise(seed: u32, index: u32) -> f32 {
    let mut hash = seed.wrapping_mul(0x9E37_79B9) ^ index.wrapping_mul(0x85EB_CA6B);
    for _ in 0..2 {
        hash = (hash ^ (hash >> 15)).wrapping_mul(0x2C1B_3C6D);
        hash = (hash ^ (hash >> 12)).wrapping_mul(0x297A_2D39);
    }
    (hash >> 8) as f32 / (1 << 24) as f32
}

/// The light of an azimuth and an elevation in degrees, of exactly the direction that the GPU is given.
pub(crate) fn light(azimuth: f64, elevation: f64) -> DirectionalLight {
    towards(DirectionalLight::from_degrees(azimuth, elevation).towards)
}

/// The light of a direction, rounded as the GPU is given it.
pub(crate) fn towards(direction: DVec3) -> DirectionalLight {
    let towards = direction.as_vec3().as_dvec3();
    let azimuth_radians = if towards.x == 0.0 && towards.y == 0.0 { 0.0 } else { libm::atan2(towards.y, towards.x) };
    DirectionalLight { towards, azimuth_radians }
}

/// The places of a probe, row by row. They are the same on every GPU: the test takes a start and a step that f32 keeps exactly.
pub(crate) fn places(probe: &Probe) -> Vec<(f64, f64)> {
    let along = |axis: usize, index: u32| {
        let place = f64::from(probe.place[axis]) + f64::from(index) * f64::from(probe.step[axis]);
        assert_eq!(f64::from(place as f32), place, "a place that f32 holds");
        place
    };
    (0..probe.size.1).flat_map(|row| (0..probe.size.0).map(move |column| (along(0, column), along(1, row)))).collect()
}

/// One of the four numbers of every pixel.
pub(crate) fn numbers(found: &[[f32; 4]], which: usize) -> Vec<f64> {
    found.iter().map(|pixel| f64::from(pixel[which])).collect()
}

/// Says how far apart the two were at most, for who wants to see it.
#[expect(clippy::print_stdout, reason = "seen with --nocapture alone")]
pub(crate) fn report(name: &str, worst: f64, tolerance: f64) {
    println!("{name}: {worst:.1e} of {tolerance:.0e}");
}
