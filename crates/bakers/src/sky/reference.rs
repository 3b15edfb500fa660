//! The obvious twin: rays, evenly spread over the hemisphere and walked through the surface in f64.
//!
//! It shares no step with the fast baker: not its horizons, not its integrals, not its slopes. A ray is walked cell
//! by cell; inside a bilinear cell the surface along it is a parabola, found from three of its points, and so is its
//! rise above the ray.

use barchan_field::HeightField;

use super::ground::normal;

/// How many rays a texel sends out: `rings` of equal solid angle, `rays` in each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RayCount {
    /// Rings between the horizontal and the zenith.
    pub rings: u32,
    /// Rays in a ring.
    pub rays: u32,
}

/// The sky of one texel; vectors are in (u, v, height) and of unit length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkyPoint {
    /// Cosine-weighted visibility.
    pub visibility: f64,
    /// Cosine-weighted mean direction of the sky; the normal where there is none.
    pub bent_normal: [f64; 3],
    /// Mean direction of the sky; the normal where there is none.
    pub cone_axis: [f64; 3],
    /// Cosine of the half-angle of the cap of the sky's solid angle.
    pub cos_half_angle: f64,
}

/// The sky of a texel by rays of length `radius`, measured along the base plane in the field's length unit.
///
/// 64 rings of 256 rays leave 3 × 10⁻⁴ in the visibility of rough relief. `radius` is what the horizons' was; the
/// texel must lie in the field.
#[must_use]
pub fn sky(field: &HeightField, radius: f64, (column, row): (u32, u32), count: RayCount) -> SkyPoint {
    let normal = normal_at(field, i64::from(column), i64::from(row));
    let (mut open, mut mean, mut cosines, mut weighted) = (0_u32, [0.0; 3], 0.0, [0.0; 3]);
    for ray in directions(count) {
        let facing: f64 = (0..3).map(|axis| normal[axis] * ray[axis]).sum();
        if facing > 0.0 && !is_blocked(field, radius, (column, row), ray) {
            open += 1;
            cosines += facing;
            for axis in 0..3 {
                mean[axis] += ray[axis];
                weighted[axis] += facing * ray[axis];
            }
        }
    }
    let hemisphere = f64::from(count.rings) * f64::from(count.rays);
    SkyPoint {
        visibility: 2.0 * cosines / hemisphere,
        bent_normal: unit(weighted).unwrap_or(normal),
        cone_axis: unit(mean).unwrap_or(normal),
        cos_half_angle: 1.0 - f64::from(open) / hemisphere,
    }
}

/// The centres of cells of equal solid angle. Each ring is turned by the golden ratio of a cell against the one
/// below, so that no straight edge of the relief lies along the rays of all.
fn directions(RayCount { rings, rays }: RayCount) -> impl Iterator<Item = [f64; 3]> {
    let golden = 0.618_033_988_749_894_9;
    (0..rings).flat_map(move |ring| {
        let sin = (f64::from(ring) + 0.5) / f64::from(rings);
        let cos = (1.0 - sin * sin).sqrt();
        let turn = (f64::from(ring) * golden).fract();
        (0..rays).map(move |ray| {
            let azimuth = std::f64::consts::TAU * (f64::from(ray) + turn) / f64::from(rays);
            [cos * libm::cos(azimuth), cos * libm::sin(azimuth), sin]
        })
    })
}

/// Does a ray from a texel's centre, `direction` a unit vector that rises, meet the surface within the radius?
fn is_blocked(field: &HeightField, radius: f64, (column, row): (u32, u32), [u, v, up]: [f64; 3]) -> bool {
    let spacing = field.grid().spacing;
    let run = libm::hypot(u, v);
    let (columns, rows, slope) = (u / run / spacing.u(), -v / run / spacing.v(), up / run);
    let origin = (f64::from(column), f64::from(row));
    let origin_height = f64::from(field.texel(i64::from(column), i64::from(row)));
    let highest = f64::from(field.range().1);
    let above_ray = |s: f64| field.surface(origin.0 + s * columns, origin.1 + s * rows) - origin_height - slope * s;
    let (mut start, mut start_above, mut column_crossings, mut row_crossings) = (0.0, 0.0, 1.0, 1.0);
    while start < radius && origin_height + slope * start <= highest {
        let (to_column, to_row) = (column_crossings / columns.abs(), row_crossings / rows.abs());
        let end = to_column.min(to_row).min(radius);
        let end_above = above_ray(end);
        if highest_of_parabola(start_above, above_ray(0.5 * (start + end)), end_above) > 0.0 {
            return true;
        }
        column_crossings += f64::from(u8::from(to_column <= end));
        row_crossings += f64::from(u8::from(to_row <= end));
        (start, start_above) = (end, end_above);
    }
    false
}

/// The highest value between the ends of the parabola through three evenly spaced values.
fn highest_of_parabola(first: f64, middle: f64, last: f64) -> f64 {
    let (slope, bend) = (last - first, first - 2.0 * middle + last);
    let ends = first.max(last);
    // The vertex lies at slope/(2 bend) half intervals before the middle.
    if bend < 0.0 && slope.abs() < -2.0 * bend { ends.max(middle - slope * slope / (8.0 * bend)) } else { ends }
}

fn normal_at(field: &HeightField, column: i64, row: i64) -> [f64; 3] {
    let spacing = field.grid().spacing;
    let height = |column: i64, row: i64| f64::from(field.texel(column, row));
    normal(
        (height(column + 1, row) - height(column - 1, row)) / (2.0 * spacing.u()),
        (height(column, row - 1) - height(column, row + 1)) / (2.0 * spacing.v()),
    )
}

fn unit(vector: [f64; 3]) -> Option<[f64; 3]> {
    let length = vector.iter().map(|component| component * component).sum::<f64>().sqrt();
    (length > 0.0).then(|| vector.map(|component| component / length))
}
