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

pub(crate) use numbered;

/// How a texel is stored; the number is Vulkan's `VkFormat`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Format {
    /// One byte k, standing for k / 255.
    R8Unorm,
    /// Two such bytes.
    Rg8Unorm,
    /// Four such bytes.
    Rgba8Unorm,
    /// One IEEE binary16.
    R16Float,
    /// Two of them.
    Rg16Float,
    /// Four of them.
    Rgba16Float,
    /// One IEEE binary32; not filterable on every GPU.
    R32Float,
    /// Two of them.
    Rg32Float,
    /// Four of them.
    Rgba32Float,
}

numbered!(Format:
    R8Unorm = 9 "R8_UNORM", Rg8Unorm = 16 "R8G8_UNORM", Rgba8Unorm = 37 "R8G8B8A8_UNORM",
    R16Float = 76 "R16_SFLOAT", Rg16Float = 83 "R16G16_SFLOAT", Rgba16Float = 97 "R16G16B16A16_SFLOAT",
    R32Float = 100 "R32_SFLOAT", Rg32Float = 103 "R32G32_SFLOAT", Rgba32Float = 109 "R32G32B32A32_SFLOAT");

/// How one channel of a texel is stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Component {
    /// One byte k, standing for k / 255.
    Unorm8,
    /// One IEEE binary16.
    Float16,
    /// One IEEE binary32.
    Float32,
}

impl Component {
    /// Bytes of one channel.
    #[must_use]
    pub fn bytes(self) -> u32 {
        match self {
            Self::Unorm8 => 1,
            Self::Float16 => 2,
            Self::Float32 => 4,
        }
    }
}

impl Format {
    /// The formats of version 1 of the descriptor, for messages.
    pub(crate) const ACCEPTED_IN_VERSION_1: &'static str = "9 (R8_UNORM), 76 (R16_SFLOAT), 100 (R32_SFLOAT)";

    /// How each channel is stored.
    #[must_use]
    pub fn component(self) -> Component {
        match self {
            Self::R8Unorm | Self::Rg8Unorm | Self::Rgba8Unorm => Component::Unorm8,
            Self::R16Float | Self::Rg16Float | Self::Rgba16Float => Component::Float16,
            Self::R32Float | Self::Rg32Float | Self::Rgba32Float => Component::Float32,
        }
    }

    /// Numbers in a texel: 1, 2 or 4, interleaved.
    #[must_use]
    pub fn channels(self) -> u32 {
        match self {
            Self::R8Unorm | Self::R16Float | Self::R32Float => 1,
            Self::Rg8Unorm | Self::Rg16Float | Self::Rg32Float => 2,
            Self::Rgba8Unorm | Self::Rgba16Float | Self::Rgba32Float => 4,
        }
    }

    /// Bytes of one texel, all channels.
    #[must_use]
    pub fn texel_bytes(self) -> u32 {
        self.channels() * self.component().bytes()
    }
}

/// What becomes of `t = scale · stored + bias`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Transfer {
    /// t is the value.
    #[default]
    Identity,
    /// t is the sine of the value, an elevation: a shadow test compares sines and never needs the angle.
    Sine,
    /// t² is the value, a distance or the ratio of a cone: small ones are resolved more finely than large ones.
    Square,
}

numbered!(Transfer: Identity = 0 "identity", Sine = 1 "sine", Square = 2 "square");

/// What the texels mean.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Semantic {
    /// Height above the field's zero.
    Height,
    /// Signed elevation angle of the horizon: 0 is level, negative is below.
    HorizonElevation,
    /// Horizontal distance to the horizon point.
    HorizonDistance,
    /// Elevation angles of further points that become the horizon where the base surface is curved.
    SweptElevation,
    /// Horizontal distances to those points.
    SweptDistance,
    /// Cosine-weighted share of the sky that is seen: 1 is open.
    SkyVisibility,
    /// The mean direction of the visible sky: its components along u and v.
    BentNormal,
    /// The cone of directions towards the visible sky: its axis and the cosine of its half-angle.
    ApertureCone,
    /// The depth at which rays of a cell of directions first meet the relief.
    HemisphereDepth,
    /// Depth, and the ratio of the widest cone above it that the relief stays out of.
    ConeMap,
    /// Depth, and the ratio of the widest cone in which a ray pierces the relief once at most.
    RelaxedConeMap,
    /// The greatest height of a cell between texels, and of squares of cells level by level.
    MaximumHeight,
}

