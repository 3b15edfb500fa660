//! Float channels, one per layer, as the values are: lengths, or elevations in radians.

use std::io::Cursor;

use exr::prelude::{AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, SmallVec};
use exr::prelude::{Text, WritableImage};

use super::Selection;
use crate::failure::Failure;

/// A single layer is called by the table's name, several by that and their number: `horizon.000`, …
pub(super) fn encode(selection: &Selection<'_>) -> Result<Vec<u8>, Failure> {
    let table = selection.table.table.name();
    let channels: SmallVec<[AnyChannel<FlatSamples>; 4]> = selection
        .layers
        .clone()
        .map(|layer| {
            let name = if selection.single { table.to_owned() } else { format!("{table}.{layer:04}") };
            AnyChannel::new(Text::new_or_panic(name), FlatSamples::F32(selection.layer_values(layer).collect()))
        })
        .collect();
    let size = (selection.width(), selection.height());
    let attributes = LayerAttributes::named(table);
    let image = Image::from_layer(Layer::new(size, attributes, Encoding::FAST_LOSSLESS, AnyChannels::sort(channels)));
    let mut bytes = Cursor::new(Vec::new());
    image
        .write()
        .non_parallel()
        .to_buffered(&mut bytes)
        .map_err(|error| Failure::Io(format!("the picture cannot be encoded: {error}")))?;
    Ok(bytes.into_inner())
}
