// Relaxed cone stepping: steps until inside the relief, then bisection.
//
// A relaxed cone is the widest in which a ray meets the surface once at most, so that steps are longer and the last one goes into the
// relief: Fabio Policarpo, Manuel Oliveira, Relaxed Cone Stepping for Relief Mapping. Steps go on until one ends inside; one is at least
// 1/1024 of the thickness, so that they end. The hit is the middle of what bisection leaves.

const BARCHAN_LEAST_STEP: f32 = 0.0009765625;

fn barchan_relief_search(ray: BarchanReliefRay, start: BarchanStart) -> BarchanFound {
    let left = barchan_relief_leave(ray, start, BARCHAN_STEP_BACK);
    var fetches = start.fetches + vec2<i32>(left.fetches, 0);
    var outside = left.outside;
    var inside = left.inside;
    if !left.is_within {
        // The floor is inside without a look.
        inside = outside;
        for (var turn = 0; turn < BARCHAN_MOST_TURNS && inside < 1.0; turn++) {
            fetches.y++;
            let cone = barchan_relaxed_cone_map_at(barchan_relief_at(ray, inside), 0);
            let gap = cone.x - inside;
            if gap <= 0.0 {
                break;
            }
            outside = inside;
            inside += max(barchan_relief_cone_step(ray, gap, cone.y), BARCHAN_LEAST_STEP);
        }
        inside = min(inside, 1.0);
    }
    return BarchanFound(barchan_relief_bisect(ray, outside, inside), fetches + vec2<i32>(BARCHAN_BISECTIONS, 0));
}
