//! Triangle meshes of closed-form surfaces.
//!
//! # Method
//!
//! Points lie on lines of equal v, the lines one spacing apart and the points one spacing apart along them, both measured on the
//! surface (`metric`, `layout`, `points`). They are joined by a Delaunay triangulation in a plane chart whose metric is nearly
//! that of the surface up to scale: exactly so (conformal) for surfaces of revolution and the helicoid, on average over u for the others.
//! What is closed is tiled in the chart (`flat`). A sphere's chart is the stereographic projection from one of its vertices, so its
//! triangles are those of the convex hull, and an ellipsoid's are those of the sphere it is stretched from (`polar`). Every mesh is
//! tested to be a manifold of its surface's kind before it is handed out (`soundness`).
//!
//! # Conventions
//!
//! Vertices lie on the surface to f64's precision, borders are followed by vertices, and triangles run counter-clockwise seen from the
//! front. Spheres and ellipsoids have a vertex at a millionth of v from each pole, where (u, v) still say everything.

mod delaunay;
mod flat;
mod grid;
mod layout;
mod metric;
mod points;
mod polar;
mod seam;
mod soundness;

use glam::DVec2;
use serde::{Deserialize, Serialize};

use self::layout::{Ends, Layout};
use self::metric::Metric;
use super::ParametricSurface;
use super::random::Random;
use crate::shapes::check::Check;
use crate::{FieldError, Mesh};

/// v of the vertex that stands for the south pole.
const POLE: f64 = 1e-6;

/// How a surface is cut into triangles.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tessellation {
    /// Roughly how many vertices, those on a seam counted once; 16 to 4194304.
    pub vertices: u32,
    /// How they lie.
    pub pattern: Pattern,
    /// What the random patterns draw from.
    #[serde(default)]
    pub seed: u64,
    /// On a surface that is closed in u or v: cut the mesh open along a seam there, so that it has texture coordinates. They run a
    /// little beyond 1 at the seam, and the vertices there are repeated. Otherwise such a mesh is whole, with one vertex per
    /// point, and has none. Meshes of open surfaces always have texture coordinates and no seam.
    #[serde(default)]
    pub uv_seam: bool,
}

/// How vertices lie and are joined. Aspects, 1 to 1000, are long over short side. The long side runs along v, whose lines are geodesics
/// on surfaces of revolution and the helicoid: along others, as around a torus, long triangles would fold over.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub enum Pattern {
    /// A grid with even steps of u and v, its cells cut by parallel diagonals. Even in the parameters, not in area.
    Regular {
        /// Mean sides of a cell.
        aspect: f64,
    },
    /// One point in the middle 80 % of each cell of an even tiling, then Delaunay.
    Jittered,
    /// Points spread evenly by area without regard for each other, then Delaunay. Slivers are included, and of those along a border that
    /// bends a few may be folded over.
    Random,
    /// As jittered, but on a surface that is shortened along v and then drawn out again: long thin triangles.
    LongThin {
        /// By how much.
        aspect: f64,
    },
}

/// A mesh and where its vertices lie on the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct TessellatedSurface {
    /// The mesh; texture coordinates, if any, are (u, v), running beyond 1 where a seam is crossed.
    pub mesh: Mesh,
    /// (u, v) from 0 to 1 of every vertex of the mesh, in its order: the truth there is [`ParametricSurface::jet`].
    pub parameters: Vec<DVec2>,
}

/// Vertices by their parameters, and triangles between them, counter-clockwise seen from the front.
struct Connected {
    parameters: Vec<DVec2>,
    triangles: Vec<[u32; 3]>,
}

impl ParametricSurface {
    /// A mesh of the surface. The same bits everywhere for the same surface and tessellation.
    ///
    /// # Errors
    /// Parameters of the surface or the tessellation that are out of range, or so few vertices, or so long triangles, that the surface's
    /// shape is lost.
    pub fn tessellate(&self, tessellation: &Tessellation) -> Result<TessellatedSurface, FieldError> {
        self.validate()?;
        tessellation.validate()?;
        let unsound = || FieldError::Tessellation { surface: self.name(), vertices: tessellation.vertices };
        let mut connected = self.connected(tessellation).ok_or_else(unsound)?;
        let ends = Ends::of(self);
        soundness::sort(&mut connected.triangles);
        if !soundness::is_sound(&connected, ends) {
            return Err(unsound());
        }
        if !ends.closed_u {
            let uvs = connected.parameters.clone();
            return self.finished(connected, Some(uvs));
        }
        if tessellation.uv_seam {
            let (cut, uvs) = seam::cut(&connected, ends);
            return self.finished(cut, Some(uvs));
        }
        self.finished(connected, None)
    }

    /// Points and triangles; none if too few points were asked for.
    fn connected(&self, tessellation: &Tessellation) -> Option<Connected> {
        let metric = Metric::of(self);
        let layout = Layout::fit(&metric, Ends::of(self), tessellation)?;
        let mut random = Random::new(tessellation.seed);
        let parameters = match tessellation.pattern {
            Pattern::Regular { .. } => return Some(grid::connected(&layout)),
            Pattern::Jittered | Pattern::LongThin { .. } => points::jittered(&layout, &metric, &mut random),
            Pattern::Random => points::independent(self, &layout, &metric, tessellation.vertices, &mut random),
        };
        let triangles = if layout.ends.poles {
            polar::triangulated(&parameters, layout.stretch)?
        } else {
            flat::triangulated(&parameters, &metric, &layout)?
        };
        Some(Connected { parameters, triangles })
    }

    fn finished(&self, connected: Connected, uvs: Option<Vec<DVec2>>) -> Result<TessellatedSurface, FieldError> {
        let Connected { parameters, triangles } = connected;
        let positions = parameters.iter().map(|at| self.jet(at.x, at.y).position).collect();
        let mesh = Mesh::new(positions, triangles)?;
        let mesh = match uvs {
            Some(uvs) => mesh.with_uvs(uvs)?,
            None => mesh,
        };
        Ok(TessellatedSurface { mesh, parameters })
    }
}

impl Tessellation {
    /// Refuses what is out of range.
    ///
    /// # Errors
    /// The parameter, its value, and what would be accepted.
    pub fn validate(&self) -> Result<(), FieldError> {
        let check = Check("tessellation");
        check.within("vertices", f64::from(self.vertices), 16.0..=4_194_304.0, "a number from 16 to 4194304")?;
        check.within("aspect", self.pattern.aspect(), 1.0..=1000.0, "a ratio from 1 to 1000")
    }
}

impl Pattern {
    /// Extent along v over extent along u of a cell of the tiling.
    fn aspect(self) -> f64 {
        match self {
            Self::Jittered | Self::Random => 1.0,
            Self::Regular { aspect } | Self::LongThin { aspect } => aspect,
        }
    }
}
