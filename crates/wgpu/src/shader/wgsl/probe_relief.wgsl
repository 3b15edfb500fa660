// The depth at which the ray of the eye meets the relief, −1 for a ray that is not valid; the fetches of heights and of tables; the
// depth of the start.
@fragment
fn barchan_probe_relief(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let ray = barchan_relief_ray(barchan_probe_place(position), barchan_probe.eye);
    if !ray.is_valid {
        return vec4<f32>(-1.0, 0.0, 0.0, 0.0);
    }
    let start = barchan_relief_start(ray);
    let found = barchan_relief_search(ray, start);
    return vec4<f32>(found.depth, vec2<f32>(found.fetches), start.depth);
}
