//! Any smooth P(u, v) over a rectangle.
//!
//! Nearest points and rays start from the best of a grid of samples and are followed by Newton's method to rounding. The
//! grid must be fine enough that the best sample lies in the right basin: a few samples per bend of the surface.

use glam::{DVec2, DVec3};

use super::{BaseSurface, Foot, Ray, SurfacePoint};
use crate::{FundamentalForms, TangentFrame};

/// Newton steps at most; four are usual.
const STEPS: u32 = 40;

/// The part of the domain by which normals are differenced: curvature to some 1e-9 of itself.
const DIFFERENCE: f64 = 1e-5;

/// A surface made of a function of (u, v).
pub struct Patch<P> {
    point: P,
    min: DVec2,
    max: DVec2,
    /// Along u, along v: whether the far edge is the near edge.
    closed: (bool, bool),
    cells: u32,
    /// `(cells + 1)²` samples, row by row from the lowest v.
    samples: Vec<DVec3>,
    bounds: (DVec3, DVec3),
}

impl<P: Fn(DVec2) -> SurfacePoint> Patch<P> {
    /// The surface of `point` over u and v from `min` to `max`, sampled by `cells` (at least 1) cells each way.
    ///
    /// Along a `closed` direction the surface goes on beyond its far edge at its near one, and `point` takes any value.
    #[must_use]
    pub fn new(point: P, (min, max): (DVec2, DVec2), closed: (bool, bool), cells: u32) -> Self {
        let cells = cells.max(1);
        let at = |column: u32, row: u32| {
            let part = DVec2::new(f64::from(column), f64::from(row)) / f64::from(cells);
            point(min + (max - min) * part).position
        };
        let corners = (0..=cells).flat_map(|row| (0..=cells).map(move |column| (column, row)));
        let samples: Vec<_> = corners.map(|(column, row)| at(column, row)).collect();
        let bounds = bounds(&samples, cells);
        Self { point, min, max, closed, cells, samples, bounds }
    }

    /// u and v of the samples' corner.
    fn corner(&self, column: u32, row: u32) -> DVec2 {
        self.min + (self.max - self.min) * DVec2::new(f64::from(column), f64::from(row)) / f64::from(self.cells)
    }

    fn sample(&self, column: u32, row: u32) -> DVec3 {
        self.samples[(row * (self.cells + 1) + column) as usize]
    }

    /// (u, v) within the domain, and whether it had to be moved there.
    fn within(&self, uv: DVec2) -> (DVec2, bool) {
        let x = if self.closed.0 { uv.x } else { uv.x.clamp(self.min.x, self.max.x) };
        let y = if self.closed.1 { uv.y } else { uv.y.clamp(self.min.y, self.max.y) };
        (DVec2::new(x, y), x != uv.x || y != uv.y)
    }

    fn nearest_sample(&self, position: DVec3) -> DVec2 {
        let corners = (0..=self.cells).flat_map(|row| (0..=self.cells).map(move |column| (column, row)));
        let nearest = corners
            .zip(&self.samples)
            .min_by(|(_, a), (_, b)| a.distance_squared(position).total_cmp(&b.distance_squared(position)));
        nearest.map_or(self.min, |((column, row), _)| self.corner(column, row))
    }

    /// Newton's method for the nearest point, from a point nearby.
    fn descend(&self, position: DVec3, start: DVec2) -> (DVec2, bool) {
        let (mut uv, mut outside) = self.within(start);
        let forms = self.forms(uv);
        let resolution = 1e-13 * (self.max - self.min).abs();
        for _ in 0..STEPS {
            let SurfacePoint { position: foot, frame } = (self.point)(uv);
            let away = position - foot;
            let step = newton_step(&forms, &frame, away);
            let (next, moved) = self.within(uv + step);
            outside = moved;
            let change = (next - uv).abs();
            uv = next;
            if change.x <= resolution.x && change.y <= resolution.y {
                break;
            }
        }
        (uv, outside)
    }
}

/// Corners of the samples' box, wider by as much as a surface may bulge out of its cells.
fn bounds(samples: &[DVec3], cells: u32) -> (DVec3, DVec3) {
    let whole = |f: fn(DVec3, DVec3) -> DVec3| samples.iter().copied().reduce(f).unwrap_or(DVec3::ZERO);
    let (low, high) = (whole(DVec3::min), whole(DVec3::max));
    let bulge = (high - low).length() / f64::from(cells);
    (low - bulge, high + bulge)
}

/// The step of (u, v) that brings the foot under a point `away` from it. Towards a centre of curvature, where the distance is
/// no longer convex in (u, v), curvature is left out.
fn newton_step(forms: &FundamentalForms, frame: &TangentFrame, away: DVec3) -> DVec2 {
    let height = away.dot(frame.normal);
    let first = frame.first_form();
    let bent: [f64; 3] = std::array::from_fn(|k| first[k] + height * forms.second[k]);
    let convex = |[e, f, g]: [f64; 3]| e > 0.0 && e * g - f * f > 1e-3 * (first[0] * first[2] - first[1] * first[1]);
    let [e, f, g] = if convex(bent) { bent } else { first };
    let area = e * g - f * f;
    let (u, v) = (away.dot(frame.along_u), away.dot(frame.along_v));
    if area > 0.0 { DVec2::new(g * u - f * v, e * v - f * u) / area } else { DVec2::ZERO }
}

