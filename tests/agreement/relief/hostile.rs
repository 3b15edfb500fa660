//! Tables full of nonsense: every ray ends.

use barchan_asset::Encoding;
use barchan_wgpu::{Sampling, Selection, Technique};

use super::scene::Scene;
use super::{SEARCHES, around, towards};
use crate::support::{Loaded, noise};

/// Turns that a loop of a search takes at most.
const MOST_TURNS: f32 = 4096.0;

/// The file with every byte of every table replaced.
fn filled(loaded: &Loaded, byte: impl Fn(u32) -> u8) -> Loaded {
    let mut bytes = loaded.bytes.clone();
    for texture in loaded.plan.textures() {
        let (start, length) = (texture.payload_offset.unwrap() as usize, texture.bytes() as usize);
        (0_u32..).zip(&mut bytes[start..start + length]).for_each(|(index, to)| *to = byte(index));
    }
    Loaded::selected(bytes, &Selection::everything())
}

#[test]
fn every_ray_ends_in_nonsense() {
    for encoding in [Encoding::F32, Encoding::U8] {
        let scene = Scene { encoding, ..Scene::noise() };
        let sound = scene.load();
        let nonsense = |index| (256.0 * noise(9, index)) as u8;
        // Anything, all bits (no number, as a float), and none.
        for loaded in [filled(&sound, nonsense), filled(&sound, |_| 0xFF), filled(&sound, |_| 0)] {
            for search in SEARCHES {
                let pass = loaded.pass(&[Technique::Relief(search)], Sampling::Loaded);
                for polar in [0.0, 50.0, 89.0] {
                    let found = pass.draw(&around(scene.size, towards(polar, 77.0))).unwrap();
                    // No depth beside the relief, though it may be no number.
                    let is_sane = |[depth, heights, tables, _]: [f32; 4]| {
                        (depth.is_nan() || (0.0..=1.0).contains(&depth)) && heights + tables <= 2.0 * MOST_TURNS + 64.0
                    };
                    assert!(found.into_iter().all(is_sane), "{search:?} {encoding:?} {polar}");
                }
            }
        }
    }
}
