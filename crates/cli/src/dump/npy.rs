//! Float32 arrays for NumPy: `[directions, height, width]`, or `[height, width]` for one layer.

use npyz::WriterBuilder;

use super::Selection;
use crate::failure::Failure;

/// Horizons as slopes, the tangent of their elevation; lengths as they are.
pub(super) fn encode(selection: &Selection<'_>) -> Result<Vec<u8>, Failure> {
    let (height, width) = (selection.height() as u64, selection.width() as u64);
    let shape = match selection.single {
        true => vec![height, width],
        false => vec![selection.layers.len() as u64, height, width],
    };
    let is_horizon = selection.is_horizon();
    let values = selection.layers.clone().flat_map(|layer| selection.layer_values(layer));
    let values = values.map(|value| if is_horizon { libm::tan(f64::from(value)) as f32 } else { value });
    let mut bytes = Vec::new();
    write(&mut bytes, &shape, values).map_err(|error| Failure::Io(format!("the array cannot be encoded: {error}")))?;
    Ok(bytes)
}

fn write(bytes: &mut Vec<u8>, shape: &[u64], values: impl Iterator<Item = f32>) -> std::io::Result<()> {
    let mut writer = npyz::WriteOptions::new().default_dtype().shape(shape).writer(bytes).begin_nd()?;
    writer.extend(values)?;
    writer.finish()
}
