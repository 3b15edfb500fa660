//! What a run time may have of a relief: every table that a search reads, as a file stores it.

use barchan_asset::{
    ConeMapTable, ConeMapView, Encoding, MaximumMipTable, MaximumMipView, RelaxedConeMapTable, RelaxedConeMapView,
    TextureTable,
};
use barchan_bakers::Exec;
use barchan_bakers::cone::{self, ConeKind};
use barchan_bakers::maximum_mip;
use barchan_field::HeightField;
use barchan_shade::{
    ConeSteps, DepthMapStart, LinearSearch, MaximumMipTraversal, ParallaxOcclusion, RelaxedConeSteps, Relief,
    ReliefSearch, Surface,
};

use crate::hemisphere_spec::{HemisphereSpec, Layers, StoredHemisphere};
use crate::relief_method::{Feed, Method, Search};
use crate::relief_seeker::Seeker;
use crate::tables::{surface, table_grid};
use crate::{Stopwatch, StudyError};

/// Steps of the linear searches, and halvings after them.
pub(crate) const STEPS: u32 = 64;
/// See [`STEPS`].
pub(crate) const BISECTIONS: u32 = 8;

/// Tables that searches read, as a file stores them.
pub(crate) struct SearchTables(Vec<(Search, Stored)>);

/// A table, and the processor time of its bake in seconds.
struct Stored {
    table: TextureTable,
    seconds: f64,
}

impl SearchTables {
    /// Bakes what these searches read.
    pub(crate) fn bake(field: &HeightField, searches: &[Search], exec: &Exec<'_>) -> Result<Self, StudyError> {
        let mut tables = Vec::new();
        for &search in searches {
            match search {
                Search::Linear | Search::Parallax => {}
                Search::Cones => tables.push((search, stored(|| cones(field, ConeKind::Strict, exec))?)),
                Search::RelaxedCones => tables.push((search, stored(|| cones(field, ConeKind::Relaxed, exec))?)),
                Search::MaximumMip => tables.push((search, stored(|| mip(field, exec))?)),
            }
        }
        Ok(Self(tables))
    }

    /// The search, if its table was baked.
    pub(crate) fn search<'a>(
        &self,
        relief: &Relief<'a>,
        search: Search,
    ) -> Result<Box<dyn ReliefSearch + 'a>, StudyError> {
        Ok(match search {
            Search::Linear => Box::new(LinearSearch::new(relief, STEPS, BISECTIONS)),
            Search::Parallax => Box::new(ParallaxOcclusion::new(relief, STEPS)),
            Search::Cones => {
                let (descriptor, payload) = self.stored(search)?;
                Box::new(ConeSteps::new(relief, &ConeMapView::new(descriptor, payload)?)?)
            }
            Search::RelaxedCones => {
                let (descriptor, payload) = self.stored(search)?;
                Box::new(RelaxedConeSteps::new(relief, &RelaxedConeMapView::new(descriptor, payload)?)?)
            }
            Search::MaximumMip => {
                let (descriptor, payload) = self.stored(search)?;
                Box::new(MaximumMipTraversal::new(relief, &MaximumMipView::new(descriptor, payload)?)?)
            }
        })
    }

    /// Bytes of what a search reads beside heights, and the seconds of its bake.
    pub(crate) fn weight(&self, search: Search) -> (u64, f64) {
        let stored = self.0.iter().find(|(of, _)| *of == search);
        stored.map_or((0, 0.0), |(_, stored)| (stored.table.payload().len() as u64, stored.seconds))
    }
}

fn stored(bake: impl FnOnce() -> Result<TextureTable, StudyError>) -> Result<Stored, StudyError> {
    let watch = Stopwatch::start();
    let table = bake()?;
    Ok(Stored { table, seconds: watch.elapsed().core_seconds() })
}

pub(crate) fn cones(field: &HeightField, kind: ConeKind, exec: &Exec<'_>) -> Result<TextureTable, StudyError> {
    let map = cone::bake(field, kind, exec)?;
    let (grid, relief, values) = (table_grid(field.grid()), map.relief, &map.values[..]);
    Ok(match kind {
        ConeKind::Relaxed => RelaxedConeMapTable { grid, relief, values }.encode(Encoding::Compact)?,
        _ => ConeMapTable { grid, relief, values }.encode(Encoding::Compact)?,
    })
}

fn mip(field: &HeightField, exec: &Exec<'_>) -> Result<TextureTable, StudyError> {
    let mip = maximum_mip::bake(field, exec)?;
    let levels: Vec<&[f32]> = mip.levels.iter().map(|level| &level.values[..]).collect();
    Ok(MaximumMipTable { grid: table_grid(field.grid()), levels: &levels }.encode(Encoding::Compact)?)
}
