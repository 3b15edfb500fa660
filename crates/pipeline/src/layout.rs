//! What tables say of themselves before they hold a value: fields, azimuths and ranges in the words of the asset, which
//! knows nothing of bakers.

use barchan_asset::{Azimuths as TableAzimuths, CurvatureSweep, LengthUnit as AssetUnit, TableFacts, TableGrid, Wrap};
use barchan_bakers::horizon::{Azimuths, HorizonParams};
use barchan_field::{Edge, Grid, LengthUnit};

use crate::Table;

/// Where texels and layers lie.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TableLayout {
    pub(crate) grid: TableGrid,
    pub(crate) azimuths: TableAzimuths,
    pub(crate) radius: f64,
}

impl TableLayout {
    pub(crate) fn new(grid: &Grid, params: &HorizonParams) -> Self {
        Self { grid: table_grid(grid), azimuths: table_azimuths(&params.azimuths), radius: params.radius }
    }

    /// A directional table; `sweep` is for the swept ones, which need it.
    pub(crate) fn facts(&self, table: Table, sweep: Option<CurvatureSweep>) -> TableFacts {
        let Self { grid, azimuths, radius } = *self;
        match (table, sweep) {
            (Table::Distance, _) => TableFacts::distance(grid, azimuths, radius),
            (Table::SweptHorizon, Some(sweep)) => TableFacts::swept_horizon(grid, azimuths, radius, sweep),
            (Table::SweptDistance, Some(sweep)) => TableFacts::swept_distance(grid, azimuths, radius, sweep),
            _ => TableFacts::horizon(grid, azimuths, radius),
        }
    }
}

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
        length_unit: length_unit(grid.unit),
        wrap_u: wrap,
        wrap_v: wrap,
    }
}

pub(crate) fn length_unit(unit: LengthUnit) -> AssetUnit {
    match unit {
        LengthUnit::SceneUnit => AssetUnit::SceneUnit,
        LengthUnit::Metre => AssetUnit::Metre,
        LengthUnit::Centimetre => AssetUnit::Centimetre,
        LengthUnit::Millimetre => AssetUnit::Millimetre,
        LengthUnit::Kilometre => AssetUnit::Kilometre,
    }
}

fn table_azimuths(azimuths: &Azimuths) -> TableAzimuths {
    match *azimuths {
        Azimuths::FullCircle { count } => TableAzimuths::full_circle(count),
        Azimuths::Arc { first_degrees, last_degrees, count } => {
            TableAzimuths::arc(first_degrees.to_radians(), last_degrees.to_radians(), count)
        }
    }
}
