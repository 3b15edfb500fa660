//! The thin reader: what a game links to have a `.barchan` file on its GPU, and the WGSL that samples it.
//!
//! # How it goes
//!
//! ```
//! # fn load(bytes: &[u8]) -> Result<(), Box<dyn std::error::Error>> {
//! use barchan_wgpu::{DeviceLimits, Reader, Selection, Shader, ShaderOptions, Technique, UploadPlan};
//!
//! let reader = Reader::open(bytes)?;
//! let plan = UploadPlan::new(&reader, &Selection::everything(), &DeviceLimits::WEBGPU)?;
//! let shader = Shader::compose(&plan, &[Technique::HorizonShadow], &ShaderOptions::default())?;
//! # Ok(())
//! # }
//! ```
//!
//! 1. [`Reader::open`] checks the structure of the file and every descriptor. It looks at no payload, and copies nothing.
//! 2. [`UploadPlan::new`] says what becomes of each table: format, extent, layers, and which bytes of the file go where. An engine
//!    with an allocator of its own follows it; `GpuAsset::upload` (feature `device`) carries it out on a `wgpu::Device`.
//! 3. [`Shader::compose`] puts together the WGSL of the techniques that a pipeline is to have, and lists what it binds. What the
//!    asset or the pipeline does not need is neither compiled nor bound.
//!
//! # Features
//!
//! * `device`, on by default: `wgpu`, without any of its back ends; those are the game's to choose.
//! * `zstd`: also sections that are stored compressed; these are decoded to memory first, within [`barchan_asset::Limits`].
//! * `fast-checksum`: [`Reader::check_bytes`] by the processor's own instructions, some fifty times as fast.
//!
//! # The frame
//!
//! The asset's: u right, v up the picture, height towards the viewer; row 0 at the top. Places on a table are in texels from the
//! centre of texel (0, 0), rows downwards, so that texture coordinates (from the upper left) are (place + ½) / extent.

#[cfg(feature = "device")]
mod device;
mod parameters;
mod plan;
mod reader;
mod selection;
mod shader;

#[cfg(feature = "device")]
pub use device::{GpuAsset, UploadError};
pub use parameters::{PARAMETER_BYTES, TABLE_BYTES};
pub use plan::{ColumnPlan, CurvaturePlan, DeviceLimits, PlanError, Shape, TextureCopy, TexturePlan, UploadPlan};
pub use reader::{ReadError, Reader, TextureSection};
pub use selection::{Selection, TablePart};
pub use shader::{
    Binding, BindingKind, ComposeError, ReliefSearch, SEARCH_BISECTIONS, SEARCH_STEPS, Sampling, Shader, ShaderOptions,
    Technique,
};

/// What the README says compiles.
#[cfg(all(doctest, feature = "device"))]
#[doc = include_str!("../README.md")]
struct Readme;
