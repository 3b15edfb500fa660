//! From values to the bytes of a file.

mod codes;
mod encode;
mod encoder;
mod facts;
mod identity;
mod loss;
mod quantiser;
mod tables;
mod writer;

pub use encode::{EncodeError, Encoding};
pub use encoder::TableEncoder;
pub use facts::{CurvatureSweep, TableFacts, TableGrid};
pub(crate) use identity::IdentityHasher;
pub use identity::content_identity;
pub use loss::{EncodingLoss, LayerMeasure};
pub use tables::{
    ApertureConeTable, BentNormalTable, DistanceTable, HeightTable, HorizonTable, SkyVisibilityTable,
    SweptDistanceTable, SweptHorizonTable, TextureTable,
};
pub use writer::{AssetWriter, RawSection, WriteError};
