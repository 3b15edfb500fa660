//! One strip or tile: from stored bytes to samples in native byte order.

use flate2::{Decompress, FlushDecompress};
use weezl::{BitOrder, LzwStatus, decode::Configuration};

use super::{damaged, header::Header};
use crate::DecodeError;

/// What all blocks of an image have in common.
pub(crate) struct BlockDecoder {
    compression: u64,
    predictor: u64,
    little_endian: bool,
    sample_bytes: usize,
    /// Channels side by side in a block.
    interleaved: usize,
    pub(crate) row_bytes: usize,
}

impl BlockDecoder {
    pub(crate) fn new(header: &Header, block_width: usize, interleaved: usize) -> Self {
        let sample_bytes = (header.bits / 8) as usize;
        Self {
            compression: header.compression,
            predictor: header.predictor,
            little_endian: header.little_endian,
            sample_bytes,
            interleaved,
            row_bytes: block_width * interleaved * sample_bytes,
        }
    }

    /// Fills `block`, some whole rows.
    pub(crate) fn decode(&self, stored: &[u8], block: &mut [u8]) -> Result<(), DecodeError> {
        let filled = match self.compression {
            5 => unpack_lzw(stored, block),
            8 | 32946 => inflate(stored, block),
            32773 => unpack_bits(stored, block),
            _ => copy(stored, block),
        };
        if !filled {
            let reason =
                format!("a block of {} stored bytes does not decode to its {} bytes", stored.len(), block.len());
            return Err(damaged(reason));
        }
        let mut shuffled = vec![0; if self.predictor == 3 { self.row_bytes } else { 0 }];
        for row in block.chunks_exact_mut(self.row_bytes) {
            match self.predictor {
                3 => self.undo_float_differences(row, &mut shuffled),
                predictor => {
                    self.to_native_order(row);
                    if predictor == 2 {
                        self.undo_differences(row);
                    }
                }
            }
        }
        Ok(())
    }

    fn to_native_order(&self, row: &mut [u8]) {
        if self.little_endian != cfg!(target_endian = "little") {
            row.chunks_exact_mut(self.sample_bytes).for_each(<[u8]>::reverse);
        }
    }

    /// Predictor 2: each sample is stored as the difference from its left neighbour, as an integer, even if it is a float.
    fn undo_differences(&self, row: &mut [u8]) {
        macro_rules! undo {
            ($type:ty) => {{
                let (samples, _) = row.as_chunks_mut();
                for i in self.interleaved..samples.len() {
                    let left = <$type>::from_ne_bytes(samples[i - self.interleaved]);
                    samples[i] = left.wrapping_add(<$type>::from_ne_bytes(samples[i])).to_ne_bytes();
                }
            }};
        }
        match self.sample_bytes {
            1 => undo!(u8),
            2 => undo!(u16),
            4 => undo!(u32),
            _ => undo!(u64),
        }
    }

    /// Predictor 3: all first (most significant) bytes of a row's floats, then all second ones, and so on; of this row of
    /// bytes, the differences.
    fn undo_float_differences(&self, row: &mut [u8], shuffled: &mut [u8]) {
        shuffled.copy_from_slice(row);
        for i in self.interleaved..shuffled.len() {
            shuffled[i] = shuffled[i].wrapping_add(shuffled[i - self.interleaved]);
        }
        let samples = shuffled.len() / self.sample_bytes;
        for (i, sample) in row.chunks_exact_mut(self.sample_bytes).enumerate() {
            for (position, byte) in sample.iter_mut().enumerate() {
                let little_endian = cfg!(target_endian = "little");
                let significance = if little_endian { self.sample_bytes - 1 - position } else { position };
                *byte = shuffled[significance * samples + i];
            }
        }
    }
}

// Each of the following tells whether `block` was filled. What a writer put after that is ignored, as libtiff ignores it.

fn copy(stored: &[u8], block: &mut [u8]) -> bool {
    stored.get(..block.len()).map(|bytes| block.copy_from_slice(bytes)).is_some()
}

fn unpack_lzw(mut stored: &[u8], mut block: &mut [u8]) -> bool {
    let mut decoder = Configuration::with_tiff_size_switch(BitOrder::Msb, 8).with_yield_on_full_buffer(true).build();
    while !block.is_empty() {
        let step = decoder.decode_bytes(stored, block);
        stored = &stored[step.consumed_in..];
        block = &mut block[step.consumed_out..];
        let stuck = step.consumed_in == 0 && step.consumed_out == 0;
        if stuck || matches!(step.status, Ok(LzwStatus::Done) | Err(_)) {
            break;
        }
    }
    block.is_empty()
}

fn inflate(stored: &[u8], block: &mut [u8]) -> bool {
    let mut decoder = Decompress::new(true);
    // A checksum that is wrong is an error even where all bytes came out.
    decoder.decompress(stored, block, FlushDecompress::Finish).is_ok() && decoder.total_out() == block.len() as u64
}

fn unpack_bits(mut stored: &[u8], mut block: &mut [u8]) -> bool {
    while let ([head, rest @ ..], false) = (stored, block.is_empty()) {
        // 0 … 127: so many bytes and one more as they are; 129 … 255: the next byte, 257 − head times; 128: nothing.
        let (taken, given) = match usize::from(*head) {
            head @ 0..128 => (head + 1, head + 1),
            128 => (0, 0),
            head => (1, 257 - head),
        };
        let Some((source, rest)) = rest.split_at_checked(taken) else { return false };
        let (target, free) = block.split_at_mut(given.min(block.len()));
        for (byte, source) in target.iter_mut().zip(source.iter().cycle()) {
            *byte = *source;
        }
        (stored, block) = (rest, free);
    }
    block.is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packbits_as_in_the_specification() {
        let stored = b"\xFE\xAA\x02\x80\x00\x2A\xFD\xAA\x03\x80\x00\x2A\x22\xF7\xAA";
        let mut block = [0; 24];
        assert!(unpack_bits(stored, &mut block));
        assert_eq!(&block[..14], b"\xAA\xAA\xAA\x80\x00\x2A\xAA\xAA\xAA\xAA\x80\x00\x2A\x22");
        assert_eq!(&block[14..], [0xAA; 10]);
        assert!(!unpack_bits(stored, &mut [0; 25]));
        assert!(!unpack_bits(b"\x05\x01", &mut [0; 6]));
        assert!(unpack_bits(b"\x80\x00\x07", &mut [0; 1]));
    }
}
