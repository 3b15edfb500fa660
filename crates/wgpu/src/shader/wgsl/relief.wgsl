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
