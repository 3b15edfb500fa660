// Functions of angles to a few ulp: of those built in, Vulkan promises 2⁻¹¹ for sines and 4096 ulp for arcs.
//
// Polynomials: Stephen Moshier, Cephes mathematical library, 1989.

// The angle of a sine. The arc of 1 is the f32 just below π/2, the greatest elevation of the format: that just above has a negative
// cosine, and would shade the zenith.
fn barchan_arcsine(sine: f32) -> f32 {
    let size = min(abs(sine), 1.0);
    // Beyond ½ the half-angle: asin s = π/2 − 2 asin √((1 − s) / 2).
    let is_steep = size > 0.5;
    let square = select(size * size, 0.5 * (1.0 - size), is_steep);
    let root = select(size, sqrt(square), is_steep);
    let series = ((((4.2163199048e-2 * square + 2.4181311049e-2) * square + 4.5470025998e-2) * square
        + 7.4953002686e-2) * square + 1.6666752422e-1) * square * root + root;
    let angle = select(series, 1.5707962513 - 2.0 * series, is_steep);
    return select(angle, -angle, sine < 0.0);
}

// The azimuth of a direction, in radians: 0 along +u, counter-clockwise.
fn barchan_azimuth(direction: vec2<f32>) -> f32 {
    let size = abs(direction);
    let larger = max(size.x, size.y);
    if !(larger > 0.0) {
        return 0.0;
    }
    let sine = min(size.x, size.y) / larger;
    let octant = barchan_arctangent(sine);
    let quadrant = select(octant, 1.5707963268 - octant, size.y > size.x);
    let half = select(quadrant, 3.1415926536 - quadrant, direction.x < 0.0);
    return select(half, -half, direction.y < 0.0);
}

// The angle of a tangent, within ±π/2.
fn barchan_arctangent(tangent: f32) -> f32 {
    let size = abs(tangent);
    var start = 0.0;
    var part = size;
    if size > 2.414213562 {
        start = 1.5707963268;
        part = -1.0 / size;
    } else if size > 0.4142135624 {
        start = 0.7853981634;
        part = (size - 1.0) / (size + 1.0);
    }
    let square = part * part;
    let angle = start + ((((8.05374449538e-2 * square - 1.38776856032e-1) * square + 1.99777106478e-1) * square
        - 3.33329491539e-1) * square * part + part);
    return select(angle, -angle, tangent < 0.0);
}

// The sine and the cosine of an angle within ±π.
fn barchan_sine_cosine(angle: f32) -> vec2<f32> {
    // To the nearest quarter turn, whose digits are taken off in three parts.
    let quarter = round(angle * 0.6366197724);
    let rest = ((angle - quarter * 1.5703125) - quarter * 4.837512969970703e-4) - quarter * 7.549789948768648e-8;
    let square = rest * rest;
    let sine = ((-1.9515295891e-4 * square + 8.3321608736e-3) * square - 1.6666654611e-1) * square * rest + rest;
    let cosine = ((2.443315711809948e-5 * square - 1.388731625493765e-3) * square + 4.166664568298827e-2) * square * square
        - 0.5 * square + 1.0;
    let turned = i32(quarter) & 3;
    let swapped = select(vec2<f32>(sine, cosine), vec2<f32>(cosine, sine), (turned & 1) != 0);
    return vec2<f32>(
        select(swapped.x, -swapped.x, turned >= 2),
        select(swapped.y, -swapped.y, turned == 1 || turned == 2),
    );
}

// What an asset's tables are, and what all of them share.

// The numbers of a table; 96 bytes.
struct BarchanTable {
    // Texels along u and v.
    extent: vec2<f32>,
    // Length per texel along u and v.
    spacing: vec2<f32>,
    // A value is the transfer of scale · stored + bias.
    scale: f32,
    bias: f32,
    // 0: none, 1: the arcsine, 2: the square.
    transfer: u32,
    // Bit 0: it repeats along u, bit 1: along v. Otherwise the outermost texel goes on.
    edges: u32,
    // The azimuth of layer 0, in radians counter-clockwise from +u, and from one to the next.
    first_azimuth: f32,
    azimuth_step: f32,
    azimuths: u32,
    // 1 where the last azimuth is followed by the first.
    is_circle: u32,
    // Layers per azimuth of a swept table, and of a hemisphere table.
    candidates: u32,
    rings: u32,
    // 1: rings of equal angles, 2: of squared tangents.
    ring_spacing: u32,
    // 1: depths of the nearest ray, 2: conservative.
    depth_mode: u32,
    // The tangent of the polar angle at which the last ring ends, and the angle.
    max_tangent: f32,
    max_polar: f32,
    // The height of depth 0, and from there down to depth 1.
    relief_top: f32,
    relief_thickness: f32,
    // The level of the table that is the texture's finest, and how many there are from there.
    first_level: u32,
    levels: u32,
    // The least and the greatest value.
    least: f32,
    greatest: f32,
}

