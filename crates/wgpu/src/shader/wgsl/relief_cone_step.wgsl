// How far a ray can sink from a gap above the tip of a cone before it leaves the cone: r g / (s + r) for a cone of the ratio r and a ray
// that moves s along the plane per length down.
fn barchan_relief_cone_step(ray: BarchanReliefRay, gap: f32, ratio: f32) -> f32 {
    // Along the normal all of the gap is free, whatever the ratio.
    var part = 1.0;
    if ray.tangent > 0.0 {
        part = select(0.0, ratio / (ray.tangent + ratio), ratio > 0.0);
    }
    // A damaged table may hold anything; no gap is wider than the relief is thick.
    return select(0.0, min(gap * part, 1.0), gap > 0.0 && part > 0.0);
}
