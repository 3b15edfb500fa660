// What all pictures share: their light, their colours, and how these become bytes.

struct PictureLight {
    // The pixel at the upper left of what is drawn now.
    first: vec2<f32>,
    unused_0: vec2<f32>,
    // A unit vector towards the sun.
    towards: vec3<f32>,
    unused_1: f32,
    // Linear light: what the surface reflects, what the sun sheds on ground that faces it, the sky on ground that faces up.
    albedo: vec3<f32>,
    unused_2: f32,
    sun: vec3<f32>,
    unused_3: f32,
    sky: vec3<f32>,
    unused_4: f32,
    // Where nothing is seen; already encoded.
    background: vec3<f32>,
    unused_5: f32,
}

@group(1) @binding(0) var<uniform> picture_light: PictureLight;

// A pixel: its colour, opaque where something is seen, and its numbers: fetches of heights and of tables, 1 in shadow, and a
// share, 65535 for all.
struct PicturePixel {
    @location(0) colour: vec4<f32>,
    @location(1) numbers: vec4<u32>,
}

// One triangle over all of the target.
@vertex
fn picture_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0, 0.0, 1.0);
}

// The pixel's centre in the whole picture, columns and rows from its upper left corner.
fn picture_centre(position: vec4<f32>) -> vec2<f32> {
    return picture_light.first + position.xy;
}

// Linear light with a shoulder instead of a hard clip, encoded as sRGB, in whole 255ths.
fn picture_encoded(linear: vec3<f32>) -> vec3<f32> {
    let light = 1.0 - exp(-1.2 * linear);
    let power = 1.055 * pow(max(light, vec3<f32>(0.0)), vec3<f32>(1.0 / 2.4)) - 0.055;
    let encoded = select(power, 12.92 * light, light <= vec3<f32>(0.0031308));
    return round(255.0 * clamp(encoded, vec3<f32>(0.0), vec3<f32>(1.0))) / 255.0;
}

fn picture_seen(linear: vec3<f32>, fetches: vec2<i32>, is_dark: bool, share: f32) -> PicturePixel {
    let counts = vec2<u32>(clamp(fetches, vec2<i32>(0), vec2<i32>(65535)));
    let part = u32(round(65535.0 * clamp(share, 0.0, 1.0)));
    return PicturePixel(vec4<f32>(picture_encoded(linear), 1.0), vec4<u32>(counts, select(0u, 1u, is_dark), part));
}

fn picture_nothing() -> PicturePixel {
    return PicturePixel(vec4<f32>(picture_light.background, 0.0), vec4<u32>(0u));
}
