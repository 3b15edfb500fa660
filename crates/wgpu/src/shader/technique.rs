//! What shaders can do, and which tables it takes.

use barchan_asset::Semantic;

use super::{ComposeError, alike};
use crate::UploadPlan;

/// Steps of the searches that have a fixed number, where nobody says otherwise.
pub const SEARCH_STEPS: u32 = 64;

/// Halvings of the last step, where nobody says otherwise.
pub const SEARCH_BISECTIONS: u32 = 10;

/// How relief is found, as in the CPU twin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ReliefSearch {
    /// Steps of equal depth, and a bisection.
    Linear {
        /// Steps from the top to the floor.
        steps: u32,
        /// Halvings of the last one.
        bisections: u32,
    },
    /// Steps of equal depth, and a secant.
    ParallaxOcclusion {
        /// Steps from the top to the floor.
        steps: u32,
    },
    /// Cone steps that end in an exact cell.
    ConeSteps,
    /// Relaxed cone steps, and a bisection.
    RelaxedConeSteps {
        /// Halvings of the last step.
        bisections: u32,
    },
    /// Traversal of maximum mips, exact.
    MaximumMip,
}

impl ReliefSearch {
    /// The best that the tables of a plan allow: maximum mips, cone steps, relaxed cone steps, and linear search, which needs no table
    /// but the heights. The first two are exact, and mips take fewer fetches.
    #[must_use]
    pub fn best_of(plan: &UploadPlan) -> Self {
        let of_tables = [
            (Semantic::MaximumHeight, Self::MaximumMip),
            (Semantic::ConeMap, Self::ConeSteps),
            (Semantic::RelaxedConeMap, Self::RelaxedConeSteps { bisections: SEARCH_BISECTIONS }),
        ];
        let linear = Self::Linear { steps: SEARCH_STEPS, bisections: SEARCH_BISECTIONS };
        of_tables.into_iter().find(|(table, _)| plan.texture(*table).is_some()).map_or(linear, |(_, search)| search)
    }
}

/// Something a shader can do. Each is a part of WGSL, and a twin in `barchan-shade`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Technique {
    /// Heights and normals of the surface: `barchan_height_at`, `barchan_surface_normal`.
    Surface,
    /// Shadows on a flat base: `barchan_horizon_in_shadow`.
    HorizonShadow,
    /// Shadows on a curved base, convex or concave, by as many points as there are: `barchan_curved_in_shadow`.
    CurvedShadow,
    /// Soft shadows of a disc: `barchan_penumbra_visibility`.
    Penumbra,
    /// Light of the sky: `barchan_sky_visibility`, `barchan_sky_irradiance`, and `barchan_sky_bent_normal` where it is loaded.
    Sky,
    /// The cone of the visible sky: `barchan_aperture_cone`.
    ApertureCone,
    /// Where a ray meets the relief, from a hemisphere table's start where it is loaded: `barchan_relief_find`.
    Relief(ReliefSearch),
    /// Shadows of relief by that search: `barchan_relief_in_shadow`.
    ReliefShadow,
}

impl Technique {
    /// All that the tables of a plan allow, relief by the best search.
    ///
    /// Heights alone would allow relief too; it is among them only if a table was loaded that helps to find it.
    #[must_use]
    pub fn of_plan(plan: &UploadPlan) -> Vec<Self> {
        let mut techniques =
            vec![Self::Surface, Self::HorizonShadow, Self::CurvedShadow, Self::Penumbra, Self::Sky, Self::ApertureCone];
        if plan.textures().iter().any(|texture| texture.table.is_relief_search()) {
            techniques.extend([Self::Relief(ReliefSearch::best_of(plan)), Self::ReliefShadow]);
        }
        techniques.retain(|technique| technique.tables(plan).is_ok());
        techniques
    }

