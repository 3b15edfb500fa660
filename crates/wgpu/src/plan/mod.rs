//! What becomes of each table of a file on a device, and which bytes go where.
//!
//! A plan is plain data: an engine with its own allocator follows it without `wgpu`. Formats are `VkFormat` numbers
//! ([`barchan_asset::Format::number`]), rows are tight, and an offset is counted in the decoded payload of its section, which for a
//! section that is stored raw is the file's own bytes.

mod curvature;
mod error;
mod limits;
mod texture;

pub use curvature::{ColumnPlan, CurvaturePlan};
pub use error::PlanError;
pub use limits::DeviceLimits;
pub use texture::{Shape, TextureCopy, TexturePlan};

use barchan_asset::Semantic;

use crate::{Reader, Selection};

/// What is uploaded, checked against what a device can hold.
#[derive(Debug, Clone, PartialEq)]
pub struct UploadPlan {
    textures: Vec<TexturePlan>,
    curvature: Option<CurvaturePlan>,
}

impl UploadPlan {
    /// Plans the upload of what is selected of a file to a device of those limits.
    ///
    /// # Errors
    /// A table that is selected by name and not in the file, a part that a table does not have, or a table that the device cannot
    /// hold in any shape: by name, with what it needs and what there is.
    pub fn new(reader: &Reader<'_>, selection: &Selection, limits: &DeviceLimits) -> Result<Self, PlanError> {
        for &table in selection.named() {
            if reader.texture(table).is_none() {
                return Err(PlanError::Missing { table });
            }
        }
        let chosen = reader.textures().iter().filter(|texture| selection.has_table(texture.descriptor.semantic));
        let plan = |texture| TexturePlan::new(texture, &selection.part(semantic_of(texture)), limits);
        let textures = chosen.map(plan).collect::<Result<Vec<_>, _>>()?;
        let curvature = CurvaturePlan::new(reader, selection, limits)?;
        Ok(Self { textures, curvature })
    }

    /// The textures, in the order of the file.
    #[must_use]
    pub fn textures(&self) -> &[TexturePlan] {
        &self.textures
    }

    /// The texture of a table, if it is planned.
    #[must_use]
    pub fn texture(&self, table: Semantic) -> Option<&TexturePlan> {
        self.textures.iter().find(|texture| texture.table == table)
    }

    /// The vertex buffers of the curvature, if there are any.
    #[must_use]
    pub fn curvature(&self) -> Option<&CurvaturePlan> {
        self.curvature.as_ref()
    }

    /// Bytes that are uploaded, parameters aside.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let textures = self.textures.iter().map(TexturePlan::bytes).sum::<u64>();
        textures + self.curvature.as_ref().map_or(0, CurvaturePlan::bytes)
    }
}

fn semantic_of(texture: &crate::TextureSection<'_>) -> Semantic {
    texture.descriptor.semantic
}
