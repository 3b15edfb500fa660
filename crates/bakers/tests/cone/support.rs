//! Reliefs, the filtered map, and rays that are walked by it.

use barchan_bakers::Exec;
use barchan_bakers::cone::{self, ConeKind, ConeMap};
use barchan_field::{Edge, Grid, HeightField};

pub(crate) use crate::fields::{fill, grid};
pub(crate) use crate::random::noise;

pub(crate) const EDGES: [Edge; 2] = [Edge::Wrap, Edge::Clamp];

/// Square texels, and texels neither square nor of a length that is a power of two.
pub(crate) const SPACINGS: [(f64, f64); 2] = [(1.0, 1.0), (0.7, 1.9)];

/// The reliefs that every promise is held against.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Relief {
    /// Single texels that stand out of level ground.
    Spikes,
    /// Blocks with level tops.
    Walls,
    /// Every texel for itself.
    Noise,
    /// Hills of a few texels.
    Smooth,
    /// A ramp, where every ascent is as steep as any other.
    Ramp,
}

impl Relief {
    pub(crate) const ALL: [Self; 5] = [Self::Spikes, Self::Walls, Self::Noise, Self::Smooth, Self::Ramp];

    pub(crate) fn field(self, grid: Grid) -> HeightField {
        let (across, down) = (std::f32::consts::TAU / grid.width as f32, std::f32::consts::TAU / grid.height as f32);
        fill(grid, |column, row| match self {
            Self::Spikes => {
                if noise(3, column, row) < 0.03 {
                    2.0 + 6.0 * noise(4, column, row)
                } else {
                    0.0
                }
            }
            Self::Walls => 5.0 * (3.0 * noise(5, column / 4, row / 5)).floor(),
            Self::Noise => 4.0 * noise(6, column, row),
            Self::Smooth => {
                3.0 * ((2.0 * across * column as f32).sin() + (down * row as f32).cos())
                    + 0.3 * (3.0 * across * column as f32 + down * row as f32).sin()
            }
            Self::Ramp => 0.5 * column as f32 - 0.25 * row as f32,
        })
    }
}

/// Every relief with every edge policy and kind of texel.
pub(crate) fn fields(size: (u32, u32)) -> impl Iterator<Item = (Relief, HeightField)> {
    let grids = EDGES.into_iter().flat_map(move |edge| SPACINGS.map(|spacing| grid(size, spacing, edge)));
    grids.flat_map(|grid| Relief::ALL.map(|relief| (relief, relief.field(grid))))
}

pub(crate) fn bake(field: &HeightField, kind: ConeKind) -> ConeMap {
    cone::bake(field, kind, &Exec::new(1).unwrap()).unwrap()
}

/// A stream of numbers in [0, 1).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64) / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, least: f64, most: f64) -> f64 {
        least + (most - least) * self.next()
    }
}

/// Depth and ratio at a place, in texels from the centre of the first, as a bilinear filter makes them.
pub(crate) fn filtered(map: &ConeMap, x: f64, y: f64) -> (f64, f64) {
    let (column, row) = (x.floor(), y.floor());
    let (fx, fy) = (x - column, y - row);
    let Grid { width, height, edge, .. } = map.grid;
    let texel = |i: i64, j: i64| {
        let (column, row) = (edge.resolve(column as i64 + i, width), edge.resolve(row as i64 + j, height));
        (f64::from(map.depth(column as u32, row as u32)), f64::from(map.ratio(column as u32, row as u32)))
    };
    let corners = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| {
        let weight = (if i == 0 { 1.0 - fx } else { fx }) * (if j == 0 { 1.0 - fy } else { fy });
        let (depth, ratio) = texel(i, j);
        (weight * depth, weight * ratio)
    });
    corners.into_iter().fold((0.0, 0.0), |sum, corner| (sum.0 + corner.0, sum.1 + corner.1))
}

/// A ray downwards from the top plane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Ray {
    /// Where it enters, in texels from the centre of the first.
    pub(crate) start: [f64; 2],
    /// What it advances while its depth grows by 1, in texels.
    pub(crate) advance: [f64; 2],
    /// Horizontal length for each length that it sinks.
    pub(crate) tangent: f64,
}

impl Ray {
    pub(crate) fn random(map: &ConeMap, random: &mut Random) -> Self {
        let Grid { width, height, spacing, .. } = map.grid;
        let start = [width, height].map(|texels| random.between(0.0, f64::from(texels) - 1.0));
        let (tangent, azimuth) =
            (random.between(0.0, 80.0).to_radians().tan(), random.between(0.0, std::f64::consts::TAU));
        let length = tangent * map.relief.thickness;
        let advance = [length * azimuth.cos() / spacing.u(), -length * azimuth.sin() / spacing.v()];
        Self { start, advance, tangent }
    }

    pub(crate) fn at(&self, depth: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.start[axis] + depth * self.advance[axis])
    }

    /// The depth after one cone step.
    pub(crate) fn step(&self, map: &ConeMap, depth: f64) -> f64 {
        let [x, y] = self.at(depth);
        let (surface, ratio) = filtered(map, x, y);
        // Where neither goes anywhere, the ray is upright and so is the wall.
        if ratio + self.tangent > 0.0 {
            depth + ratio * (surface - depth).max(0.0) / (self.tangent + ratio)
        } else {
            depth
        }
    }

    /// How much the surface is below the ray where it is so least, from one depth to another; exact, the surface along a
    /// ray being a parabola in every cell. In depths.
    pub(crate) fn least_clearance(&self, field: &HeightField, map: &ConeMap, from: f64, to: f64) -> f64 {
        let clearance = |depth: f64| {
            let [x, y] = self.at(depth);
            map.relief.depth(field.surface(x, y)) - depth
        };
        let mut depths = vec![from, to];
        for axis in 0..2 {
            let (a, b) = (self.at(from)[axis], self.at(to)[axis]);
            let crossings = (a.min(b).ceil() as i64)..=(a.max(b).floor() as i64);
            depths.extend(crossings.map(|line| (line as f64 - self.start[axis]) / self.advance[axis]));
        }
        depths.retain(|depth| (from..=to).contains(depth));
        depths.sort_by(f64::total_cmp);
        let pieces = depths.windows(2).map(|ends| {
            let [first, middle, last] = [ends[0], 0.5 * (ends[0] + ends[1]), ends[1]].map(clearance);
            lowest_of_parabola(first, middle, last)
        });
        pieces.fold(clearance(from), f64::min)
    }
}

/// The lowest value between the ends of the parabola through three evenly spaced values.
fn lowest_of_parabola(first: f64, middle: f64, last: f64) -> f64 {
    let (slope, bend) = (last - first, first - 2.0 * middle + last);
    let ends = first.min(last);
    if bend > 0.0 && slope.abs() < 2.0 * bend { ends.min(middle - slope * slope / (8.0 * bend)) } else { ends }
}
