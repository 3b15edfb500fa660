//! The fields that techniques are studied on, by name and at any size.
//!
//! # Conventions
//!
//! Every scene is 256 length units wide whatever its size in texels: the example of each
//! [`Shape`] is made for such a tile, and a finer grid resolves the same relief better. What is meant texel by texel, the
//! noises and the spike, is as steep at any size. Shapes that tile wrap, others are clamped; noise and the constant wrap.

use barchan_field::{Edge, Grid, HeightField, LengthUnit, Shape, Spacing};

use crate::{StudyError, sample};

/// Length units along a scene's side.
pub const SIDE: f64 = 256.0;

/// The height of a texel, in texels, by its place in row order.
type TexelsHigh = fn(u64) -> f64;

/// Scenes that are not the example of a shape.
const MADE_HERE: [(&str, TexelsHigh); 3] = [
    // A sweep's worst case: a dozen columns compete, 0 to 4 texels high.
    ("white_noise", |texel| 4.0 * sample::unit(texel)),
    // Normally distributed, 16 texels of standard deviation: nothing but walls and spikes.
    ("steep_noise", |texel| 16.0 * sample::normal(texel)),
    // Every point of every ray is as high as every other.
    ("constant", |_| 1.0),
];

/// A height field with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Its name in records.
    pub name: String,
    /// The heights.
    pub field: HeightField,
}

/// The names that [`by_name`] knows: shapes first.
#[must_use]
pub fn names() -> Vec<&'static str> {
    Shape::ALL_NAMES.into_iter().chain(MADE_HERE.map(|(name, _)| name)).collect()
}

/// A scene of `size` × `size` texels.
///
/// # Errors
/// An unknown name, or a size of 0.
pub fn by_name(name: &str, size: u32) -> Result<Scene, StudyError> {
    let shape = Shape::examples().into_iter().find(|shape| shape.name() == name);
    let made_here = MADE_HERE.iter().find(|(known, _)| *known == name);
    let field = match (shape, made_here) {
        (Some(shape), _) => shape.rasterize(grid(size, shape.tiles())?)?,
        (None, Some((_, texels_high))) => by_texel(grid(size, true)?, *texels_high)?,
        (None, None) => return Err(StudyError::Scene { name: name.to_owned(), known: names().join(", ") }),
    };
    Ok(Scene { name: name.to_owned(), field })
}

/// The scene with its lowest texel on the base surface.
pub(crate) fn on_the_base(scene: Scene) -> Result<Scene, StudyError> {
    let lowest = scene.field.range().0;
    let heights = scene.field.samples().iter().map(|height| height - lowest).collect();
    Ok(Scene { field: HeightField::new(*scene.field.grid(), heights)?, ..scene })
}

fn grid(size: u32, tiles: bool) -> Result<Grid, StudyError> {
    let spacing = Spacing::square(SIDE / f64::from(size.max(1)))?;
    let edge = if tiles { Edge::Wrap } else { Edge::Clamp };
    Ok(Grid { width: size, height: size, spacing, unit: LengthUnit::SceneUnit, edge })
}

/// Heights given in texels, each by its own index.
fn by_texel(grid: Grid, texels_high: TexelsHigh) -> Result<HeightField, StudyError> {
    let height = |texel| (texels_high(texel) * grid.spacing.u()) as f32;
    Ok(HeightField::new(grid, (0..grid.texels() as u64).map(height).collect())?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_a_scene_of_the_size_asked_for() {
        for name in names() {
            let scene = by_name(name, 16).unwrap();
            assert_eq!((scene.name.as_str(), scene.field.grid().texels()), (name, 256));
            assert_eq!(scene.field.grid().extent_u(), SIDE);
        }
    }

    #[test]
    fn noise_is_as_steep_at_any_size() {
        for (name, highest) in [("white_noise", 4.0), ("steep_noise", 80.0)] {
            let reliefs = [32, 64].map(|size| {
                let field = by_name(name, size).unwrap().field;
                let (low, high) = field.range();
                f64::from(high - low) / field.grid().spacing.u()
            });
            assert!(reliefs.iter().all(|relief| (0.9 * highest..2.0 * highest).contains(relief)), "{reliefs:?}");
        }
    }

    #[test]
    fn an_unknown_name_is_answered_with_those_known() {
        let message = by_name("moon", 8).unwrap_err().to_string();
        assert!(message.contains("`moon`") && message.contains("fractal_terrain") && message.contains("steep_noise"));
    }
}
