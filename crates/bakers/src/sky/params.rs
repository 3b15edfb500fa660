//! Which tables of the sky are asked for.

use crate::BakeError;
use crate::horizon::{Azimuths, MAX_DIRECTIONS};

/// The fewest azimuths a sky can be summed over: two cannot tell in which direction a slope falls.
pub const MIN_SKY_DIRECTIONS: u32 = 3;

/// The tables asked for. One that is not costs neither memory nor time, and none changes a bit of another.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct SkyParams {
    /// Cosine-weighted visibility of the sky; 4 bytes a texel while it is summed.
    pub visibility: bool,
    /// Cosine-weighted mean direction of the sky; 12 bytes a texel.
    pub bent_normal: bool,
    /// Mean direction of the sky and the half-angle of its cap; 16 bytes a texel.
    pub aperture_cone: bool,
}

impl SkyParams {
    /// All three tables.
    pub const ALL: Self = Self { visibility: true, bent_normal: true, aperture_cone: true };

    /// Refuses azimuths that no sky can be summed over; where no table is asked for, none.
    ///
    /// # Errors
    /// The parameter, its value, and what would be accepted.
    pub fn check(&self, azimuths: &Azimuths) -> Result<(), BakeError> {
        if *self == Self::default() { Ok(()) } else { check_azimuths(azimuths) }
    }

    /// Sums kept per texel.
    pub(crate) fn planes(self) -> usize {
        usize::from(self.visibility) + 3 * usize::from(self.bent_normal) + 4 * usize::from(self.aperture_cone)
    }
}

/// Refuses azimuths that do not go round.
pub(crate) fn check_azimuths(azimuths: &Azimuths) -> Result<(), BakeError> {
    let refuse = |name, value: String, accepted| Err(BakeError::Parameter { name, value, accepted });
    match *azimuths {
        Azimuths::FullCircle { count } if (MIN_SKY_DIRECTIONS..=MAX_DIRECTIONS).contains(&count) => Ok(()),
        Azimuths::FullCircle { count } => {
            refuse("directions", count.to_string(), "3 to 2048 azimuths are accepted where a sky is baked")
        }
        Azimuths::Arc { first_degrees, last_degrees, .. } => refuse(
            "arc",
            format!("{first_degrees} to {last_degrees}"),
            "the sky is all around a texel: only the full circle of azimuths is accepted where it is baked",
        ),
    }
}
