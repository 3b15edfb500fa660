// What part of the sky is cut off: a shadow ray for each of some directions, weighed by the cosine to the normal. Takeshi Suzuki,
// An Accelerated Relief Mapping Using Depth Maps, section 4.2.

struct PictureDirection {
    // A unit vector in the frame of the relief.
    towards: vec3<f32>,
    unused_0: f32,
    // All the directions it stands for, integrated over their solid angle.
    integral: vec3<f32>,
    unused_1: f32,
}

@group(1) @binding(2) var<uniform> picture_directions: array<PictureDirection, PICTURE_DIRECTIONS>;

fn picture_occlusion(place: vec2<f32>, depth: f32, normal: vec3<f32>) -> f32 {
    var cut_off = 0.0;
    var whole = 0.0;
    for (var index = 0u; index < PICTURE_DIRECTIONS; index++) {
        let direction = picture_directions[index];
        let weight = dot(normal, direction.integral);
        if weight > 0.0 {
            whole += weight;
            if barchan_relief_in_shadow(place, depth, direction.towards, picture_view.tolerance) {
                cut_off += weight;
            }
        }
    }
    return select(0.0, cut_off / whole, whole > 0.0);
}
