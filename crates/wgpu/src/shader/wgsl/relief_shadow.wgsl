// Shadows of relief by the search that finds it: the light is an eye, and what it does not see is dark.
//
// From a point of the relief one goes up along the light to the top plane, and a relief ray comes down again. If it meets the relief
// before the point, something stands in the light: Takeshi Suzuki, An Accelerated Relief Mapping Using Depth Maps, section 4.1. Where a
// conservative depth map starts the ray at the point or beyond, the point is lit without a search.

// Whether a point at a depth below a place is in the shadow of a light from `towards`. Relief must stand before the point by more than
// `tolerance`, a part of its whole depth, to shade it: the ray comes down through the point itself, which rounding puts on either side.
// A light on the horizon or below reaches nothing, nor one so near to it that its ray is given up.
fn barchan_relief_in_shadow(place: vec2<f32>, depth: f32, towards: vec3<f32>, tolerance: f32) -> bool {
    let ray = barchan_relief_ray_through(place, depth, towards);
    if !ray.is_valid {
        return true;
    }
    let clear = depth - tolerance;
    let start = barchan_relief_start(ray);
    if start.is_proven && start.depth >= clear {
        return false;
    }
    return barchan_relief_search(ray, start).depth < clear;
}
