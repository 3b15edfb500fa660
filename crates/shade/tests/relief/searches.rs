//! What each search finds and what it counts.

use barchan_field::{Edge, HeightField};
use barchan_shade::{
    Fetches, LinearSearch, ParallaxOcclusion, Relief, ReliefRay, ReliefSearch, Start, Surface, TracedRelief,
};

use crate::support::{
    assert_near, cone_steps, field, gap, mips, rays, relaxed_cone_steps, reliefs, steepest_cones,
    steepest_relaxed_cones, surface, towards, traversal,
};

const POLARS: [f64; 5] = [0.0, 10.0, 35.0, 60.0, 80.0];

/// Rises from 0 to 8, one a texel.
fn slope() -> HeightField {
    field((9, 2), (1.0, 1.0), Edge::Clamp, |column, _| column as f32)
}

/// A ray up the slope, and the depth of its hit.
fn ray_on_slope(surface: &Surface, x: f64, polar: f64) -> (ReliefRay, f64) {
    let ray = Relief::new(surface).ray(x, 0.5, towards(polar, 180.0)).unwrap();
    (ray, (8.0 - x) / (8.0 * (1.0 + ray.tangent())))
}

fn at(depth: f64, proven: bool) -> Start {
    Start { depth, proven, fetches: Fetches::TABLE }
}

#[test]
fn linear_search_halves_the_step_that_ends_inside_and_counts_each_look() {
    let surface = surface(&slope());
    for (x, polar) in [(1.3, 0.0), (2.0, 45.0), (4.1, 70.0)] {
        let (ray, depth) = ray_on_slope(&surface, x, polar);
        let found = LinearSearch::new(&Relief::new(&surface), 20, 6).find(&ray, Start::TOP);
        assert_near(found.depth, depth, 1.0 / 20.0 / 128.0 + 1e-12);
        assert_eq!(found.fetches, Fetches { heights: (20.0 * depth).ceil() as u32 + 6, tables: 0 });
    }
}

#[test]
fn a_secant_is_exact_where_the_surface_is_a_line() {
    let surface = surface(&slope());
    for (x, polar) in [(1.3, 0.0), (2.0, 45.0), (4.1, 70.0)] {
        let (ray, depth) = ray_on_slope(&surface, x, polar);
        let found = ParallaxOcclusion::new(&Relief::new(&surface), 20).find(&ray, Start::TOP);
        assert_near(found.depth, depth, 1e-12);
        // The gap before the first step is looked at, too.
        assert_eq!(found.fetches, Fetches { heights: (20.0 * depth).ceil() as u32 + 1, tables: 0 });
    }
}

#[test]
fn steps_of_equal_depth_go_through_a_spike_and_free_space_does_not() {
    let field =
        field((64, 64), (1.0, 1.0), Edge::Wrap, |column, row| if (column, row) == (30, 30) { 8.0 } else { 0.0 });
    let surface = surface(&field);
    let relief = Relief::new(&surface);
    // Through the spike at half its height, where it is a texel wide.
    let ray = relief.ray(30.0 - 24.0, 30.0, towards(6_f64.atan().to_degrees(), 180.0)).unwrap();
    let truth = TracedRelief::new(&relief).first_hit(&ray, 0.0);
    assert!((0.4..0.6).contains(&truth), "{truth}");
    assert!(LinearSearch::new(&relief, 7, 8).find(&ray, Start::TOP).depth > 0.9);
    assert!(ParallaxOcclusion::new(&relief, 7).find(&ray, Start::TOP).depth > 0.9);
    assert_near(traversal(&relief, &mips(&field)).find(&ray, Start::TOP).depth, truth, 1e-12);
    assert_near(cone_steps(&relief, &steepest_cones(&field)).find(&ray, Start::TOP).depth, truth, 1e-12);
}

