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

// Linear, with the edges of the tables as address modes.
@group(0) @binding(1) var barchan_sampler: sampler;

@group(0) @binding(2) var barchan_height_texels: texture_2d<f32>;

const BARCHAN_HEIGHT: u32 = 0u;

fn barchan_height_before_transfer(place: vec2<i32>, layer: i32) -> f32 {
    let texel = barchan_inside(BARCHAN_HEIGHT, place, 0);
    return barchan_scaled(BARCHAN_HEIGHT, textureLoad(barchan_height_texels, texel, layer).x);
}

fn barchan_height_texel(place: vec2<i32>, layer: i32) -> f32 {
    return barchan_transferred(BARCHAN_HEIGHT, barchan_height_before_transfer(place, layer));
}

@group(0) @binding(11) var barchan_cone_map_texels: texture_2d<f32>;

const BARCHAN_CONE_MAP: u32 = 9u;

fn barchan_cone_map_before_transfer(place: vec2<i32>, layer: i32) -> vec2<f32> {
    let texel = barchan_inside(BARCHAN_CONE_MAP, place, 0);
    return barchan_scaled_cone(BARCHAN_CONE_MAP, textureLoad(barchan_cone_map_texels, texel, layer).xy);
}

fn barchan_cone_map_texel(place: vec2<i32>, layer: i32) -> vec2<f32> {
    return barchan_transferred_cone(BARCHAN_CONE_MAP, barchan_cone_map_before_transfer(place, layer));
}

