//! What may be allocated on the word of a header.

use crate::{DecodeError, Format};

/// Bytes of samples per byte of file. Deflate emits at most 258 bytes for 2 bits, 1032 : 1. TIFF's LZW, fed a constant,
/// emits strings of 1, 2, … 3837 bytes between two clear codes, for 5406 bytes of codes in all: 1363 : 1. One bound lies above both.
pub(crate) const MAX_RATIO: u64 = 2048;

/// What a header says of an image before any of it is decoded.
pub(crate) struct Claim {
    pub(crate) format: Format,
    pub(crate) width: u64,
    pub(crate) height: u64,
    /// Bits of all samples as the file stores them, uncompressed, padding of tiles included.
    pub(crate) stored_bits: u128,
    /// Bytes of samples per byte of file that the compression can reach.
    pub(crate) max_ratio: u64,
}

impl Claim {
    /// An image without padding, of `bits` per texel.
    pub(crate) fn new(format: Format, width: u64, height: u64, bits: u64) -> Self {
        // Saturating is enough: such a claim is refused all the same.
        let texels = u128::from(width) * u128::from(height);
        let stored_bits = texels.saturating_mul(bits.into());
        Self { format, width, height, stored_bits, max_ratio: MAX_RATIO }
    }

    /// The sides as u32 if the claim is within u32, the caller's limit, and what `file_bytes` can hold.
    pub(crate) fn check(&self, file_bytes: usize, max_texels: u64) -> Result<(u32, u32), DecodeError> {
        let Self { format, width, height, .. } = *self;
        let sides = (u32::try_from(width), u32::try_from(height));
        let (Ok(w @ 1..), Ok(h @ 1..)) = sides else {
            return Err(DecodeError::Extent { format, width, height });
        };
        if width * height > max_texels || usize::try_from(width * height).is_err() {
            return Err(DecodeError::TooManyTexels { format, width, height, max: max_texels });
        }
        let promised = self.stored_bits.div_ceil(8);
        let file = file_bytes as u64;
        let possible = u128::from(file) * u128::from(self.max_ratio);
        if promised > possible {
            return Err(DecodeError::Implausible { format, width, height, promised, file, possible });
        }
        Ok((w, h))
    }
}

/// `len` default values, or an error where `vec!` would abort.
pub(crate) fn zeroed<T: Clone + Default>(len: usize) -> Result<Vec<T>, DecodeError> {
    let mut values = reserved(len)?;
    values.resize(len, T::default());
    Ok(values)
}

/// An empty vector with room for `len` values, or an error where `with_capacity` would abort.
pub(crate) fn reserved<T>(len: usize) -> Result<Vec<T>, DecodeError> {
    let mut values = Vec::new();
    let bytes = len as u128 * size_of::<T>() as u128;
    values.try_reserve_exact(len).map_err(|_| DecodeError::Memory { bytes })?;
    Ok(values)
}
