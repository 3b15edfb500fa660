//! What a search reads beside heights, as a file stores it.

use barchan_asset::{
    ConeMapTable, ConeMapView, Encoding, MaximumMipTable, MaximumMipView, RelaxedConeMapTable, RelaxedConeMapView,
    TextureTable,
};
use barchan_bakers::Exec;
use barchan_bakers::cone::{self, ConeKind};
use barchan_bakers::maximum_mip;
use barchan_field::HeightField;
use barchan_shade::{
    ConeSteps, LinearSearch, MaximumMipTraversal, ParallaxOcclusion, RelaxedConeSteps, Relief, ReliefSearch,
};

use crate::relief_method::Search;
use crate::tables::table_grid;
use crate::{Stopwatch, StudyError};

/// Steps of the linear searches.
pub(crate) const STEPS: u32 = 64;

/// Halvings of the last step.
pub(crate) const BISECTIONS: u32 = 8;

/// A search and its table.
pub(crate) struct StoredSearch {
    pub(crate) search: Search,
    /// None if heights are enough.
    table: Option<TextureTable>,
    /// Processor time of the bake.
    seconds: f64,
}

impl StoredSearch {
    pub(crate) fn bake(search: Search, field: &HeightField, exec: &Exec<'_>) -> Result<Self, StudyError> {
        let watch = Stopwatch::start();
        let table = match search {
            Search::Linear | Search::Parallax => None,
            Search::Cones | Search::RelaxedCones => Some(cones(search, field, exec)?),
            Search::MaximumMip => Some(mip(field, exec)?),
        };
        Ok(Self { search, table, seconds: watch.elapsed().core_seconds() })
    }

    /// The search of the relief that the table was baked of.
    pub(crate) fn of<'a>(&self, relief: &Relief<'a>) -> Result<Box<dyn ReliefSearch + 'a>, StudyError> {
        let Some(table) = &self.table else {
            return Ok(match self.search {
                Search::Parallax => Box::new(ParallaxOcclusion::new(relief, STEPS)),
                _ => Box::new(LinearSearch::new(relief, STEPS, BISECTIONS)),
            });
        };
        let (descriptor, payload) = (*table.descriptor(), table.payload());
        Ok(match self.search {
            Search::MaximumMip => {
                Box::new(MaximumMipTraversal::new(relief, &MaximumMipView::new(descriptor, payload)?)?)
            }
            Search::RelaxedCones => {
                let view = RelaxedConeMapView::new(descriptor, payload)?;
                Box::new(RelaxedConeSteps::new(relief, &view, BISECTIONS)?)
            }
            _ => Box::new(ConeSteps::new(relief, &ConeMapView::new(descriptor, payload)?)?),
        })
    }

    /// The table, if it has one.
    pub(crate) fn into_table(self) -> Option<TextureTable> {
        self.table
    }

    /// Bytes of the table, and the seconds of its bake.
    pub(crate) fn weight(&self) -> (u64, f64) {
        self.table.as_ref().map_or((0, 0.0), |table| (table.payload().len() as u64, self.seconds))
    }
}

fn cones(search: Search, field: &HeightField, exec: &Exec<'_>) -> Result<TextureTable, StudyError> {
    let kind = if search == Search::RelaxedCones { ConeKind::Relaxed } else { ConeKind::Strict };
    let map = cone::bake(field, kind, exec)?;
    let (grid, relief, values) = (table_grid(field.grid()), map.relief, &map.values[..]);
    Ok(match kind {
        ConeKind::Relaxed => RelaxedConeMapTable { grid, relief, values }.encode(Encoding::Compact)?,
        ConeKind::Strict => ConeMapTable { grid, relief, values }.encode(Encoding::Compact)?,
    })
}

fn mip(field: &HeightField, exec: &Exec<'_>) -> Result<TextureTable, StudyError> {
    let mip = maximum_mip::bake(field, exec)?;
    let levels: Vec<&[f32]> = mip.levels.iter().map(|level| &level.values[..]).collect();
    Ok(MaximumMipTable { grid: table_grid(field.grid()), levels: &levels }.encode(Encoding::Compact)?)
}
