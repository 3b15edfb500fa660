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
