// The cone that stands for the visible sky: Christopher Oat, Pedro V. Sander, Ambient aperture lighting, 2007.

// The unit axis of the cone in the frame (u, v up the picture, height), and the cosine of its half-angle: 0 is a hemisphere, 1 no sky.
fn barchan_aperture_cone(place: vec2<f32>) -> vec4<f32> {
    let stored = barchan_aperture_cone_at(place, 0);
    let size = length(stored.xyz);
    // Opposite axes leave nothing half-way between them.
    let axis = select(vec3<f32>(0.0, 0.0, 1.0), stored.xyz / max(size, 1e-20), size > 1e-6);
    return vec4<f32>(axis, stored.w);
}
