//! The shader of a pipeline, put together from what its asset has and what it is to do.
//!
//! # Parts
//!
//! Every part is WGSL without imports; every global name begins with `barchan_`, `Barchan` or `BARCHAN_`. A shader is
//! 1. `functions.wgsl` and `table.wgsl`: arcs and sines, the uniform buffer of the asset's numbers, and what all tables share;
//! 2. for each table that a technique reads its texture, and functions that load texels and interpolate between them
//!    (`access.rs`): from a 2-D texture, a layered one or a volume, filtered by the sampler or by four loads;
//! 3. a part for each [`Technique`], and for those that they stand on.
//!
//! What no technique asks for is not there: neither its code nor its bindings.
//!
//! # Bindings
//!
//! All in one group, and always at the same numbers: the uniform buffer at 0, the sampler at 1, a texture at 1 + its semantic's
//! number ([`Semantic::number`]), the uniform buffer of probes at 14.
//!
//! # Arithmetic
//!
//! Vulkan promises little of sines and arcsines in a shader (2⁻¹¹ and 4096 ulp), so `functions.wgsl` has its own.

mod access;
mod alike;
mod technique;

use std::fmt;

use barchan_asset::Semantic;

use crate::{Shape, TexturePlan, UploadPlan};
pub use technique::{ReliefSearch, SEARCH_BISECTIONS, SEARCH_STEPS, Technique};

/// How a shader interpolates between texels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Sampling {
    /// By the sampler, one sample for four texels, where the device can filter the format; by four loads where it cannot. What is
    /// interpolated is what is stored, before the transfer: sines of elevations, where the table stores these. A sampler's weights
    /// have 8 bits.
    #[default]
    Filtered,
    /// By four loads: values are decoded first and interpolated in 32-bit floats, as the CPU twin does.
    Loaded,
}

/// How a shader is put together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct ShaderOptions {
    /// The bind group of all bindings.
    pub group: u32,
    /// How it interpolates between texels.
    pub sampling: Sampling,
    /// Whether it has entry points that draw the numbers of its techniques: `barchan_probe_vertex`, and a fragment stage for each.
    pub probes: bool,
}

/// What a shader binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Binding {
    /// The bind group.
    pub group: u32,
    /// The number in the group.
    pub binding: u32,
    /// What is bound there.
    pub kind: BindingKind,
}

/// What is bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BindingKind {
    /// The uniform buffer of the asset's numbers, [`crate::PARAMETER_BYTES`] long.
    Parameters,
    /// The sampler: linear, with the tables' edges as address modes.
    Sampler,
    /// The texture of a table.
    Texture {
        /// Which table.
        table: Semantic,
        /// What kind of texture.
        shape: Shape,
        /// Whether it is sampled through the sampler.
        is_filtered: bool,
    },
    /// The uniform buffer of what probes draw, [`Shader::PROBE_BYTES`] long.
    Probe,
}

/// A shader and what it binds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Shader {
    source: String,
    bindings: Vec<Binding>,
}

/// Why a shader cannot be put together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ComposeError {
    /// A technique needs a table that is not in the plan.
    Missing {
        /// Which technique.
        technique: Technique,
        /// Which table.
        table: Semantic,
    },
    /// Two tables of a technique do not lie alike, so that one place and one azimuth cannot stand for both: in the file, or because other
    /// parts of them were selected.
    Unlike {
        /// Which technique.
        technique: Technique,
        /// One of them.
        table: Semantic,
        /// The other.
        other: Semantic,
        /// What differs.
        field: &'static str,
    },
    /// Shadows of relief need a technique that finds relief.
    NoSearch,
    /// There is one way to find relief in a shader.
    TwoSearches {
        /// One that was named.
        first: Technique,
        /// Another one.
        second: Technique,
    },
}

impl Shader {
    /// Bytes of the uniform buffer of probes.
    pub const PROBE_BYTES: usize = 112;

    /// The binding number of the uniform buffer of probes.
    pub const PROBE_BINDING: u32 = 14;

    /// Puts the shader of some techniques together for the tables of a plan.
    ///
    /// # Errors
    /// A technique whose tables are not in the plan, or techniques that do not go together.
    pub fn compose(plan: &UploadPlan, techniques: &[Technique], options: &ShaderOptions) -> Result<Self, ComposeError> {
        technique::check(techniques)?;
        let tables = technique::tables(techniques, plan)?;
        let parts = technique::parts(techniques, &tables, options.probes);
        let textures: Vec<_> = tables.iter().filter_map(|&table| plan.texture(table)).collect();
        let interpolations: Vec<_> = textures.iter().map(|texture| interpolation(texture, &parts, options)).collect();
        let mut kinds = vec![BindingKind::Parameters];
        let mut source = [include_str!("wgsl/functions.wgsl"), include_str!("wgsl/table.wgsl")].join("\n");
        if interpolations.contains(&Some(Sampling::Filtered)) {
            kinds.push(BindingKind::Sampler);
            source += access::SAMPLER;
        }
        for (texture, interpolation) in textures.into_iter().zip(interpolations) {
            let is_filtered = interpolation == Some(Sampling::Filtered);
            kinds.push(BindingKind::Texture { table: texture.table, shape: texture.shape, is_filtered });
            source += &access::of_table(texture, interpolation);
        }
        source += &technique::constants(techniques);
        for part in parts {
            source += "\n";
            source += part;
        }
        if options.probes {
            kinds.push(BindingKind::Probe);
        }
        let group = options.group;
        // No part has another group, nor a comment that names one.
        let source = source.replace("@group(0)", &format!("@group({group})"));
        let bindings = kinds.into_iter().map(|kind| Binding { group, binding: kind.number(), kind }).collect();
        Ok(Self { source, bindings })
    }

    /// The WGSL.
    #[must_use]
    pub fn source(&self) -> &str {
        &self.source
    }

    /// What it binds, by number.
    #[must_use]
    pub fn bindings(&self) -> &[Binding] {
        &self.bindings
    }
}

/// How the parts interpolate between texels of a table, if they do.
fn interpolation(texture: &TexturePlan, parts: &[&str], options: &ShaderOptions) -> Option<Sampling> {
    let called = format!("barchan_{}_at(", texture.table.kind().name().unwrap_or_default());
    let is_asked = parts.iter().any(|part| part.contains(&called));
    let sampling = if texture.is_filterable { options.sampling } else { Sampling::Loaded };
    is_asked.then_some(sampling)
}

impl BindingKind {
    /// Its number in the group.
    #[must_use]
    pub fn number(&self) -> u32 {
        match self {
            Self::Parameters => 0,
            Self::Sampler => 1,
            Self::Texture { table, .. } => 1 + table.number(),
            Self::Probe => Shader::PROBE_BINDING,
        }
    }
}

impl fmt::Display for ComposeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { technique, table } => {
                let table = table.kind().name().unwrap_or_default();
                write!(f, "{} needs the table {table}, which is not loaded", technique.name())
            }
            Self::Unlike { technique, table, other, field } => write!(
                f,
                "{} needs the same {field} of the tables {} and {}; theirs differ",
                technique.name(),
                table.kind(),
                other.kind()
            ),
            Self::NoSearch => write!(f, "relief shadow needs a way to find relief; name a relief technique beside it"),
            Self::TwoSearches { first, second } => {
                write!(f, "{} and {} are both named; a shader finds relief in one way", first.name(), second.name())
            }
        }
    }
}

impl std::error::Error for ComposeError {}
