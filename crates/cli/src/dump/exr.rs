//! Float channels, one per layer, as the values are: lengths, or elevations in radians.

use std::io::Cursor;

use exr::prelude::{AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, SmallVec};
use exr::prelude::{Text, WritableImage};

use super::Selection;
use crate::failure::Failure;

/// A single layer is called by the table's name, several by that and their number: `horizon.0000`, …; the numbers of a
/// texel by that and their own names: `bent_normal.u`, …
pub(super) fn encode(selection: &Selection<'_>) -> Result<Vec<u8>, Failure> {
    let table = selection.table.table.name();
    let channels: SmallVec<[AnyChannel<FlatSamples>; 4]> =
        selection.layers.clone().flat_map(|layer| layer_channels(selection, table, layer)).collect();
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

fn layer_channels(selection: &Selection<'_>, table: &str, layer: u32) -> Vec<AnyChannel<FlatSamples>> {
    let (values, numbers) = (selection.layer_values(layer), selection.numbers());
    let base = if selection.single { table.to_owned() } else { format!("{table}.{layer:04}") };
    let [_] = numbers else {
        let channel = |(index, number): (usize, &&str)| {
            let samples = values.iter().skip(index).step_by(numbers.len()).copied().collect();
            AnyChannel::new(Text::new_or_panic(format!("{base}.{number}")), FlatSamples::F32(samples))
        };
        return numbers.iter().enumerate().map(channel).collect();
    };
    vec![AnyChannel::new(Text::new_or_panic(base), FlatSamples::F32(values))]
}
