// Steps of equal depth until one ends inside the relief, then bisection: the baseline.
//
// Fabio Policarpo, Manuel Oliveira, João Comba, Real-Time Relief Mapping on Arbitrary Polygonal Surfaces: whatever is thinner than a
// step may be stepped over. The hit is the middle of what bisection leaves.

fn barchan_relief_search(ray: BarchanReliefRay, start: BarchanStart) -> BarchanFound {
    let step = 1.0 / f32(BARCHAN_STEPS);
    let left = barchan_relief_leave(ray, start, step);
    var fetches = start.fetches + vec2<i32>(left.fetches, 0);
    var outside = left.outside;
    var inside = left.inside;
    if !left.is_within {
        // The floor is inside without a look.
        inside = 1.0;
        for (var k = 1; k <= BARCHAN_STEPS; k++) {
            let depth = left.outside + f32(k) * step;
            if depth >= 1.0 {
                break;
            }
            fetches.x++;
            if barchan_relief_sampled_gap(ray, depth) <= 0.0 {
                inside = depth;
                break;
            }
            outside = depth;
        }
    }
    return BarchanFound(barchan_relief_bisect(ray, outside, inside), fetches + vec2<i32>(BARCHAN_BISECTIONS, 0));
}
