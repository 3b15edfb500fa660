//! Tables that belong to other heights.

use barchan_asset::{
    Azimuths, ConeMapView, DepthMode, Encoding, HemisphereDirections, HemisphereTable, HemisphereView, MaximumMipView,
    RingSpacing,
};
use barchan_field::{Edge, HeightField};
use barchan_shade::{ConeSteps, DepthMapStart, MaximumMipTraversal, MismatchedRelief, Relief};

use crate::common::table_grid;
use crate::support::{field, mips, relief_range, steepest_cones, surface};

fn of(size: u32, spacing: f64, edge: Edge, highest: f32) -> HeightField {
    field((size, size), (spacing, spacing), edge, |column, row| if column + row == 0 { highest } else { 0.0 })
}

fn accepted(heights: &HeightField, baked_of: &HeightField) -> [Result<(), MismatchedRelief>; 3] {
    let surface = surface(heights);
    let relief = Relief::new(&surface);
    let (cones, mips) = (steepest_cones(baked_of), mips(baked_of));
    let directions = HemisphereDirections {
        rings: 1,
        azimuths: Azimuths::full_circle(1),
        spacing: RingSpacing::EqualAngles,
        max_polar_radians: 1.0,
    };
    let values = vec![0.0; baked_of.samples().len()];
    let depths = HemisphereTable {
        grid: table_grid(baked_of.grid()),
        directions,
        mode: DepthMode::Conservative,
        relief: relief_range(baked_of),
        values: &values,
    };
    let depths = depths.encode(Encoding::F32).unwrap();
    [
        ConeSteps::new(&relief, &ConeMapView::new(*cones.descriptor(), cones.payload()).unwrap()).map(drop),
        MaximumMipTraversal::new(&relief, &MaximumMipView::new(*mips.descriptor(), mips.payload()).unwrap()).map(drop),
        DepthMapStart::new(&relief, &HemisphereView::new(*depths.descriptor(), depths.payload()).unwrap()).map(drop),
    ]
}

#[test]
fn a_table_of_other_heights_is_refused_and_told_why() {
    let heights = of(6, 1.0, Edge::Wrap, 2.0);
    assert!(accepted(&heights, &of(6, 1.0, Edge::Wrap, 2.0)).iter().all(Result::is_ok));
    for other in [of(6, 2.0, Edge::Wrap, 2.0), of(6, 1.0, Edge::Clamp, 2.0), of(6, 1.0, Edge::Wrap, 1.5)] {
        assert!(accepted(&heights, &other).iter().all(Result::is_err));
    }
    // A depth map may have fewer texels over the same tile.
    let [cones, mips, depths] = accepted(&heights, &of(3, 2.0, Edge::Wrap, 2.0));
    assert!(cones.is_err() && mips.is_err() && depths.is_ok());
    assert_eq!(
        cones.unwrap_err().to_string(),
        "the cone map table has another size than the heights; a table baked of these heights, as they are stored, is accepted"
    );
}
