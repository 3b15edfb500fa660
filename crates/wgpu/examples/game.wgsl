// What the game adds to Barchan's parts: its camera, its mesh, its sun, and what light does to the skin of the torus.

struct Frame {
    clip_from_world: mat4x4<f32>,
    eye: vec3<f32>,
    // What the stored fundamental forms are multiplied by.
    first_scale: f32,
    // A unit vector towards the sun.
    sun: vec3<f32>,
    second_scale: f32,
}

@group(0) @binding(0) var<uniform> frame: Frame;

struct Vertex {
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    // Unit, along u; w is the side of v: 1, or −1 where the texture is mirrored.
    @location(2) tangent: vec4<f32>,
    @location(3) uv: vec2<f32>,
    // E, F, G and e, f, g from the asset.
    @location(4) first_form: vec3<f32>,
    @location(5) second_form: vec3<f32>,
}

struct Pixel {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) tangent: vec4<f32>,
    @location(3) uv: vec2<f32>,
    @location(4) first_form: vec3<f32>,
    @location(5) second_form: vec3<f32>,
}

// Relief stands on the mesh: what is drawn is the surface that its highest point touches, where eye rays enter.
@vertex
fn place_vertex(vertex: Vertex) -> Pixel {
    let position = vertex.position + vertex.normal * barchan_tables[BARCHAN_HEIGHT].greatest;
    let clip = frame.clip_from_world * vec4<f32>(position, 1.0);
    let first_form = frame.first_scale * vertex.first_form;
    let second_form = frame.second_scale * vertex.second_form;
    return Pixel(clip, position, vertex.normal, vertex.tangent, vertex.uv, first_form, second_form);
}

@fragment
fn shade_pixel(pixel: Pixel) -> @location(0) vec4<f32> {
    // How the texture lies on the surface: the mesh has the direction of u, the asset how long its unit is, and v's.
    let normal = normalize(pixel.normal);
    let tangent = normalize(pixel.tangent.xyz - normal * dot(pixel.tangent.xyz, normal));
    let e = pixel.first_form.x;
    let f = pixel.first_form.y;
    let along_u = sqrt(e) * tangent;
    let across = sqrt(max(pixel.first_form.z - f * f / e, 0.0)) * pixel.tangent.w;
    let along_v = (f / e) * along_u + across * cross(normal, tangent);

    // Relief: the eye's ray, in the frame of the height map, goes on from here until it hits.
    let texels = barchan_tables[BARCHAN_HEIGHT].extent;
    let extent = texels * barchan_tables[BARCHAN_HEIGHT].spacing;
    let place = vec2<f32>(pixel.uv.x, 1.0 - pixel.uv.y) * texels - 0.5;
    let eye = normalize(frame.eye - pixel.position);
    let towards_eye = vec3<f32>(barchan_texture_step(along_u, along_v, eye) * extent, dot(eye, normal));
    let ray = barchan_relief_ray(place, normalize(towards_eye));
    let depth = barchan_relief_find(ray).depth;
    let hit = barchan_relief_at(ray, depth);

    // The sun: what relief and the curved surface under it leave of it there, on the normal of the relief.
    let light = barchan_tangent_light(along_u, along_v, normal, frame.sun, extent);
    let curvature = barchan_curvature_along(pixel.first_form, pixel.second_form, light.direction);
    let is_dark = barchan_curved_in_shadow(hit, light, curvature);
    let bump = barchan_bump_normal(along_u, along_v, normal, barchan_surface_slopes(hit) * extent);
    let sun = select(max(dot(bump, frame.sun), 0.0), 0.0, is_dark);

    // The sky: what of it the relief leaves open, and how much of that is above the horizon of the world.
    let sky = barchan_sky_irradiance(hit) * (0.6 + 0.4 * bump.z);

    let albedo = mix(vec3<f32>(0.14, 0.05, 0.02), vec3<f32>(0.24, 0.26, 0.08), 1.0 - depth);
    let gloss = select(0.25 * pow(max(dot(bump, normalize(eye + frame.sun)), 0.0), 40.0), 0.0, is_dark);
    let warm = vec3<f32>(2.4, 2.2, 1.9);
    return vec4<f32>(albedo * (sun * warm + sky * vec3<f32>(0.30, 0.38, 0.50)) + gloss * warm, 1.0);
}
