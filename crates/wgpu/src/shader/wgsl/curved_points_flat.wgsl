// A map for flat surfaces has one point of each texel and azimuth, the paper's table, and no further ones.

fn barchan_further_slope(ground: BarchanGround, texel: vec2<i32>, height: f32, azimuth: i32) -> f32 {
    return BARCHAN_NO_HORIZON;
}
