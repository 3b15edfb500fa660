// The depth at which the ray of the eye meets the relief, and 1 where that point is in shadow.
@fragment
fn barchan_probe_relief_shadow(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let ray = barchan_relief_ray(barchan_probe_place(position), barchan_probe.eye);
    let depth = barchan_relief_find(ray).depth;
    let place = barchan_relief_at(ray, depth);
    let is_dark = barchan_relief_in_shadow(place, depth, barchan_probe.light, barchan_probe.tolerance);
    return vec4<f32>(depth, select(0.0, 1.0, is_dark), 0.0, 0.0);
}
