//! Samples as a file stores them.

use half::f16;

use crate::{DecodeError, Format, limits::zeroed};

/// One channel of a decoded file, not yet scaled.
pub(crate) struct RawMap {
    pub(crate) format: Format,
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// Row by row from the top; `width * height` of them.
    pub(crate) samples: Samples,
    /// What the file stored; its bits may be fewer than those of `samples`.
    pub(crate) sample_type: SampleType,
    /// The channel the samples came from.
    pub(crate) channel: String,
    /// The raw value that the file itself declares to be no data.
    pub(crate) no_data: Option<f64>,
}

/// How a file stores one sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SampleType {
    /// `u`, `i` or `f`.
    pub(crate) kind: char,
    pub(crate) bits: u8,
}

impl SampleType {
    /// What a sample is divided by before it is scaled: 1 for floats.
    pub(crate) fn full_scale(self) -> f64 {
        match self.kind {
            'u' => ((1_u64 << self.bits) - 1) as f64,
            'i' => ((1_u64 << (self.bits - 1)) - 1) as f64,
            _ => 1.0,
        }
    }

    /// `u16`, `f32` and so on.
    pub(crate) fn name(self) -> String {
        format!("{}{}", self.kind, self.bits)
    }
}

/// A number that files store, exactly representable in f64.
pub(crate) trait Sample: Copy + Default {
    const TYPE: SampleType;
    const BYTES: usize;
    /// From the first `BYTES` bytes.
    fn from_native(bytes: &[u8]) -> Self;
    fn to_f64(self) -> f64;
    /// The nearest value of a float type; integers are not rounded to.
    fn round(value: f64) -> f64;
}

macro_rules! samples {
    ($($variant:ident $type:ty, $kind:literal $bits:literal, $round:expr;)*) => {
        /// Samples of any type that files store. Channels may be interleaved or one after the other.
        #[derive(Debug, Clone, PartialEq)]
        pub(crate) enum Samples { $($variant(Vec<$type>),)* }

        $(impl Sample for $type {
            const TYPE: SampleType = SampleType { kind: $kind, bits: $bits };
            const BYTES: usize = $bits / 8;
            fn from_native(bytes: &[u8]) -> Self { Self::from_ne_bytes(std::array::from_fn(|i| bytes[i])) }
            fn to_f64(self) -> f64 { self.into() }
            fn round(value: f64) -> f64 { let round: fn(f64) -> f64 = $round; round(value) }
        })*

        impl Samples {
            /// `len` zeros of a type, if there is such a type.
            pub(crate) fn zeroed(sample_type: SampleType, len: usize) -> Option<Result<Self, DecodeError>> {
                match (sample_type.kind, sample_type.bits) {
                    $(($kind, $bits) => Some(zeroed(len).map(Self::$variant)),)*
                    _ => None,
                }
            }

            pub(crate) fn sample_type(&self) -> SampleType {
                match self { $(Self::$variant(_) => <$type>::TYPE,)* }
            }
        }

        /// Evaluates `$body` with `$v` bound to the vector, whatever its type.
        macro_rules! with_samples {
            ($samples:expr, $v:ident => $body:expr) => {
                match $samples { $($crate::samples::Samples::$variant($v) => $body,)* }
            };
            ($samples:expr, $v:ident => wrap $body:expr) => {
                match $samples { $($crate::samples::Samples::$variant($v) => $crate::samples::Samples::$variant($body),)* }
            };
        }
    };
}

samples! {
    U8 u8, 'u' 8, |v| v;
    U16 u16, 'u' 16, |v| v;
    U32 u32, 'u' 32, |v| v;
    I8 i8, 'i' 8, |v| v;
    I16 i16, 'i' 16, |v| v;
    I32 i32, 'i' 32, |v| v;
    F16 f16, 'f' 16, |v| f16::from_f64(v).into();
    F32 f32, 'f' 32, |v| (v as f32).into();
    F64 f64, 'f' 64, |v| v;
}

// A macro has a path only through such an import.
#[allow(clippy::single_component_path_imports)]
pub(crate) use with_samples;
