// Normal curvature along a direction of the texture, from the fundamental forms of the surface:
//
//   κ = (e du² + 2f du dv + g dv²) / (E du² + 2F du dv + G dv²).
//
// The six numbers are vertex attributes, each interpolated by itself: the columns `first_form` (E, F, G) and `second_form` (e, f, g) of
// a curvature table. A column of halves comes as float16x4, whose fourth number is 0; the vertex stage multiplies it by the column's
// scale, a power of two. κ is in 1 / length, positive where the surface is convex; mirrored texture coordinates change nothing.

// The curvature along a direction of any length; the mean curvature where it has no length on the surface, 0 where the chart has no
// area.
fn barchan_curvature_along(first: vec3<f32>, second: vec3<f32>, direction: vec2<f32>) -> f32 {
    let larger = max(abs(direction.x), abs(direction.y));
    if !(larger > 0.0) {
        return barchan_mean_curvature(first, second);
    }
    // Squares of a direction as it comes may leave the range of f32.
    let step = direction / larger;
    let products = vec3<f32>(step.x * step.x, 2.0 * step.x * step.y, step.y * step.y);
    let length_squared = dot(first, products);
    if !(length_squared > 0.0) {
        return barchan_mean_curvature(first, second);
    }
    return dot(second, products) / length_squared;
}

// Half the sum of the principal curvatures.
fn barchan_mean_curvature(first: vec3<f32>, second: vec3<f32>) -> f32 {
    let area_squared = first.x * first.z - first.y * first.y;
    if !(area_squared > 0.0) {
        return 0.0;
    }
    return (second.x * first.z - 2.0 * second.y * first.y + second.z * first.x) / (2.0 * area_squared);
}
