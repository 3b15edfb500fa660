// Relief on a base surface before a camera, each pixel by a relief ray.
//
// The base surface is the top plane of the relief. Where a ray of the camera hits it, the tangent frame takes the direction to the eye
// into the frame of the relief, and a relief ray goes on from there as if the surface were flat: Fabio Policarpo, Manuel Oliveira,
// João Comba, Real-Time Relief Mapping on Arbitrary Polygonal Surfaces, 2005.

// Rays are parallel.
struct PictureView {
    // The point that the first pixel's ray goes through, and from there to the next pixel's, across and down.
    corner: vec3<f32>,
    // By how much of its depth relief must stand before a point to shade it.
    tolerance: f32,
    across: vec3<f32>,
    // Of a sphere.
    radius: f32,
    down: vec3<f32>,
    // 1 where there is a sun.
    has_sun: u32,
    // A unit vector towards the eye.
    eye: vec3<f32>,
    unused: f32,
    // Lengths of the surface per unit of texture coordinates.
    tile: vec2<f32>,
}

@group(1) @binding(1) var<uniform> picture_view: PictureView;

// Where a ray meets the base: u and v, Pu, Pv and the unit normal there.
struct PictureHit {
    uv: vec2<f32>,
    along_u: vec3<f32>,
    along_v: vec3<f32>,
    normal: vec3<f32>,
    is_hit: bool,
}

@fragment
fn picture_fragment(@builtin(position) position: vec4<f32>) -> PicturePixel {
    let pixel = picture_centre(position) - 0.5;
    let origin = picture_view.corner + picture_view.across * pixel.x + picture_view.down * pixel.y;
    let hit = picture_hit(origin, picture_view.eye);
    if !(hit.is_hit && picture_is_covered(hit.uv)) {
        return picture_nothing();
    }
    let extent = barchan_tables[BARCHAN_HEIGHT].extent;
    let entry = vec2<f32>(hit.uv.x, 1.0 - hit.uv.y) * extent - 0.5;
    let ray = barchan_relief_ray(entry, picture_relief_direction(hit, picture_view.eye));
    if !ray.is_valid {
        return picture_nothing();
    }
    let found = barchan_relief_find(ray);
    let place = barchan_relief_at(ray, found.depth);
    let slopes = barchan_surface_slopes(place);
    let per_uv = slopes * extent * barchan_tables[BARCHAN_HEIGHT].spacing;
    let normal = barchan_bump_normal(hit.along_u, hit.along_v, hit.normal, per_uv);
    var is_dark = true;
    if picture_view.has_sun != 0u {
        let towards = picture_relief_direction(hit, picture_light.towards);
        is_dark = barchan_relief_in_shadow(place, found.depth, towards, picture_view.tolerance);
    }
    let occlusion = picture_occlusion(place, found.depth, normalize(vec3<f32>(-slopes, 1.0)));
    let sun = select(max(dot(normal, picture_light.towards), 0.0), 0.0, is_dark);
    let sky = (0.5 + 0.5 * dot(normal, hit.normal)) * (1.0 - occlusion);
    let linear = picture_light.albedo * (picture_light.sun * sun + picture_light.sky * sky);
    return picture_seen(linear, found.fetches, is_dark, occlusion);
}

// A clamped tile is seen through its own top face alone.
fn picture_is_covered(uv: vec2<f32>) -> bool {
    let edges = barchan_tables[BARCHAN_HEIGHT].edges;
    let is_within = (uv >= vec2<f32>(0.0)) & (uv <= vec2<f32>(1.0));
    return all(is_within | vec2<bool>((edges & 1u) != 0u, (edges & 2u) != 0u));
}

// A direction of space in the frame of the relief, as a unit vector.
fn picture_relief_direction(hit: PictureHit, direction: vec3<f32>) -> vec3<f32> {
    let table = barchan_tables[BARCHAN_HEIGHT].extent * barchan_tables[BARCHAN_HEIGHT].spacing;
    let step = barchan_texture_step(hit.along_u, hit.along_v, direction) * table;
    return normalize(vec3<f32>(step, dot(direction, hit.normal)));
}
