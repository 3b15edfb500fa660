//! The layers and levels of a table that are loaded, and what the table is that is left.

use barchan_asset::{Azimuths, Semantic, TextureDescriptor};

use super::PlanError;
use crate::TablePart;

/// Part of a table, found to be there.
pub(super) struct ChosenLayers {
    /// How many candidates or rings there are of each azimuth.
    groups: u32,
    /// The first azimuth, and how many from there on.
    azimuths: (u32, u32),
    all_azimuths: u32,
    /// The finest level.
    pub(super) first_level: u32,
}

impl ChosenLayers {
    pub(super) fn new(stored: &TextureDescriptor, part: &TablePart) -> Result<Self, PlanError> {
        let groups = match (stored.candidates, stored.rings) {
            (0, 0) => 1,
            (0, rings) => within(stored, "rings", part.rings.unwrap_or(rings), (1, rings))?,
            (all, _) => within(stored, "candidates", part.candidates.unwrap_or(all), (1, all))?,
        };
        let first_level = if stored.mips > 1 { part.first_level } else { 0 };
        within(stored, "first_level", first_level, (0, stored.mips - 1))?;
        let Some(azimuths) = stored.azimuths() else {
            return Ok(Self { groups, azimuths: (0, 1), all_azimuths: 1, first_level });
        };
        let all_azimuths = azimuths.count();
        let azimuths = part.azimuths.map_or(Ok((0, all_azimuths)), |part| arc(stored, &azimuths, part))?;
        Ok(Self { groups, azimuths, all_azimuths, first_level })
    }

    pub(super) fn count(&self) -> u32 {
        self.groups * self.azimuths.1
    }

    /// The layers of the table, in the order of the texture's.
    pub(super) fn layers(&self) -> impl Iterator<Item = u32> + '_ {
        let (first, count) = self.azimuths;
        (0..self.groups).flat_map(move |group| {
            (0..count).map(move |azimuth| group * self.all_azimuths + (first + azimuth) % self.all_azimuths)
        })
    }

    /// The descriptor of what is left. Extent and mips stay those of the whole table: levels keep their numbers.
    pub(super) fn descriptor(&self, stored: &TextureDescriptor) -> TextureDescriptor {
        let mut left = *stored;
        left.layers = self.count();
        if let Some(azimuths) = stored.azimuths().filter(|azimuths| azimuths.count() != self.azimuths.1) {
            left.first_azimuth = azimuths.radians(self.azimuths.0);
            left.azimuth_step = if self.azimuths.1 > 1 { azimuths.step_radians() } else { 0.0 };
        }
        if stored.candidates > 0 {
            left.candidates = self.groups;
        }
        if let Some(directions) = stored.directions().filter(|directions| directions.rings != self.groups) {
            left.rings = self.groups;
            left.max_polar = directions.tangent_of_edge(self.groups).atan();
        }
        left
    }
}

/// The first of the azimuths that are asked for, and how many there are from there.
fn arc(stored: &TextureDescriptor, azimuths: &Azimuths, (first, count): (u32, u32)) -> Result<(u32, u32), PlanError> {
    let all = azimuths.count();
    let is_circle = azimuths.is_full_circle();
    within(stored, "first azimuth", first, (0, all - 1))?;
    // The cells of a hemisphere are as wide as the step between two.
    let least = if stored.semantic == Semantic::HemisphereDepth { all.min(2) } else { 1 };
    let most = if is_circle { all } else { all - first };
    let count = within(stored, "number of azimuths", count, (least, most))?;
    // All of a circle is the circle, wherever one begins.
    Ok(if count == all { (0, all) } else { (first, count) })
}

fn within(
    stored: &TextureDescriptor,
    field: &'static str,
    found: u32,
    (least, most): (u32, u32),
) -> Result<u32, PlanError> {
    let refused = PlanError::Part { table: stored.semantic, field, found, least, most };
    if (least..=most).contains(&found) { Ok(found) } else { Err(refused) }
}
