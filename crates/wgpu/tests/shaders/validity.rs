//! What is composed is WGSL, of names that clash with nobody's.

use barchan_asset::{Encoding, Semantic};
use barchan_wgpu::{DeviceLimits, Sampling, Shader, ShaderOptions, Technique, UploadPlan};

use crate::{PLAIN, SEARCHES, module, plan, plan_of};

/// Plans that differ in all that a shader depends on: optional tables, layered textures or volumes, formats that filter or do not.
fn plans() -> Vec<UploadPlan> {
    let optional = [Semantic::SweptElevation, Semantic::SweptDistance, Semantic::BentNormal, Semantic::HemisphereDepth];
    let required: Vec<_> = Semantic::ALL.into_iter().filter(|table| !optional.contains(table)).collect();
    let one_layer = DeviceLimits { max_layers: 1, ..DeviceLimits::WEBGPU };
    let mut plans = Vec::new();
    for tables in [&Semantic::ALL[..], &required] {
        for limits in [DeviceLimits::WEBGPU, one_layer] {
            plans.extend([Encoding::F32, Encoding::Compact].map(|encoding| plan_of(tables, encoding, &limits)));
        }
    }
    plans
}

/// Every set of techniques that go together.
fn sets() -> Vec<Vec<Technique>> {
    let mut reliefs: Vec<Vec<Technique>> = vec![Vec::new()];
    for search in SEARCHES {
        reliefs.push(vec![Technique::Relief(search)]);
        reliefs.push(vec![Technique::Relief(search), Technique::ReliefShadow]);
    }
    let mut sets = Vec::new();
    for bits in 0..1 << PLAIN.len() {
        let plain = (0..PLAIN.len()).filter(|i| bits >> i & 1 == 1).map(|i| PLAIN[i]);
        sets.extend(reliefs.iter().map(|relief| plain.clone().chain(relief.iter().copied()).collect()));
    }
    sets
}

/// Names of all that a module declares.
fn names(module: &naga::Module) -> Vec<&str> {
    let functions = module.functions.iter().filter_map(|(_, function)| function.name.as_deref());
    let globals = module.global_variables.iter().filter_map(|(_, global)| global.name.as_deref());
    let constants = module.constants.iter().filter_map(|(_, constant)| constant.name.as_deref());
    let overrides = module.overrides.iter().filter_map(|(_, constant)| constant.name.as_deref());
    let types = module.types.iter().filter_map(|(_, named)| named.name.as_deref());
    let entry_points = module.entry_points.iter().map(|entry| entry.name.as_str());
    functions.chain(globals).chain(constants).chain(overrides).chain(types).chain(entry_points).collect()
}

#[test]
fn every_set_of_techniques_is_valid_in_some_form_and_each_form_in_some_set() {
    let plans = plans();
    for (i, techniques) in sets().iter().enumerate() {
        let sampling = if i % 2 == 0 { Sampling::Filtered } else { Sampling::Loaded };
        let options = ShaderOptions { group: i as u32 % 4, sampling, probes: i % 3 == 0 };
        // 8 plans: a stride that shares no factor with the others reaches all combinations.
        let shader = Shader::compose(&plans[i / 2 % plans.len()], techniques, &options).unwrap();
        module(shader.source());
    }
}

#[test]
fn every_technique_is_valid_alone_in_every_form() {
    for plan in plans() {
        for technique in PLAIN.into_iter().chain(SEARCHES.map(Technique::Relief)) {
            for sampling in [Sampling::Filtered, Sampling::Loaded] {
                let options = ShaderOptions { group: 3, sampling, probes: true };
                let shader = Shader::compose(&plan, &[technique], &options).unwrap();
                let module = module(shader.source());
                let entry_points: Vec<_> = module.entry_points.iter().map(|entry| entry.name.as_str()).collect();
                assert_eq!(entry_points, ["barchan_probe_vertex", technique.probe()], "{}", technique.name());
            }
        }
    }
}

#[test]
fn every_function_that_a_technique_names_is_there() {
    let plan = plan(&Semantic::ALL);
    for technique in PLAIN.into_iter().chain([Technique::Relief(SEARCHES[0]), Technique::ReliefShadow]) {
        let set = [technique, Technique::Relief(SEARCHES[0])];
        let module = module(Shader::compose(&plan, &set, &ShaderOptions::default()).unwrap().source());
        for name in technique.functions() {
            assert!(names(&module).contains(name), "{name}, of {}", technique.name());
        }
    }
}

#[test]
fn every_global_name_has_the_prefix() {
    let plan = plan(&Semantic::ALL);
    for search in SEARCHES {
        let techniques = [&PLAIN[..], &[Technique::Relief(search), Technique::ReliefShadow]].concat();
        let shader =
            Shader::compose(&plan, &techniques, &ShaderOptions { probes: true, ..Default::default() }).unwrap();
        for name in names(&module(shader.source())) {
            let has_prefix = ["barchan_", "Barchan", "BARCHAN_"].iter().any(|prefix| name.starts_with(prefix));
            assert!(has_prefix, "{name}, in {}", Technique::Relief(search).name());
        }
    }
}

#[test]
fn it_imports_nothing_and_asks_for_no_extension() {
    let plan = plan(&Semantic::ALL);
    let shader = Shader::compose(&plan, &Technique::of_plan(&plan), &ShaderOptions::default()).unwrap();
    for line in shader.source().lines() {
        assert!(!["#", "enable ", "requires ", "diagnostic"].iter().any(|start| line.starts_with(start)), "{line}");
    }
}

#[test]
fn the_uniform_blocks_are_as_long_as_the_buffers_that_are_bound() {
    let plan = plan(&Semantic::ALL);
    let options = ShaderOptions { probes: true, ..Default::default() };
    let module = module(Shader::compose(&plan, &Technique::of_plan(&plan), &options).unwrap().source());
    let bytes = |name| {
        let (_, global) =
            module.global_variables.iter().find(|(_, global)| global.name.as_deref() == Some(name)).unwrap();
        module.types[global.ty].inner.size(module.to_ctx()) as usize
    };
    assert_eq!(bytes("barchan_tables"), barchan_wgpu::PARAMETER_BYTES);
    assert_eq!(bytes("barchan_probe"), Shader::PROBE_BYTES);
}
