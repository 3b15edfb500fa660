//! What a descriptor may say.

use core::f64::consts::{FRAC_PI_2, TAU};

use super::{MAX_EXTENT, MAX_LAYERS, TextureDescriptor};
use crate::{Component, DepthMode, DescriptorError, Filter, Format, MipReducer, RingSpacing, Semantic, Transfer};

impl TextureDescriptor {
    /// Whether every field is within the format and all agree with each other.
    ///
    /// # Errors
    /// The first field that does not, with its value and what would be accepted.
    pub fn check(&self) -> Result<(), DescriptorError> {
        self.check_extent()?;
        self.check_unit()?;
        self.check_encoding()?;
        self.check_range()?;
        self.check_sweep()?;
        self.check_geometry()?;
        self.check_relief()
    }

    /// Refuses what a section of that version cannot say.
    pub(super) fn fits(&self, version: u16) -> Result<(), DescriptorError> {
        let accepted = match version {
            1 => return self.fits_version_1(),
            2 => Semantic::ACCEPTED_IN_VERSION_2,
            _ => Semantic::ACCEPTED_IN_VERSION_3,
        };
        word("semantic", self.semantic.number(), self.semantic.is_relief_search() == (version > 2), accepted)
    }

    /// Refuses what version 1 of the descriptor cannot say.
    fn fits_version_1(&self) -> Result<(), DescriptorError> {
        let plain_format = self.format.channels() == 1;
        word("vk_format", self.format.number(), plain_format, Format::ACCEPTED_IN_VERSION_1)?;
        let known = matches!(self.semantic, Semantic::Height | Semantic::HorizonElevation | Semantic::HorizonDistance);
        word("semantic", self.semantic.number(), known, Semantic::ACCEPTED_IN_VERSION_1)?;
        word("transfer", self.transfer.number(), self.transfer == Transfer::Identity, "0 (identity)")?;
        word("candidates", self.candidates, self.candidates == 0, "0")?;
        for (field, found) in [("curvature_min", self.curvature_min), ("curvature_max", self.curvature_max)] {
            real(field, found, found == 0.0, "0")?;
        }
        real("first_azimuth", self.first_azimuth, self.first_azimuth == 0.0, "0")?;
        let step = self.azimuth_step;
        if self.semantic.is_directional() {
            real("azimuth_step", step, step == TAU / f64::from(self.layers), "2π / layers")
        } else {
            real("azimuth_step", step, step == 0.0, "0 for heights")
        }
    }

    fn check_extent(&self) -> Result<(), DescriptorError> {
        let max_layers = if self.semantic.is_directional() { MAX_LAYERS } else { 1 };
        let mips = if self.semantic == Semantic::MaximumHeight { self.levels_to_one_texel() } else { 1 };
        let (min_rings, max_rings) = if self.semantic == Semantic::HemisphereDepth { (1, MAX_LAYERS) } else { (0, 0) };
        for (field, found, min, max) in [
            ("width", self.width, 1, MAX_EXTENT),
            ("height", self.height, 1, MAX_EXTENT),
            ("rings", self.rings, min_rings, max_rings),
            ("layers", self.layers, 1, max_layers),
            ("mips", self.mips, mips, mips),
        ] {
            if !(min..=max).contains(&found) {
                return Err(DescriptorError::Extent { field, found, min, max });
            }
        }
        if !self.layers.is_multiple_of(self.rings.max(1)) {
            return Err(DescriptorError::Rings { found: self.rings, layers: self.layers });
        }
        let (found, expected) = (self.format.channels(), self.semantic.channels());
        if found != expected {
            return Err(DescriptorError::Channels { found, expected, semantic: self.semantic });
        }
        Ok(())
    }

    fn check_unit(&self) -> Result<(), DescriptorError> {
        let expected = self.semantic.unit(self.length_unit);
        if self.unit != expected {
            let accepted = match self.semantic {
                semantic if semantic.is_elevation() => "1 (radian) for elevations",
                Semantic::Height | Semantic::HorizonDistance | Semantic::SweptDistance | Semantic::MaximumHeight => {
                    "the same number as length_unit"
                }
                _ => "7 (none) for what is not an elevation or a length",
            };
            return Err(DescriptorError::Enumeration { field: "unit", found: self.unit.number(), accepted });
        }
        Ok(())
    }

    fn check_encoding(&self) -> Result<(), DescriptorError> {
        let (scale, bias) = (self.scale, self.bias);
        if self.format.component() == Component::Float32 {
            real("scale", scale, scale == 1.0, "1 for 32-bit floats")?;
            real("bias", bias, bias == 0.0, "0 for 32-bit floats")?;
        }
        real("scale", scale, is_f32(scale) && scale >= 0.0, "0 or more, finite and exact as f32")?;
        real("bias", bias, is_f32(bias), "finite and exact as f32")?;
        let error = self.worst_case_error;
        real("worst_case_error", error, error.is_finite() && error >= 0.0, "0 or more and finite")?;
        if !self.semantic.allows(self.transfer) {
            return Err(DescriptorError::Transfer { found: self.transfer, semantic: self.semantic });
        }
        let (filter, accepted) = match self.semantic {
            Semantic::HemisphereDepth | Semantic::MaximumHeight => {
                (Filter::Nearest, "2 (nearest) for hemisphere depths and maximum heights")
            }
            _ => (Filter::Linear, "1 (linear)"),
        };
        word("filter", self.filter.number(), self.filter == filter, accepted)?;
        let maxima = self.semantic != Semantic::MaximumHeight || self.mip_reducer == MipReducer::Max;
        word("mip_reducer", self.mip_reducer.number(), maxima, "3 (max) for maximum heights")
    }

