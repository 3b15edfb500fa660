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
