//! Float32 arrays for NumPy: `[height, width]` with the axes in front that a table has, candidates or rings and directions, and one
//! behind for the numbers of a texel, if there are several.

use npyz::WriterBuilder;

use super::Selection;
use crate::failure::Failure;

/// Elevations as slopes, their tangent; everything else as it is.
pub(super) fn encode(selection: &Selection<'_>) -> Result<Vec<u8>, Failure> {
    let is_elevation = selection.is_elevation();
    let values = selection.layers.clone().flat_map(|layer| selection.layer_values(layer));
    let values = values.map(|value| if is_elevation { libm::tan(f64::from(value)) as f32 } else { value });
    array(&shape(selection), values)
}

/// An array in C order.
pub(super) fn array(shape: &[u64], values: impl Iterator<Item = f32>) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    write(&mut bytes, shape, values).map_err(|error| Failure::Io(format!("the array cannot be encoded: {error}")))?;
    Ok(bytes)
}

/// One layer alone has no axis for layers.
fn shape(selection: &Selection<'_>) -> Vec<u64> {
    let descriptor = &selection.table.descriptor;
    // No table has both.
    let (layers, groups) = (selection.layers.len() as u64, u64::from(descriptor.candidates.max(descriptor.rings)));
    let mut shape = match (selection.single, groups) {
        (true, _) => vec![],
        (false, 0) => vec![layers],
        (false, groups) => vec![groups, layers / groups],
    };
    shape.extend([selection.height() as u64, selection.width() as u64]);
    let numbers = selection.numbers().len() as u64;
    shape.extend((numbers > 1).then_some(numbers));
    shape
}

fn write(bytes: &mut Vec<u8>, shape: &[u64], values: impl Iterator<Item = f32>) -> std::io::Result<()> {
    let mut writer = npyz::WriteOptions::new().default_dtype().shape(shape).writer(bytes).begin_nd()?;
    writer.extend(values)?;
    writer.finish()
}
