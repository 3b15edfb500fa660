//! From values to the bytes of a file.

mod encode;
mod identity;
mod quantiser;
mod tables;
mod writer;

pub use encode::{EncodeError, Encoded, Encoding, encode};
pub(crate) use identity::IdentityHasher;
pub use identity::content_identity;
pub use tables::{DistanceTable, HeightTable, HorizonTable, TableGrid, TextureTable};
pub use writer::{AssetWriter, RawSection, WriteError};
