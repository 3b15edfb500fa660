//! Surfaces in closed form, their exact curvature, and meshes of them.

use barchan_asset::VertexFlags;
use barchan_bakers::Exec;
use barchan_bakers::curvature::{MeshCurvature, MeshReport, VertexCurvature, VertexForms, forms};
use barchan_field::Mesh;
use glam::{DVec2, DVec3};

/// A point with its derivatives by (u, v).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Jet {
    pub(crate) point: DVec3,
    pub(crate) du: DVec3,
    pub(crate) dv: DVec3,
    pub(crate) duu: DVec3,
    pub(crate) duv: DVec3,
    pub(crate) dvv: DVec3,
}

impl Jet {
    pub(crate) fn normal(&self) -> DVec3 {
        self.du.cross(self.dv).normalize()
    }

    pub(crate) fn first(&self) -> [f64; 3] {
        [self.du.dot(self.du), self.du.dot(self.dv), self.dv.dot(self.dv)]
    }

    /// Positive where convex.
    pub(crate) fn second(&self) -> [f64; 3] {
        [self.duu, self.duv, self.dvv].map(|second| -second.dot(self.normal()))
    }

    /// Principal curvatures and directions, by diagonalising the second form in an orthonormal frame.
    pub(crate) fn curvature(&self) -> VertexCurvature {
        let normal = self.normal();
        let x = self.du.normalize();
        let y = normal.cross(x);
        // (du, dv) of the unit tangents x and y.
        let (length, slant, height) = (self.du.length(), self.dv.dot(x), self.dv.dot(y));
        let [ux, uy] = [DVec2::new(1.0 / length, 0.0), DVec2::new(-slant / (length * height), 1.0 / height)];
        let [e, f, g] = self.second();
        let form = |a: DVec2, b: DVec2| e * a.x * b.x + f * (a.x * b.y + a.y * b.x) + g * a.y * b.y;
        let (xx, xy, yy) = (form(ux, ux), form(ux, uy), form(uy, uy));
        let (mean, half) = (0.5 * (xx + yy), DVec2::new(0.5 * (xx - yy), xy));
        let angle = 0.5 * half.y.atan2(half.x);
        let first = x * angle.cos() + y * angle.sin();
        VertexCurvature {
            principal: [mean + half.length(), mean - half.length()],
            directions: [first, normal.cross(first)],
            normal,
            flags: VertexFlags::NONE,
        }
    }
}

pub(crate) fn cylinder(u: f64, v: f64) -> Jet {
    let (sin, cos) = u.sin_cos();
    Jet {
        point: DVec3::new(2.0 * cos, 2.0 * sin, 3.0 * v),
        du: DVec3::new(-2.0 * sin, 2.0 * cos, 0.0),
        dv: DVec3::Z * 3.0,
        duu: DVec3::new(-2.0 * cos, -2.0 * sin, 0.0),
        duv: DVec3::ZERO,
        dvv: DVec3::ZERO,
    }
}

/// Around the equator of the unit sphere: v is the latitude.
pub(crate) fn sphere(u: f64, v: f64) -> Jet {
    let v = v - 0.5;
    let ((su, cu), (sv, cv)) = (u.sin_cos(), v.sin_cos());
    Jet {
        point: DVec3::new(cu * cv, su * cv, sv),
        du: DVec3::new(-su * cv, cu * cv, 0.0),
        dv: DVec3::new(-cu * sv, -su * sv, cv),
        duu: DVec3::new(-cu * cv, -su * cv, 0.0),
        duv: DVec3::new(su * sv, -cu * sv, 0.0),
        dvv: DVec3::new(-cu * cv, -su * cv, -sv),
    }
}

