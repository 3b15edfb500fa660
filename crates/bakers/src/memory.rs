//! Memory that the system refuses is an error of the bake, not the end of the program.

use crate::BakeError;

/// One bound for what a bake may hold of one table.
pub(crate) const MAX_TABLE_BYTES: u64 = 1 << 36;

/// As many zeros, or what cannot be had.
pub(crate) fn zeros<T: Clone + Default>(what: &'static str, values: u64) -> Result<Vec<T>, BakeError> {
    let bytes = values.saturating_mul(size_of::<T>() as u64);
    if bytes > MAX_TABLE_BYTES {
        return Err(BakeError::TooLarge { what, bytes, limit: MAX_TABLE_BYTES });
    }
    let mut zeros = Vec::new();
    zeros.try_reserve_exact(values as usize).map_err(|_| BakeError::Memory { what, bytes })?;
    zeros.resize(values as usize, T::default());
    Ok(zeros)
}
