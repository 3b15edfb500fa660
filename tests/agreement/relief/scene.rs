//! Reliefs with every table for their search, on the GPU and as the CPU twin.

use barchan_asset::{
    Azimuths, ConeMapTable, ConeMapView, DepthMode, Encoding, HeightTable, HeightView, HemisphereDirections,
    HemisphereTable, HemisphereView, MaximumMipTable, MaximumMipView, RelaxedConeMapTable, RelaxedConeMapView,
    RingSpacing, Semantic, TableGrid, TextureTable, Wrap,
};
use barchan_bakers::cone::{self, ConeKind};
use barchan_bakers::hemisphere::{self, HemisphereParams};
use barchan_bakers::{Exec, maximum_mip};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Spacing};
use barchan_shade::{
    ConeSteps, DepthMapStart, Found, LinearSearch, MaximumMipTraversal, ParallaxOcclusion, RelaxedConeSteps, Relief,
    ReliefRoad, ReliefSearch as Twin, Surface,
};
use barchan_wgpu::ReliefSearch;
use glam::DVec3;

use crate::support::{Loaded, grid, noise};

/// Length of a texel along u and v.
const SPACING: (f64, f64) = (0.75, 1.25);

/// Where rings of directions end.
const MAX_POLAR: f64 = 80.0;

/// A relief to be searched.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Scene {
    pub(crate) kind: Kind,
    pub(crate) size: (u32, u32),
    pub(crate) edge: Edge,
    pub(crate) encoding: Encoding,
    pub(crate) mode: DepthMode,
    pub(crate) spacing: RingSpacing,
    pub(crate) azimuths: Azimuths,
}

/// Kinds of relief.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Smooth,
    Cobbles,
    Spikes,
    Walls,
    Noise,
    Flat,
}

impl Kind {
    /// The height of a texel, 0 to 1.
    fn height(self, (width, height): (u32, u32), column: u32, row: u32) -> f32 {
        let turn = |index: u32, of: u32| (std::f64::consts::TAU * f64::from(index) / f64::from(of)) as f32;
        let (u, v) = (turn(column, width), turn(row, height));
        let noise = |seed| noise(seed, row * width + column);
        match self {
            Self::Smooth => 0.25 * (2.0 + (2.0 * u).sin() + (3.0 * v + u).cos()),
            Self::Cobbles => (1.0 - (4.0 * u).sin().powi(2) * (3.0 * v + 0.5).sin().powi(2)).sqrt(),
            Self::Spikes => f32::from(noise(2) > 0.99),
            Self::Walls => f32::from((column / 5 + row / 7).is_multiple_of(3)),
            Self::Noise => noise(1),
            Self::Flat => 0.5,
        }
    }
}

impl Scene {
    /// Relief in which neighbours differ, of tables that lose nothing.
    pub(crate) fn noise() -> Self {
        Self {
            kind: Kind::Noise,
            size: (24, 19),
            edge: Edge::Wrap,
            encoding: Encoding::F32,
            mode: DepthMode::Conservative,
            spacing: RingSpacing::SquaredTangents,
            azimuths: Azimuths::full_circle(6),
        }
    }

    /// All of its tables on the GPU.
    pub(crate) fn load(&self) -> Loaded {
        Loaded::of_tables(self.tables())
    }

    /// Tables of the heights as they are stored.
    fn tables(&self) -> Vec<TextureTable> {
        let (heights, exec) = (self.heights(), Exec::new(1).unwrap());
        let view = HeightView::new(*heights.descriptor(), heights.payload()).unwrap();
        let samples = (0..self.size.1).flat_map(|row| view.table().row(0, row)).collect();
        let spacing = Spacing::new(SPACING.0, SPACING.1).unwrap();
        let (width, height) = self.size;
        let field_grid = Grid { width, height, spacing, unit: LengthUnit::Metre, edge: self.edge };
        let field = HeightField::new(field_grid, samples).unwrap();
        let grid = self.grid();
        let strict = cone::bake(&field, ConeKind::Strict, &exec).unwrap();
        let relaxed = cone::bake(&field, ConeKind::Relaxed, &exec).unwrap();
        let mip = maximum_mip::bake(&field, &exec).unwrap();
        let levels: Vec<&[f32]> = mip.levels.iter().map(|level| level.values.as_slice()).collect();
        vec![
            heights,
            ConeMapTable { grid, relief: strict.relief, values: &strict.values }.encode(self.encoding).unwrap(),
            RelaxedConeMapTable { grid, relief: relaxed.relief, values: &relaxed.values }
                .encode(self.encoding)
                .unwrap(),
            MaximumMipTable { grid, levels: &levels }.encode(self.encoding).unwrap(),
            self.depths(&field, &exec),
        ]
    }