/// A sheared polynomial patch that bends either way.
pub(crate) fn patch(u: f64, v: f64) -> Jet {
    Jet {
        point: DVec3::new(u + 0.6 * v + 0.1 * v * v, 0.8 * v + 0.2 * u * v, 0.5 * u * u - 0.4 * u * v * v + 0.3 * v),
        du: DVec3::new(1.0, 0.2 * v, u - 0.4 * v * v),
        dv: DVec3::new(0.6 + 0.2 * v, 0.8 + 0.2 * u, -0.8 * u * v + 0.3),
        duu: DVec3::Z,
        duv: DVec3::new(0.0, 0.2, -0.8 * v),
        dvv: DVec3::new(0.2, 0.0, -0.8 * u),
    }
}

/// A mesh of a surface over the unit square, its vertices moved at random by up to a quarter of their distance, with exact curvature.
pub(crate) struct Case {
    pub(crate) mesh: Mesh,
    pub(crate) jets: Vec<Jet>,
    pub(crate) curvature: MeshCurvature,
}

impl Case {
    pub(crate) fn of(surface: fn(f64, f64) -> Jet, quads: u32) -> Self {
        let mut uvs = Vec::new();
        for row in 0..=quads {
            for column in 0..=quads {
                let shift = |index: u32, salt| match index {
                    0 => 0.0,
                    _ if index == quads => 0.0,
                    _ => noise(row * 1009 + column, salt) * 0.5 - 0.25,
                };
                let at = |index: u32, salt| (f64::from(index) + shift(index, salt)) / f64::from(quads);
                uvs.push(DVec2::new(at(column, 1), at(row, 2)));
            }
        }
        let mut triangles = Vec::new();
        for row in 0..quads {
            for column in 0..quads {
                let a = row * (quads + 1) + column;
                let [b, c, d] = [a + 1, a + quads + 2, a + quads + 1];
                let pair = if noise(a, 3) < 0.5 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
                triangles.extend(pair);
            }
        }
        let jets: Vec<Jet> = uvs.iter().map(|uv| surface(uv.x, uv.y)).collect();
        let positions = jets.iter().map(|jet| jet.point).collect();
        let mesh = Mesh::new(positions, triangles).unwrap().with_uvs(uvs).unwrap();
        let curvature = curvature(jets.iter().map(Jet::curvature).collect());
        Self { mesh, jets, curvature }
    }

    pub(crate) fn forms(&self) -> Vec<VertexForms> {
        forms(&self.mesh, &self.curvature, &Exec::new(1).unwrap()).unwrap()
    }

    /// The same surface with other texture coordinates.
    pub(crate) fn with_uvs(&self, uv: impl Fn(DVec2) -> DVec2) -> Self {
        let uvs = self.mesh.uvs().unwrap().iter().map(|&at| uv(at)).collect();
        let mesh = self.mesh.clone().with_uvs(uvs).unwrap();
        Self { mesh, jets: self.jets.clone(), curvature: self.curvature.clone() }
    }
}

/// Curvature of a mesh of which nothing else is of interest.
pub(crate) fn curvature(vertices: Vec<VertexCurvature>) -> MeshCurvature {
    MeshCurvature { vertices, report: MeshReport::default(), noise: 0.0 }
}

/// From 0 to 1, the same every time.
pub(crate) fn noise(index: u32, salt: u32) -> f64 {
    let mixed = index.wrapping_mul(0x9E37_79B1) ^ salt.wrapping_mul(0x85EB_CA77);
    let mixed = (mixed ^ mixed >> 15).wrapping_mul(0x2C1B_3C6D);
    f64::from((mixed ^ mixed >> 12).wrapping_mul(0x297A_2D39) >> 8) / f64::from(1 << 24)
}

/// The largest difference of two forms, over the largest of their numbers.
pub(crate) fn difference(found: [f64; 3], expected: [f64; 3]) -> f64 {
    let size = expected.map(f64::abs).into_iter().fold(0.0, f64::max);
    (0..3).map(|index| (found[index] - expected[index]).abs() / size).fold(0.0, f64::max)
}
