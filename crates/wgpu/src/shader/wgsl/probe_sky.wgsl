// The visible share of an even sky, and the irradiance.
@fragment
fn barchan_probe_sky(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = barchan_probe_place(position);
    return vec4<f32>(barchan_sky_visibility(place), barchan_sky_irradiance(place), 0.0, 0.0);
}
