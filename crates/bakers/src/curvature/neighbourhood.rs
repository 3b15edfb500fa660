//! The points around a point, nearest first come.
//!
//! Points are found along edges, ring by ring, so that two sides of a thin shell never meet; of what is found the nearest are kept. Where
//! triangles are long and thin in one direction, near means near in the neighbourhood's own ellipse: else all would lie on one line.

use glam::DVec3;

use super::frame::Frame;
use super::sheets::Sheets;
use super::sphere::Sphere;

/// How much longer than wide a neighbourhood must be before distances are measured in an ellipse.
const ELONGATED: f64 = 1.4;
/// The ellipse is this power of what the neighbours' own is, in long over short, up to [`MOST_ELONGATED`]: a jet wants as many rows as its
/// degree, and the rows of triangles that are long and thin are far apart. Of 0.4, 0.6, 0.8 and 1 and of bounds from 3.3 to none the best on
/// grids of aspect up to 4 and random meshes of aspect 20.
const LESS_ELONGATED: f64 = 0.7;
const MOST_ELONGATED: f64 = 3.3;
/// As rings are longer than that ellipse, so many times the neighbours are looked at.
const LOOKED_AT: usize = 3;
/// How many neighbours of one point are followed: a hub of a fan has 100 000.
const MAX_FOLLOWED: usize = 64;

/// How far round the sphere that is flattened neighbours may lie: radii.
const MOST_BENT: f64 = 1.2;
/// Neighbours whose normals turn away farther, as a cosine, are on another side of the body.
const TURNED_AWAY: f64 = 0.35;
/// With fewer on this side the body has no sides to speak of: all count.
const LEAST_ON_THIS_SIDE: usize = 5;

/// A neighbour in the frame of the centre, in lengths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Neighbour {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) z: f64,
    /// (x, y) in units of the neighbourhood's ellipse, squared.
    pub(super) squared_distance: f64,
}

/// Finds neighbourhoods; keeps its memory from one to the next.
#[derive(Debug)]
pub(super) struct Gatherer<'a> {
    sheets: &'a Sheets,
    visits: Vec<u32>,
    visit: u32,
    found: Vec<u32>,
    /// The nearest points of the last neighbourhood, in no order; the centre is not among them.
    pub(super) neighbours: Vec<Neighbour>,
    /// Half axes of the neighbourhood along x and y: that of the farthest neighbour. Equal unless it is elongated.
    pub(super) extent: [f64; 2],
    /// The curvature that was taken out of the neighbours by [`flatten`](Self::flatten).
    pub(super) flattened: f64,
}

impl<'a> Gatherer<'a> {
    pub(super) fn new(sheets: &'a Sheets) -> Self {
        let visits = vec![0; sheets.positions.len()];
        Self { sheets, visits, visit: 0, found: Vec::new(), neighbours: Vec::new(), extent: [1.0; 2], flattened: 0.0 }
    }

    /// Gathers the `count` nearest neighbours of a point, or as many as there are, and returns the frame they are in.
    pub(super) fn gather(&mut self, centre: usize, count: usize) -> Frame {
        self.collect(centre, count + count / 4);
        let mut frame = Frame::with_normal(self.sheets.positions[centre], self.steady_normal(centre));
        let axes = self.axes(&frame);
        let [long, short] = [axes.lengths[0], axes.lengths[1].max(1e-9 * axes.lengths[0])];
        let mut scale = [1.0; 2];
        if long > ELONGATED * short {
            self.collect(centre, LOOKED_AT * count);
            frame = frame.turned(axes.direction);
            scale = [1.0, libm::pow(long / short, LESS_ELONGATED).min(MOST_ELONGATED)];
        }
        self.measure(&frame, scale);
        self.keep_nearest(count);
        let farthest = self.neighbours.iter().fold(0.0_f64, |most, near| most.max(near.squared_distance));
        let radius = if farthest > 0.0 { farthest.sqrt() } else { 1.0 };
        self.extent = [radius / scale[0], radius / scale[1]];
        for neighbour in &mut self.neighbours {
            neighbour.squared_distance /= radius * radius;
        }
        let sphere = Sphere::along(&self.neighbours);
        let frame = self.lean(&frame, sphere.slope);
        self.flatten(sphere.curvature);
        frame
    }

    /// Turns the frame until its normal is the sphere's: the normal of slivers along a border can be far off.
    fn lean(&mut self, frame: &Frame, [p, q]: [f64; 2]) -> Frame {
        let normal = (frame.normal - frame.x * p - frame.y * q).normalize();
        // So steep that nothing is left of x: the frame stays as it is.
        let Some(x) = (frame.x - normal * frame.x.dot(normal)).try_normalize() else { return *frame };
        let leant = Frame { origin: frame.origin, x, y: normal.cross(x), normal };
        let rows =
            [leant.x, leant.y, leant.normal].map(|axis| [frame.x, frame.y, frame.normal].map(|old| axis.dot(old)));
        for near in &mut self.neighbours {
            let [x, y, z] = rows.map(|[a, b, c]| a * near.x + b * near.y + c * near.z);
            (near.x, near.y, near.z) = (x, y, z);
        }
        leant
    }

