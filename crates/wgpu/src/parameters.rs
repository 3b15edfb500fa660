//! The numbers of an asset that shaders need: one uniform buffer, whose layout never changes.
//!
//! It holds an entry of [`TABLE_BYTES`] for each of the twelve kinds of tables, in the order of their semantic numbers; entries of
//! tables that are not uploaded are zero. `table.wgsl` declares the same as `BarchanTable`.

use barchan_asset::{DepthMode, RingSpacing, Semantic, Transfer, Wrap};

use crate::{TexturePlan, UploadPlan};

/// Bytes of one table's entry.
pub const TABLE_BYTES: usize = 96;

/// Bytes of the uniform buffer.
pub const PARAMETER_BYTES: usize = TABLE_BYTES * Semantic::ALL.len();

impl UploadPlan {
    /// The bytes of the uniform buffer, little-endian.
    #[must_use]
    pub fn parameters(&self) -> [u8; PARAMETER_BYTES] {
        let mut bytes = [0; PARAMETER_BYTES];
        for texture in self.textures() {
            let start = TABLE_BYTES * (texture.table.number() as usize - 1);
            for (word, number) in bytes[start..start + TABLE_BYTES].chunks_exact_mut(4).zip(entry(texture)) {
                word.copy_from_slice(&number.to_le_bytes());
            }
        }
        bytes
    }
}

/// The words of a table's entry.
fn entry(texture: &TexturePlan) -> [u32; TABLE_BYTES / 4] {
    let table = &texture.descriptor;
    let real = |number: f64| (number as f32).to_bits();
    let repeats = |wrap| u32::from(wrap == Wrap::Repeat);
    let transfer = match table.transfer {
        Transfer::Identity => 0,
        Transfer::Sine => 1,
        Transfer::Square => 2,
    };
    let azimuths = table.azimuths();
    let is_circle = azimuths.is_some_and(|azimuths| azimuths.is_full_circle());
    let max_tangent = table.directions().map_or(0.0, |directions| directions.tangent_of_edge(directions.rings));
    [
        real(f64::from(table.width)),
        real(f64::from(table.height)),
        real(table.spacing_u),
        real(table.spacing_v),
        real(table.scale),
        real(table.bias),
        transfer,
        repeats(table.wrap_u) | repeats(table.wrap_v) << 1,
        real(table.first_azimuth),
        real(table.azimuth_step),
        azimuths.map_or(0, |azimuths| azimuths.count()),
        u32::from(is_circle),
        table.candidates,
        table.rings,
        table.ring_spacing.map_or(0, RingSpacing::number),
        table.depth_mode.map_or(0, DepthMode::number),
        real(max_tangent),
        real(table.max_polar),
        real(table.relief_top),
        real(table.relief_thickness),
        texture.first_level,
        texture.levels,
        real(table.range_min),
        real(table.range_max),
    ]
}