#[test]
fn cone_steps_and_maximum_mips_find_the_truth_from_any_proven_start() {
    for edge in [Edge::Wrap, Edge::Clamp] {
        for (name, field) in reliefs(27, 6.0, edge) {
            let (surface, mips, cones) = (surface(&field), mips(&field), steepest_cones(&field));
            let relief = Relief::new(&surface);
            let searches: [&dyn ReliefSearch; 2] = [&traversal(&relief, &mips), &cone_steps(&relief, &cones)];
            for polar in POLARS {
                for (index, ray) in rays(&relief, polar, 100).enumerate() {
                    let truth = TracedRelief::new(&relief).first_hit(&ray, 0.0);
                    let start = at(truth * [0.0, 0.3, 0.9, 1.0][index % 4], true);
                    for search in searches {
                        let found = search.find(&ray, start).depth;
                        let off = (found - truth).abs();
                        assert!(off < 1e-10, "{} on {name}: {found} instead of {truth}, {polar}°", search.name());
                    }
                }
            }
        }
    }
}

#[test]
fn relaxed_cone_steps_halve_the_step_that_ends_inside() {
    let field = slope();
    let (surface, cones) = (surface(&field), steepest_relaxed_cones(&field));
    for (x, polar) in [(1.3, 0.0), (2.0, 45.0), (4.1, 70.0)] {
        let (ray, depth) = ray_on_slope(&surface, x, polar);
        let found = relaxed_cone_steps(&Relief::new(&surface), &cones).find(&ray, Start::TOP);
        // The longest step there is goes from the top to the bottom.
        assert_near(found.depth, depth, 1.0 / 8192.0);
        assert_eq!(found.fetches.heights, 12);
    }
}

#[test]
fn a_search_marches_back_out_of_a_start_inside_and_trusts_a_proven_one() {
    let field = slope();
    let (surface, mips, cones) = (surface(&field), mips(&field), steepest_cones(&field));
    let (relief, relaxed) = (Relief::new(&surface), steepest_relaxed_cones(&field));
    let searches: [&dyn ReliefSearch; 5] = [
        &LinearSearch::new(&relief, 40, 20),
        &ParallaxOcclusion::new(&relief, 40),
        &cone_steps(&relief, &cones),
        &relaxed_cone_steps(&relief, &relaxed),
        &traversal(&relief, &mips),
    ];
    let (ray, depth) = ray_on_slope(&surface, 2.0, 45.0);
    for search in searches {
        let name = search.name();
        for start in [0.1 * depth, 0.9 * depth, 1.2 * depth, 1.0] {
            let found = search.find(&ray, at(start, false));
            assert!((found.depth - depth).abs() < 1e-5, "{name} from {start}: {} instead of {depth}", found.depth);
        }
        let (unsure, proven) = (search.find(&ray, at(0.9 * depth, false)), search.find(&ray, at(0.9 * depth, true)));
        assert_eq!(unsure.fetches.heights, proven.fetches.heights + 1, "{name} looks whether it is inside");
        let top = search.find(&ray, Start::TOP);
        assert!(proven.fetches.total() <= top.fetches.total() + 1, "{name}: {proven:?} {top:?}");
    }
}

#[test]
fn along_the_normal_one_gather_is_the_whole_search() {
    let (_, field) = reliefs(16, 4.0, Edge::Wrap).into_iter().next().unwrap();
    let (surface, mips, cones) = (surface(&field), mips(&field), steepest_cones(&field));
    let relief = Relief::new(&surface);
    for ray in rays(&relief, 0.0, 50) {
        let (by_mips, by_cones) =
            (traversal(&relief, &mips).find(&ray, Start::TOP), cone_steps(&relief, &cones).find(&ray, Start::TOP));
        assert_eq!(by_mips.fetches, Fetches { heights: 1, tables: 0 });
        assert_eq!(by_cones.fetches, Fetches { heights: 1, tables: 1 });
        assert_near(gap(&relief, &ray, by_mips.depth), 0.0, 1e-14);
    }
}

#[test]
fn the_trace_counts_the_cells_it_walks() {
    let surface = surface(&field((8, 8), (1.0, 1.0), Edge::Wrap, |column, row| f32::from((column, row) == (0, 0))));
    let relief = Relief::new(&surface);
    // Along a row of the floor, from the middle of a cell to that of the fourth on.
    let ray = relief.ray(1.5, 4.5, towards(4_f64.atan().to_degrees(), 180.0)).unwrap();
    let found = TracedRelief::new(&relief).find(&ray, Start::TOP);
    assert_eq!((found.depth, found.fetches), (1.0, Fetches { heights: 5, tables: 0 }));
}
