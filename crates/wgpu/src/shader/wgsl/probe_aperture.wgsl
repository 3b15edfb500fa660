// The cone of the visible sky: axis, and cosine of the half-angle.
@fragment
fn barchan_probe_aperture(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return barchan_aperture_cone(barchan_probe_place(position));
}
