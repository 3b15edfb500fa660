//! Nothing of the relief is inside a cone, at any place, whatever is made of the map by a bilinear filter.

use barchan_bakers::cone::ConeKind;

use crate::support::{Random, Ray, bake, fields, filtered};

#[test]
fn the_filtered_depth_is_nowhere_below_the_surface() {
    let mut random = Random(1);
    for (relief, field) in fields((23, 17)) {
        let map = bake(&field, ConeKind::Strict);
        for _ in 0..2000 {
            let (x, y) = (random.between(-30.0, 50.0), random.between(-30.0, 50.0));
            let depth = map.relief.depth(field.surface(x, y));
            assert!(filtered(&map, x, y).0 <= depth + 1e-14, "{relief:?} at {x}, {y}");
        }
    }
}

#[test]
fn no_point_is_inside_the_filtered_cone_of_another() {
    let mut random = Random(2);
    let (mut touched, mut pairs) = (0, 0);
    for (relief, field) in fields((23, 17)) {
        let (map, spacing) = (bake(&field, ConeKind::Strict), field.grid().spacing);
        for _ in 0..1000 {
            let (x, y) = (random.between(-1.0, 23.0), random.between(-1.0, 17.0));
            let (foot, (_, ratio)) = (field.surface(x, y), filtered(&map, x, y));
            for _ in 0..100 {
                // As many far as near, down to a thousandth of a texel.
                let reach = 25.0 * 10.0_f64.powf(random.between(-4.5, 0.0));
                let (across, down) = (random.between(-reach, reach), random.between(-reach, reach));
                let rise = field.surface(x + across, y + down) - foot;
                let distance = (across * spacing.u()).hypot(down * spacing.v());
                assert!(
                    ratio * rise <= distance * (1.0 + 1e-9) + 1e-12,
                    "{relief:?} from {x}, {y} by {across}, {down}"
                );
                pairs += 1;
                touched += u32::from(ratio * rise > 0.9 * distance);
            }
        }
    }
    // Cones that were far too narrow would pass as well: some must nearly touch the relief.
    assert!(touched * 200 > pairs, "{touched} of {pairs}");
}

#[test]
fn no_step_of_any_ray_crosses_the_surface() {
    let mut random = Random(3);
    for (relief, field) in fields((23, 17)) {
        let map = bake(&field, ConeKind::Strict);
        for _ in 0..500 {
            let ray = Ray::random(&map, &mut random);
            let mut depth = 0.0;
            for _ in 0..60 {
                let next = ray.step(&map, depth);
                let clearance = ray.least_clearance(&field, &map, depth, next);
                assert!(clearance > -1e-12, "{relief:?}: {ray:?} from {depth} to {next} is {clearance} inside");
                depth = next;
            }
        }
    }
}
