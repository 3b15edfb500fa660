// Maximum mipmaps: blocks of cells that a ray passes above are skipped, cells are solved exactly.
//
// Level k holds the greatest height over 2ᵏ × 2ᵏ cells. A ray that leaves a block above it goes on to the block behind. Otherwise it is
// followed down to that height and looks at a block of half the size, down to the cell: Art Tevs, Ivo Ihrke, Hans-Peter Seidel,
// Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering. Level 0 is not read, as the cell's four heights cost
// as much and decide; where a texture begins at a coarser level than 1, cells are looked at instead of those that are left out.

// Beyond an edge that clamps a block has no end: farther than any ray goes.
const BARCHAN_ENDLESS: i32 = 33554432;
// From the highest point of a block a ray goes on at a level whose blocks are at most so many times as long as its way to its end.
const BARCHAN_LONGEST_BLOCK: f32 = 4.0;

// A block of a level, and its texel.
struct BarchanMipBlock {
    low: vec2<i32>,
    high: vec2<i32>,
    texel: vec2<i32>,
}

// The coarsest level of the table.
fn barchan_mip_coarsest() -> i32 {
    return i32(barchan_tables[BARCHAN_MAXIMUM_MIP].first_level + barchan_tables[BARCHAN_MAXIMUM_MIP].levels) - 1;
}

// The finest level that is read.
fn barchan_mip_finest() -> i32 {
    return max(i32(barchan_tables[BARCHAN_MAXIMUM_MIP].first_level), 1);
}

// The coarsest level whose blocks are no longer than a way in texels; 0 where cells are to be looked at.
fn barchan_mip_level_as_long_as(way: f32, most: i32) -> i32 {
    var level = 0;
    while level < most && f32(2 << u32(level)) <= way {
        level++;
    }
    return select(level, 0, level < barchan_mip_finest());
}

// The cells along one axis that share a texel of a level: the first of them, the one behind the last, and the texel.
//
// A tile that repeats is cut at its end; beyond an edge that clamps all cells are alike, and count to the last texel.
fn barchan_mip_range(repeats: bool, cell: i32, size: i32, level: i32) -> vec3<i32> {
    let last = max(size >> u32(level), 1) - 1;
    let repeated = ((cell % size) + size) % size;
    let inside = select(clamp(cell, 0, size - 1), repeated, repeats);
    let tile = select(0, cell - inside, repeats);
    let texel = min(inside >> u32(level), last);
    let low = texel << u32(level);
    let high = select((texel + 1) << u32(level), size, texel == last);
    if repeats {
        return vec3<i32>(tile + low, tile + high, texel);
    }
    // A cell before the first is flat; the first is not.
    if level == 0 && cell < 0 {
        return vec3<i32>(-BARCHAN_ENDLESS, 0, texel);
    }
    return vec3<i32>(
        select(low, -BARCHAN_ENDLESS, level > 0 && texel == 0),
        select(high, BARCHAN_ENDLESS, texel == last),
        texel,
    );
}

// The block of a level that a cell is in.
fn barchan_mip_block(level: i32, cell: vec2<i32>) -> BarchanMipBlock {
    let extent = vec2<i32>(barchan_tables[BARCHAN_HEIGHT].extent);
    let edges = barchan_tables[BARCHAN_HEIGHT].edges;
    let columns = barchan_mip_range((edges & 1u) != 0u, cell.x, extent.x, level);
    let rows = barchan_mip_range((edges & 2u) != 0u, cell.y, extent.y, level);
    return BarchanMipBlock(vec2<i32>(columns.x, rows.x), vec2<i32>(columns.y, rows.y), vec2<i32>(columns.z, rows.z));
}

// The level to go on with behind a block that a ray comes out of, from one cell into the next, with a gap above what it passed: one up
// where a block of that level begins, if the ray would come through that, too, were it no higher.
fn barchan_mip_level_behind(ray: BarchanReliefRay, level: i32, cell: vec2<i32>, next: vec2<i32>, gap: f32) -> i32 {
    let above = max(level + 1, barchan_mip_finest());
    let is_high = gap * barchan_relief_way(ray) > f32(1 << u32(above));
    if above > barchan_mip_coarsest() || !is_high {
        return level;
    }
    let goes_on = all(barchan_mip_block(above, cell).texel == barchan_mip_block(above, next).texel);
    return select(above, level, goes_on);
}

fn barchan_relief_search(ray: BarchanReliefRay, start: BarchanStart) -> BarchanFound {
    let left = barchan_relief_leave(ray, start, BARCHAN_STEP_BACK);
    let first_level = i32(barchan_tables[BARCHAN_MAXIMUM_MIP].first_level);
    var fetches = start.fetches + vec2<i32>(left.fetches, 0);
    var depth = left.outside;
    var cell = barchan_relief_cell(ray, depth);
    var level = barchan_mip_level_as_long_as(barchan_relief_way_ahead(ray, depth), barchan_mip_coarsest());
    for (var turn = 0; turn < BARCHAN_MOST_TURNS; turn++) {
        let block = barchan_mip_block(level, cell);
        let exit = barchan_relief_exit(ray, block.low, block.high, depth);
        var gap = 0.0;
        if level == 0 {
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
            gap = barchan_relief_cell_gap(ray, cell, corners, exit.depth);
        } else {
            fetches.y++;
            let highest = barchan_relief_depth(barchan_maximum_mip_texel(block.texel, level - first_level));
            if !(highest > exit.depth && exit.depth < 1.0) {
                depth = max(depth, min(highest, exit.depth));
                let way_left = (exit.depth - depth) * barchan_relief_way(ray);
                cell = barchan_relief_cell_of(ray, block.low, block.high, depth);
                level = barchan_mip_level_as_long_as(BARCHAN_LONGEST_BLOCK * way_left, level - 1);
                continue;
            }
            gap = highest - exit.depth;
        }
        level = barchan_mip_level_behind(ray, level, cell, exit.next, gap);
        depth = exit.depth;
        cell = exit.next;
    }
    return BarchanFound(depth, fetches);
}
