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

@group(0) @binding(3) var barchan_horizon_texels: texture_2d_array<f32>;

const BARCHAN_HORIZON: u32 = 1u;

fn barchan_horizon_before_transfer(place: vec2<i32>, layer: i32) -> f32 {
    let texel = barchan_inside(BARCHAN_HORIZON, place, 0);
    return barchan_scaled(BARCHAN_HORIZON, textureLoad(barchan_horizon_texels, texel, layer, 0).x);
}

fn barchan_horizon_texel(place: vec2<i32>, layer: i32) -> f32 {
    return barchan_transferred(BARCHAN_HORIZON, barchan_horizon_before_transfer(place, layer));
}

fn barchan_horizon_at(place: vec2<f32>, layer: i32) -> f32 {
    let uv = (place + 0.5) / barchan_tables[BARCHAN_HORIZON].extent;
    let stored = textureSampleLevel(barchan_horizon_texels, barchan_sampler, uv, layer, 0.0).x;
    return barchan_transferred(BARCHAN_HORIZON, barchan_scaled(BARCHAN_HORIZON, stored));
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

// Shadows from a horizon map on a flat base surface.
//
// A place is in shadow iff the light stands below its horizon: Koiichi Onoue, Nelson Max, Tomoyuki Nishita, Bumpmap Shadows on
// Curved Surfaces. Elevations are interpolated within the layers of the two azimuths beside the light's, and between them.

// The elevation of the horizon in an azimuth, in radians.
fn barchan_horizon_elevation(place: vec2<f32>, azimuth: f32) -> f32 {
    let beside = barchan_neighbours(BARCHAN_HORIZON, azimuth);
    return mix(barchan_horizon_at(place, beside.first), barchan_horizon_at(place, beside.second), beside.weight);
}

// Whether the light stands below the horizon of a place. `towards` is a unit vector in the frame (u, v up the picture, height).
fn barchan_horizon_in_shadow(place: vec2<f32>, towards: vec3<f32>) -> bool {
    let horizon = barchan_sine_cosine(barchan_horizon_elevation(place, barchan_azimuth(towards.xy)));
    return towards.z * horizon.y < length(towards.xy) * horizon.x;
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

// The elevation of the horizon towards the light, in radians, and 1 in shadow.
@fragment
fn barchan_probe_horizon(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    let place = barchan_probe_place(position);
    let elevation = barchan_horizon_elevation(place, barchan_azimuth(barchan_probe.light.xy));
    let is_dark = barchan_horizon_in_shadow(place, barchan_probe.light);
    return vec4<f32>(elevation, select(0.0, 1.0, is_dark), 0.0, 0.0);
}