    /// Bends space so that the sphere that follows the neighbours best becomes a plane: what is left is nearer to a polynomial.
    ///
    /// p′ = (p − b p²) / (1 − 2 b·p + b² p²), b = −½ κ₀ along the normal, is conformal and the identity to first order at the centre,
    /// so that it takes κ₀ from every normal curvature there and changes nothing else.
    fn flatten(&mut self, mean: f64) {
        let farthest = self.neighbours.iter().map(|near| near.x * near.x + near.y * near.y + near.z * near.z);
        let farthest = farthest.fold(0.0, f64::max).sqrt();
        // The far side of the sphere, at distance 2 / κ₀, goes to infinity.
        let limit = MOST_BENT / farthest.max(f64::MIN_POSITIVE);
        let bend = mean.clamp(-limit, limit);
        for near in &mut self.neighbours {
            let squared = near.x * near.x + near.y * near.y + near.z * near.z;
            let stretch = 1.0 / (1.0 + bend * near.z + 0.25 * bend * bend * squared);
            near.x *= stretch;
            near.y *= stretch;
            near.z = (near.z + 0.5 * bend * squared) * stretch;
        }
        self.flattened = bend;
    }

    /// A normal that no single sliver can turn: half the point's own, half its neighbours'.
    fn steady_normal(&self, centre: usize) -> DVec3 {
        let Sheets { normals, .. } = self.sheets;
        let around = self.sheets.around(centre);
        let others: DVec3 = around.iter().take(MAX_FOLLOWED).map(|&next| normals[next as usize]).sum();
        let count = around.len().min(MAX_FOLLOWED) as f64;
        (others + normals[centre] * (0.5 * count)).try_normalize().unwrap_or(normals[centre])
    }

    /// Whole rings, until there are at least `enough` points.
    fn collect(&mut self, centre: usize, enough: usize) {
        self.visit += 1;
        self.found.clear();
        self.visits[centre] = self.visit;
        self.follow(centre);
        let mut ring = 0..self.found.len();
        while self.found.len() < enough && !ring.is_empty() {
            for index in ring.clone() {
                // Among hubs a ring can be many times what is needed.
                if self.found.len() < 4 * enough {
                    self.follow(self.found[index] as usize);
                }
            }
            ring = ring.end..self.found.len();
        }
    }

    /// Adds the neighbours of a point that are not there yet; of too many, evenly spread ones.
    fn follow(&mut self, point: usize) {
        let around = self.sheets.around(point);
        for &next in around.iter().step_by(around.len().div_ceil(MAX_FOLLOWED).max(1)) {
            let visits = &mut self.visits[next as usize];
            if *visits != self.visit {
                *visits = self.visit;
                self.found.push(next);
            }
        }
    }

    /// The principal axes of what was found, as standard deviations.
    fn axes(&self, frame: &Frame) -> Axes {
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for &point in &self.found {
            let offset = self.sheets.positions[point as usize] - frame.origin;
            let (x, y) = (offset.dot(frame.x), offset.dot(frame.y));
            xx += x * x;
            xy += x * y;
            yy += y * y;
        }
        let count = (self.found.len() as f64).max(1.0);
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let spread = (half * half + xy * xy).sqrt();
        let lengths = [mean + spread, (mean - spread).max(0.0)].map(|variance| (variance / count).sqrt());
        // Of the two forms of the eigenvector, the one that does not cancel.
        let direction = if half > 0.0 { [half + spread, xy] } else { [xy, spread - half] };
        Axes { lengths, direction }
    }

    fn measure(&mut self, frame: &Frame, scale: [f64; 2]) {
        let Sheets { positions, normals, .. } = self.sheets;
        let on_this_side = |point: u32| {
            let normal = normals[point as usize];
            normal == DVec3::ZERO || normal.dot(frame.normal) > TURNED_AWAY
        };
        let has_sides = self.found.iter().filter(|&&point| on_this_side(point)).count() >= LEAST_ON_THIS_SIDE;
        self.neighbours.clear();
        let counting = self.found.iter().filter(|&&point| !has_sides || on_this_side(point));
        self.neighbours.extend(counting.map(|&point| {
            let offset: DVec3 = positions[point as usize] - frame.origin;
            let (x, y, z) = (offset.dot(frame.x), offset.dot(frame.y), offset.dot(frame.normal));
            let (across, up) = (x * scale[0], y * scale[1]);
            Neighbour { x, y, z, squared_distance: across * across + up * up + z * z * scale[0] * scale[0] }
        }));
    }

    fn keep_nearest(&mut self, count: usize) {
        if self.neighbours.len() > count {
            // A stable rule for ties: the order in which they were found is that of the mesh.
            self.neighbours.select_nth_unstable_by(count, |a, b| a.squared_distance.total_cmp(&b.squared_distance));
            self.neighbours.truncate(count);
        }
    }
}

/// The longer axis first.
struct Axes {
    lengths: [f64; 2],
    /// Along the longer, of any length.
    direction: [f64; 2],
}