@group(0) @binding(0) var<uniform> barchan_tables: array<BarchanTable, 12>;

// The texel of a level that stands for a place inside or beyond the edges.
fn barchan_inside(table: u32, place: vec2<i32>, level: i32) -> vec2<i32> {
    let first = barchan_tables[table].first_level;
    let whole = vec2<i32>(barchan_tables[table].extent);
    let extent = max(whole >> vec2<u32>(first + u32(level)), vec2<i32>(1));
    let edges = barchan_tables[table].edges;
    let repeated = ((place % extent) + extent) % extent;
    let clamped = clamp(place, vec2<i32>(0), extent - 1);
    return barchan_chosen(clamped, repeated, vec2<bool>((edges & 1u) != 0u, (edges & 2u) != 0u));
}

// `select` of whole numbers, number by number, which GLSL ES 3 does not have.
fn barchan_chosen(other: vec2<i32>, chosen: vec2<i32>, is_chosen: vec2<bool>) -> vec2<i32> {
    return vec2<i32>(select(other.x, chosen.x, is_chosen.x), select(other.y, chosen.y, is_chosen.y));
}

fn barchan_scaled(table: u32, stored: f32) -> f32 {
    return barchan_tables[table].scale * stored + barchan_tables[table].bias;
}

fn barchan_scaled_2(table: u32, stored: vec2<f32>) -> vec2<f32> {
    return barchan_tables[table].scale * stored + barchan_tables[table].bias;
}

fn barchan_scaled_4(table: u32, stored: vec4<f32>) -> vec4<f32> {
    return barchan_tables[table].scale * stored + barchan_tables[table].bias;
}

fn barchan_scaled_cone(table: u32, stored: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(stored.x, barchan_scaled(table, stored.y));
}

fn barchan_transferred(table: u32, number: f32) -> f32 {
    switch barchan_tables[table].transfer {
        case 1u: { return barchan_arcsine(number); }
        case 2u: { return number * number; }
        default: { return number; }
    }
}

fn barchan_transferred_2(table: u32, number: vec2<f32>) -> vec2<f32> {
    return number;
}

fn barchan_transferred_4(table: u32, number: vec4<f32>) -> vec4<f32> {
    return number;
}

fn barchan_transferred_cone(table: u32, number: vec2<f32>) -> vec2<f32> {
    return vec2<f32>(number.x, barchan_transferred(table, number.y));
}

@group(0) @binding(2) var barchan_height_texels: texture_2d<f32>;

const BARCHAN_HEIGHT: u32 = 0u;

fn barchan_height_before_transfer(place: vec2<i32>, layer: i32) -> f32 {
    let texel = barchan_inside(BARCHAN_HEIGHT, place, 0);
    return barchan_scaled(BARCHAN_HEIGHT, textureLoad(barchan_height_texels, texel, layer).x);
}

fn barchan_height_texel(place: vec2<i32>, layer: i32) -> f32 {
    return barchan_transferred(BARCHAN_HEIGHT, barchan_height_before_transfer(place, layer));
}

@group(0) @binding(3) var barchan_horizon_texels: texture_2d_array<f32>;

const BARCHAN_HORIZON: u32 = 1u;

fn barchan_horizon_before_transfer(place: vec2<i32>, layer: i32) -> f32 {
    let texel = barchan_inside(BARCHAN_HORIZON, place, 0);
    return barchan_scaled(BARCHAN_HORIZON, textureLoad(barchan_horizon_texels, texel, layer, 0).x);
}

fn barchan_horizon_texel(place: vec2<i32>, layer: i32) -> f32 {
    return barchan_transferred(BARCHAN_HORIZON, barchan_horizon_before_transfer(place, layer));
}

@group(0) @binding(4) var barchan_distance_texels: texture_2d_array<f32>;

const BARCHAN_DISTANCE: u32 = 2u;

fn barchan_distance_before_transfer(place: vec2<i32>, layer: i32) -> f32 {
    let texel = barchan_inside(BARCHAN_DISTANCE, place, 0);
    return barchan_scaled(BARCHAN_DISTANCE, textureLoad(barchan_distance_texels, texel, layer, 0).x);
}

fn barchan_distance_texel(place: vec2<i32>, layer: i32) -> f32 {
    return barchan_transferred(BARCHAN_DISTANCE, barchan_distance_before_transfer(place, layer));
}

