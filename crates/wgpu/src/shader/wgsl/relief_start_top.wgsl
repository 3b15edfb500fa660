// Rays start at the top plane: nothing is above it, and nothing is read.

fn barchan_relief_start(ray: BarchanReliefRay) -> BarchanStart {
    return BarchanStart(0.0, true, vec2<i32>(0));
}
