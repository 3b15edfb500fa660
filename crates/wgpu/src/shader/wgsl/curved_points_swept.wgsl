// The points of a map that is swept over a range of curvatures: first the flat surface's, then as many candidates as are loaded. The
// candidates must be loaded for the azimuths of the horizon.

// A map has at most 8 points.
fn barchan_points() -> i32 {
    let elevations = barchan_tables[BARCHAN_SWEPT_HORIZON].candidates;
    let distances = barchan_tables[BARCHAN_SWEPT_DISTANCE].candidates;
    return 1 + i32(min(min(elevations, distances), 7u));
}

fn barchan_point(point: i32, texel: vec2<i32>, azimuth: i32) -> BarchanPoint {
    if point == 0 {
        let elevation = barchan_horizon_before_transfer(texel, azimuth);
        return barchan_point_of(BARCHAN_HORIZON, elevation, barchan_distance_texel(texel, azimuth));
    }
    let layer = (point - 1) * i32(barchan_tables[BARCHAN_SWEPT_HORIZON].azimuths) + azimuth;
    let elevation = barchan_swept_horizon_before_transfer(texel, layer);
    return barchan_point_of(BARCHAN_SWEPT_HORIZON, elevation, barchan_swept_distance_texel(texel, layer));
}