    /// What people call it.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Surface => "surface",
            Self::HorizonShadow => "horizon shadow",
            Self::CurvedShadow => "curved shadow",
            Self::Penumbra => "penumbra",
            Self::Sky => "sky",
            Self::ApertureCone => "aperture cone",
            Self::Relief(ReliefSearch::Linear { .. }) => "relief by linear search",
            Self::Relief(ReliefSearch::ParallaxOcclusion { .. }) => "relief by parallax occlusion",
            Self::Relief(ReliefSearch::ConeSteps) => "relief by cone steps",
            Self::Relief(ReliefSearch::RelaxedConeSteps { .. }) => "relief by relaxed cone steps",
            Self::Relief(ReliefSearch::MaximumMip) => "relief by maximum mip",
            Self::ReliefShadow => "relief shadow",
        }
    }

    /// The functions of WGSL that a game calls, those for optional tables only where these are loaded. The others that a shader has are
    /// what these are made of.
    #[must_use]
    pub fn functions(self) -> &'static [&'static str] {
        match self {
            Self::Surface => &["barchan_height_at", "barchan_surface_slopes", "barchan_surface_normal"],
            Self::HorizonShadow => &["barchan_horizon_elevation", "barchan_horizon_in_shadow"],
            Self::CurvedShadow => &[
                "barchan_texture_step",
                "barchan_bump_normal",
                "barchan_tangent_light",
                "barchan_curvature_along",
                "barchan_curved_elevation",
                "barchan_curved_in_shadow",
            ],
            Self::Penumbra => &["barchan_penumbra_visibility"],
            Self::Sky => &["barchan_sky_visibility", "barchan_sky_irradiance", "barchan_sky_bent_normal"],
            Self::ApertureCone => &["barchan_aperture_cone"],
            Self::Relief(_) => {
                &["barchan_relief_ray", "barchan_relief_ray_through", "barchan_relief_find", "barchan_relief_at"]
            }
            Self::ReliefShadow => &["barchan_relief_in_shadow"],
        }
    }

    /// The fragment stage that draws its numbers, in a shader with probes.
    #[must_use]
    pub fn probe(self) -> &'static str {
        match self {
            Self::Surface => "barchan_probe_surface",
            Self::HorizonShadow => "barchan_probe_horizon",
            Self::CurvedShadow => "barchan_probe_curved",
            Self::Penumbra => "barchan_probe_penumbra",
            Self::Sky => "barchan_probe_sky",
            Self::ApertureCone => "barchan_probe_aperture",
            Self::Relief(_) => "barchan_probe_relief",
            Self::ReliefShadow => "barchan_probe_relief_shadow",
        }
    }

    /// The tables it cannot do without.
    #[must_use]
    pub fn required(self) -> &'static [Semantic] {
        match self {
            Self::Surface => &[Semantic::Height],
            Self::HorizonShadow => &[Semantic::HorizonElevation],
            Self::CurvedShadow => &[Semantic::Height, Semantic::HorizonElevation, Semantic::HorizonDistance],
            Self::Penumbra => &[Semantic::HorizonElevation, Semantic::HorizonDistance],
            Self::Sky => &[Semantic::SkyVisibility],
            Self::ApertureCone => &[Semantic::ApertureCone],
            Self::Relief(ReliefSearch::ConeSteps) => &[Semantic::Height, Semantic::ConeMap],
            Self::Relief(ReliefSearch::RelaxedConeSteps { .. }) => &[Semantic::Height, Semantic::RelaxedConeMap],
            Self::Relief(ReliefSearch::MaximumMip) => &[Semantic::Height, Semantic::MaximumHeight],
            Self::Relief(_) | Self::ReliefShadow => &[Semantic::Height],
        }
    }

    /// The tables it uses where they are loaded, all or none of them.
    #[must_use]
    pub fn optional(self) -> &'static [Semantic] {
        match self {
            Self::CurvedShadow => &[Semantic::SweptElevation, Semantic::SweptDistance],
            Self::Sky => &[Semantic::BentNormal],
            Self::Relief(_) => &[Semantic::HemisphereDepth],
            _ => &[],
        }
    }

    /// The tables of a plan that it reads.
    fn tables(self, plan: &UploadPlan) -> Result<Vec<Semantic>, ComposeError> {
        let is_loaded = |table: &Semantic| plan.texture(*table).is_some();
        if let Some(&table) = self.required().iter().find(|table| !is_loaded(table)) {
            return Err(ComposeError::Missing { technique: self, table });
        }
        let mut tables = self.required().to_vec();
        if self.optional().iter().all(is_loaded) {
            tables.extend(self.optional());
        }
        alike::check(self, &tables, plan)?;
        Ok(tables)
    }
}

/// Techniques that go together: one way to find relief, and one where its shadows need it.
pub(super) fn check(techniques: &[Technique]) -> Result<(), ComposeError> {
    let mut searches = techniques.iter().copied().filter(|technique| matches!(technique, Technique::Relief(_)));
    let Some(first) = searches.next() else {
        let has_shadow = techniques.contains(&Technique::ReliefShadow);
        return if has_shadow { Err(ComposeError::NoSearch) } else { Ok(()) };
    };
    match searches.find(|&search| search != first) {
        Some(second) => Err(ComposeError::TwoSearches { first, second }),
        None => Ok(()),
    }
}

/// The tables that the techniques read, by number.
pub(super) fn tables(techniques: &[Technique], plan: &UploadPlan) -> Result<Vec<Semantic>, ComposeError> {
    let mut tables = Vec::new();
    for technique in techniques {
        tables.extend(technique.tables(plan)?);
    }
    tables.sort_by_key(|table| table.number());
    tables.dedup();
    Ok(tables)
}