    fn heights(&self) -> TextureTable {
        let (width, height) = self.size;
        let thickness = 0.2 * width as f32;
        let texels = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        let values: Vec<f32> =
            texels.map(|(column, row)| 3.0 + thickness * self.kind.height(self.size, column, row)).collect();
        HeightTable { grid: self.grid(), values: &values }.encode(self.encoding).unwrap()
    }

    fn grid(&self) -> TableGrid {
        let wrap = if self.edge == Edge::Wrap { Wrap::Repeat } else { Wrap::Clamp };
        grid(self.size, SPACING, (wrap, wrap))
    }

    /// About a texel for 2 × 2 of the heights.
    fn depths(&self, field: &HeightField, exec: &Exec) -> TextureTable {
        let directions = HemisphereDirections {
            rings: 5,
            azimuths: self.azimuths,
            spacing: self.spacing,
            max_polar_radians: MAX_POLAR.to_radians(),
        };
        let (width, height) = (self.size.0.div_ceil(2), self.size.1.div_ceil(2));
        let params = HemisphereParams { directions, width, height, mode: self.mode };
        let map = hemisphere::bake(field, &params, exec).unwrap();
        let along = |size: u32, count: u32, spacing: f64| f64::from(size) * spacing / f64::from(count);
        let grid = TableGrid {
            width,
            height,
            spacing_u: along(self.size.0, width, SPACING.0),
            spacing_v: along(self.size.1, height, SPACING.1),
            ..self.grid()
        };
        HemisphereTable { grid, directions, mode: self.mode, relief: map.relief, values: &map.depths }
            .encode(self.encoding)
            .unwrap()
    }
}

/// The CPU twin of a file on the GPU.
pub(crate) struct ReliefTwin<'a> {
    loaded: &'a Loaded,
    surface: Surface,
}

impl<'a> ReliefTwin<'a> {
    pub(crate) fn new(loaded: &'a Loaded) -> Self {
        Self { loaded, surface: Surface::new(&loaded.view(Semantic::Height, HeightView::new)) }
    }

    pub(crate) fn relief(&self) -> Relief<'_> {
        Relief::new(&self.surface)
    }

    /// How this search does it.
    pub(crate) fn search<'s>(&'s self, search: ReliefSearch) -> Box<dyn Twin + 's> {
        let (relief, loaded) = (self.relief(), self.loaded);
        match search {
            ReliefSearch::Linear { steps, bisections } => Box::new(LinearSearch::new(&relief, steps, bisections)),
            ReliefSearch::ParallaxOcclusion { steps } => Box::new(ParallaxOcclusion::new(&relief, steps)),
            ReliefSearch::ConeSteps => {
                Box::new(ConeSteps::new(&relief, &loaded.view(Semantic::ConeMap, ConeMapView::new)).unwrap())
            }
            ReliefSearch::RelaxedConeSteps { bisections } => {
                let view = loaded.view(Semantic::RelaxedConeMap, RelaxedConeMapView::new);
                Box::new(RelaxedConeSteps::new(&relief, &view, bisections).unwrap())
            }
            ReliefSearch::MaximumMip => {
                let view = loaded.view(Semantic::MaximumHeight, MaximumMipView::new);
                Box::new(MaximumMipTraversal::new(&relief, &view).unwrap())
            }
        }
    }

    /// The starts of the hemisphere table, if it is on the GPU.
    pub(crate) fn starts(&self) -> Option<DepthMapStart<'_>> {
        self.loaded.plan.texture(Semantic::HemisphereDepth)?;
        let view = self.loaded.view(Semantic::HemisphereDepth, HemisphereView::new);
        Some(DepthMapStart::new(&self.relief(), &view).unwrap())
    }

    /// Where rays of an eye into these places start and end; nothing for a ray that is given up.
    pub(crate) fn find(
        &self,
        search: ReliefSearch,
        places: &[(f64, f64)],
        towards: DVec3,
    ) -> Vec<Option<(f64, Found)>> {
        let (starts, search, relief) = (self.starts(), self.search(search), self.relief());
        let road = ReliefRoad { depth_map: starts.as_ref(), search: search.as_ref() };
        let find = |&(x, y): &(f64, f64)| {
            let ray = relief.ray(x, y, towards)?;
            Some((road.start(&ray).depth, road.find(&ray)))
        };
        places.iter().map(find).collect()
    }
}
