// The points of a map for flat surfaces: one of each texel and azimuth, the paper's table.

fn barchan_points() -> i32 {
    return 1;
}

fn barchan_point(point: i32, texel: vec2<i32>, azimuth: i32) -> BarchanPoint {
    let elevation = barchan_horizon_before_transfer(texel, azimuth);
    return barchan_point_of(BARCHAN_HORIZON, elevation, barchan_distance_texel(texel, azimuth));
}