// The two azimuths of a table beside an azimuth, and how far the second one counts.
//
// On a full circle the last is followed by the first; beyond an arc its nearer end stands alone.

struct BarchanNeighbours {
    first: i32,
    second: i32,
    weight: f32,
}

const BARCHAN_TURN: f32 = 6.283185307;

fn barchan_neighbours(table: u32, azimuth: f32) -> BarchanNeighbours {
    let count = i32(barchan_tables[table].azimuths);
    let step = barchan_tables[table].azimuth_step;
    let turns = (azimuth - barchan_tables[table].first_azimuth) / BARCHAN_TURN;
    let offset = (turns - floor(turns)) * BARCHAN_TURN;
    if count <= 1 || step <= 0.0 {
        return BarchanNeighbours(0, 0, 0.0);
    }
    let position = offset / step;
    let index = floor(position);
    let weight = position - index;
    if barchan_tables[table].is_circle != 0u {
        let first = i32(index) % count;
        return BarchanNeighbours(first, (first + 1) % count, weight);
    }
    let last = count - 1;
    let span = f32(last) * step;
    if offset < span {
        let first = min(i32(index), last - 1);
        return BarchanNeighbours(first, first + 1, min(position - f32(first), 1.0));
    }
    let end = select(last, 0, BARCHAN_TURN - offset <= offset - span);
    return BarchanNeighbours(end, end, 0.0);
}

// The light, and the normal of relief, in the tangent frame of a textured surface.
//
// Koiichi Onoue, Nelson Max, Tomoyuki Nishita, Bumpmap Shadows on Curved Surfaces; James Blinn, Simulation of Wrinkled Surfaces, 1978.
//
// `along_u` and `along_v` are Pu and Pv: length along the surface per unit of texture coordinate, v up the picture, which may be
// stretched, sheared and mirrored; lengths of 1e-9 to 1e9. `normal` is the unit normal of the geometry, whatever way Pu × Pv points.
// All vectors are in the same axes, those of the world or of the object.
//
// The CPU twin solves by E, F and G. EG − F² loses twice as many digits in a sheared chart as Pu × Pv does, of which it is the square.

// A light, as relief at one point of a surface sees it.
struct BarchanTangentLight {
    // The sine of its elevation above the tangent plane, negative behind the terminator, and the cosine.
    height: f32,
    level: f32,
    // The direction it comes from in texture coordinates, of any length: what curvature is asked for along.
    direction: vec2<f32>,
    // The same on the map's grid, in radians: 0 along +u, counter-clockwise with v up the picture.
    azimuth: f32,
    // Length on the surface per length of the map's grid, along the direction.
    stretch: f32,
}

// The gradients of u and v on the surface.
struct BarchanGradients {
    of_u: vec3<f32>,
    of_v: vec3<f32>,
}

// Null where the chart has no area.
fn barchan_gradients(along_u: vec3<f32>, along_v: vec3<f32>) -> BarchanGradients {
    let area = cross(along_u, along_v);
    let area_squared = dot(area, area);
    if !(area_squared > 0.0) {
        return BarchanGradients(vec3<f32>(0.0), vec3<f32>(0.0));
    }
    return BarchanGradients(cross(along_v, area) / area_squared, cross(area, along_u) / area_squared);
}

// The step in the texture whose image on the surface is the vector's projection to the tangent plane.
fn barchan_texture_step(along_u: vec3<f32>, along_v: vec3<f32>, vector: vec3<f32>) -> vec2<f32> {
    let gradients = barchan_gradients(along_u, along_v);
    return vec2<f32>(dot(vector, gradients.of_u), dot(vector, gradients.of_v));
}

// The unit normal of relief whose height grows by `per_uv` per unit of u and of v. It takes the surface as flat over the height of the
// relief.
fn barchan_bump_normal(along_u: vec3<f32>, along_v: vec3<f32>, normal: vec3<f32>, per_uv: vec2<f32>) -> vec3<f32> {
    let gradients = barchan_gradients(along_u, along_v);
    return normalize(normal - per_uv.x * gradients.of_u - per_uv.y * gradients.of_v);
}

// `towards` is a unit vector from the surface towards the light, `extent` how long the map's own grid is along one unit of u and of v:
// its texels times their spacing. A light at the zenith has azimuth 0 and stretch 1.
fn barchan_tangent_light(
    along_u: vec3<f32>,
    along_v: vec3<f32>,
    normal: vec3<f32>,
    towards: vec3<f32>,
    extent: vec2<f32>,
) -> BarchanTangentLight {
    let height = dot(towards, normal);
    let tangent = towards - normal * height;
    let level = length(tangent);
    let direction = barchan_texture_step(along_u, along_v, tangent);
    let on_grid = direction * extent;
    let grid_length = length(on_grid);
    if !(level > 0.0 && grid_length > 0.0) {
        return BarchanTangentLight(height, level, direction, 0.0, 1.0);
    }
    return BarchanTangentLight(height, level, direction, barchan_azimuth(on_grid), level / grid_length);
}

