// Lambert's law for the sun where the horizon map lets it through, an even sky everywhere.
@fragment
fn picture_fragment(@builtin(position) position: vec4<f32>) -> PicturePixel {
    let place = picture_place(position);
    let normal = barchan_surface_normal(place);
    let is_dark = barchan_horizon_in_shadow(place, picture_light.towards);
    let sun = select(max(dot(normal, picture_light.towards), 0.0), 0.0, is_dark);
    let sky = 0.5 + 0.5 * normal.z;
    let linear = picture_light.albedo * (picture_light.sun * sun + picture_light.sky * sky);
    return picture_seen(linear, vec2<i32>(0), is_dark, 0.0);
}
