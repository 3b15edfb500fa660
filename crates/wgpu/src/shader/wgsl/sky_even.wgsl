// A sky that is evenly bright: where no mean direction of what is seen of it is known.

// How bright the visible sky is: as bright as the zenith.
fn barchan_sky_brightness(place: vec2<f32>) -> f32 {
    return 1.0;
}
