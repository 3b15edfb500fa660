use thiserror::Error;

/// Why numbers are not a height field, a mesh or a surface. Whoever supplied the value named in the message must act.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FieldError {
    /// Width or height is zero.
    #[error("the height field is {width} × {height} texels; both sides must be at least 1")]
    Empty {
        /// Texels along u.
        width: u32,
        /// Texels along v.
        height: u32,
    },
    /// The samples do not fill the grid.
    #[error("{found} samples do not fill {width} × {height} texels; {expected} are needed")]
    SampleCount {
        /// Texels along u.
        width: u32,
        /// Texels along v.
        height: u32,
        /// `width * height`.
        expected: u64,
        /// Samples given.
        found: u64,
    },
    /// A sample is NaN or infinite.
    #[error(
        "the height at column {column}, row {row} is {value} ({count} of {total} texels are not finite); every height must be a finite number"
    )]
    NotFinite {
        /// Column of the first offending texel in row order.
        column: u32,
        /// Its row, 0 at the top.
        row: u32,
        /// Its value.
        value: f32,
        /// How many texels are not finite.
        count: u64,
        /// Texels in all.
        total: u64,
    },
    /// A spacing is not a positive, finite length.
    #[error("spacing {axis} is {value}; a positive, finite length per texel is needed")]
    Spacing {
        /// `u` or `v`.
        axis: char,
        /// The value given.
        value: f64,
    },
    /// A shape's parameter is out of range.
    #[error("{shape}: {name} is {value}; {accepted} is needed")]
    Parameter {
        /// The name of the shape or surface, as [`crate::Shape::name`] gives it.
        shape: &'static str,
        /// The parameter's name, as in recipes.
        name: &'static str,
        /// The value given.
        value: f64,
        /// What would be accepted.
        accepted: &'static str,
    },
    /// More vertices than a triangle can name.
    #[error("the mesh has {found} vertices; up to 4294967295 would be accepted")]
    VertexCount {
        /// Vertices given.
        found: u64,
    },
    /// A coordinate is not a usable number.
    #[error("vertex {vertex} has the coordinate {value}; finite coordinates up to 1e30 would be accepted")]
    VertexPosition {
        /// The first such vertex, counted from 0.
        vertex: u64,
        /// The coordinate.
        value: f64,
    },
    /// A triangle names a vertex that does not exist.
    #[error("triangle {triangle} names vertex {vertex}; there are {vertices} vertices, counted from 0")]
    TriangleCorner {
        /// The first such triangle, counted from 0.
        triangle: u64,
        /// The vertex it names.
        vertex: u32,
        /// How many there are.
        vertices: u64,
    },
    /// Not one value per vertex.
    #[error("there are {found} {attribute} for {expected} vertices; one per vertex is needed")]
    AttributeCount {
        /// `texture coordinates` or `normals`.
        attribute: &'static str,
        /// Values given.
        found: u64,
        /// Vertices.
        expected: u64,
    },
    /// A value of a vertex is not finite.
    #[error("the {attribute} of vertex {vertex} are not finite; finite numbers are needed")]
    AttributeNotFinite {
        /// `texture coordinates` or `normals`.
        attribute: &'static str,
        /// The first such vertex, counted from 0.
        vertex: u64,
    },
    /// A tessellation is too coarse for the surface.
    #[error(
        "{surface}: {vertices} vertices in this pattern do not make a sound mesh; more of them or shorter triangles would be accepted"
    )]
    Tessellation {
        /// The surface's name, as [`crate::ParametricSurface::name`] gives it.
        surface: &'static str,
        /// How many vertices were asked for.
        vertices: u32,
    },
}
