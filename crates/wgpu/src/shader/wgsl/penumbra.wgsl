// Soft shadows of a disc light on a flat base surface, from horizon and distance maps, without a search for blockers.
//
// A disc of angular radius α about the elevation θ is cut by the horizon at the elevation ε along a chord; seen is the share
//
//   V = ½ + (t √(1 − t²) + asin t) / π,  t = clamp(tan(θ − ε) / tan α, −1, 1).
//
// What stands behind a light that is close by does not hide it. Of the eight taps, four texels in each of the two azimuths beside
// the light's, those count whose horizon is nearer than the light: with c the sum of their weights and ε the weighted mean of
// their elevations, V = 1 − c (1 − V(ε)). Distances jump from texel to texel, so then texels are loaded, never filtered. Nothing is
// behind a sun: its horizon is that of hard shadows, which are the limit α → 0.

// A disc no larger than this at the distance 1 is a point.
const BARCHAN_SMALLEST_DISC: f32 = 1e-6;

// The share of what blocks, 0 to 1, and the elevation of its horizon.
//
// A loop, and not a call for each texel: compilers inline calls, and eight copies take them long.
fn barchan_penumbra_horizon(place: vec2<f32>, azimuth: f32, level_distance: f32) -> vec2<f32> {
    let beside = barchan_neighbours(BARCHAN_HORIZON, azimuth);
    if level_distance > barchan_tables[BARCHAN_DISTANCE].greatest {
        let first = barchan_horizon_at(place, beside.first);
        return vec2<f32>(1.0, mix(first, barchan_horizon_at(place, beside.second), beside.weight));
    }
    let corner = floor(place);
    let part = place - corner;
    var coverage = 0.0;
    var elevation = 0.0;
    for (var tap = 0; tap < 8; tap++) {
        let is_second = tap > 3;
        let layer = select(beside.first, beside.second, is_second);
        let offset = vec2<i32>(tap & 1, (tap >> 1u) & 1);
        let texel = vec2<i32>(corner) + offset;
        if barchan_distance_texel(texel, layer) < level_distance {
            let weights = select(1.0 - part, part, offset == vec2<i32>(1));
            let weight = weights.x * weights.y * select(1.0 - beside.weight, beside.weight, is_second);
            coverage += weight;
            elevation += weight * barchan_horizon_texel(texel, layer);
        }
    }
    return vec2<f32>(coverage, elevation / max(coverage, 1e-6));
}

// How much of a disc is seen from a place, 0 to 1. `towards` is a unit vector to its centre in the frame (u, v up the picture, height),
// its angular radius is in radians, less than a right angle; `level_distance` is how far away it is along the base, for a sun any
// large number.
fn barchan_penumbra_visibility(place: vec2<f32>, towards: vec3<f32>, angular_radius: f32, level_distance: f32) -> f32 {
    let blocking = barchan_penumbra_horizon(place, barchan_azimuth(towards.xy), level_distance);
    let horizon = barchan_sine_cosine(blocking.y);
    let level = length(towards.xy);
    // The sine and the cosine of θ − ε; at a right angle and beyond, all of the disc is on one side.
    let rise = towards.z * horizon.y - level * horizon.x;
    let run = level * horizon.y + towards.z * horizon.x;
    let disc = barchan_sine_cosine(angular_radius);
    let radius = max(disc.x / disc.y, BARCHAN_SMALLEST_DISC);
    let t = clamp(rise / (max(run, BARCHAN_SMALLEST_DISC) * radius), -1.0, 1.0);
    let seen = 0.5 + (t * sqrt(1.0 - t * t) + barchan_arcsine(t)) * 0.31830989;
    return clamp(1.0 - blocking.x * (1.0 - seen), 0.0, 1.0);
}
