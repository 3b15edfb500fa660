// Shadows of relief on a curved surface, convex or concave, from baked points.
//
// Koiichi Onoue, Nelson Max, Tomoyuki Nishita, Bumpmap Shadows on Curved Surfaces: the full form before eq 2, made exact, and eq 3 with
// its sign mended. Along the light the base surface is a circle of curvature κ through the texel, positive where convex. A stored point
// of slope δ at the distance d, seen from the height h over that circle, with γ = κd and sinc x = sin x / x, stands at the slope
//
//   δ′ = [δ cos γ − (1 + κh) · sin(γ/2) · sinc(γ/2)] / [(1 + κh + γδ) · sinc γ].
//
// The horizon is the highest of a texel's points, and no lower than the smooth surface through the lowest relief. Distances jump from
// texel to texel, so texels are always loaded, never filtered: each of the four around a place, in each of the two azimuths beside the
// light's, carries its own points over, and the elevation of what comes out is interpolated.
//
// Where the CPU twin has δ, here sine and cosine of the elevation stand above and below the fraction's line: a table of sines needs no
// tangent, and a wall no infinity. No number is divided by κ or d. What f32 cannot mend is a texel near the centre of a hollow: 1 + κh
// has the rounding of κh, and elevations that over 1 + κh.
//
// Lengths are those of the surface, in the unit of the tables; κ in its inverse; angles in radians.

// A point of the relief along an azimuth, as a texel of a flat base sees it: its elevation, and its distance on the map.
struct BarchanPoint {
    sine: f32,
    cosine: f32,
    distance: f32,
}

// The base surface along the light: its curvature, the stretch of the texture, the least height of relief, and the curvature of the
// parallel surface at that height, 0 where it hides nothing.
struct BarchanGround {
    curvature: f32,
    stretch: f32,
    lowest: f32,
    floor_curvature: f32,
}

// Below and above every other slope: what darkens nothing, and what shuts out all light.
const BARCHAN_NO_HORIZON: f32 = -3.4e38;
const BARCHAN_CLOSED: f32 = 3.4e38;

// The greatest elevation a table holds, a hair below the zenith, and its cosine.
const BARCHAN_GREATEST_ELEVATION: f32 = 1.57079625;
const BARCHAN_LEAST_COSINE: f32 = 7.549789e-8;

// A point from what a table stores before its transfer, a sine or an angle.
fn barchan_point_of(table: u32, stored: f32, distance: f32) -> BarchanPoint {
    if barchan_tables[table].transfer == 1u {
        let sine = clamp(stored, -1.0, 1.0);
        return BarchanPoint(sine, max(sqrt((1.0 - sine) * (1.0 + sine)), BARCHAN_LEAST_COSINE), distance);
    }
    let elevation = barchan_sine_cosine(clamp(stored, -BARCHAN_GREATEST_ELEVATION, BARCHAN_GREATEST_ELEVATION));
    return BarchanPoint(elevation.x, max(elevation.y, BARCHAN_LEAST_COSINE), distance);
}

fn barchan_ground(curvature: f32, stretch: f32, lowest: f32) -> BarchanGround {
    let widened = 1.0 + curvature * lowest;
    if !(curvature * widened > 0.0) {
        return BarchanGround(curvature, stretch, lowest, 0.0);
    }
    return BarchanGround(curvature, stretch, lowest, min(curvature / widened, 1e30));
}

// The slope of a point on the curved surface.
fn barchan_carried_slope(ground: BarchanGround, point: BarchanPoint, height: f32) -> f32 {
    let angle = ground.curvature * (ground.stretch * point.distance);
    let raised = 1.0 + ground.curvature * height;
    // A quarter round a ball it is out of sight, half round a hollow it is behind; at the centre heights have lost their meaning.
    if !(angle < 1.5707963 && angle > -3.1415925 && raised > 0.0) {
        return BARCHAN_NO_HORIZON;
    }
    // On the surface, lengths of the map are longer and heights are the same.
    let run = point.cosine * ground.stretch;
    let widened = run * raised + angle * point.sine;
    if !(widened > 0.0) {
        // Relief that reaches the centre: a shaft on a ball, a roof in a hollow.
        return select(BARCHAN_CLOSED, BARCHAN_NO_HORIZON, ground.curvature > 0.0);
    }
    let half = barchan_sine_cosine(0.5 * angle);
    let half_sinc = barchan_sinc(0.5 * angle, half.x);
    let rise = point.sine * (1.0 - 2.0 * half.x * half.x) - run * raised * half.x * half_sinc;
    return clamp(rise / (widened * half_sinc * half.y), BARCHAN_NO_HORIZON, BARCHAN_CLOSED);
}

