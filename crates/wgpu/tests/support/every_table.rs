//! A small asset that has some of the twelve tables of texels, or all of them: what shaders are composed for, without a bake.

use std::error::Error;

use barchan_asset::{
    AssetWriter, Azimuths, Codec, CurvatureSweep, DepthMode, Encoding, HemisphereDirections, LengthUnit, ReliefRange,
    RingSpacing, Semantic, TableEncoder, TableFacts, TableGrid, TextureTable, Wrap,
};

/// A file of those tables, all of zeros.
///
/// # Errors
/// None, unless the format is broken.
pub(crate) fn every_table(tables: &[Semantic], encoding: Encoding) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut writer = AssetWriter::new();
    for &table in tables {
        let encoder = TableEncoder::new(&facts(table), encoding, 0.0..=0.5)?;
        let descriptor = *encoder.descriptor();
        let payload = vec![0; descriptor.payload_length() as usize];
        writer.add_table(TextureTable::new(descriptor, payload)?, Codec::Raw)?;
    }
    Ok(writer.finish()?)
}

fn facts(table: Semantic) -> TableFacts {
    let (length_unit, wrap) = (LengthUnit::Metre, Wrap::Repeat);
    let grid =
        TableGrid { width: 4, height: 4, spacing_u: 1.0, spacing_v: 1.0, length_unit, wrap_u: wrap, wrap_v: wrap };
    let (azimuths, radius) = (Azimuths::full_circle(4), 8.0);
    let sweep = CurvatureSweep { candidates: 2, curvature_min: -0.1, curvature_max: 0.1 };
    let relief = ReliefRange { top: 1.0, thickness: 1.0 };
    let spacing = RingSpacing::SquaredTangents;
    let directions = HemisphereDirections { rings: 2, azimuths, spacing, max_polar_radians: 1.3 };
    match table {
        Semantic::Height => TableFacts::height(grid),
        Semantic::HorizonElevation => TableFacts::horizon(grid, azimuths, radius),
        Semantic::HorizonDistance => TableFacts::distance(grid, azimuths, radius),
        Semantic::SweptElevation => TableFacts::swept_horizon(grid, azimuths, radius, sweep),
        Semantic::SweptDistance => TableFacts::swept_distance(grid, azimuths, radius, sweep),
        Semantic::SkyVisibility => TableFacts::sky_visibility(grid, radius),
        Semantic::BentNormal => TableFacts::bent_normal(grid, radius),
        Semantic::ApertureCone => TableFacts::aperture_cone(grid, radius),
        Semantic::HemisphereDepth => TableFacts::hemisphere(grid, directions, DepthMode::Conservative, relief),
        Semantic::ConeMap => TableFacts::cone_map(grid, relief),
        Semantic::RelaxedConeMap => TableFacts::relaxed_cone_map(grid, relief),
        Semantic::MaximumHeight => TableFacts::maximum_mip(grid),
    }
}
