// An overcast sky alone.
@fragment
fn picture_fragment(@builtin(position) position: vec4<f32>) -> PicturePixel {
    let place = picture_place(position);
    let linear = picture_light.albedo * picture_light.sky * barchan_sky_irradiance(place);
    return picture_seen(linear, vec2<i32>(0), false, barchan_sky_visibility(place));
}
