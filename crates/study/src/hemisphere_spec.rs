//! Hemisphere depths as the studies vary them: from a specification to the table that a file stores.

use barchan_asset::{
    Azimuths, DepthMode, Encoding, HemisphereDirections, HemisphereTable, HemisphereView, RingSpacing, TextureTable,
};
use barchan_bakers::Exec;
use barchan_bakers::hemisphere::{HemisphereBaker, HemisphereParams};
use barchan_field::HeightField;
use barchan_shade::{DepthMapStart, Relief};

use crate::tables::table_grid;
use crate::{Setting, Stopwatch, StudyError};

/// Both modes, in the order of the docs.
pub(crate) const MODES: [DepthMode; 2] = [DepthMode::Nearest, DepthMode::Conservative];

/// What is varied of a hemisphere table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HemisphereSpec {
    /// What a depth promises.
    pub mode: DepthMode,
    /// Texels along each side.
    pub size: u32,
    /// Rings of directions.
    pub rings: u32,
    /// Azimuths of directions, all round.
    pub azimuths: u32,
    /// How the polar angle is cut.
    pub spacing: RingSpacing,
    /// Where the last ring ends, from the normal.
    pub max_polar_degrees: f64,
    /// How depths are stored.
    pub encoding: Encoding,
}

/// A table, and what its bake took.
pub(crate) struct StoredHemisphere {
    pub(crate) table: TextureTable,
    /// Processor time of the layers that were baked, in seconds.
    pub(crate) seconds: f64,
}

/// Which layers are baked: the others stay at depth 0, from which any search is right, and slow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Layers<'a> {
    All,
    /// Those that rays at these angles from the normal, in degrees, ask for.
    AtAngles(&'a [f64]),
    /// Those of the azimuths, in degrees, besides.
    AtAnglesAnd(&'a [f64], &'a [f64]),
}

impl HemisphereSpec {
    /// The default of a recipe whose scene is not looked at from below `90° − max_polar_degrees`.
    pub(crate) fn conservative(max_polar_degrees: f64) -> Self {
        Self {
            mode: DepthMode::Conservative,
            size: 64,
            rings: 32,
            azimuths: 16,
            spacing: RingSpacing::SquaredTangents,
            max_polar_degrees,
            encoding: Encoding::Compact,
        }
    }

    /// The paper's: equal angles, and the depth of one ray.
    pub(crate) fn paper(max_polar_degrees: f64) -> Self {
        let conservative = Self::conservative(max_polar_degrees);
        Self { mode: DepthMode::Nearest, spacing: RingSpacing::EqualAngles, ..conservative }
    }

    pub(crate) fn directions(&self) -> HemisphereDirections {
        HemisphereDirections {
            rings: self.rings,
            azimuths: Azimuths::full_circle(self.azimuths),
            spacing: self.spacing,
            max_polar_radians: self.max_polar_degrees.to_radians(),
        }
    }

    pub(crate) fn params(&self) -> HemisphereParams {
        HemisphereParams { directions: self.directions(), width: self.size, height: self.size, mode: self.mode }
    }

    /// The mode as records have it.
    pub(crate) fn mode_name(&self) -> &'static str {
        if self.mode == DepthMode::Nearest { "nearest" } else { "conservative" }
    }

    /// As records have it.
    pub(crate) fn setting(&self) -> Setting {
        let spacing = if self.spacing == RingSpacing::EqualAngles { "equal_angles" } else { "squared_tangents" };
        Setting::default()
            .with("mode", self.mode_name())
            .with("size", self.size)
            .with("rings", self.rings)
            .with("azimuths", self.azimuths)
            .with("spacing", spacing)
            .with("encoding", self.encoding.name())
    }

    pub(crate) fn bake(
        &self,
        field: &HeightField,
        layers: Layers<'_>,
        exec: &Exec<'_>,
    ) -> Result<StoredHemisphere, StudyError> {
        let directions = self.directions();
        let texels = self.size as usize * self.size as usize;
        let mut values = vec![0.0; texels * directions.layers() as usize];
        let watch = Stopwatch::start();
        let baker = HemisphereBaker::new(field, self.params(), exec)?;
        for (layer, values) in (0..).zip(values.chunks_exact_mut(texels)) {
            if layers.have(&directions, layer) {
                baker.bake_layer(layer, exec, values);
            }
        }
        let seconds = watch.elapsed().core_seconds();
        let (mode, relief) = (self.mode, baker.relief());
        let grid = table_grid(field.grid()).with_texels(self.size, self.size);
        let table = HemisphereTable { grid, directions, mode, relief, values: &values };
        Ok(StoredHemisphere { table: table.encode(self.encoding)?, seconds })
    }
}

impl Layers<'_> {
    fn have(self, directions: &HemisphereDirections, layer: u32) -> bool {
        match self {
            Self::All => true,
            Self::AtAngles(angles) => {
                let (ring, _) = directions.ring_and_azimuth(layer);
                angles.iter().any(|angle| directions.ring_of_tangent(libm::tan(angle.to_radians())) == Some(ring))
            }
            Self::AtAnglesAnd(angles, azimuths) => {
                let (_, azimuth) = directions.ring_and_azimuth(layer);
                let have = |degrees: &f64| directions.azimuth_cell(degrees.to_radians()) == Some(azimuth);
                // Straight from above there is no azimuth, and the first cell is asked.
                Self::AtAngles(angles).have(directions, layer) && (azimuth == 0 || azimuths.iter().any(have))
            }
        }
    }
}

impl StoredHemisphere {
    /// Where rays into the relief that it was baked of start.
    pub(crate) fn start(&self, relief: &Relief<'_>) -> Result<DepthMapStart<'_>, StudyError> {
        let view = HemisphereView::new(*self.table.descriptor(), self.table.payload())?;
        Ok(DepthMapStart::new(relief, &view)?)
    }

    pub(crate) fn bytes(&self) -> u64 {
        self.table.payload().len() as u64
    }
}
