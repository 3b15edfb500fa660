// The share of the light's disc that is seen.
@fragment
fn barchan_probe_penumbra(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = barchan_probe_place(position);
    let probe = barchan_probe;
    return vec4<f32>(
        barchan_penumbra_visibility(place, probe.light, probe.angular_radius, probe.level_distance), 0.0, 0.0, 0.0,
    );
}