// Normal curvature along a direction of the texture, from the fundamental forms of the surface:
//
//   κ = (e du² + 2f du dv + g dv²) / (E du² + 2F du dv + G dv²).
//
// The six numbers are vertex attributes, each interpolated by itself: the columns `first_form` (E, F, G) and `second_form` (e, f, g) of
// a curvature table. A column of halves comes as float16x4, whose fourth number is 0; the vertex stage multiplies it by the column's
// scale, a power of two. κ is in 1 / length, positive where the surface is convex; mirrored texture coordinates change nothing.

// The curvature along a direction of any length; the mean curvature where it has no length on the surface, 0 where the chart has no
// area.
fn barchan_curvature_along(first: vec3<f32>, second: vec3<f32>, direction: vec2<f32>) -> f32 {
    let larger = max(abs(direction.x), abs(direction.y));
    if !(larger > 0.0) {
        return barchan_mean_curvature(first, second);
    }
    // Squares of a direction as it comes may leave the range of f32.
    let step = direction / larger;
    let products = vec3<f32>(step.x * step.x, 2.0 * step.x * step.y, step.y * step.y);
    let length_squared = dot(first, products);
    if !(length_squared > 0.0) {
        return barchan_mean_curvature(first, second);
    }
    return dot(second, products) / length_squared;
}

// Half the sum of the principal curvatures.
fn barchan_mean_curvature(first: vec3<f32>, second: vec3<f32>) -> f32 {
    let area_squared = first.x * first.z - first.y * first.y;
    if !(area_squared > 0.0) {
        return 0.0;
    }
    return (second.x * first.z - 2.0 * second.y * first.y + second.z * first.x) / (2.0 * area_squared);
}

// A map for flat surfaces has one point of each texel and azimuth, the paper's table, and no further ones.

fn barchan_further_slope(ground: BarchanGround, texel: vec2<i32>, height: f32, azimuth: i32) -> f32 {
    return BARCHAN_NO_HORIZON;
}

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

// Probes draw the numbers of a technique: one place a pixel, for tests, benches and first light.

struct BarchanProbe {
    // The place of the first pixel's centre, in texels, and from a pixel to the next, columns and rows.
    place: vec2<f32>,
    step: vec2<f32>,
    // A unit vector towards the light in the frame of the table, and the angular radius of its disc in radians.
    light: vec3<f32>,
    angular_radius: f32,
    // A unit vector towards the eye in the frame of the table, and how far away the light is along the base plane.
    eye: vec3<f32>,
    level_distance: f32,
    // The first fundamental form of the base, and the part of the relief's depth that shadows tolerate.
    first_form: vec3<f32>,
    tolerance: f32,
    // Its second.
    second_form: vec3<f32>,
    unused_0: f32,
    // Pu and Pv in the space of the light, whose third axis is the normal.
    along_u: vec3<f32>,
    unused_1: f32,
    along_v: vec3<f32>,
    unused_2: f32,
}

@group(0) @binding(14) var<uniform> barchan_probe: BarchanProbe;

// One triangle over all of the target.
@vertex
fn barchan_probe_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

fn barchan_probe_place(position: vec4<f32>) -> vec2<f32> {
    return barchan_probe.place + floor(position.xy) * barchan_probe.step;
}

// The elevation of the horizon towards the light, in radians, 1 in shadow, the curvature along the light, and its azimuth on the map.
// The light is in the axes of Pu and Pv, whose third is the normal.
@fragment
fn barchan_probe_curved(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = barchan_probe_place(position);
    let extent = barchan_tables[BARCHAN_HORIZON].extent * barchan_tables[BARCHAN_HORIZON].spacing;
    let normal = vec3<f32>(0.0, 0.0, 1.0);
    let light = barchan_tangent_light(barchan_probe.along_u, barchan_probe.along_v, normal, barchan_probe.light, extent);
    let curvature = barchan_curvature_along(barchan_probe.first_form, barchan_probe.second_form, light.direction);
    let elevation = barchan_curved_elevation(place, light, curvature);
    let is_dark = barchan_is_below(light, elevation);
    return vec4<f32>(elevation, select(0.0, 1.0, is_dark), curvature, light.azimuth);
}
