// Cone steps that end in an exact cell.
//
// At a place of the surface a cone map holds the ratio r of a cone that opens upwards and holds no surface. A ray a gap g above that
// place, moving s along the plane per length down, can sink r g / (s + r) before it leaves the cone: Jonathan Dummer, Cone Step Mapping:
// An Iterative Ray-Heightfield Intersection Algorithm. Where a step does not get out of the cell it is in, the cell is solved. Behind a
// cell without a hit the next one is looked at at once where the ratio last seen says that a step would not get out of it either.

// A hit that is likely to be nearer than this is looked for in the cell the ray is in.
const BARCHAN_NEAR_TEXELS: f32 = 0.5;

fn barchan_relief_search(ray: BarchanReliefRay, start: BarchanStart) -> BarchanFound {
    let left = barchan_relief_leave(ray, start, BARCHAN_STEP_BACK);
    var fetches = start.fetches + vec2<i32>(left.fetches, 0);
    var depth = left.outside;
    var cell = barchan_relief_cell(ray, depth);
    var takes_sample = depth <= 0.0 || barchan_relief_way_ahead(ray, depth) >= BARCHAN_NEAR_TEXELS;
    var ratio = 0.0;
    for (var turn = 0; turn < BARCHAN_MOST_TURNS; turn++) {
        let exit = barchan_relief_exit(ray, cell, cell + 1, depth);
        if takes_sample {
            fetches.y++;
            let cone = barchan_cone_map_at(barchan_relief_at(ray, depth), 0);
            let next = min(depth + barchan_relief_cone_step(ray, cone.x - depth, cone.y), 1.0);
            ratio = cone.y;
            if next > exit.depth && exit.depth < 1.0 {
                depth = next;
                cell = barchan_relief_cell(ray, next);
                continue;
            }
        }
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
        let gap = barchan_relief_cell_gap(ray, cell, corners, exit.depth);
        depth = exit.depth;
        cell = exit.next;
        takes_sample = depth + barchan_relief_cone_step(ray, gap, ratio) > barchan_relief_exit(ray, cell, cell + 1, depth).depth;
    }
    return BarchanFound(depth, fetches);
}