// sin x / x of any x whose sine is given.
fn barchan_sinc(x: f32, sine: f32) -> f32 {
    // The next term of the series, x⁴/120, is below rounding.
    if abs(x) < 0.04 {
        return 1.0 - x * x / 6.0;
    }
    return sine / x;
}

// The slope of the smooth surface's own horizon.
fn barchan_smooth_slope(ground: BarchanGround, height: f32) -> f32 {
    if ground.floor_curvature <= 0.0 {
        return BARCHAN_NO_HORIZON;
    }
    let raised = max(ground.floor_curvature * (height - ground.lowest), 0.0);
    return -sqrt(raised * (2.0 + raised));
}

// The elevation of a texel's horizon in one azimuth.
fn barchan_curved_towards(ground: BarchanGround, texel: vec2<i32>, height: f32, azimuth: i32) -> f32 {
    let elevation = barchan_horizon_before_transfer(texel, azimuth);
    let point = barchan_point_of(BARCHAN_HORIZON, elevation, barchan_distance_texel(texel, azimuth));
    let slope = max(barchan_smooth_slope(ground, height), barchan_carried_slope(ground, point, height));
    return barchan_arctangent(max(slope, barchan_further_slope(ground, texel, height, azimuth)));
}

// The elevation of a texel's horizon between two azimuths.
fn barchan_curved_texel(ground: BarchanGround, texel: vec2<i32>, beside: BarchanNeighbours) -> f32 {
    let height = barchan_height_texel(texel, 0);
    var elevation = 0.0;
    for (var side = 0; side < 2; side++) {
        let weight = select(1.0 - beside.weight, beside.weight, side == 1);
        if weight != 0.0 {
            let azimuth = select(beside.first, beside.second, side == 1);
            elevation += weight * barchan_curved_towards(ground, texel, height, azimuth);
        }
    }
    return elevation;
}

// The elevation of the horizon towards a light above the tangent plane of a place; `curvature` is that of the base along the light.
//
// Loops, and not a call for each texel: compilers inline calls, and eight copies take them minutes.
fn barchan_curved_elevation(place: vec2<f32>, light: BarchanTangentLight, curvature: f32) -> f32 {
    let ground = barchan_ground(curvature, light.stretch, barchan_tables[BARCHAN_HEIGHT].least);
    let beside = barchan_neighbours(BARCHAN_HORIZON, light.azimuth);
    let corner = floor(place);
    let part = place - corner;
    var elevation = 0.0;
    for (var tap = 0; tap < 4; tap++) {
        let offset = vec2<i32>(tap & 1, tap >> 1u);
        let weights = select(1.0 - part, part, offset == vec2<i32>(1));
        elevation += weights.x * weights.y * barchan_curved_texel(ground, vec2<i32>(corner) + offset, beside);
    }
    return clamp(elevation, -BARCHAN_GREATEST_ELEVATION, BARCHAN_GREATEST_ELEVATION);
}

// Whether a light stands below a horizon: L′z < δ′ · |L′xy|. Light from below the tangent plane is not cut off: a bump behind the
// terminator whose horizon is lower still is lit. At the zenith it always is; straight from below, never.
fn barchan_is_below(light: BarchanTangentLight, elevation: f32) -> bool {
    let horizon = barchan_sine_cosine(elevation);
    return light.height * horizon.y < light.level * horizon.x;
}

// Whether a place is in shadow.
fn barchan_curved_in_shadow(place: vec2<f32>, light: BarchanTangentLight, curvature: f32) -> bool {
    return barchan_is_below(light, barchan_curved_elevation(place, light, curvature));
}
