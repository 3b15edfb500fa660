//! Every search ends, whatever it is given.

use barchan_asset::{ConeMapView, MaximumMipView, RelaxedConeMapView};
use barchan_field::{Edge, HeightField};
use barchan_shade::{
    ConeSteps, Fetches, LinearSearch, MaximumMipTraversal, ParallaxOcclusion, RelaxedConeSteps, Relief, ReliefSearch,
    Start, TracedRelief,
};

use crate::support::{
    cone_steps, field, mips, noise, relaxed_cone_steps, steepest_cones, steepest_relaxed_cones, surface, towards,
    traversal,
};

/// What every search finds from the top and from an arbitrary start, exact ones marked.
fn each(field: &HeightField, place: (f64, f64), direction: (f64, f64), check: impl Fn(&str, bool, f64, f64)) {
    let (surface, mips, cones) = (surface(field), mips(field), steepest_cones(field));
    let (relief, relaxed) = (Relief::new(&surface), steepest_relaxed_cones(field));
    let ray = relief.ray(place.0, place.1, towards(direction.0, direction.1)).unwrap();
    let searches: [(bool, &dyn ReliefSearch); 6] = [
        (true, &TracedRelief::new(&relief)),
        (true, &cone_steps(&relief, &cones)),
        (true, &traversal(&relief, &mips)),
        (false, &relaxed_cone_steps(&relief, &relaxed)),
        (false, &LinearSearch::new(&relief, 0, 10)),
        (false, &ParallaxOcclusion::new(&relief, 500)),
    ];
    let truth = TracedRelief::new(&relief).first_hit(&ray, 0.0);
    for (exact, search) in searches {
        check(search.name(), exact, search.find(&ray, Start::TOP).depth, truth);
        for depth in [-1.0, 0.5, 1.0, 7.0, f64::NAN] {
            for proven in [true, false] {
                let found = search.find(&ray, Start { depth, proven, fetches: Fetches::default() }).depth;
                assert!((0.0..=1.0).contains(&found), "{} from {depth}: {found}", search.name());
            }
        }
    }
}

#[test]
fn a_relief_without_thickness_is_hit_at_the_top() {
    for (size, edge) in [((1, 1), Edge::Wrap), ((1, 1), Edge::Clamp), ((3, 2), Edge::Wrap)] {
        for polar in [0.0, 45.0, 89.0] {
            each(&field(size, (1.0, 1.0), edge, |_, _| 2.5), (0.3, 0.7), (polar, 30.0), |name, exact, found, _| {
                assert!(found <= if exact { 0.0 } else { 0.5 }, "{name} {found}");
            });
        }
    }
}

#[test]
fn strips_one_texel_wide_are_searched_as_any_map() {
    for size in [(1, 9), (9, 1), (2, 1), (2, 2), (3, 5)] {
        for edge in [Edge::Wrap, Edge::Clamp] {
            for azimuth in [0.0, 45.0, 100.0, 270.0] {
                let field = field(size, (1.0, 1.0), edge, |column, row| 3.0 * noise(7, column, row));
                each(&field, (0.4, -0.2), (70.0, azimuth), |name, exact, found, truth| {
                    assert!(!exact || (found - truth).abs() < 1e-12, "{name} on {size:?}: {found} {truth}");
                });
            }
        }
    }
}

#[test]
fn the_most_grazing_ray_along_a_groove_ends_at_the_floor() {
    // A hundred thousand texels of floor between two walls, and no hit before it.
    let field = field((4, 4), (1.0, 1.0), Edge::Wrap, |_, row| f32::from(row == 0));
    let polar = 1.0e5_f64.atan().to_degrees();
    each(&field, (0.5, 2.0), (polar, 0.0), |name, _, found, truth| {
        assert_eq!(truth, 1.0);
        assert!((found - 1.0).abs() < 2e-3, "{name} {found}");
    });
}

#[test]
fn no_number_of_steps_is_too_small_or_too_large() {
    let surface = surface(&field((2, 1), (1.0, 1.0), Edge::Wrap, |column, _| column as f32));
    let relief = Relief::new(&surface);
    let ray = relief.ray(0.2, 0.0, towards(40.0, 0.0)).unwrap();
    let truth = TracedRelief::new(&relief).first_hit(&ray, 0.0);
    for steps in [0, u32::MAX] {
        let fine = 1.0 / f64::from(steps.clamp(1, 1 << 20));
        assert!((LinearSearch::new(&relief, steps, u32::MAX).find(&ray, Start::TOP).depth - truth).abs() <= fine);
        assert!((ParallaxOcclusion::new(&relief, steps).find(&ray, Start::TOP).depth - truth).abs() <= fine);
    }
}

#[test]
fn numbers_that_no_encoder_writes_end_a_search_like_any_others() {
    let field = field((8, 8), (1.0, 1.0), Edge::Wrap, |column, row| 2.0 * noise(8, column, row));
    let (surface, mips) = (surface(&field), mips(&field));
    let (cones, relaxed) = (steepest_cones(&field), steepest_relaxed_cones(&field));
    let relief = Relief::new(&surface);
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -5.0, 1e30] {
        let spoil = |payload: &[u8]| {
            let mut bytes = payload.to_vec();
            bytes.chunks_exact_mut(4).step_by(3).for_each(|number| number.copy_from_slice(&bad.to_le_bytes()));
            bytes
        };
        let (cone_bytes, relaxed_bytes) = (spoil(cones.payload()), spoil(relaxed.payload()));
        let cone_view = ConeMapView::new(*cones.descriptor(), &cone_bytes).unwrap();
        let relaxed_view = RelaxedConeMapView::new(*relaxed.descriptor(), &relaxed_bytes).unwrap();
        let mut mip_bytes = spoil(mips.payload());
        // But for the last level, by which a table is told to belong.
        let last = mip_bytes.len() - 4;
        mip_bytes[last..].copy_from_slice(&mips.payload()[last..]);
        let mip_view = MaximumMipView::new(*mips.descriptor(), &mip_bytes).unwrap();
        let searches: [&dyn ReliefSearch; 3] = [
            &ConeSteps::new(&relief, &cone_view).unwrap(),
            &RelaxedConeSteps::new(&relief, &relaxed_view, 8).unwrap(),
            &MaximumMipTraversal::new(&relief, &mip_view).unwrap(),
        ];
        for search in searches {
            for azimuth in 0..8 {
                let ray = relief.ray(1.2, 3.4, towards(75.0, 45.0 * f64::from(azimuth))).unwrap();
                let found = search.find(&ray, Start::TOP).depth;
                assert!((0.0..=1.0).contains(&found), "{} {bad} {found}", search.name());
            }
        }
    }
}
