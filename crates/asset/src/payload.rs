//! Decoding a section's payload within limits.

use core::fmt;
use std::borrow::Cow;
use std::io::Read;
use std::string::{String, ToString};
use std::vec::Vec;

use ruzstd::decoding::{BlockDecodingStrategy, FrameDecoder};

use crate::{Codec, Limits, Section};

/// Why a payload could not be decoded.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum PayloadError {
    /// A codec this version does not know.
    Codec {
        /// Its number.
        found: u16,
    },
    /// The decoded payload would be larger than the caller allows.
    TooLarge {
        /// Decoded length in bytes.
        raw_length: u64,
        /// [`Limits::max_decoded_bytes`].
        limit: u64,
    },
    /// The machine has no room for the decoded payload.
    OutOfMemory {
        /// Decoded length in bytes.
        raw_length: u64,
    },
    /// Not a zstd frame, a damaged one, or one with a larger window than [`Limits::max_zstd_window_bytes`].
    Frame {
        /// What the decoder says.
        reason: String,
    },
    /// The frame states or has another length than the section.
    Length {
        /// The section's raw length in bytes.
        raw_length: u64,
        /// What the frame has: its stated length, or a lower bound if it has more than that.
        found: u64,
    },
    /// Bytes follow the frame.
    Trailing {
        /// How many.
        bytes: u64,
    },
}

impl PayloadError {
    /// The number of the finding that `validate` reports for this error; listed in `formats/barchan-v1.md`.
    #[must_use]
    pub fn id(&self) -> &'static str {
        match self {
            Self::Codec { .. } => "B0216",
            Self::TooLarge { .. } | Self::OutOfMemory { .. } => "B0304",
            Self::Frame { .. } => "B0305",
            Self::Length { .. } => "B0306",
            Self::Trailing { .. } => "B0307",
        }
    }
}

impl fmt::Display for PayloadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Codec { found } => write!(f, "codec {found} is not known; 0 (raw) and 1 (zstd) are accepted"),
            Self::TooLarge { raw_length, limit } => {
                write!(f, "raw_length is {raw_length}; at most {limit} bytes are accepted")
            }
            Self::OutOfMemory { raw_length } => write!(f, "no memory for raw_length {raw_length}"),
            Self::Frame { reason } => write!(f, "the zstd frame cannot be decoded: {reason}"),
            Self::Length { raw_length, found } => {
                write!(f, "the zstd frame has {found} bytes; raw_length is {raw_length}")
            }
            Self::Trailing { bytes } => write!(f, "{bytes} bytes follow the zstd frame; none are accepted"),
        }
    }
}

impl core::error::Error for PayloadError {}

impl<'a> Section<'a> {
    /// The decoded payload: borrowed if it is stored raw. Checks no checksum; see [`Self::is_intact`].
    ///
    /// Allocates at most the raw length and the zstd window, each after it was found within `limits`.
    ///
    /// # Errors
    /// An unknown codec, a length or window beyond `limits`, or a frame that does not decode to exactly the raw length.
    pub fn payload(&self, limits: &Limits) -> Result<Cow<'a, [u8]>, PayloadError> {
        match self.codec() {
            Some(Codec::Raw) => Ok(Cow::Borrowed(self.stored_payload())),
            Some(Codec::Zstd) => decode_frame(self.stored_payload(), self.raw_length(), limits).map(Cow::Owned),
            None => Err(PayloadError::Codec { found: self.codec_number() }),
        }
    }
}

/// Decodes the single frame `stored`, which must have exactly `raw_length` bytes.
fn decode_frame(mut stored: &[u8], raw_length: u64, limits: &Limits) -> Result<Vec<u8>, PayloadError> {
    let limit = limits.max_decoded_bytes;
    if raw_length > limit {
        return Err(PayloadError::TooLarge { raw_length, limit });
    }
    let mut decoder = FrameDecoder::new();
    decoder.set_max_window_size(limits.max_zstd_window_bytes);
    decoder.init(&mut stored).map_err(|error| frame_error(&error))?;
    let length_error = |found| PayloadError::Length { raw_length, found };
    if decoder.content_size() != raw_length {
        return Err(length_error(decoder.content_size()));
    }
    let mut out = zeroed(raw_length)?;
    let mut filled = 0;
    while !decoder.is_finished() {
        decoder
            .decode_blocks(&mut stored, BlockDecodingStrategy::UptoBlocks(1))
            .map_err(|error| frame_error(&error))?;
        filled += decoder.read(&mut out[filled..]).map_err(|error| frame_error(&error))?;
        let pending = decoder.can_collect();
        if pending > 0 {
            return Err(length_error(raw_length.saturating_add(pending as u64)));
        }
    }
    match (filled == out.len(), stored.len() as u64) {
        (false, _) => Err(length_error(filled as u64)),
        (true, 0) => Ok(out),
        (true, bytes) => Err(PayloadError::Trailing { bytes }),
    }
}

fn frame_error(error: &impl ToString) -> PayloadError {
    PayloadError::Frame { reason: error.to_string() }
}

fn zeroed(raw_length: u64) -> Result<Vec<u8>, PayloadError> {
    let none = PayloadError::OutOfMemory { raw_length };
    let Ok(length) = usize::try_from(raw_length) else { return Err(none) };
    let mut out = Vec::new();
    if out.try_reserve_exact(length).is_err() {
        return Err(none);
    }
    out.resize(length, 0);
    Ok(out)
}