numbered!(Semantic:
    Height = 1 "height", HorizonElevation = 2 "horizon elevation", HorizonDistance = 3 "horizon distance",
    SweptElevation = 4 "swept horizon elevation", SweptDistance = 5 "swept horizon distance",
    SkyVisibility = 6 "sky visibility", BentNormal = 7 "bent normal", ApertureCone = 8 "aperture cone",
    HemisphereDepth = 9 "hemisphere depth", ConeMap = 10 "cone map", RelaxedConeMap = 11 "relaxed cone map",
    MaximumHeight = 12 "maximum height");

impl Semantic {
    /// Every semantic, by number.
    pub const ALL: [Self; 12] = [
        Self::Height,
        Self::HorizonElevation,
        Self::HorizonDistance,
        Self::SweptElevation,
        Self::SweptDistance,
        Self::SkyVisibility,
        Self::BentNormal,
        Self::ApertureCone,
        Self::HemisphereDepth,
        Self::ConeMap,
        Self::RelaxedConeMap,
        Self::MaximumHeight,
    ];

    /// The semantics of version 2 of the descriptor, for messages.
    pub(crate) const ACCEPTED_IN_VERSION_2: &'static str = "1 (height) to 8 (aperture cone)";
    /// The semantics of version 3 of the descriptor, for messages.
    pub(crate) const ACCEPTED_IN_VERSION_3: &'static str = "9 (hemisphere depth) to 12 (maximum height)";

    /// The semantics of version 1 of the descriptor, for messages.
    pub(crate) const ACCEPTED_IN_VERSION_1: &'static str = "1 (height), 2 (horizon elevation), 3 (horizon distance)";

    /// The kind of section that holds such a table.
    #[must_use]
    pub fn kind(self) -> SectionKind {
        match self {
            Self::Height => SectionKind::HEIGHT,
            Self::HorizonElevation => SectionKind::HORIZON,
            Self::HorizonDistance => SectionKind::DISTANCE,
            Self::SweptElevation => SectionKind::SWEPT_HORIZON,
            Self::SweptDistance => SectionKind::SWEPT_DISTANCE,
            Self::SkyVisibility => SectionKind::SKY_VISIBILITY,
            Self::BentNormal => SectionKind::BENT_NORMAL,
            Self::ApertureCone => SectionKind::APERTURE_CONE,
            Self::HemisphereDepth => SectionKind::HEMISPHERE,
            Self::ConeMap => SectionKind::CONE_MAP,
            Self::RelaxedConeMap => SectionKind::RELAXED_CONE_MAP,
            Self::MaximumHeight => SectionKind::MAXIMUM_MIP,
        }
    }

    /// What a section of that kind holds; `None` if it is not a table of texels.
    #[must_use]
    pub fn of_kind(kind: SectionKind) -> Option<Self> {
        Self::ALL.into_iter().find(|semantic| semantic.kind() == kind)
    }

    /// Whether layers belong to azimuths: one each, or for each one per candidate or ring.
    #[must_use]
    pub fn is_directional(self) -> bool {
        self.is_elevation() || self.is_distance() || self == Self::HemisphereDepth
    }

    /// Whether there are several candidates per azimuth.
    #[must_use]
    pub fn is_swept(self) -> bool {
        matches!(self, Self::SweptElevation | Self::SweptDistance)
    }

    /// Whether a texel is a depth and the ratio of a cone.
    #[must_use]
    pub fn is_cone_map(self) -> bool {
        matches!(self, Self::ConeMap | Self::RelaxedConeMap)
    }

    /// Whether the table speeds up the search for where a ray meets the relief; those have version 3 of the descriptor.
    #[must_use]
    pub fn is_relief_search(self) -> bool {
        matches!(self, Self::HemisphereDepth | Self::ConeMap | Self::RelaxedConeMap | Self::MaximumHeight)
    }

    /// Whether values are depths, so that the descriptor says where depth 0 and 1 are.
    #[must_use]
    pub fn has_depths(self) -> bool {
        self == Self::HemisphereDepth || self.is_cone_map()
    }

