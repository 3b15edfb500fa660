// Heights along a ray, one sample each, and the bisection that ends the searches that step until they are inside.

// How far the surface is below a ray, by one sample: negative inside the relief.
fn barchan_relief_sampled_gap(ray: BarchanReliefRay, depth: f32) -> f32 {
    return barchan_relief_depth(barchan_height_at(barchan_relief_at(ray, depth), 0)) - depth;
}

// The middle of what is left after halving a part of a ray that goes from outside to inside; one fetch of a height a halving.
fn barchan_relief_bisect(ray: BarchanReliefRay, before: f32, behind: f32) -> f32 {
    var outside = before;
    var inside = behind;
    for (var k = 0; k < BARCHAN_BISECTIONS; k++) {
        let middle = 0.5 * (outside + inside);
        if barchan_relief_sampled_gap(ray, middle) > 0.0 {
            outside = middle;
        } else {
            inside = middle;
        }
    }
    return 0.5 * (outside + inside);
}
