// Shadows from a horizon map on a flat base surface.
//
// A place is in shadow iff the light stands below its horizon: Koiichi Onoue, Nelson Max, Tomoyuki Nishita, Bumpmap Shadows on
// Curved Surfaces. Elevations are interpolated within the layers of the two azimuths beside the light's, and between them.

// The elevation of the horizon in an azimuth, in radians.
fn barchan_horizon_elevation(place: vec2<f32>, azimuth: f32) -> f32 {
    let beside = barchan_neighbours(BARCHAN_HORIZON, azimuth);
    return mix(barchan_horizon_at(place, beside.first), barchan_horizon_at(place, beside.second), beside.weight);
}

// Whether the light stands below the horizon of a place. `towards` is a unit vector in the frame (u, v up the picture, height).
fn barchan_horizon_in_shadow(place: vec2<f32>, towards: vec3<f32>) -> bool {
    let horizon = barchan_sine_cosine(barchan_horizon_elevation(place, barchan_azimuth(towards.xy)));
    return towards.z * horizon.y < length(towards.xy) * horizon.x;
}
