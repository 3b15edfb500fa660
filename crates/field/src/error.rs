use thiserror::Error;

/// Why a set of samples is not a height field. Whoever supplied the value named in the message must act.
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
        /// The shape's name, as [`crate::Shape::name`] gives it.
        shape: &'static str,
        /// The parameter's name, as in recipes.
        name: &'static str,
        /// The value given.
        value: f64,
        /// What would be accepted.
        accepted: &'static str,
    },
}