    fn check_range(&self) -> Result<(), DescriptorError> {
        let (min, max) = (self.range_min, self.range_max);
        real("range_min", min, is_f32(min), "finite and exact as f32")?;
        real("range_max", max, is_f32(max) && min <= max, "range_min or more, finite and exact as f32")?;
        match self.semantic {
            Semantic::Height | Semantic::MaximumHeight => Ok(()),
            // Which of the numbers are depths, a table knows.
            Semantic::ConeMap | Semantic::RelaxedConeMap => real("range_min", min, min >= 0.0, "0 or more"),
            Semantic::HorizonElevation | Semantic::SweptElevation => {
                real("range_min", min, min > -FRAC_PI_2, "above −π/2")?;
                real("range_max", max, max < FRAC_PI_2, "below π/2")
            }
            Semantic::HorizonDistance | Semantic::SweptDistance => {
                real("range_min", min, min >= 0.0, "0 or more")?;
                real("range_max", max, max <= self.search_radius, "search_radius or less")
            }
            Semantic::SkyVisibility | Semantic::HemisphereDepth => {
                real("range_min", min, min >= 0.0, "0 or more")?;
                real("range_max", max, max <= 1.0, "1 or less")
            }
            Semantic::BentNormal | Semantic::ApertureCone => {
                real("range_min", min, min >= -1.0, "−1 or more")?;
                real("range_max", max, max <= 1.0, "1 or less")
            }
        }
    }

    fn check_geometry(&self) -> Result<(), DescriptorError> {
        for (field, spacing) in [("spacing_u", self.spacing_u), ("spacing_v", self.spacing_v)] {
            real(field, spacing, (1e-30..=1e30).contains(&spacing), "1e-30 to 1e30")?;
        }
        let radius = self.search_radius;
        if self.semantic == Semantic::Height || self.semantic.is_relief_search() {
            real("search_radius", radius, radius == 0.0, "0 where no horizon was searched")?;
        } else {
            real("search_radius", radius, radius > 0.0 && radius <= f64::from(f32::MAX), "above 0 and within f32")?;
        }
        let (first, step) = (self.first_azimuth, self.azimuth_step);
        match self.azimuths() {
            Some(azimuths) if azimuths.is_legal() => Ok(()),
            Some(azimuths) => Err(DescriptorError::Azimuths { first, step, count: azimuths.count() }),
            None => {
                real("first_azimuth", first, first == 0.0, "0 where there is no direction")?;
                real("azimuth_step", step, step == 0.0, "0 where there is no direction")
            }
        }
    }

    fn check_sweep(&self) -> Result<(), DescriptorError> {
        let (candidates, min, max) = (self.candidates, self.curvature_min, self.curvature_max);
        if self.semantic.is_swept() {
            if candidates == 0 || !self.layers.is_multiple_of(candidates) {
                return Err(DescriptorError::Candidates { found: candidates, layers: self.layers });
            }
            real("curvature_min", min, min.is_finite(), "finite")?;
            return real("curvature_max", max, max.is_finite() && min <= max, "curvature_min or more and finite");
        }
        if candidates != 0 {
            return Err(DescriptorError::Candidates { found: candidates, layers: self.layers });
        }
        real("curvature_min", min, min == 0.0, "0 for a table that is not swept")?;
        real("curvature_max", max, max == 0.0, "0 for a table that is not swept")
    }

    fn check_relief(&self) -> Result<(), DescriptorError> {
        let (top, thickness) = (self.relief_top, self.relief_thickness);
        if self.semantic.has_depths() {
            real("relief_top", top, top.is_finite(), "finite")?;
            real("relief_thickness", thickness, thickness.is_finite() && thickness >= 0.0, "0 or more and finite")?;
        } else {
            real("relief_top", top, top == 0.0, "0 where there are no depths")?;
            real("relief_thickness", thickness, thickness == 0.0, "0 where there are no depths")?;
        }
        self.check_cells()
    }

    fn check_cells(&self) -> Result<(), DescriptorError> {
        let has_cells = self.semantic == Semantic::HemisphereDepth;
        let (spacing, mode) = (self.ring_spacing, self.depth_mode);
        for (field, found, known) in [
            ("ring_spacing", spacing.map_or(0, RingSpacing::number), RingSpacing::ACCEPTED),
            ("depth_mode", mode.map_or(0, DepthMode::number), DepthMode::ACCEPTED),
        ] {
            word(
                field,
                found,
                (found != 0) == has_cells,
                if has_cells { known } else { "0 where there are no rings" },
            )?;
        }
        if !has_cells {
            return real("max_polar", self.max_polar, self.max_polar == 0.0, "0 where there are no rings");
        }
        let step = self.azimuth_step;
        real("azimuth_step", step, step > 0.0, "above 0: hemisphere depths want an arc of two azimuths or more")?;
        let within = self.max_polar > 0.0 && self.max_polar < FRAC_PI_2;
        real("max_polar", self.max_polar, within, "above 0 and below π/2")
    }
}

fn word(field: &'static str, found: u32, holds: bool, accepted: &'static str) -> Result<(), DescriptorError> {
    if holds { Ok(()) } else { Err(DescriptorError::Enumeration { field, found, accepted }) }
}

fn is_f32(value: f64) -> bool {
    value.is_finite() && f64::from(value as f32) == value
}

fn real(field: &'static str, found: f64, holds: bool, accepted: &'static str) -> Result<(), DescriptorError> {
    if holds { Ok(()) } else { Err(DescriptorError::Number { field, found, accepted }) }
}
