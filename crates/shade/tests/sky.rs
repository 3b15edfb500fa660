//! The light of the sky.

use barchan_asset::{
    BentNormalTable, BentNormalView, Encoding, LengthUnit, SkyVisibilityTable, SkyVisibilityView, TableGrid, Wrap,
};
use barchan_shade::SkyLight;

const GRID: TableGrid = TableGrid {
    width: 2,
    height: 1,
    spacing_u: 1.0,
    spacing_v: 1.0,
    length_unit: LengthUnit::Metre,
    wrap_u: Wrap::Clamp,
    wrap_v: Wrap::Clamp,
};

fn light(visibility: [f32; 2], bent_normal: Option<[f32; 4]>) -> SkyLight {
    let table = SkyVisibilityTable { grid: GRID, radius: 1.0, values: &visibility }.encode(Encoding::F32).unwrap();
    let visibility = SkyVisibilityView::new(*table.descriptor(), table.payload()).unwrap();
    let Some(values) = bent_normal else { return SkyLight::new(&visibility, None) };
    let table = BentNormalTable { grid: GRID, radius: 1.0, values: &values }.encode(Encoding::F32).unwrap();
    let bent_normal = BentNormalView::new(*table.descriptor(), table.payload()).unwrap();
    SkyLight::new(&visibility, Some(&bent_normal))
}

#[test]
fn an_even_sky_is_as_bright_as_it_is_visible() {
    let light = light([0.25, 1.0], None);
    assert_eq!([0.0, 0.5, 1.0].map(|x| light.irradiance(x, 0.0)), [0.25, 0.625, 1.0]);
    assert_eq!(light.visibility(0.5, 0.0), 0.625);
}

#[test]
fn an_overcast_sky_is_brightest_above() {
    let light = light([1.0, 0.5], Some([0.0, 0.0, 1.0, 0.0]));
    // The zenith itself; then a sky that is seen at the horizon alone, a third as bright.
    assert_eq!(light.irradiance(0.0, 0.0), 1.0);
    assert!((light.irradiance(1.0, 0.0) - 0.5 / 3.0).abs() < 1e-12);
}
