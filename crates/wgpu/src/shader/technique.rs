//! What shaders can do, which tables it takes, and of which parts it is made.

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

    /// The parts of WGSL it is made of, those it stands on first; `has` tells which tables are bound.
    fn parts(self, has: &dyn Fn(Semantic) -> bool, probes: bool) -> Vec<&'static str> {
        let mut parts = match self {
            Self::Surface => vec![include_str!("wgsl/surface.wgsl")],
            Self::HorizonShadow => vec![include_str!("wgsl/azimuths.wgsl"), include_str!("wgsl/horizon.wgsl")],
            Self::CurvedShadow => curved_parts(has),
            Self::Penumbra => vec![include_str!("wgsl/azimuths.wgsl"), include_str!("wgsl/penumbra.wgsl")],
            Self::Sky if has(Semantic::BentNormal) => {
                vec![include_str!("wgsl/sky_bent_normal.wgsl"), include_str!("wgsl/sky.wgsl")]
            }
            Self::Sky => vec![include_str!("wgsl/sky_even.wgsl"), include_str!("wgsl/sky.wgsl")],
            Self::ApertureCone => vec![include_str!("wgsl/aperture.wgsl")],
            Self::Relief(search) => relief_parts(search, has),
            Self::ReliefShadow => vec![include_str!("wgsl/relief_shadow.wgsl")],
        };
        if probes {
            parts.push(include_str!("wgsl/probe.wgsl"));
            parts.push(self.probe_part(has));
        }
        parts
    }

    fn probe_part(self, has: &dyn Fn(Semantic) -> bool) -> &'static str {
        match self {
            Self::Surface => include_str!("wgsl/probe_surface.wgsl"),
            Self::HorizonShadow => include_str!("wgsl/probe_horizon.wgsl"),
            Self::CurvedShadow => include_str!("wgsl/probe_curved.wgsl"),
            Self::Penumbra => include_str!("wgsl/probe_penumbra.wgsl"),
            Self::Sky if has(Semantic::BentNormal) => include_str!("wgsl/probe_sky_bent_normal.wgsl"),
            Self::Sky => include_str!("wgsl/probe_sky.wgsl"),
            Self::ApertureCone => include_str!("wgsl/probe_aperture.wgsl"),
            Self::Relief(_) => include_str!("wgsl/probe_relief.wgsl"),
            Self::ReliefShadow => include_str!("wgsl/probe_relief_shadow.wgsl"),
        }
    }
}

fn curved_parts(has: &dyn Fn(Semantic) -> bool) -> Vec<&'static str> {
    let points = match has(Semantic::SweptElevation) {
        true => include_str!("wgsl/curved_points_swept.wgsl"),
        false => include_str!("wgsl/curved_points_flat.wgsl"),
    };
    vec![
        include_str!("wgsl/azimuths.wgsl"),
        include_str!("wgsl/tangent.wgsl"),
        include_str!("wgsl/curvature.wgsl"),
        points,
        include_str!("wgsl/curved.wgsl"),
    ]
}

fn relief_parts(search: ReliefSearch, has: &dyn Fn(Semantic) -> bool) -> Vec<&'static str> {
    let start = match has(Semantic::HemisphereDepth) {
        true => include_str!("wgsl/relief_start_depth_map.wgsl"),
        false => include_str!("wgsl/relief_start_top.wgsl"),
    };
    let (sampled, cone_step) = (include_str!("wgsl/relief_sampled.wgsl"), include_str!("wgsl/relief_cone_step.wgsl"));
    let search = match search {
        ReliefSearch::Linear { .. } => vec![sampled, include_str!("wgsl/relief_linear.wgsl")],
        ReliefSearch::ParallaxOcclusion { .. } => vec![sampled, include_str!("wgsl/relief_parallax.wgsl")],
        ReliefSearch::ConeSteps => vec![cone_step, include_str!("wgsl/relief_cones.wgsl")],
        ReliefSearch::RelaxedConeSteps { .. } => {
            vec![sampled, cone_step, include_str!("wgsl/relief_relaxed_cones.wgsl")]
        }
        ReliefSearch::MaximumMip => vec![include_str!("wgsl/relief_maximum_mip.wgsl")],
    };
    // Relief lies on something: directions of space come to it through a tangent frame.
    let starts = [include_str!("wgsl/tangent.wgsl"), include_str!("wgsl/relief.wgsl"), start];
    starts.into_iter().chain(search).chain([include_str!("wgsl/relief_find.wgsl")]).collect()
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

/// The parts of the techniques, each once, those that others stand on first.
pub(super) fn parts(techniques: &[Technique], tables: &[Semantic], probes: bool) -> Vec<&'static str> {
    let has = |table| tables.contains(&table);
    let mut parts = Vec::new();
    for part in techniques.iter().flat_map(|technique| technique.parts(&has, probes)) {
        if !parts.contains(&part) {
            parts.push(part);
        }
    }
    parts
}

/// The numbers of a search that has any.
pub(super) fn constants(techniques: &[Technique]) -> String {
    let of = |technique: &Technique| match *technique {
        Technique::Relief(ReliefSearch::Linear { steps, bisections }) => Some((steps, bisections)),
        Technique::Relief(ReliefSearch::ParallaxOcclusion { steps }) => Some((steps, 0)),
        Technique::Relief(ReliefSearch::RelaxedConeSteps { bisections }) => Some((0, bisections)),
        _ => None,
    };
    techniques.iter().find_map(of).map_or_else(String::new, |(steps, bisections)| {
        let (steps, bisections) = (steps.clamp(1, 1 << 12), bisections.min(32));
        format!("\nconst BARCHAN_STEPS: i32 = {steps};\nconst BARCHAN_BISECTIONS: i32 = {bisections};\n")
    })
}
