// Steps of equal depth until one ends inside the relief, then one secant.
//
// Natalya Tatarchuk, Dynamic Parallax Occlusion Mapping with Approximate Soft Shadows: the surface between the last two steps is taken
// for a line. It misses what a linear search misses, and its hit is off where the surface is not a line.

fn barchan_relief_search(ray: BarchanReliefRay, start: BarchanStart) -> BarchanFound {
    let step = 1.0 / f32(BARCHAN_STEPS);
    let left = barchan_relief_leave(ray, start, step);
    var fetches = start.fetches + vec2<i32>(left.fetches + 1, 0);
    var before = left.outside;
    var gap = barchan_relief_sampled_gap(ray, before);
    for (var k = 1; k <= BARCHAN_STEPS + 1; k++) {
        if gap <= 0.0 || before >= 1.0 {
            break;
        }
        let here = min(left.outside + f32(k) * step, 1.0);
        let after = barchan_relief_sampled_gap(ray, here);
        fetches.x++;
        if after <= 0.0 {
            return BarchanFound(before + (here - before) * gap / (gap - after), fetches);
        }
        before = here;
        gap = after;
    }
    return BarchanFound(before, fetches);
}
