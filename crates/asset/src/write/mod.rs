//! From values to the bytes of a file.

mod codes;
mod curvature;
mod directed;
mod encode;
mod encoder;
mod error;
mod facts;
mod identity;
mod layout;
mod loss;
mod numbers;
mod quantiser;
mod relief_tables;
mod stream;
mod tables;
mod writer;

pub use curvature::{CurvatureTable, EncodedCurvature};
pub use encode::{EncodeError, Encoding};
pub use encoder::TableEncoder;
pub use error::WriteError;
pub use facts::{CurvatureSweep, TableFacts, TableGrid};
pub(crate) use identity::IdentityHasher;
pub use identity::content_identity;
pub use layout::Finished;
pub use loss::{EncodingLoss, LayerMeasure};
pub use relief_tables::{ConeMapTable, HemisphereTable, MaximumMipTable, RelaxedConeMapTable};
pub use stream::{AssetStream, RawSection};
pub use tables::{
    ApertureConeTable, BentNormalTable, DistanceTable, HeightTable, HorizonTable, SkyVisibilityTable,
    SweptDistanceTable, SweptHorizonTable, TextureTable,
};
pub use writer::AssetWriter;
