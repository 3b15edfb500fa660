// The elevation of the horizon towards the light, in radians, and 1 in shadow.
@fragment
fn barchan_probe_horizon(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = barchan_probe_place(position);
    let elevation = barchan_horizon_elevation(place, barchan_azimuth(barchan_probe.light.xy));
    let is_dark = barchan_horizon_in_shadow(place, barchan_probe.light);
    return vec4<f32>(elevation, select(0.0, 1.0, is_dark), 0.0, 0.0);
}
