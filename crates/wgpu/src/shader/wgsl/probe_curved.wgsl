// The elevation of the horizon towards the light, in radians, 1 in shadow, the curvature along the light, and its azimuth on the map.
// The light is in the axes of Pu and Pv, whose third is the normal.
@fragment
fn barchan_probe_curved(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = barchan_probe_place(position);
    let extent = barchan_tables[BARCHAN_HORIZON].extent * barchan_tables[BARCHAN_HORIZON].spacing;
    let normal = vec3<f32>(0.0, 0.0, 1.0);
    let light = barchan_tangent_light(barchan_probe.along_u, barchan_probe.along_v, normal, barchan_probe.light, extent);
    let curvature = barchan_curvature_along(barchan_probe.first_form, barchan_probe.second_form, light.direction);
    let elevation = barchan_curved_elevation(place, light, curvature);
    let is_dark = barchan_is_below(light, elevation);
    return vec4<f32>(elevation, select(0.0, 1.0, is_dark), curvature, light.azimuth);
}
