//! What relaxed cones gain, and how often they miss.

use barchan_bakers::cone::{ConeKind, ConeMap};
use barchan_field::{Edge, HeightField};

use crate::support::{Random, Ray, Relief, bake, fields};

#[test]
fn a_relaxed_cone_is_at_least_as_wide_as_a_strict_one() {
    for (relief, field) in fields((23, 17)) {
        let [strict, relaxed] = [ConeKind::Strict, ConeKind::Relaxed].map(|kind| bake(&field, kind));
        let wider = strict.values.chunks(2).zip(relaxed.values.chunks(2)).map(|(strict, relaxed)| {
            // Either is within 1/64 of what it stands for.
            assert!(relaxed[1] * (1.0 + 1.0 / 64.0) >= strict[1], "{relief:?}: {relaxed:?}, {strict:?}");
            assert_eq!(relaxed[0], strict[0]);
            u32::from(relaxed[1] > 1.5 * strict[1])
        });
        // On a ramp that ends at clamped edges the widest cones are both.
        let all_are_widest = matches!((relief, field.grid().edge), (Relief::Ramp, Edge::Clamp));
        assert!(wider.sum::<u32>() > 0 || all_are_widest, "{relief:?}: nothing is gained");
    }
}

/// Does a ray step right through a part of the relief?
fn misses(field: &HeightField, map: &ConeMap, ray: &Ray) -> bool {
    let mut depth = 0.0;
    for _ in 0..100 {
        let next = ray.step(map, depth).min(1.0);
        let inside = ray.least_clearance(field, map, next, next) <= 1e-6;
        if inside {
            return false;
        }
        if ray.least_clearance(field, map, depth, next) < -1e-6 {
            return true;
        }
        depth = next;
    }
    false
}

/// Of 4000 rays at up to 80° from the normal; found: spikes 150, walls 113, noise 205, smooth 2, ramp 27. Nothing is
/// promised, and a map that never missed would be needlessly narrow.
#[test]
fn a_few_in_a_hundred_rays_step_through_the_relief() {
    let mut random = Random(4);
    let mut missed = [0; 5];
    for (relief, field) in fields((46, 34)) {
        let map = bake(&field, ConeKind::Relaxed);
        let rays = (0..1000).map(|_| Ray::random(&map, &mut random));
        missed[relief as usize] += rays.filter(|ray| misses(&field, &map, ray)).count();
    }
    assert!(missed.iter().all(|&rays| rays < 4000 / 12), "{missed:?}");
    assert!(missed.iter().sum::<usize>() > 0);
}