impl<P: Fn(DVec2) -> SurfacePoint> BaseSurface for Patch<P> {
    fn point(&self, uv: DVec2) -> SurfacePoint {
        (self.point)(uv)
    }

    fn forms(&self, uv: DVec2) -> FundamentalForms {
        let frame = (self.point)(uv).frame;
        let reach = (self.max - self.min) * DIFFERENCE;
        let change = |reach: DVec2| {
            let (ahead, behind) = (self.within(uv + reach).0, self.within(uv - reach).0);
            let normals = (self.point)(ahead).frame.normal - (self.point)(behind).frame.normal;
            normals / (ahead - behind).element_sum()
        };
        let (normal_u, normal_v) = (change(DVec2::new(reach.x, 0.0)), change(DVec2::new(0.0, reach.y)));
        let (u, v) = (frame.along_u, frame.along_v);
        let second = [u.dot(normal_u), 0.5 * (u.dot(normal_v) + v.dot(normal_u)), v.dot(normal_v)];
        FundamentalForms { first: frame.first_form(), second }
    }

    fn foot(&self, position: DVec3, near: Option<DVec2>) -> Foot {
        let start = near.unwrap_or_else(|| self.nearest_sample(position));
        let (uv, beyond_edge) = self.descend(position, start);
        let SurfacePoint { position: foot, frame } = (self.point)(uv);
        let away = position - foot;
        Foot { uv, height: if beyond_edge { away.length() } else { away.dot(frame.normal) }, beyond_edge }
    }

    fn escapes(&self, ray: &Ray, height: f64) -> bool {
        let (low, high) = (self.bounds.0 - height.max(0.0), self.bounds.1 + height.max(0.0));
        let (mut enters, mut leaves) = (0.0_f64, f64::INFINITY);
        for axis in 0..3 {
            let (origin, direction) = (ray.origin[axis], ray.direction[axis]);
            if direction == 0.0 {
                if origin < low[axis] || origin > high[axis] {
                    return true;
                }
                continue;
            }
            let (a, b) = ((low[axis] - origin) / direction, (high[axis] - origin) / direction);
            (enters, leaves) = (enters.max(a.min(b)), leaves.min(a.max(b)));
        }
        enters > leaves
    }

    fn hit(&self, ray: &Ray) -> Option<DVec2> {
        let front = self.triangles().filter_map(|corners| {
            let triangle = corners.map(|(column, row)| self.sample(column, row));
            let (distance, weights) = triangle_hit(ray, triangle)?;
            let [a, b, c] = corners.map(|(column, row)| self.corner(column, row));
            let uv = a * weights[0] + b * weights[1] + c * weights[2];
            ((self.point)(uv).frame.normal.dot(ray.direction) < 0.0).then_some((distance, uv))
        });
        let nearest = front.min_by(|(a, _), (b, _)| a.total_cmp(b));
        nearest.map(|(_, uv)| self.polish_hit(ray, uv))
    }
}

impl<P: Fn(DVec2) -> SurfacePoint> Patch<P> {
    /// The corners, as column and row, of the triangles between the samples.
    fn triangles(&self) -> impl Iterator<Item = [(u32, u32); 3]> {
        let halves = [[(0, 0), (1, 0), (1, 1)], [(0, 0), (1, 1), (0, 1)]];
        let cells = (0..self.cells).flat_map(|row| (0..self.cells).map(move |column| (column, row)));
        cells.flat_map(move |(column, row)| halves.map(|half| half.map(|(i, j)| (column + i, row + j))))
    }

    /// Newton's method for a hit, from that on the samples' triangles; where it leads away, at a silhouette, that one stays.
    fn polish_hit(&self, ray: &Ray, start: DVec2) -> DVec2 {
        let cell = (self.max - self.min).abs() / f64::from(self.cells);
        let mut uv = start;
        for _ in 0..STEPS {
            let SurfacePoint { position, frame } = (self.point)(uv);
            let facing = frame.normal.dot(ray.direction);
            if facing >= 0.0 {
                return start;
            }
            let distance = (position - ray.origin).dot(frame.normal) / facing;
            let step = frame.texture_step(ray.at(distance) - position);
            uv = self.within(uv + step).0;
            let strayed = (uv - start).abs();
            if strayed.x > 2.0 * cell.x || strayed.y > 2.0 * cell.y {
                return start;
            }
            if step.abs().max_element() <= 1e-14 * cell.max_element() {
                break;
            }
        }
        uv
    }
}

/// Where a ray meets a triangle from either side: how far, and the barycentric coordinates.
fn triangle_hit(ray: &Ray, [a, b, c]: [DVec3; 3]) -> Option<(f64, [f64; 3])> {
    let (along_b, along_c) = (b - a, c - a);
    let across = ray.direction.cross(along_c);
    let volume = along_b.dot(across);
    if volume == 0.0 {
        return None;
    }
    let from_a = ray.origin - a;
    let weight_b = from_a.dot(across) / volume;
    let up = from_a.cross(along_b);
    let weight_c = ray.direction.dot(up) / volume;
    let distance = along_c.dot(up) / volume;
    let weights = [1.0 - weight_b - weight_c, weight_b, weight_c];
    (distance >= 0.0 && weights.iter().all(|&weight| weight >= 0.0)).then_some((distance, weights))
}
