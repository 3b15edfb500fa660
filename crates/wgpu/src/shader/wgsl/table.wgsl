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
