//! The reliefs that searches are studied on: five that differ in what makes a search fail, and two for the paper's scenes.
//!
//! # Conventions
//!
//! Every relief is a tile of [`SIDE`] length units that wraps, [`DEPTH`] of its side deep from the highest texel to the
//! lowest, whatever its size in texels. The paper prints its height maps as pictures, so they cannot be had; what its text
//! says of them is kept: one of pyramids, whose tips a coarse search loses, and one "filled with values near the bottom".

use barchan_field::shapes::{FractalTerrain, RipplePattern, Ripples};
use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};

use crate::scenes::SIDE;
use crate::{Scene, StudyError, sample};

/// The thickness of every relief, as a part of the tile's side.
pub const DEPTH: f64 = 0.15;

/// The five of the table of methods.
pub const FIVE: [&str; 5] = ["smooth", "fractal", "spikes", "bricks", "white_noise"];

/// The paper's two height maps: that of its figures, and one that is near its floor.
pub const PAPER: [&str; 2] = ["pyramids", "studs"];

/// Of this many texels one sticks out of the spikes' floor.
const TEXELS_PER_SPIKE: u64 = 328;

/// Pyramids in a tile.
const PYRAMIDS: u64 = 40;

/// A height at the texel `(column, row)` of a square grid of so many texels across.
type ByTexel = fn((u64, u64), u64) -> f64;

/// A relief of `size` × `size` texels.
///
/// # Errors
/// An unknown name, or a size of 0.
pub fn by_name(name: &str, size: u32) -> Result<Scene, StudyError> {
    let field = match name {
        "smooth" => smooth().rasterize(grid(size)?)?,
        "fractal" => fractal().rasterize(grid(size)?)?,
        "spikes" => by_texel(size, spike)?,
        "bricks" => by_texel(size, brick)?,
        "white_noise" => by_texel(size, |(column, row), width| sample::unit(row * width + column))?,
        "pyramids" => by_texel(size, pyramids)?,
        "studs" => by_texel(size, stud)?,
        _ => {
            let known: Vec<&str> = FIVE.into_iter().chain(PAPER).collect();
            return Err(StudyError::Scene { name: name.to_owned(), known: known.join(", ") });
        }
    };
    Ok(Scene { name: name.to_owned(), field: as_deep(&field)? })
}

/// Eight hills by eight.
fn smooth() -> Shape {
    Shape::Ripples(Ripples { amplitude: 1.0, waves_u: 8, waves_v: 8, phase: 0.0, pattern: RipplePattern::EggBox })
}

/// Relief of many scales, down to a few texels of a tile of 256.
fn fractal() -> Shape {
    Shape::FractalTerrain(FractalTerrain { height: 40.0, hurst: 0.8, features_across: 4, octaves: 5, seed: 1 })
}

/// Single texels that stick out of a floor.
fn spike((column, row): (u64, u64), width: u64) -> f64 {
    if sample::scramble(row * width + column).is_multiple_of(TEXELS_PER_SPIKE) { 1.0 } else { 0.0 }
}

/// A running bond of bricks, eight courses of four, joints of a fortieth of the tile: plateaus and walls a texel wide.
fn brick((column, row): (u64, u64), width: u64) -> f64 {
    const JOINT: f64 = 0.1;
    let (u, v) = fractions((column, row), width);
    let course = (8.0 * v).floor();
    let along = 4.0 * u + 0.5 * (course % 2.0);
    let in_joint = (8.0 * v).fract() < 2.0 * JOINT || along.fract() < JOINT;
    if in_joint { 0.0 } else { 1.0 }
}

/// Pyramids of many sizes that stand in each other.
fn pyramids(texel: (u64, u64), width: u64) -> f64 {
    let place = fractions(texel, width);
    let height = |index: u64| {
        let [u, v, size] = [0, 1, 2].map(|part| sample::unit(3 * index + part));
        let half_width = 0.05 + 0.12 * size;
        let away = wrapped(place.0 - u).max(wrapped(place.1 - v));
        (half_width / 0.17) * (1.0 - away / half_width)
    };
    (0..PYRAMIDS).map(height).fold(0.0, f64::max)
}

/// Four by four round studs on a floor.
fn stud(texel: (u64, u64), width: u64) -> f64 {
    let (u, v) = fractions(texel, width);
    let (u, v) = ((4.0 * u).fract() - 0.5, (4.0 * v).fract() - 0.5);
    let away = (u * u + v * v).sqrt() / 0.18;
    if away < 1.0 { (1.0 - away * away).sqrt() } else { 0.0 }
}

/// Where a texel's centre is, as parts of the tile.
fn fractions((column, row): (u64, u64), width: u64) -> (f64, f64) {
    ((column as f64 + 0.5) / width as f64, (row as f64 + 0.5) / width as f64)
}

/// The distance to the nearest repetition.
fn wrapped(difference: f64) -> f64 {
    (difference - difference.round()).abs()
}

fn by_texel(size: u32, height: ByTexel) -> Result<HeightField, StudyError> {
    let (grid, width) = (grid(size)?, u64::from(size));
    let rows = (0..width).flat_map(|row| (0..width).map(move |column| (column, row)));
    Ok(HeightField::new(grid, rows.map(|texel| height(texel, width) as f32).collect())?)
}

/// The relief stretched to [`DEPTH`]; one without any stays as it is.
fn as_deep(field: &HeightField) -> Result<HeightField, StudyError> {
    let (low, high) = field.range();
    let stretch = if high > low { DEPTH * SIDE / f64::from(high - low) } else { 1.0 };
    let heights = field.samples().iter().map(|height| (f64::from(height - low) * stretch) as f32);
    Ok(HeightField::new(*field.grid(), heights.collect())?)
}

fn grid(size: u32) -> Result<Grid, StudyError> {
    let spacing = Spacing::square(SIDE / f64::from(size.max(1)))?;
    Ok(Grid { width: size, height: size, spacing, unit: LengthUnit::SceneUnit, edge: Edge::Wrap })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_relief_is_as_deep_and_wraps() {
        for name in FIVE.into_iter().chain(PAPER) {
            for size in [32, 64] {
                let field = by_name(name, size).unwrap().field;
                let (low, high) = field.range();
                assert_eq!((low, field.grid().edge), (0.0, Edge::Wrap), "{name}");
                assert!((f64::from(high) / (DEPTH * SIDE) - 1.0).abs() < 1e-6, "{name}: {high}");
            }
        }
    }

    #[test]
    fn studs_are_near_their_floor_and_spikes_are_few() {
        let low_share = |name: &str| {
            let field = by_name(name, 128).unwrap().field;
            let low = field.samples().iter().filter(|height| f64::from(**height) < 0.1 * DEPTH * SIDE).count();
            low as f64 / field.samples().len() as f64
        };
        assert!(low_share("studs") > 0.8 && low_share("spikes") > 0.99 && low_share("pyramids") < 0.5);
    }

    #[test]
    fn an_unknown_relief_is_answered_with_those_known() {
        let message = by_name("moon", 8).unwrap_err().to_string();
        assert!(message.contains("`moon`") && message.contains("bricks") && message.contains("studs"), "{message}");
    }
}
