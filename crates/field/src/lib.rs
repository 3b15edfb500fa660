//! Height fields with units, edge policy and sampling rules, triangle meshes, and closed forms of both.
//!
//! # The frame
//!
//! A height field is looked at from above, with row 0 of the file at the top of the picture. `u` points right along a
//! row, `v` points **up** the picture, towards row 0, and the height points at the viewer, so that (u, v, height) is
//! right-handed. An azimuth is 0 along +u and grows counter-clockwise as seen in the picture: 90° points along +v, that
//! is, towards row 0. Texel `(column, row)` has its centre at `u = column + ½`, and rows are counted downwards.
//!
//! # The surface
//!
//! The samples are heights at texel centres. The surface between them is the bilinear interpolant, everywhere in
//! Barchan, continued beyond the outermost centres by the field's [`Edge`] policy, exactly as a GPU sampler with the
//! same address mode continues it.
//!
//! # Units
//!
//! Heights, [`Spacing`] and every distance derived from them are in one [`LengthUnit`], so a slope is a pure number.

mod error;
mod grid;
mod height_field;
mod mesh;
pub mod shapes;
pub mod surfaces;

pub use error::FieldError;
pub use grid::{Edge, Grid, LengthUnit, Spacing};
pub use height_field::HeightField;
pub use mesh::Mesh;
pub use shapes::Shape;
pub use surfaces::ParametricSurface;
