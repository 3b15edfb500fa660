//! The `.barchan` file: sections to bytes and back, and typed views of each table kind.
//!
//! The law is `formats/barchan-v1.md` and its sister pages; this crate follows them.
//!
//! # Reading
//!
//! Without features the crate is `no_std`, has no dependency and no allocator: [`Asset::open`] checks the structure and
//! the header checksum of a `&[u8]` and hands out slices of it.
//!
//! ```
//! # fn read(bytes: &[u8]) -> Option<f32> {
//! use barchan_asset::{Asset, HorizonView, SectionKind};
//!
//! let asset = Asset::open(bytes).ok()?;
//! let section = asset.section(SectionKind::HORIZON)?;
//! let horizon = HorizonView::new(section.texture().ok()?, section.raw_payload()?).ok()?;
//! Some(horizon.elevation_radians(0, 0, 0))
//! # }
//! ```
//!
//! [`Section::texture`] and the views of its tables read texels; [`Section::curvature`] and [`CurvatureView`] the columns of
//! a mesh.
//!
//! Opening does not look at a payload. A stranger's file wants [`Section::is_intact`] or, with the feature `write`,
//! `validate` before its values are trusted; no call panics on a bad file either way.
//!
//! # Features
//!
//! * `fast-checksum` (needs std): [`Section::is_intact`] by the processor's own instructions, not byte by byte.
//! * `zstd` (needs std): `Section::payload` decodes zstd sections within [`Limits`].
//! * `write` (needs std): `AssetWriter` in memory and `AssetStream` for tables that are larger, `TableEncoder` and the
//!   tables that use it, the content identity, `validate`, the published `vectors`.
//!
//! # The frame
//!
//! Row 0 is the top of the picture, u points right, v points up the picture, azimuth 0 is along +u and grows
//! counter-clockwise as seen. Texel `(column, row)` is centred at `column + ½` along u.

#![no_std]

#[cfg(feature = "zstd")]
extern crate std;

mod angle;
mod asset;
mod azimuths;
mod bytes;
mod crc;
mod curvature;
mod descriptor;
mod entry;
mod error;
mod half;
mod hemisphere;
mod kind;
mod limits;
#[cfg(feature = "zstd")]
mod payload;
mod rounding;
mod section;
mod sky_views;
mod terms;
mod transfer;
#[cfg(feature = "write")]
mod validate;
#[cfg(feature = "write")]
pub mod vectors;
mod view;
mod views;
#[cfg(feature = "write")]
mod write;

pub use asset::{Asset, MAJOR, MAX_SECTIONS, MINOR};
pub use azimuths::Azimuths;
pub use curvature::{
    CURVATURE_VERSION, ColumnLayout, CurvatureColumn, CurvatureDescriptor, CurvatureError, CurvatureView, SurfaceForms,
    VertexFlags, VertexFormat,
};
pub use descriptor::{DescriptorError, MAX_EXTENT, MAX_LAYERS, SECTION_VERSION, TextureDescriptor};
pub use error::{OpenError, SectionFault};
pub use hemisphere::{
    ConeMapView, DepthMode, HemisphereDirections, HemisphereView, MaximumMipView, RelaxedConeMapView, ReliefRange,
    RingSpacing,
};
pub use kind::SectionKind;
pub use limits::Limits;
#[cfg(feature = "zstd")]
pub use payload::PayloadError;
pub use rounding::{f32_at_least, f32_at_most};
pub use section::{Codec, Section};
pub use sky_views::{ApertureConeView, BentNormalView, SkyVisibilityView};
pub use terms::{Component, Filter, Format, LengthUnit, MipReducer, Semantic, Transfer, Unit, Wrap};
pub use transfer::MAX_ELEVATION;
#[cfg(feature = "write")]
pub use validate::{FINDINGS, Finding, FindingKind, Severity, validate};
pub use view::TableView;
pub use views::{DistanceView, HeightView, HorizonView, SweptDistanceView, SweptHorizonView};
#[cfg(feature = "write")]
pub use write::{
    ApertureConeTable, AssetStream, AssetWriter, BentNormalTable, ConeMapTable, CurvatureSweep, CurvatureTable,
    DistanceTable, EncodeError, EncodedCurvature, Encoding, EncodingLoss, Finished, HeightTable, HemisphereTable,
    HorizonTable, LayerMeasure, MaximumMipTable, RawSection, RelaxedConeMapTable, SkyVisibilityTable,
    SweptDistanceTable, SweptHorizonTable, TableEncoder, TableFacts, TableGrid, TextureTable, WriteError,
    content_identity,
};
