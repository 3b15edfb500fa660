//! Shaders composed for what an asset has: whole, valid, and without what nobody asked for.

#[path = "../support/every_table.rs"]
mod every_table;

mod bindings;
mod readme;
mod validity;

use barchan_asset::{Encoding, Semantic};
use barchan_wgpu::{
    DeviceLimits, Reader, ReliefSearch, Sampling, Selection, Shader, ShaderOptions, Technique, UploadPlan,
};

/// Every search, with numbers where it has any.
const SEARCHES: [ReliefSearch; 5] = [
    ReliefSearch::Linear { steps: 16, bisections: 4 },
    ReliefSearch::ParallaxOcclusion { steps: 16 },
    ReliefSearch::ConeSteps,
    ReliefSearch::RelaxedConeSteps { bisections: 4 },
    ReliefSearch::MaximumMip,
];

/// Every technique that stands without relief.
const PLAIN: [Technique; 6] = [
    Technique::Surface,
    Technique::HorizonShadow,
    Technique::CurvedShadow,
    Technique::Penumbra,
    Technique::Sky,
    Technique::ApertureCone,
];

/// A plan of those tables for a device of those limits.
fn plan_of(tables: &[Semantic], encoding: Encoding, limits: &DeviceLimits) -> UploadPlan {
    let bytes = every_table::every_table(tables, encoding).unwrap();
    UploadPlan::new(&Reader::open(&bytes).unwrap(), &Selection::everything(), limits).unwrap()
}

/// A plan of those tables as a bake stores them.
fn plan(tables: &[Semantic]) -> UploadPlan {
    plan_of(tables, Encoding::Compact, &DeviceLimits::WEBGPU)
}

fn composed(plan: &UploadPlan, techniques: &[Technique], sampling: Sampling) -> Shader {
    Shader::compose(plan, techniques, &ShaderOptions { group: 0, sampling, probes: false }).unwrap()
}

/// The module, parsed and checked; a fault is shown in the source.
fn module(source: &str) -> naga::Module {
    let module =
        naga::front::wgsl::parse_str(source).unwrap_or_else(|error| panic!("{}", error.emit_to_string(source)));
    let mut validator =
        naga::valid::Validator::new(naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty());
    validator.validate(&module).unwrap_or_else(|error| panic!("{}", error.emit_to_string(source)));
    module
}
