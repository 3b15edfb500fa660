//! The figures as the paper shows them, three side by side: the horizon map without correction, the swept horizon of three
//! points, and the truth, a ray per pixel traced over the displaced surface.
//!
//! Light comes from the side, so that the terminator of the base surface is seen: what is lit behind it are bumps. The
//! outline is that of the base in all three, as bump mapping has it; only shadows differ.

use barchan_bakers::Exec;
use barchan_shade::{BaseSurface, Camera, CurvedMethod, CurvedPixels, DisplacedShadow, Lens, Palette, Picture};
use glam::DVec3;

use crate::figure_tables::FigureTables;
use crate::figures::{self, Figure};
use crate::runner::{Observer, Step};
use crate::{Scale, StudyError};

/// White pixels between pictures.
const GAP: u32 = 6;

/// A way to look at a figure.
struct Shot {
    /// The beginning of the figure's name.
    figure: &'static str,
    /// The picture's name.
    name: &'static str,
    eye: DVec3,
    target: DVec3,
    lens: Lens,
    /// The picture's height over its width.
    aspect: f64,
    /// Towards the light.
    light: DVec3,
}

/// On a sphere of such a radius, from straight before it: poles, where the texture is pinched, are on the outline.
fn before_sphere(figure: &'static str, name: &'static str, radius: f64) -> Shot {
    Shot {
        figure,
        name,
        eye: DVec3::new(4.0, 0.0, 0.0) * radius,
        target: DVec3::ZERO,
        lens: Lens::Orthographic { height: 2.1 * radius },
        aspect: 1.0,
        light: DVec3::new(0.25, 0.9, 0.35),
    }
}

/// On a patch, from above its near edge.
fn above_patch(figure: &'static str, name: &'static str, light: DVec3) -> Shot {
    Shot {
        figure,
        name,
        eye: DVec3::new(0.0, -380.0, 300.0),
        target: DVec3::new(4.0, -10.0, 16.0),
        lens: Lens::Perspective { field_of_view: 22.0 },
        aspect: 0.62,
        light,
    }
}

fn shots() -> Vec<Shot> {
    let low = DVec3::new(-1.0, 0.35, 0.28);
    vec![
        before_sphere("4", "figure_4", 1.0 / 0.015),
        before_sphere("5", "figure_5", 1.0 / 0.005),
        before_sphere("6", "figure_6", 1.0 / 0.015),
        above_patch("7", "figure_7", low),
        above_patch("8", "figure_8", low),
        above_patch("9", "figure_9", low),
    ]
}

/// The pictures, and their names.
///
/// # Errors
/// A figure that cannot be made.
pub fn draw(
    scale: Scale,
    exec: &Exec<'_>,
    observe: &mut Observer<'_>,
) -> Result<Vec<(&'static str, Picture)>, StudyError> {
    let (figures, shots) = (figures::all(scale)?, shots());
    let size = match scale {
        Scale::Full => 320,
        Scale::Quick => 24,
    };
    let mut pictures = Vec::new();
    for (done, shot) in shots.iter().enumerate() {
        observe(&Step { done, total: shots.len(), what: shot.name });
        if let Some(figure) = figures.iter().find(|figure| figure.relief.name.starts_with(shot.figure)) {
            pictures.push((shot.name, shot.take(figure, size, exec)?));
        }
    }
    Ok(pictures)
}

impl Shot {
    fn take(&self, figure: &Figure, size: u32, exec: &Exec<'_>) -> Result<Picture, StudyError> {
        let (eye, target, lens) = (self.eye, self.target, self.lens);
        let height = (self.aspect * f64::from(size)).round() as u32;
        let camera = Camera { eye, target, up: DVec3::Z, lens, width: size, height };
        let (base, light): (&dyn BaseSurface, _) = (&*figure.base, self.light.normalize());
        let tables = FigureTables::bake(figure, exec)?;
        let pixels = CurvedPixels::new(&camera, base, &tables.surface, light);
        let oracle = DisplacedShadow::new(base, &tables.surface, f64::INFINITY);
        let by_table = |method: CurvedMethod| {
            pixels.decide(|place| {
                let direction = place.light.direction;
                let curvature = figure.forms_at(place.uv).along(direction.x, direction.y);
                tables.shadow.in_shadow(method, place.texel, &place.light, curvature)
            })
        };
        let shadows = [
            by_table(CurvedMethod::Flat),
            by_table(CurvedMethod::Exact(3)),
            pixels.decide(|place| oracle.in_shadow(place.uv, light)),
        ];
        let pictures = shadows.map(|shadow| pixels.picture(&tables.surface, &shadow, &Palette::SAND));
        Ok(Picture::side_by_side(&pictures, GAP))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_figure_is_drawn_three_times_and_the_swept_one_is_nearer_the_truth() {
        let exec = Exec::new(1).unwrap();
        let pictures = draw(Scale::Quick, &exec, &mut |_| ()).unwrap();
        assert_eq!(pictures.len(), shots().len());
        let (mut flat, mut swept) = (0_u64, 0_u64);
        for (name, picture) in &pictures {
            assert_eq!(picture.width, 3 * 24 + 2 * GAP, "{name}");
            for row in picture.rgb.chunks_exact(3 * picture.width as usize) {
                let part = |index: usize| &row[index * 3 * (24 + GAP as usize)..][..3 * 24];
                let apart =
                    |index| part(index).iter().zip(part(2)).map(|(a, b)| u64::from(a.abs_diff(*b))).sum::<u64>();
                (flat, swept) = (flat + apart(0), swept + apart(1));
            }
        }
        assert!(4 * swept < 3 * flat, "{swept} {flat}");
    }
}
