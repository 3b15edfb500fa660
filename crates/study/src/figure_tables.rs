//! What a run time has of a figure.

use barchan_asset::{CurvatureSweep, Encoding};
use barchan_bakers::Exec;
use barchan_bakers::horizon::{Azimuths, HorizonParams, Method};
use barchan_shade::{CurvedMethod, CurvedShadow, Surface};

use crate::figures::Figure;
use crate::reading::MOST_POINTS;
use crate::tables::{self, StoredPoints};
use crate::{StudyError, points};

/// Relief and its tables, as a file stores them, in the default encoding.
pub(crate) struct FigureTables {
    pub(crate) surface: Surface,
    pub(crate) shadow: CurvedShadow,
    height_bytes: u64,
    point_bytes: u64,
}

impl FigureTables {
    pub(crate) fn bake(figure: &Figure, exec: &Exec<'_>) -> Result<Self, StudyError> {
        let (field, range) = (&figure.relief.field, figure.range);
        let azimuths = Azimuths::full_circle(figure.directions);
        let params = HorizonParams { azimuths, radius: figure.radius, distance: true, method: Method::default() };
        let baked = points::bake(field, &params, range, 0..figure.directions, exec)?;
        let sweep = CurvatureSweep { candidates: MOST_POINTS - 1, curvature_min: range.min, curvature_max: range.max };
        let stored = StoredPoints::new(field.grid(), figure.radius, sweep, &baked, Encoding::Compact)?;
        Ok(Self {
            surface: tables::surface(field)?,
            shadow: stored.curved_shadow(field)?,
            height_bytes: field.grid().texels() as u64,
            point_bytes: stored.bytes() / u64::from(MOST_POINTS),
        })
    }

    /// Bytes of the points that a method reads, and of heights in 8 bit.
    pub(crate) fn bytes(&self, method: CurvedMethod) -> u64 {
        self.height_bytes + u64::from(method.points()) * self.point_bytes
    }
}
