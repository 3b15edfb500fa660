// The visible share of the sky, the irradiance, and the bent normal along u and v.
@fragment
fn barchan_probe_sky(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = barchan_probe_place(position);
    return vec4<f32>(barchan_sky_visibility(place), barchan_sky_irradiance(place), barchan_sky_bent_normal(place).xy);
}
