// Rays start at the depth at which a ray like them first met the relief, out of a hemisphere table.
//
// A ray looks up the texel it enters in and the cell it comes from: its ring by the tangent of its polar angle, rounded towards the
// normal, and the nearest azimuth. Takeshi Suzuki, An Accelerated Relief Mapping Using Depth Maps. A conservative depth is where no ray
// of the cell has met the relief; the depth of the nearest ray is projected onto this one (eq 1), and not proven. A ray beyond the
// cells, or that enters beyond an edge that clamps, starts at the top, and nothing is fetched.

const BARCHAN_TAU: f32 = 6.283185307;

fn barchan_relief_start(ray: BarchanReliefRay) -> BarchanStart {
    let top = BarchanStart(0.0, true, vec2<i32>(0));
    let cell = barchan_relief_direction_cell(ray);
    // How far into the tile it enters, in texels of the heights.
    let along = barchan_relief_in_tile(ray.place + 0.5);
    let size = barchan_tables[BARCHAN_HEIGHT].extent;
    if any(cell < vec2<i32>(0)) || any(along < vec2<f32>(0.0)) || any(along > size) {
        return top;
    }
    let count = barchan_tables[BARCHAN_HEMISPHERE].extent;
    // Rounding may end a tile that repeats at its end.
    let texel = min(vec2<i32>(along / size * count), vec2<i32>(count) - 1);
    let layer = cell.x * i32(barchan_tables[BARCHAN_HEMISPHERE].azimuths) + cell.y;
    let depth = barchan_hemisphere_texel(texel, layer);
    if barchan_tables[BARCHAN_HEMISPHERE].depth_mode == 2u {
        return BarchanStart(depth, true, vec2<i32>(0, 1));
    }
    // Eq 1: the point at that depth of the stored direction, projected onto the ray.
    let level = ray.towards.xy / ray.towards.z;
    let stored = barchan_relief_ring_edge(cell.x) * dot(barchan_relief_azimuth_direction(cell.y), level);
    return BarchanStart(clamp(depth * (1.0 + stored) / (1.0 + dot(level, level)), 0.0, 1.0), false, vec2<i32>(0, 1));
}

// The ring and the azimuth of a ray; a negative one beyond the cells.
fn barchan_relief_direction_cell(ray: BarchanReliefRay) -> vec2<i32> {
    let ring = barchan_relief_ring(ray.tangent);
    // A ray along the normal comes from any azimuth.
    if ray.tangent <= 0.0 {
        return vec2<i32>(ring, 0);
    }
    return vec2<i32>(ring, barchan_relief_azimuth_cell(barchan_azimuth(ray.towards.xy)));
}

// The ring of a tangent, the last whose edge is not beyond it; −1 beyond the last.
fn barchan_relief_ring(tangent: f32) -> i32 {
    let rings = f32(barchan_tables[BARCHAN_HEMISPHERE].rings);
    let greatest = barchan_tables[BARCHAN_HEMISPHERE].max_tangent;
    if !(tangent >= 0.0 && tangent < greatest) {
        return -1;
    }
    var part = sqrt(tangent / greatest);
    if barchan_tables[BARCHAN_HEMISPHERE].ring_spacing == 1u {
        part = barchan_arctangent(tangent) / barchan_tables[BARCHAN_HEMISPHERE].max_polar;
    }
    return i32(min(floor(part * rings), rings - 1.0));
}

// The tangent of the polar angle at which a ring begins.
fn barchan_relief_ring_edge(ring: i32) -> f32 {
    let part = f32(ring) / f32(barchan_tables[BARCHAN_HEMISPHERE].rings);
    if barchan_tables[BARCHAN_HEMISPHERE].ring_spacing == 1u {
        let angle = barchan_sine_cosine(part * barchan_tables[BARCHAN_HEMISPHERE].max_polar);
        return angle.x / angle.y;
    }
    return part * part * barchan_tables[BARCHAN_HEMISPHERE].max_tangent;
}

// The nearest azimuth; −1 further than half a step beyond the ends of an arc.
fn barchan_relief_azimuth_cell(azimuth: f32) -> i32 {
    let count = i32(barchan_tables[BARCHAN_HEMISPHERE].azimuths);
    let step = barchan_tables[BARCHAN_HEMISPHERE].azimuth_step;
    let turns = (azimuth - barchan_tables[BARCHAN_HEMISPHERE].first_azimuth) / BARCHAN_TAU;
    let offset = (turns - floor(turns)) * BARCHAN_TAU;
    let span = f32(count - 1) * step;
    if step > 0.0 && (barchan_tables[BARCHAN_HEMISPHERE].is_circle != 0u || offset < span) {
        // On a circle the last half step belongs to the first azimuth again.
        return i32(offset / step + 0.5) % max(count, 1);
    }
    let beyond_last = offset - span;
    let before_first = BARCHAN_TAU - offset;
    let nearer_end = select(0, count - 1, beyond_last <= before_first);
    return select(-1, nearer_end, min(beyond_last, before_first) <= 0.5 * step);
}

// A unit vector towards the middle of an azimuth cell.
fn barchan_relief_azimuth_direction(index: i32) -> vec2<f32> {
    let azimuth = barchan_tables[BARCHAN_HEMISPHERE].first_azimuth + f32(index) * barchan_tables[BARCHAN_HEMISPHERE].azimuth_step;
    let angle = barchan_sine_cosine(azimuth - round(azimuth / BARCHAN_TAU) * BARCHAN_TAU);
    return angle.yx;
}
