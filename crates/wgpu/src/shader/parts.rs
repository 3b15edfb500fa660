//! Of which parts of WGSL a technique is made, and the numbers that some need.

use barchan_asset::Semantic;

use super::{ReliefSearch, Technique};

/// The parts of the techniques, each once, those that others stand on first.
pub(super) fn of(techniques: &[Technique], tables: &[Semantic], probes: bool) -> Vec<&'static str> {
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

impl Technique {
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
