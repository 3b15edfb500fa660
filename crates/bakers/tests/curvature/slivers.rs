//! Triangles a million times as long as they are high.

use barchan_field::Mesh;
use barchan_field::surfaces::{ParametricSurface, Pattern, Tessellation};
use glam::DVec2;

use crate::support::{Case, baked, example};

/// A mesh that is being cut: vertices by their parameters on the surface.
struct Cut<'a> {
    surface: &'a ParametricSurface,
    parameters: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
}

impl<'a> Cut<'a> {
    fn new(surface: &'a ParametricSurface, vertices: u32) -> Self {
        let tessellation = Tessellation { vertices, pattern: Pattern::Jittered, seed: 3, uv_seam: false };
        let made = surface.tessellate(&tessellation).unwrap();
        Self { surface, parameters: made.parameters, triangles: made.mesh.triangles().to_vec() }
    }

    /// Cuts a triangle into three about a point of it, `near` its first corner as a part of the way to the middle of the
    /// opposite side, a little off that line.
    fn cut(&mut self, triangle: usize, near: f64) {
        let [a, b, c] = self.triangles[triangle];
        let [from, left, right] = [a, b, c].map(|vertex| self.parameters[vertex as usize]);
        let new = self.parameters.len() as u32;
        self.parameters.push(from + near * (0.7 * (left - from) + 0.3 * (right - from)));
        self.triangles[triangle] = [new, b, c];
        self.triangles.extend([[a, b, new], [a, new, c]]);
    }

    /// Cuts a triangle so that the new vertex is all but on its first side.
    fn graze(&mut self, triangle: usize, height: f64) {
        let [a, b, c] = self.triangles[triangle];
        let [from, to, apex] = [a, b, c].map(|vertex| self.parameters[vertex as usize]);
        let new = self.parameters.len() as u32;
        self.parameters.push(0.5 * (1.0 - height) * (from + to) + height * apex);
        self.triangles[triangle] = [new, c, a];
        self.triangles.extend([[a, b, new], [b, c, new]]);
    }

    fn case(&self) -> Case {
        let jets = || self.parameters.iter().map(|at| self.surface.jet(at.x, at.y));
        let positions = jets().map(|jet| jet.position).collect();
        let mesh = Mesh::new(positions, self.triangles.clone()).unwrap();
        Case { mesh, truth: jets().map(|jet| jet.curvature()).collect() }
    }
}

/// Triangles that do not wrap around in the parameters.
fn whole(cut: &Cut<'_>) -> Vec<usize> {
    let narrow = |corners: &[u32; 3]| {
        let [a, b, c] = corners.map(|vertex| cut.parameters[vertex as usize]);
        a.distance(b).max(b.distance(c)).max(c.distance(a)) < 0.3
    };
    (0..cut.triangles.len()).filter(|&triangle| narrow(&cut.triangles[triangle])).collect()
}

#[track_caller]
fn assert_unharmed(every: usize, cut: impl Fn(&mut Cut<'_>, usize)) {
    for name in ["ellipsoid", "torus", "saddle", "bezier_patch"] {
        let surface = example(name);
        let mut mesh = Cut::new(&surface, 2000);
        let clean = mesh.case().clean();
        for triangle in whole(&mesh).into_iter().step_by(every) {
            cut(&mut mesh, triangle);
        }
        let case = mesh.case();
        let found = case.errors(&baked(&case.mesh));
        assert!(found.rms <= (1.5 * clean.rms).max(4e-5), "{name}: {found:?}, clean {clean:?}");
    }
}

#[test]
fn needles_no_wider_than_the_tolerance_are_welded() {
    assert_unharmed(10, |mesh, triangle| mesh.cut(triangle, 1e-6));
}

#[test]
fn needles_just_wider_than_the_tolerance() {
    assert_unharmed(10, |mesh, triangle| mesh.cut(triangle, 3e-5));
}

#[test]
fn needles_of_a_thousandth() {
    assert_unharmed(10, |mesh, triangle| mesh.cut(triangle, 1e-3));
}

#[test]
fn a_million_times_as_long_as_high() {
    // In a needle 1e-4 wide, a triangle a hundredth as high.
    assert_unharmed(10, |mesh, triangle| {
        mesh.cut(triangle, 1e-4);
        let needle = mesh.triangles.len() - 1;
        mesh.graze(needle, 0.01);
    });
}

#[test]
fn vertices_all_but_on_an_edge() {
    // On a bent surface such a vertex is off the edge by what the edge is off the surface: triangles may stand upright.
    assert_unharmed(10, |mesh, triangle| mesh.graze(triangle, 1e-6));
}
