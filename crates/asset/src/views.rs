//! Views of the table kinds, in the words of each.

use crate::transfer::sine_of_elevation;
use crate::{Azimuths, DescriptorError, LengthUnit, Semantic, TableView, TextureDescriptor, Transfer, Wrap};

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

pub(crate) use common_view;

/// What a view with one layer per azimuth, or per candidate and azimuth, offers besides.
macro_rules! directional_view {
    ($name:ident) => {
        impl $name<'_> {
            /// Where the layers look, and how to interpolate between them.
            #[must_use]
            pub fn azimuths(&self) -> Azimuths {
                let descriptor = self.descriptor();
                // The semantic was checked to be a directional one.
                descriptor.azimuths().unwrap_or(Azimuths::full_circle(descriptor.layers))
            }

            /// How many azimuths there are.
            #[must_use]
            pub fn directions(&self) -> u32 {
                self.azimuths().count()
            }

            /// Azimuth of a direction in radians: 0 along +u, counter-clockwise as seen, so that a quarter turn is up
            /// the picture.
            #[must_use]
            pub fn azimuth_radians(&self, direction: u32) -> f64 {
                self.azimuths().radians(direction)
            }

            /// Whether an azimuth lies between baked ones: [`Azimuths::covers`].
            #[must_use]
            pub fn covers(&self, azimuth_radians: f64) -> bool {
                self.azimuths().covers(azimuth_radians)
            }

            /// The two directions to interpolate between, and how far the second one counts: [`Azimuths::neighbours`].
            #[must_use]
            pub fn neighbours(&self, azimuth_radians: f64) -> (u32, u32, f32) {
                self.azimuths().neighbours(azimuth_radians)
            }

            /// How far the horizon was searched, in the length unit.
            #[must_use]
            pub fn radius(&self) -> f64 {
                self.descriptor().search_radius
            }
        }
    };
}

/// What a view with several candidates per azimuth offers besides.
macro_rules! swept_view {
    ($name:ident) => {
        impl $name<'_> {
            /// How many points there are per texel and azimuth, besides the horizon of the flat base.
            #[must_use]
            pub fn candidates(&self) -> u32 {
                self.descriptor().candidates
            }

            /// The least and the greatest curvature of the base that the points serve, in 1 / length unit.
            #[must_use]
            pub fn curvature_range(&self) -> (f64, f64) {
                (self.descriptor().curvature_min, self.descriptor().curvature_max)
            }

            /// The layer of a candidate and a direction.
            ///
            /// # Panics
            /// If there is no such candidate or direction.
            #[must_use]
            pub fn layer(&self, candidate: u32, direction: u32) -> u32 {
                let (candidates, directions) = (self.candidates(), self.directions());
                assert!(
                    candidate < candidates && direction < directions,
                    "candidate {candidate}, direction {direction}"
                );
                candidate * directions + direction
            }
        }
    };
}

/// The sine of the elevation of a texel, from a table that holds elevations or their sines.
fn sine_at(table: &TableView<'_>, layer: u32, column: u32, row: u32) -> f32 {
    let t = table.before_transfer(layer, column, row, 0);
    if table.descriptor().transfer == Transfer::Sine { t.clamp(-1.0, 1.0) } else { sine_of_elevation(t) }
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

    /// Sine of the horizon's elevation, in [−1, 1]: a light is in shadow iff the sine of its own elevation is less.
    /// Where the table holds sines, this is what it holds, without an arcsine.
    ///
    /// # Panics
    /// If there is no such direction or texel.
    #[must_use]
    pub fn sine_of_elevation(&self, direction: u32, column: u32, row: u32) -> f32 {
        sine_at(&self.table, direction, column, row)
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

/// Elevation angles, on the flat base, of points that become the horizon on a curved one.
#[derive(Debug, Clone, Copy)]
pub struct SweptHorizonView<'a> {
    table: TableView<'a>,
}

common_view!(SweptHorizonView, Semantic::SweptElevation);
directional_view!(SweptHorizonView);
swept_view!(SweptHorizonView);

impl SweptHorizonView<'_> {
    /// Elevation of a candidate in radians, in (−π/2, π/2), as seen on the flat base.
    ///
    /// # Panics
    /// If there is no such candidate, direction or texel.
    #[must_use]
    pub fn elevation_radians(&self, candidate: u32, direction: u32, column: u32, row: u32) -> f32 {
        self.table.value(self.layer(candidate, direction), column, row)
    }

    /// Sine of a candidate's elevation, in [−1, 1].
    ///
    /// # Panics
    /// If there is no such candidate, direction or texel.
    #[must_use]
    pub fn sine_of_elevation(&self, candidate: u32, direction: u32, column: u32, row: u32) -> f32 {
        sine_at(&self.table, self.layer(candidate, direction), column, row)
    }
}

/// Horizontal distances to the points of a [`SweptHorizonView`].
#[derive(Debug, Clone, Copy)]
pub struct SweptDistanceView<'a> {
    table: TableView<'a>,
}

common_view!(SweptDistanceView, Semantic::SweptDistance);
directional_view!(SweptDistanceView);
swept_view!(SweptDistanceView);

impl SweptDistanceView<'_> {
    /// Horizontal distance to a candidate in the length unit, in [0, radius].
    ///
    /// # Panics
    /// If there is no such candidate, direction or texel.
    #[must_use]
    pub fn distance(&self, candidate: u32, direction: u32, column: u32, row: u32) -> f32 {
        self.table.value(self.layer(candidate, direction), column, row)
    }
}
