//! The tables of a file as starts and searches of relief rays.

use barchan_asset::{ConeMapView, HemisphereView, MaximumMipView, RelaxedConeMapView};
use barchan_pipeline::Table;
use barchan_shade::{
    ConeSteps, DepthMapStart, LinearSearch, MaximumMipTraversal, ParallaxOcclusion, RelaxedConeSteps, Relief,
    ReliefSearch,
};

use crate::args::{RenderArguments, SearchName, StartName};
use crate::asset_file::{AssetFile, DecodedTable};
use crate::failure::Failure;

/// Steps of searches that know nothing of the relief.
pub(super) const STEPS: u32 = 64;

/// Halvings that follow.
pub(super) const BISECTIONS: u32 = 10;

impl SearchName {
    /// The table that the search needs.
    pub(super) fn table(self) -> Option<Table> {
        match self {
            Self::ConeSteps => Some(Table::ConeMap),
            Self::RelaxedConeSteps => Some(Table::RelaxedConeMap),
            Self::MaximumMip => Some(Table::MaximumMip),
            Self::Linear | Self::ParallaxOcclusion => None,
        }
    }

    /// As flags spell it.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::ConeSteps => "cone_steps",
            Self::RelaxedConeSteps => "relaxed_cone_steps",
            Self::MaximumMip => "maximum_mip",
            Self::Linear => "linear",
            Self::ParallaxOcclusion => "parallax_occlusion",
        }
    }

    /// The first that the tables of a file allow, the last one always: the first two are exact, mips in fewer fetches.
    pub(super) fn best_of(file: &AssetFile) -> Result<Self, Failure> {
        let best = [Self::MaximumMip, Self::ConeSteps, Self::RelaxedConeSteps, Self::Linear];
        let tables = file.tables()?;
        let allowed = |search: &Self| search.table().is_none_or(|table| tables.contains(&table));
        Ok(best.into_iter().find(allowed).unwrap_or(Self::Linear))
    }

    /// The search through a relief.
    pub(super) fn open<'a>(self, file: &AssetFile, relief: &Relief<'a>) -> Result<Box<dyn ReliefSearch + 'a>, Failure> {
        let asked = format!("--search {}", self.name());
        let decode = |table| decode(file, table, &asked);
        let bad = |error: &dyn std::fmt::Display| file.content(error);
        Ok(match self {
            Self::Linear => baseline(relief),
            Self::ParallaxOcclusion => Box::new(ParallaxOcclusion::new(relief, STEPS)),
            Self::ConeSteps => {
                let table = decode(Table::ConeMap)?;
                let view = ConeMapView::new(table.descriptor, &table.payload).map_err(|error| bad(&error))?;
                Box::new(ConeSteps::new(relief, &view).map_err(|error| bad(&error))?)
            }
            Self::RelaxedConeSteps => {
                let table = decode(Table::RelaxedConeMap)?;
                let view = RelaxedConeMapView::new(table.descriptor, &table.payload).map_err(|error| bad(&error))?;
                Box::new(RelaxedConeSteps::new(relief, &view, BISECTIONS).map_err(|error| bad(&error))?)
            }
            Self::MaximumMip => {
                let table = decode(Table::MaximumMip)?;
                let view = MaximumMipView::new(table.descriptor, &table.payload).map_err(|error| bad(&error))?;
                Box::new(MaximumMipTraversal::new(relief, &view).map_err(|error| bad(&error))?)
            }
        })
    }
}

/// What others are held against: the search of the paper.
pub(super) fn baseline<'a>(relief: &Relief<'a>) -> Box<dyn ReliefSearch + 'a> {
    Box::new(LinearSearch::new(relief, STEPS, BISECTIONS))
}

/// The hemisphere table, if it is there or asked for.
pub(super) fn hemisphere<'a>(
    file: &'a AssetFile,
    arguments: &RenderArguments,
) -> Result<Option<DecodedTable<'a>>, Failure> {
    let asked = match arguments.view.start {
        _ if arguments.ambient => "--ambient",
        Some(StartName::DepthMap) => "--start depth_map",
        _ if file.tables()?.contains(&Table::Hemisphere) => "",
        _ => return Ok(None),
    };
    decode(file, Table::Hemisphere, asked).map(Some)
}

/// The starts that a hemisphere table gives.
pub(super) fn depth_map<'a>(
    file: &AssetFile,
    relief: &Relief<'_>,
    table: &'a DecodedTable<'_>,
) -> Result<DepthMapStart<'a>, Failure> {
    let view = HemisphereView::new(table.descriptor, &table.payload).map_err(|error| file.content(error))?;
    DepthMapStart::new(relief, &view).map_err(|error| file.content(error))
}

/// A table that was asked for, or what to do where there is none.
fn decode<'a>(file: &'a AssetFile, table: Table, asked: &str) -> Result<DecodedTable<'a>, Failure> {
    if !file.tables()?.contains(&table) {
        let name = table.name();
        let advice = "bake it with `relief_mapping` in the recipe's scene, or from a height map with `--only height";
        return Err(file.content(format!("there is no {name} table, which {asked} needs; {advice},{name}`")));
    }
    file.decode(table)
}
