//! Views of the table kinds, in the words of each.

use crate::{DescriptorError, LengthUnit, Semantic, TableView, TextureDescriptor, Wrap};

/// The greatest elevation a table holds: the largest f32 below π/2, in radians. The least is its negative.
///
/// The f32 nearest to π/2 is *above* π/2, so a wall's elevation has to be cut to this before it is encoded.
pub const MAX_ELEVATION: f32 = f32::from_bits(0x3FC9_0FDA);

/// What every view of a table offers.
macro_rules! common_view {
    ($name:ident, $semantic:expr) => {
        impl<'a> $name<'a> {
            /// `payload` is the decoded payload of the section that `descriptor` came from.
            ///
            /// # Errors
            /// A table of another semantic, or whatever [`TableView::new`] refuses.
            pub fn new(descriptor: TextureDescriptor, payload: &'a [u8]) -> Result<Self, DescriptorError> {
                descriptor.expect($semantic)?;
                Ok(Self { table: TableView::new(descriptor, payload)? })
            }

            /// The table without its meaning.
            #[must_use]
            pub fn table(&self) -> TableView<'a> {
                self.table
            }

            /// What the table is.
            #[must_use]
            pub fn descriptor(&self) -> &TextureDescriptor {
                self.table.descriptor()
            }

            /// Texels along u.
            #[must_use]
            pub fn width(&self) -> u32 {
                self.descriptor().width
            }

            /// Texels along v.
            #[must_use]
            pub fn height(&self) -> u32 {
                self.descriptor().height
            }

            /// Length per texel along u and along v.
            #[must_use]
            pub fn spacing(&self) -> (f64, f64) {
                (self.descriptor().spacing_u, self.descriptor().spacing_v)
            }

            /// What lies beyond the edge along u and along v.
            #[must_use]
            pub fn wrap(&self) -> (Wrap, Wrap) {
                (self.descriptor().wrap_u, self.descriptor().wrap_v)
            }

            /// The unit of lengths.
            #[must_use]
            pub fn length_unit(&self) -> LengthUnit {
                self.descriptor().length_unit
            }
        }
    };
}

/// What a view with one layer per azimuth offers besides.
macro_rules! directional_view {
    ($name:ident) => {
        impl $name<'_> {
            /// How many azimuths, evenly spread over the full circle.
            #[must_use]
            pub fn directions(&self) -> u32 {
                self.descriptor().layers
            }

            /// Azimuth of a direction in radians: 0 along +u, counter-clockwise as seen, so that a quarter turn is up
            /// the picture.
            #[must_use]
            pub fn azimuth_radians(&self, direction: u32) -> f64 {
                self.descriptor().first_azimuth + f64::from(direction) * self.descriptor().azimuth_step
            }

            /// How far the horizon was searched, in the length unit.
            #[must_use]
            pub fn radius(&self) -> f64 {
                self.descriptor().search_radius
            }
        }
    };
}

/// Heights of a field.
#[derive(Debug, Clone, Copy)]
pub struct HeightView<'a> {
    table: TableView<'a>,
}

common_view!(HeightView, Semantic::Height);

impl HeightView<'_> {
    /// Height of a texel in the length unit; row 0 is the top of the picture.
    ///
    /// # Panics
    /// If there is no such texel.
    #[must_use]
    pub fn height_at(&self, column: u32, row: u32) -> f32 {
        self.table.value(0, column, row)
    }
}

/// Elevation angles of the horizon.
#[derive(Debug, Clone, Copy)]
pub struct HorizonView<'a> {
    table: TableView<'a>,
}

common_view!(HorizonView, Semantic::HorizonElevation);
directional_view!(HorizonView);

impl HorizonView<'_> {
    /// Elevation of the horizon in radians, in (−π/2, π/2): 0 is level, negative is below.
    ///
    /// # Panics
    /// If there is no such direction or texel.
    #[must_use]
    pub fn elevation_radians(&self, direction: u32, column: u32, row: u32) -> f32 {
        self.table.value(direction, column, row)
    }
}

/// Horizontal distances to the horizon.
#[derive(Debug, Clone, Copy)]
pub struct DistanceView<'a> {
    table: TableView<'a>,
}

common_view!(DistanceView, Semantic::HorizonDistance);
directional_view!(DistanceView);

impl DistanceView<'_> {
    /// Horizontal distance to the horizon point in the length unit, in [0, radius].
    ///
    /// # Panics
    /// If there is no such direction or texel.
    #[must_use]
    pub fn distance(&self, direction: u32, column: u32, row: u32) -> f32 {
        self.table.value(direction, column, row)
    }
}

#[cfg(test)]
mod tests {
    use super::MAX_ELEVATION;
    use core::f64::consts::FRAC_PI_2;

    #[test]
    fn the_greatest_elevation_is_the_last_f32_below_a_right_angle() {
        assert!(f64::from(MAX_ELEVATION) < FRAC_PI_2);
        assert!(f64::from(MAX_ELEVATION.next_up()) > FRAC_PI_2);
    }
}
