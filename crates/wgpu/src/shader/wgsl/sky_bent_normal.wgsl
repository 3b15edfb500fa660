// The mean direction of the visible sky: Hayden Landis, Production-ready global illumination, 2002.

// The bent normal, a unit vector in the frame (u, v up the picture, height). Components along u and v are stored.
fn barchan_sky_bent_normal(place: vec2<f32>) -> vec3<f32> {
    let level = barchan_bent_normal_at(place, 0);
    return vec3<f32>(level, sqrt(max(1.0 - dot(level, level), 0.0)));
}

// How bright an overcast sky is there, over the zenith: a third at the horizon.
fn barchan_sky_brightness(place: vec2<f32>) -> f32 {
    return (1.0 + 2.0 * barchan_sky_bent_normal(place).z) / 3.0;
}
