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
