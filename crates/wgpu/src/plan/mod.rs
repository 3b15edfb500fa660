//! What becomes of each table of a file on a device, and which bytes go where.
//!
//! A plan is plain data: an engine with its own allocator follows it without `wgpu`, as in the example at [`UploadPlan`]. Formats
//! are `VkFormat` numbers ([`barchan_asset::Format::number`], [`barchan_asset::VertexFormat::number`]), rows are tight, and an
//! offset is counted in the decoded payload of its section, which for a section that is stored raw is the file's own bytes.

mod curvature;
mod error;
mod layers;
mod limits;
mod texture;

pub use curvature::{ColumnPlan, CurvaturePlan};
pub use error::PlanError;
pub use limits::DeviceLimits;
pub use texture::{Shape, TextureCopy, TexturePlan};

use barchan_asset::{Codec, Section, Semantic, Wrap};

use crate::{Reader, Selection};

/// What is uploaded, checked against what a device can hold.
///
/// # An engine of one's own
///
/// ```
/// # struct Engine;
/// # impl Engine {
/// #     fn create_image(&mut self, vk_format: u32, is_volume: bool, extent: (u32, u32), layers: u32, levels: u32) -> usize { 0 }
/// #     fn copy(&mut self, image: usize, level: u32, first_layer: u32, layers: u32, extent: (u32, u32), bytes: &[u8]) {}
/// #     fn create_vertex_buffer(&mut self, vk_format: u32, bytes: &[u8]) {}
/// #     fn create_uniform_buffer(&mut self, bytes: &[u8]) {}
/// # }
/// # fn load(engine: &mut Engine, bytes: &[u8]) -> Result<(), Box<dyn std::error::Error>> {
/// use barchan_asset::SectionKind;
/// use barchan_wgpu::{DeviceLimits, Reader, Selection, Shape, UploadPlan};
///
/// let reader = Reader::open(bytes)?;
/// let limits = DeviceLimits { max_2d: 16_384, max_layers: 2048, ..DeviceLimits::WEBGPU };
/// let plan = UploadPlan::new(&reader, &Selection::everything(), &limits)?;
/// for texture in plan.textures() {
///     let (format, is_volume) = (texture.format.number(), texture.shape == Shape::D3);
///     let image = engine.create_image(format, is_volume, texture.extent, texture.layers, texture.levels);
///     let payload = reader.payload(texture.table.kind())?; // The file's own bytes, unless they are compressed.
///     for copy in &texture.copies {
///         let bytes = copy.of(&payload).ok_or("the plan is of another file")?;
///         engine.copy(image, copy.level, copy.first_layer, copy.layers, copy.extent, bytes);
///     }
/// }
/// if let Some(curvature) = plan.curvature() {
///     let payload = reader.payload(SectionKind::CURVATURE)?;
///     for column in &curvature.columns {
///         let bytes = column.of(&payload).ok_or("the plan is of another file")?;
///         engine.create_vertex_buffer(column.format.number(), bytes);
///     }
/// }
/// engine.create_uniform_buffer(&plan.parameters());
/// # Ok(())
/// # }
/// # let bytes = include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../formats/vectors/v1/relief-f16.barchan"));
/// # load(&mut Engine, bytes).unwrap();
/// ```
///
/// The sampler is linear, without mips, with [`Self::edges`] as address modes.
#[derive(Debug, Clone, PartialEq)]
pub struct UploadPlan {
    identity: [u8; 32],
    textures: Vec<TexturePlan>,
    curvature: Option<CurvaturePlan>,
    edges: (Wrap, Wrap),
}

impl UploadPlan {
    /// Plans the upload of what is selected of a file to a device of those limits.
    ///
    /// # Errors
    /// A table that is selected by name and not in the file, a part that a table does not have, a compressed section where the
    /// feature `zstd` is off, or a table that the device cannot hold in any shape: by name, with what it needs and what there is.
    pub fn new(reader: &Reader<'_>, selection: &Selection, limits: &DeviceLimits) -> Result<Self, PlanError> {
        if let Some(table) = selection.named().iter().find(|&&table| reader.texture(table).is_none()) {
            return Err(PlanError::Missing { table: *table });
        }
        let chosen = reader.textures().iter().filter(|texture| selection.has_table(texture.descriptor.semantic));
        let plan = |texture: &crate::TextureSection<'_>| {
            TexturePlan::new(texture, &selection.part(texture.descriptor.semantic), limits)
        };
        let mut textures = chosen.map(plan).collect::<Result<Vec<_>, _>>()?;
        let filtered = textures.iter().find(|texture| texture.is_filterable);
        let edges = filtered.map_or((Wrap::Clamp, Wrap::Clamp), TexturePlan::edges);
        for texture in &mut textures {
            texture.is_filterable &= texture.edges() == edges;
        }
        let curvature = CurvaturePlan::new(reader, selection, limits)?;
        Ok(Self { identity: reader.asset().identity(), textures, curvature, edges })
    }

    /// The content identity of the file that it is of: a file with another content is refused when the plan is carried out.
    #[must_use]
    pub fn identity(&self) -> [u8; 32] {
        self.identity
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

    /// The address modes of the sampler along u and v. All tables that a baker writes to one file have the same edges; where those of
    /// a table are others, shaders load its texels, as they do where the device cannot filter its format.
    #[must_use]
    pub fn edges(&self) -> (Wrap, Wrap) {
        self.edges
    }

    /// Bytes that are uploaded, parameters aside.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        let textures = self.textures.iter().map(TexturePlan::bytes).sum::<u64>();
        textures + self.curvature.as_ref().map_or(0, CurvaturePlan::bytes)
    }
}

/// Where the decoded payload begins in the file; nothing for a section that has to be decoded first.
fn payload_offset(section: &Section<'_>) -> Result<Option<u64>, PlanError> {
    match section.codec() {
        Some(Codec::Raw) => Ok(Some(section.payload_offset())),
        Some(Codec::Zstd) if cfg!(feature = "zstd") => Ok(None),
        _ => Err(PlanError::Codec { kind: section.kind(), found: section.codec_number() }),
    }
}

fn slice(payload: &[u8], offset: u64, bytes: u64) -> Option<&[u8]> {
    let start = usize::try_from(offset).ok()?;
    let end = start.checked_add(usize::try_from(bytes).ok()?)?;
    payload.get(start..end)
}