fn barchan_cone_map_at(place: vec2<f32>, layer: i32) -> vec2<f32> {
    let uv = (place + 0.5) / barchan_tables[BARCHAN_CONE_MAP].extent;
    let stored = textureSampleLevel(barchan_cone_map_texels, barchan_sampler, uv, 0.0).xy;
    return barchan_transferred_cone(BARCHAN_CONE_MAP, barchan_scaled_cone(BARCHAN_CONE_MAP, stored));
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

// Rays against relief below a plane, and one cell of it under a ray.
//
// A ray enters the top plane, which the highest sample touches, at a place and goes down and away from the eye. It is followed by its
// depth, 0 on the top plane and 1 at the lowest sample, and stands at place + depth · step: Takeshi Suzuki, An Accelerated Relief
// Mapping Using Depth Maps. Inside a cell of four samples the surface along it is a parabola in its depth, which is solved: a hit
// has no error but that of 32-bit floats. Walks count the borders they cross in whole numbers, so that no rounded place holds them up.
//
// `towards` is a unit vector to the eye or the light in the frame (u, v up the picture, height). Samples of the heights are loaded.

struct BarchanReliefRay {
    // Where it enters, in texels; within the first tile where tiles repeat, so that far tiles lose no more digits than they have.
    place: vec2<f32>,
    // Texels moved, along columns and rows, from depth 0 to depth 1.
    step: vec2<f32>,
    towards: vec3<f32>,
    // Of its angle from the normal: length moved along the plane per length of height.
    tangent: f32,
    // Whether it goes down, from a place that is near enough, by a way that is short enough.
    is_valid: bool,
}

// Where a search begins.
struct BarchanStart {
    depth: f32,
    // Whether nothing above that depth can be hit.
    is_proven: bool,
    // Fetches: of heights (a gather of four or a filtered sample), and of tables.
    fetches: vec2<i32>,
}

// Where it ends.
struct BarchanFound {
    depth: f32,
    // Those of the start included.
    fetches: vec2<i32>,
}

// Where a ray leaves a block of cells, and the cell behind.
struct BarchanReliefExit {
    depth: f32,
    next: vec2<i32>,
}

// What a start turned out to be: behind nothing, or within the relief, and then the depths before and behind where the ray got in.
struct BarchanReliefLeft {
    outside: f32,
    inside: f32,
    is_within: bool,
    fetches: i32,
}

// The longest way to the floor, in texels along u and v together: there a place is known to 1/128 of a texel.
const BARCHAN_LONGEST_WAY: f32 = 65536.0;
// The farthest place, in texels: there it is known to a texel.
const BARCHAN_FARTHEST: f32 = 16777216.0;
// The steepest tangent of a relief without thickness, whose rays have no way.
const BARCHAN_STEEPEST: f32 = 1048576.0;
// The most turns of a loop. What gives up then has passed nothing: its depth is on the way to the first hit. Of rays that are not
// given up at once only those need more that graze thousands of cells one by one.
const BARCHAN_MOST_TURNS: i32 = 4096;
// The step of a march back for searches that have no step of their own, as a part of the thickness.
const BARCHAN_STEP_BACK: f32 = 0.015625;

fn barchan_relief_thickness() -> f32 {
    return barchan_tables[BARCHAN_HEIGHT].greatest - barchan_tables[BARCHAN_HEIGHT].least;
}

// The depths of heights; 0 on a relief without thickness.
fn barchan_relief_depths(heights: vec4<f32>) -> vec4<f32> {
    let thickness = barchan_relief_thickness();
    if !(thickness > 0.0) {
        return vec4<f32>(0.0);
    }
    return (barchan_tables[BARCHAN_HEIGHT].greatest - heights) / thickness;
}

fn barchan_relief_depth(height: f32) -> f32 {
    return barchan_relief_depths(vec4<f32>(height)).x;
}

// The ray that enters the top plane at a place, in texels, and comes from `towards`.
fn barchan_relief_ray(place: vec2<f32>, towards: vec3<f32>) -> BarchanReliefRay {
    let spacing = barchan_tables[BARCHAN_HEIGHT].spacing;
    let thickness = max(barchan_relief_thickness(), 0.0);
    let level = length(towards.xy);
    // Products instead of quotients: nothing is infinite.
    let way = thickness * (abs(towards.x) * spacing.y + abs(towards.y) * spacing.x);
    let is_short = way <= BARCHAN_LONGEST_WAY * spacing.x * spacing.y * towards.z && level <= BARCHAN_STEEPEST * towards.z;
    let is_near = all(abs(place) <= vec2<f32>(BARCHAN_FARTHEST));
    if !(towards.z > 0.0 && is_short && is_near) {
        return BarchanReliefRay(vec2<f32>(0.0), vec2<f32>(0.0), vec3<f32>(0.0, 0.0, 1.0), 0.0, false);
    }
    // Away from the eye; rows count down the picture.
    let run = thickness / towards.z;
    let step = vec2<f32>(-run * towards.x, run * towards.y) / spacing;
    return BarchanReliefRay(barchan_relief_in_tile(place), step, towards, level / towards.z, true);
}

// A place in the first tile, along the axes that repeat. Tiles are whole numbers of texels long: nothing is rounded.
fn barchan_relief_in_tile(place: vec2<f32>) -> vec2<f32> {
    let extent = barchan_tables[BARCHAN_HEIGHT].extent;
    let edges = barchan_tables[BARCHAN_HEIGHT].edges;
    let repeats = vec2<bool>((edges & 1u) != 0u, (edges & 2u) != 0u);
    let rest = place - floor(place / extent) * extent;
    // A quotient may be rounded up to the next tile.
    return select(place, select(rest, rest + extent, rest < vec2<f32>(0.0)), repeats);
}

// The ray from the top plane down through a point at a depth below a place.
fn barchan_relief_ray_through(place: vec2<f32>, depth: f32, towards: vec3<f32>) -> BarchanReliefRay {
    let ray = barchan_relief_ray(place, towards);
    if !ray.is_valid {
        return ray;
    }
    // As far up along the light as a ray from here goes down.
    return barchan_relief_ray(ray.place - depth * ray.step, towards);
}

// Where a ray stands at a depth, in texels.
fn barchan_relief_at(ray: BarchanReliefRay, depth: f32) -> vec2<f32> {
    return ray.place + depth * ray.step;
}

// The longer of the ways of a ray along u and along v.
fn barchan_relief_way(ray: BarchanReliefRay) -> f32 {
    return max(abs(ray.step.x), abs(ray.step.y));
}

// About how many texels a ray goes along u or v from a start to its hit.
fn barchan_relief_way_ahead(ray: BarchanReliefRay, start: f32) -> f32 {
    return select(0.25, 0.03125, start > 0.0) * barchan_relief_way(ray);
}

// The cell that a ray goes through just behind a depth: the one right of and below this texel.
fn barchan_relief_cell(ray: BarchanReliefRay, depth: f32) -> vec2<i32> {
    let place = barchan_relief_at(ray, depth);
    return vec2<i32>(select(floor(place), ceil(place) - 1.0, ray.step < vec2<f32>(0.0)));
}

// The cell of a block that a ray goes through just behind a depth at which it is in the block, whatever rounding says.
fn barchan_relief_cell_of(ray: BarchanReliefRay, low: vec2<i32>, high: vec2<i32>, depth: f32) -> vec2<i32> {
    return clamp(barchan_relief_cell(ray, depth), low, high - 1);
}

// Where a ray leaves a block, from the columns and rows `low` up to, but without, `high`; `start` at the earliest, 1 at the latest.
fn barchan_relief_exit(ray: BarchanReliefRay, low: vec2<i32>, high: vec2<i32>, start: f32) -> BarchanReliefExit {
    let moves = ray.step != vec2<f32>(0.0);
    let ends = vec2<f32>(barchan_chosen(low, high, ray.step > vec2<f32>(0.0)));
    let borders = select(vec2<f32>(1e30), (ends - ray.place) / select(vec2<f32>(1.0), ray.step, moves), moves);
    let depth = min(max(min(borders.x, borders.y), start), 1.0);
    var next = barchan_relief_cell_of(ray, low, high, depth);
    let behind = barchan_chosen(high, low - 1, ray.step < vec2<f32>(0.0));
    if borders.x <= borders.y {
        next.x = behind.x;
    } else {
        next.y = behind.y;
    }
    return BarchanReliefExit(depth, next);
}

// The depths at the corners of a cell, upper row first. One fetch: a gather.
fn barchan_relief_corners(cell: vec2<i32>) -> vec4<f32> {
    return barchan_relief_depths(vec4<f32>(
        barchan_height_texel(cell, 0),
        barchan_height_texel(cell + vec2<i32>(1, 0), 0),
        barchan_height_texel(cell + vec2<i32>(0, 1), 0),
        barchan_height_texel(cell + vec2<i32>(1, 1), 0),
    ));
}

// 0 where two sides are level, to the bit.
fn barchan_relief_twist(corners: vec4<f32>) -> f32 {
    return (corners.x - corners.y) + (corners.w - corners.z);
}

// How far the surface of a cell is below a ray at a depth of it.
fn barchan_relief_cell_gap(ray: BarchanReliefRay, cell: vec2<i32>, corners: vec4<f32>, depth: f32) -> f32 {
    let place = (ray.place - vec2<f32>(cell)) + depth * ray.step;
    let plane = corners.x + (corners.y - corners.x) * place.x + (corners.z - corners.x) * place.y;
    return plane + barchan_relief_twist(corners) * place.x * place.y - depth;
}

// How far the surface is below a ray at a depth of it: negative inside the relief. One fetch of a height.
fn barchan_relief_gap(ray: BarchanReliefRay, depth: f32) -> f32 {
    let cell = vec2<i32>(floor(barchan_relief_at(ray, depth)));
    return barchan_relief_cell_gap(ray, cell, barchan_relief_corners(cell), depth);
}

// The first hit of a ray in its part of a cell, between two depths; −1 where there is none.
fn barchan_relief_hit(ray: BarchanReliefRay, cell: vec2<i32>, corners: vec4<f32>, start: f32, end: f32) -> f32 {
    let part = end - start;
    let twist = barchan_relief_twist(corners) * (part * ray.step.x) * (part * ray.step.y);
    let before = barchan_relief_cell_gap(ray, cell, corners, start);
    let first = barchan_relief_first_zero(before, barchan_relief_cell_gap(ray, cell, corners, end), twist);
    return select(start + first * part, -1.0, first < 0.0);
}

// The least s of 0 to 1 at which the parabola from `g0` to `g1`, with the coefficient `c` of s², is not above 0; −1 if there is none.
fn barchan_relief_first_zero(g0: f32, g1: f32, c: f32) -> f32 {
    if g0 <= 0.0 {
        return 0.0;
    }
    let b = g1 - g0 - c;
    let discriminant = b * b - 4.0 * c * g0;
    if g1 > 0.0 && (c <= 0.0 || b >= 0.0 || discriminant < 0.0) {
        // Both ends are outside, and between them the gap has no minimum or one above 0.
        return -1.0;
    }
    let root = sqrt(max(discriminant, 0.0));
    // The forms that add what has one sign: nothing cancels.
    var s = 1.0;
    if b <= 0.0 {
        s = 2.0 * g0 / (root - b);
    } else {
        s = (root + b) / (-2.0 * c);
    }
    if g1 > 0.0 && s > 1.0 {
        return -1.0;
    }
    return min(s, 1.0);
}

// Looks whether a start that is not proven is inside the relief, and if it is, marches back out in steps: Suzuki, section 3.2. What is
// thinner than the way back may be missed, and that is the price of such a start.
fn barchan_relief_leave(ray: BarchanReliefRay, start: BarchanStart, step: f32) -> BarchanReliefLeft {
    // What is not a number begins at the top.
    let depth = select(0.0, min(start.depth, 1.0), start.depth > 0.0);
    if start.is_proven || depth == 0.0 {
        return BarchanReliefLeft(depth, depth, false, 0);
    }
    if barchan_relief_gap(ray, depth) > 0.0 {
        return BarchanReliefLeft(depth, depth, false, 1);
    }
    var inside = depth;
    var fetches = 1;
    for (; fetches <= BARCHAN_MOST_TURNS; fetches++) {
        let outside = inside - step;
        // Nothing is above the top.
        if outside <= 0.0 {
            break;
        }
        if barchan_relief_gap(ray, outside) > 0.0 {
            return BarchanReliefLeft(outside, inside, true, fetches + 1);
        }
        inside = outside;
    }
    return BarchanReliefLeft(0.0, inside, true, fetches);
}

// Rays start at the top plane: nothing is above it, and nothing is read.

fn barchan_relief_start(ray: BarchanReliefRay) -> BarchanStart {
    return BarchanStart(0.0, true, vec2<i32>(0));
}

// How far a ray can sink from a gap above the tip of a cone before it leaves the cone: r g / (s + r) for a cone of the ratio r and a ray
// that moves s along the plane per length down.
fn barchan_relief_cone_step(ray: BarchanReliefRay, gap: f32, ratio: f32) -> f32 {
    // Along the normal all of the gap is free, whatever the ratio.
    var part = 1.0;
    if ray.tangent > 0.0 {
        part = select(0.0, ratio / (ray.tangent + ratio), ratio > 0.0);
    }
    // A damaged table may hold anything; no gap is wider than the relief is thick.
    return select(0.0, min(gap * part, 1.0), gap > 0.0 && part > 0.0);
}

// Cone steps that end in an exact cell.
//
// At a place of the surface a cone map holds the ratio r of a cone that opens upwards and holds no surface. A ray a gap g above that
// place, moving s along the plane per length down, can sink r g / (s + r) before it leaves the cone: Jonathan Dummer, Cone Step Mapping:
// An Iterative Ray-Heightfield Intersection Algorithm. Where a step does not get out of the cell it is in, the cell is solved. Behind a
// cell without a hit the next one is looked at at once where the ratio last seen says that a step would not get out of it either.

// A hit that is likely to be nearer than this is looked for in the cell the ray is in.
const BARCHAN_NEAR_TEXELS: f32 = 0.5;

fn barchan_relief_search(ray: BarchanReliefRay, start: BarchanStart) -> BarchanFound {
    let left = barchan_relief_leave(ray, start, BARCHAN_STEP_BACK);
    var fetches = start.fetches + vec2<i32>(left.fetches, 0);
    var depth = left.outside;
    var cell = barchan_relief_cell(ray, depth);
    var takes_sample = depth <= 0.0 || barchan_relief_way_ahead(ray, depth) >= BARCHAN_NEAR_TEXELS;
    var ratio = 0.0;
    for (var turn = 0; turn < BARCHAN_MOST_TURNS; turn++) {
        let exit = barchan_relief_exit(ray, cell, cell + 1, depth);
        if takes_sample {
            fetches.y++;
            let cone = barchan_cone_map_at(barchan_relief_at(ray, depth), 0);
            let next = min(depth + barchan_relief_cone_step(ray, cone.x - depth, cone.y), 1.0);
            ratio = cone.y;
            if next > exit.depth && exit.depth < 1.0 {
                depth = next;
                cell = barchan_relief_cell(ray, next);
                continue;
            }
        }
        fetches.x++;
        let corners = barchan_relief_corners(cell);
        let hit = barchan_relief_hit(ray, cell, corners, depth, exit.depth);
        if hit >= 0.0 {
            return BarchanFound(hit, fetches);
        }
        // Nothing is deeper than 1, whatever rounding says.
        if exit.depth >= 1.0 {
            return BarchanFound(1.0, fetches);
        }
        let gap = barchan_relief_cell_gap(ray, cell, corners, exit.depth);
        depth = exit.depth;
        cell = exit.next;
        takes_sample = depth + barchan_relief_cone_step(ray, gap, ratio) > barchan_relief_exit(ray, cell, cell + 1, depth).depth;
    }
    return BarchanFound(depth, fetches);
}

// Where a ray meets the relief, by the start and the search of this shader.

// The top plane for a ray that is not valid.
fn barchan_relief_find(ray: BarchanReliefRay) -> BarchanFound {
    if !ray.is_valid {
        return BarchanFound(0.0, vec2<i32>(0));
    }
    return barchan_relief_search(ray, barchan_relief_start(ray));
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

// The depth at which the ray of the eye meets the relief, −1 for a ray that is not valid; the fetches of heights and of tables; the
// depth of the start.
@fragment
fn barchan_probe_relief(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let ray = barchan_relief_ray(barchan_probe_place(position), barchan_probe.eye);
    if !ray.is_valid {
        return vec4<f32>(-1.0, 0.0, 0.0, 0.0);
    }
    let start = barchan_relief_start(ray);
    let found = barchan_relief_search(ray, start);
    return vec4<f32>(found.depth, vec2<f32>(found.fetches), start.depth);
}

// Shadows of relief by the search that finds it: the light is an eye, and what it does not see is dark.
//
// From a point of the relief one goes up along the light to the top plane, and a relief ray comes down again. If it meets the relief
// before the point, something stands in the light: Takeshi Suzuki, An Accelerated Relief Mapping Using Depth Maps, section 4.1. Where a
// conservative depth map starts the ray at the point or beyond, the point is lit without a search.

// Whether a point at a depth below a place is in the shadow of a light from `towards`. Relief must stand before the point by more than
// `tolerance`, a part of its whole depth, to shade it: the ray comes down through the point itself, which rounding puts on either side.
// A light on the horizon or below reaches nothing, nor one so near to it that its ray is given up.
fn barchan_relief_in_shadow(place: vec2<f32>, depth: f32, towards: vec3<f32>, tolerance: f32) -> bool {
    let ray = barchan_relief_ray_through(place, depth, towards);
    if !ray.is_valid {
        return true;
    }
    let clear = depth - tolerance;
    let start = barchan_relief_start(ray);
    if start.is_proven && start.depth >= clear {
        return false;
    }
    return barchan_relief_search(ray, start).depth < clear;
}

// The depth at which the ray of the eye meets the relief, and 1 where that point is in shadow.
@fragment
fn barchan_probe_relief_shadow(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let ray = barchan_relief_ray(barchan_probe_place(position), barchan_probe.eye);
    let depth = barchan_relief_find(ray).depth;
    let place = barchan_relief_at(ray, depth);
    let is_dark = barchan_relief_in_shadow(place, depth, barchan_probe.light, barchan_probe.tolerance);
    return vec4<f32>(depth, select(0.0, 1.0, is_dark), 0.0, 0.0);
}