    /// Whether stored numbers of a channel are values as they are: `scale`, `bias` and `transfer` are of the others. So
    /// are the depths of a cone map.
    #[must_use]
    pub fn is_plain(self, channel: u32) -> bool {
        self.is_cone_map() && channel == 0
    }

    pub(crate) fn is_elevation(self) -> bool {
        matches!(self, Self::HorizonElevation | Self::SweptElevation)
    }

    pub(crate) fn is_distance(self) -> bool {
        matches!(self, Self::HorizonDistance | Self::SweptDistance)
    }

    /// Numbers in a texel.
    #[must_use]
    pub fn channels(self) -> u32 {
        match self {
            Self::BentNormal | Self::ConeMap | Self::RelaxedConeMap => 2,
            Self::ApertureCone => 4,
            _ => 1,
        }
    }

    /// The unit of decoded values, where lengths have that unit.
    #[must_use]
    pub fn unit(self, length_unit: LengthUnit) -> Unit {
        match self {
            Self::HorizonElevation | Self::SweptElevation => Unit::Radian,
            Self::Height | Self::HorizonDistance | Self::SweptDistance | Self::MaximumHeight => {
                Unit::Length(length_unit)
            }
            Self::SkyVisibility | Self::BentNormal | Self::ApertureCone => Unit::None,
            Self::HemisphereDepth | Self::ConeMap | Self::RelaxedConeMap => Unit::None,
        }
    }

    /// Whether values may be stored so.
    pub(crate) fn allows(self, transfer: Transfer) -> bool {
        match transfer {
            Transfer::Identity => true,
            Transfer::Sine => self.is_elevation(),
            Transfer::Square => self.is_distance() || self.is_cone_map(),
        }
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
    /// No unit: a share, a cosine, a component of a unit vector; 7 in the file.
    None,
}

impl Unit {
    pub(crate) const ACCEPTED: &'static str = "1 (radian), 2 (scene_unit), 3 (metre), 4 (centimetre), 5 (millimetre), 6 (kilometre), \
         7 (none)";

    /// The number in the file.
    #[must_use]
    pub fn number(self) -> u32 {
        match self {
            Self::Radian => 1,
            Self::Length(length) => length.number(),
            Self::None => 7,
        }
    }

    /// The unit with that number, if this version knows it.
    #[must_use]
    pub fn from_number(number: u32) -> Option<Self> {
        match number {
            1 => Some(Self::Radian),
            7 => Some(Self::None),
            _ => LengthUnit::from_number(number).map(Self::Length),
        }
    }

    /// The name printed for people and in JSON.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Radian => "radian",
            Self::Length(length) => length.name(),
            Self::None => "none",
        }
    }

    /// The symbol printed after a value.
    #[must_use]
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Radian => "rad",
            Self::Length(length) => length.symbol(),
            Self::None => "",
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
    /// Bilinear within a layer. Layers of a directional table are interpolated by the reader: [`crate::Azimuths`].
    Linear,
    /// The texel whose area holds the place: what is true of one texel's area is not true of a mixture.
    Nearest,
}

numbered!(Filter: Linear = 1 "linear", Nearest = 2 "nearest");

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
        for number in 1..=7 {
            assert_eq!(Unit::from_number(number).unwrap().number(), number);
        }
        for number in [9, 16, 37, 76, 83, 97, 100, 103, 109] {
            let format = Format::from_number(number).unwrap();
            assert_eq!((format.number(), format.texel_bytes() % format.channels()), (number, 0));
        }
        for semantic in Semantic::ALL {
            assert_eq!(Semantic::from_number(semantic.number()), Some(semantic));
            assert_eq!(Semantic::of_kind(semantic.kind()), Some(semantic));
        }
        assert_eq!(Unit::from_number(0), None);
        assert_eq!(LengthUnit::from_number(1), None);
        assert_eq!(Wrap::from_number(0), None);
        assert_eq!(MipReducer::from_number(0), None);
        assert_eq!(Transfer::from_number(0), Some(Transfer::Identity));
    }

    #[test]
    fn messages_list_what_is_accepted() {
        assert!(Format::ACCEPTED.starts_with("9 (R8_UNORM), 16 (R8G8_UNORM), "));
        assert_eq!(Filter::ACCEPTED, "1 (linear), 2 (nearest)");
    }
}
