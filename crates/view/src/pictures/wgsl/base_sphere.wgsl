// A sphere round the origin, u its longitude from +x to +y and v its latitude.
fn picture_hit(origin: vec3<f32>, towards: vec3<f32>) -> PictureHit {
    // In radii. The eye is outside, so the hit is the one nearer to it.
    let start = origin / picture_view.radius;
    let along = dot(start, towards);
    let aside = start - towards * along;
    let inside = 1.0 - dot(aside, aside);
    let normal = aside + towards * sqrt(max(inside, 0.0));
    let from_axis = length(normal.xy);
    // A pole has the longitude 0.
    let east = select(vec2<f32>(0.0, 1.0), vec2<f32>(-normal.y, normal.x) / from_axis, from_axis > 0.0);
    let angles = vec2<f32>(barchan_azimuth(normal.xy), barchan_azimuth(vec2<f32>(from_axis, normal.z)));
    let along_u = vec3<f32>(east * from_axis, 0.0) * picture_view.tile.x;
    let along_v = vec3<f32>(-normal.z * east.y, normal.z * east.x, from_axis) * picture_view.tile.y;
    return PictureHit(angles * picture_view.radius / picture_view.tile, along_u, along_v, normal, inside >= 0.0);
}
