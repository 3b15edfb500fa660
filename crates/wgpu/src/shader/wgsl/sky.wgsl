// The light of an overcast sky on a place that sees a part of it.
//
// Such a sky is three times as bright at the zenith as at the horizon: L(θ) = L₀ (1 + 2 sin θ) / 3 at the elevation θ, Parry Moon,
// Domina Spencer, Illumination from a nonuniform sky, 1942. Its irradiance is π times the visible share of the sky times its mean
// brightness there, which is taken in the mean direction of the visible sky.

// The visible share of the sky, weighted by the cosine to the surface normal: 0 to 1.
fn barchan_sky_visibility(place: vec2<f32>) -> f32 {
    return barchan_sky_visibility_at(place, 0);
}

// The irradiance over that of a level place in the open under a sky as bright as the zenith: 0 to 1.
fn barchan_sky_irradiance(place: vec2<f32>) -> f32 {
    return barchan_sky_visibility(place) * barchan_sky_brightness(place);
}
