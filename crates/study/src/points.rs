//! Points of curvature-swept horizons, as they are baked.

use barchan_bakers::Exec;
use barchan_bakers::horizon::{BentLayer, HorizonParams};
use barchan_bakers::swept::{CurvatureRange, Points, SweptBaker, SweptParams};
use barchan_field::HeightField;

use crate::StudyError;
use crate::reading::MOST_POINTS;

/// `[point][direction]`, the flat horizon first: as many points as any variant reads.
pub(crate) fn bake(
    field: &HeightField,
    horizon: &HorizonParams,
    range: CurvatureRange,
    directions: impl Iterator<Item = u32>,
    exec: &Exec<'_>,
) -> Result<Vec<Vec<BentLayer>>, StudyError> {
    let params = SweptParams { range, points: Points::Count(MOST_POINTS) };
    let mut baker = SweptBaker::new(field, horizon, &params, exec)?;
    let mut points: Vec<Vec<BentLayer>> = (0..baker.points()).map(|_| Vec::new()).collect();
    for direction in directions {
        let mut layers = (0..baker.points()).map(|_| BentLayer::new(field)).collect::<Result<Vec<_>, _>>()?;
        baker.bake_direction(direction, exec, &mut layers)?;
        points.iter_mut().zip(layers).for_each(|(point, layer)| point.push(layer));
    }
    Ok(points)
}
