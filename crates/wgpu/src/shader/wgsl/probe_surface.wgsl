// Height, and the normal.
@fragment
fn barchan_probe_surface(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = barchan_probe_place(position);
    return vec4<f32>(barchan_height_at(place, 0), barchan_surface_normal(place));
}
