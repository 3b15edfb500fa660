//! How much a reader is willing to allocate.

/// Bounds on what decoding may allocate, set by the caller and checked before anything is allocated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Limits {
    /// Greatest decoded length of one section, in bytes. The default is 1 GiB.
    pub max_decoded_bytes: u64,
    /// Greatest window a zstd frame may ask for, in bytes. The default, 8 MiB, is what the format allows.
    pub max_zstd_window_bytes: u64,
}

impl Limits {
    /// The largest zstd window of a conforming file, in bytes.
    pub const FORMAT_ZSTD_WINDOW_BYTES: u64 = 8 << 20;

    /// No bound but the machine's; for files the caller wrote itself.
    #[must_use]
    pub const fn trusting() -> Self {
        Self { max_decoded_bytes: u64::MAX, ..Self::DEFAULT }
    }

    const DEFAULT: Self = Self { max_decoded_bytes: 1 << 30, max_zstd_window_bytes: Self::FORMAT_ZSTD_WINDOW_BYTES };
}

impl Default for Limits {
    fn default() -> Self {
        Self::DEFAULT
    }
}
