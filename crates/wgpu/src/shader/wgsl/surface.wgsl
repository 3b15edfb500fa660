// The surface of a height table.

// The unit normal at a place, in the frame (u, v up the picture, height), smoothed over one texel to each side.
fn barchan_surface_normal(place: vec2<f32>) -> vec3<f32> {
    let slopes = barchan_surface_slopes(place);
    return normalize(vec3<f32>(-slopes, 1.0));
}

// How steeply heights rise along u and v.
fn barchan_surface_slopes(place: vec2<f32>) -> vec2<f32> {
    let right = barchan_height_at(place + vec2<f32>(1.0, 0.0), 0);
    let left = barchan_height_at(place - vec2<f32>(1.0, 0.0), 0);
    // v points up the picture, rows are counted downwards.
    let above = barchan_height_at(place - vec2<f32>(0.0, 1.0), 0);
    let below = barchan_height_at(place + vec2<f32>(0.0, 1.0), 0);
    return vec2<f32>(right - left, above - below) / (2.0 * barchan_tables[BARCHAN_HEIGHT].spacing);
}
