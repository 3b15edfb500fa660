// A map that is swept over a range of curvatures has further points of each texel and azimuth, as many candidates as are loaded. These
// must be loaded for the azimuths of the horizon.

// The slope of the highest of them on the curved surface.
fn barchan_further_slope(ground: BarchanGround, texel: vec2<i32>, height: f32, azimuth: i32) -> f32 {
    let elevations = barchan_tables[BARCHAN_SWEPT_HORIZON].candidates;
    let distances = barchan_tables[BARCHAN_SWEPT_DISTANCE].candidates;
    // A map has at most 8 points, the flat surface's among them.
    let candidates = i32(min(min(elevations, distances), 7u));
    var slope = BARCHAN_NO_HORIZON;
    for (var candidate = 0; candidate < candidates; candidate++) {
        let layer = candidate * i32(barchan_tables[BARCHAN_SWEPT_HORIZON].azimuths) + azimuth;
        let elevation = barchan_swept_horizon_before_transfer(texel, layer);
        let point = barchan_point_of(BARCHAN_SWEPT_HORIZON, elevation, barchan_swept_distance_texel(texel, layer));
        slope = max(slope, barchan_carried_slope(ground, point, height));
    }
    return slope;
}
