//! The words of a texture descriptor, each with its number in the file.

use crate::SectionKind;

/// Gives an enum its numbers in the file and its names, from one list.
macro_rules! numbered {
    ($name:ident: $($variant:ident = $number:literal $text:literal),+) => {
        impl $name {
            /// The numbers and names a file may hold, for messages.
            pub(crate) const ACCEPTED: &'static str = numbered!(@list $($number $text),+);

            /// The number in the file.
            #[must_use]
            pub fn number(self) -> u32 {
                match self { $(Self::$variant => $number),+ }
            }

            /// The value with that number, if this version knows it.
            #[must_use]
            pub fn from_number(number: u32) -> Option<Self> {
                match number { $($number => Some(Self::$variant),)+ _ => None }
            }

            /// The name printed for people and in JSON.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $text),+ }
            }
        }
    };
    (@list $number:literal $text:literal $(, $n:literal $t:literal)*) => {
        concat!($number, " (", $text, ")" $(, ", ", $n, " (", $t, ")")*)
    };
}

/// How a texel is stored; the number is Vulkan's `VkFormat`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// One byte k, standing for k / 255.
    R8Unorm,
    /// One IEEE binary16.
    R16Float,
    /// One IEEE binary32; not filterable on every GPU.
    R32Float,
}

numbered!(Format: R8Unorm = 9 "R8_UNORM", R16Float = 76 "R16_SFLOAT", R32Float = 100 "R32_SFLOAT");

impl Format {
    /// Bytes of one texel.
    #[must_use]
    pub fn texel_bytes(self) -> u32 {
        match self {
            Self::R8Unorm => 1,
            Self::R16Float => 2,
            Self::R32Float => 4,
        }
    }
}

/// What the texels mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Semantic {
    /// Height above the field's zero.
    Height,
    /// Signed elevation angle of the horizon: 0 is level, negative is below.
    HorizonElevation,
    /// Horizontal distance to the horizon point.
    HorizonDistance,
}

numbered!(Semantic: Height = 1 "height", HorizonElevation = 2 "horizon elevation", HorizonDistance = 3 "horizon distance");

impl Semantic {
    /// The kind of section that holds such a table.
    #[must_use]
    pub fn kind(self) -> SectionKind {
        match self {
            Self::Height => SectionKind::HEIGHT,
            Self::HorizonElevation => SectionKind::HORIZON,
            Self::HorizonDistance => SectionKind::DISTANCE,
        }
    }

    /// What a section of that kind holds; `None` if it is not a table of texels.
    #[must_use]
    pub fn of_kind(kind: SectionKind) -> Option<Self> {
        [Self::Height, Self::HorizonElevation, Self::HorizonDistance].into_iter().find(|s| s.kind() == kind)
    }

    /// Whether there is one layer per azimuth.
    #[must_use]
    pub fn is_directional(self) -> bool {
        self != Self::Height
    }
}

/// The length unit of heights, spacings and distances. It labels; nothing is converted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum LengthUnit {
    /// The scene's own unit, whatever that is.
    #[default]
    SceneUnit,
    /// Metres.
    Metre,
    /// Centimetres.
    Centimetre,
    /// Millimetres.
    Millimetre,
    /// Kilometres.
    Kilometre,
}

numbered!(LengthUnit:
    SceneUnit = 2 "scene_unit", Metre = 3 "metre", Centimetre = 4 "centimetre",
    Millimetre = 5 "millimetre", Kilometre = 6 "kilometre");

impl LengthUnit {
    /// The symbol printed after a length.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::SceneUnit => "units",
            Self::Metre => "m",
            Self::Centimetre => "cm",
            Self::Millimetre => "mm",
            Self::Kilometre => "km",
        }
    }
}

/// The unit of decoded values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Unit {
    /// Radians; 1 in the file.
    Radian,
    /// A length; its own numbers in the file.
    Length(LengthUnit),
}

impl Unit {
    pub(crate) const ACCEPTED: &'static str =
        "1 (radian), 2 (scene_unit), 3 (metre), 4 (centimetre), 5 (millimetre), 6 (kilometre)";

    /// The number in the file.
    #[must_use]
    pub fn number(self) -> u32 {
        match self {
            Self::Radian => 1,
            Self::Length(length) => length.number(),
        }
    }

    /// The unit with that number, if this version knows it.
    #[must_use]
    pub fn from_number(number: u32) -> Option<Self> {
        match number {
            1 => Some(Self::Radian),
            _ => LengthUnit::from_number(number).map(Self::Length),
        }
    }

    /// The name printed for people and in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Radian => "radian",
            Self::Length(length) => length.name(),
        }
    }

    /// The symbol printed after a value.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Radian => "rad",
            Self::Length(length) => length.symbol(),
        }
    }
}

/// What lies beyond the outermost texels; the address mode to sample with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Wrap {
    /// The table repeats.
    Repeat,
    /// The outermost texel goes on for ever.
    Clamp,
}

numbered!(Wrap: Repeat = 1 "repeat", Clamp = 2 "clamp");

/// How to interpolate between texels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Filter {
    /// Bilinear within a layer. Layers of a directional table are interpolated by the reader, cyclically.
    Linear,
}

numbered!(Filter: Linear = 1 "linear");

/// How four texels become one on the next coarser mip level.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MipReducer {
    /// Their mean.
    Mean,
    /// Their minimum.
    Min,
    /// Their maximum.
    Max,
}

numbered!(MipReducer: Mean = 1 "mean", Min = 2 "min", Max = 3 "max");

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_back_and_zero_means_nothing() {
        for number in 1..=6 {
            assert_eq!(Unit::from_number(number).unwrap().number(), number);
        }
        for format in [Format::R8Unorm, Format::R16Float, Format::R32Float] {
            assert_eq!(Format::from_number(format.number()), Some(format));
        }
        assert_eq!(Unit::from_number(0), None);
        assert_eq!(LengthUnit::from_number(1), None);
        assert_eq!(Wrap::from_number(0), None);
        assert_eq!(MipReducer::from_number(0), None);
    }

    #[test]
    fn messages_list_what_is_accepted() {
        assert_eq!(Format::ACCEPTED, "9 (R8_UNORM), 76 (R16_SFLOAT), 100 (R32_SFLOAT)");
        assert_eq!(Filter::ACCEPTED, "1 (linear)");
    }
}
