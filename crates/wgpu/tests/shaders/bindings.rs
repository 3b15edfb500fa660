//! What is not needed is neither compiled nor bound.

use barchan_asset::Semantic;
use barchan_wgpu::{
    BindingKind, ComposeError, ReliefSearch, SEARCH_BISECTIONS, SEARCH_STEPS, Sampling, Shader, ShaderOptions, Shape,
    Technique,
};

use crate::{PLAIN, SEARCHES, composed, module, plan};

/// Number and name of what a shader binds.
fn bound(shader: &Shader) -> Vec<(u32, &'static str)> {
    let name = |kind| match kind {
        BindingKind::Parameters => "parameters",
        BindingKind::Sampler => "sampler",
        BindingKind::Texture { table, .. } => table.kind().name().unwrap(),
        BindingKind::Probe => "probe",
    };
    shader.bindings().iter().map(|binding| (binding.binding, name(binding.kind))).collect()
}

/// Tables of a flat, lit terrain.
const FLAT: [Semantic; 4] =
    [Semantic::Height, Semantic::HorizonElevation, Semantic::SkyVisibility, Semantic::BentNormal];

#[test]
fn a_flat_scene_compiles_no_curvature_and_binds_no_distances() {
    let plan = plan(&FLAT);
    let techniques = Technique::of_plan(&plan);
    assert_eq!(techniques, [Technique::Surface, Technique::HorizonShadow, Technique::Sky]);
    let shader = composed(&plan, &techniques, Sampling::Filtered);
    let expected =
        [(0, "parameters"), (1, "sampler"), (2, "height"), (3, "horizon"), (7, "sky_visibility"), (8, "bent_normal")];
    assert_eq!(bound(&shader), expected);
    let module = module(shader.source());
    for (_, function) in module.functions.iter() {
        let name = function.name.as_deref().unwrap_or_default();
        assert!(
            !["curv", "distance", "tangent_light", "relief", "penumbra"].iter().any(|word| name.contains(word)),
            "{name}"
        );
    }
}

#[test]
fn a_curved_scene_binds_the_swept_points_if_it_has_them() {
    let mut tables = vec![Semantic::Height, Semantic::HorizonElevation, Semantic::HorizonDistance];
    let one_point = composed(&plan(&tables), &[Technique::CurvedShadow], Sampling::Loaded);
    assert_eq!(bound(&one_point), [(0, "parameters"), (2, "height"), (3, "horizon"), (4, "distance")]);
    tables.extend([Semantic::SweptElevation, Semantic::SweptDistance]);
    let points = composed(&plan(&tables), &[Technique::CurvedShadow], Sampling::Loaded);
    let expected = [(5, "swept_horizon"), (6, "swept_distance")];
    assert_eq!(bound(&points), [bound(&one_point), expected.to_vec()].concat());
}

#[test]
fn who_only_loads_texels_binds_no_sampler() {
    let plan = plan(&Semantic::ALL);
    let has_sampler = |techniques: &[Technique]| {
        let shader = composed(&plan, techniques, Sampling::Filtered);
        shader.bindings().iter().any(|binding| binding.kind == BindingKind::Sampler)
    };
    assert!(has_sampler(&[Technique::Surface]));
    assert!(!has_sampler(&[Technique::CurvedShadow]));
    assert!(!has_sampler(&[Technique::Relief(ReliefSearch::MaximumMip), Technique::ReliefShadow]));
}

#[test]
fn relief_binds_the_tables_of_its_search_and_of_its_start() {
    let tables = [Semantic::Height, Semantic::ConeMap, Semantic::RelaxedConeMap, Semantic::MaximumHeight];
    let searched = [vec![], vec![], vec![(11, "cone_map")], vec![(12, "relaxed_cone_map")], vec![(13, "maximum_mip")]];
    for (search, searched) in SEARCHES.into_iter().zip(searched) {
        let techniques = [Technique::Relief(search), Technique::ReliefShadow];
        let from_top = composed(&plan(&tables), &techniques, Sampling::Loaded);
        let heights = vec![(0, "parameters"), (2, "height")];
        assert_eq!(bound(&from_top), [heights.clone(), searched.clone()].concat());
        let from_map = composed(&plan(&Semantic::ALL), &techniques, Sampling::Loaded);
        assert_eq!(bound(&from_map), [heights, vec![(10, "hemisphere")], searched].concat());
    }
}

#[test]
fn the_list_is_what_the_module_binds() {
    let plan = plan(&Semantic::ALL);
    for search in SEARCHES {
        for sampling in [Sampling::Filtered, Sampling::Loaded] {
            let techniques = [&PLAIN[..], &[Technique::Relief(search)]].concat();
            let shader =
                Shader::compose(&plan, &techniques, &ShaderOptions { group: 2, sampling, probes: true }).unwrap();
            let module = module(shader.source());
            let mut found: Vec<_> = module.global_variables.iter().filter_map(|(_, global)| global.binding).collect();
            found.sort_by_key(|binding| binding.binding);
            let listed: Vec<_> = shader
                .bindings()
                .iter()
                .map(|binding| naga::ResourceBinding { group: binding.group, binding: binding.binding })
                .collect();
            assert_eq!(found, listed, "{sampling:?}");
        }
    }
}

#[test]
fn textures_are_listed_in_the_shape_the_plan_gives_them() {
    let shader = composed(&plan(&FLAT), &[Technique::Surface, Technique::HorizonShadow], Sampling::Loaded);
    let shapes: Vec<_> = shader
        .bindings()
        .iter()
        .filter_map(|binding| match binding.kind {
            BindingKind::Texture { table, shape, is_filtered } => Some((table, shape, is_filtered)),
            _ => None,
        })
        .collect();
    let expected = [(Semantic::Height, Shape::D2, false), (Semantic::HorizonElevation, Shape::D2Array, false)];
    assert_eq!(shapes, expected);
}

#[test]
fn the_best_search_is_the_one_the_command_line_would_take() {
    let mut tables = vec![Semantic::Height];
    let linear = ReliefSearch::Linear { steps: SEARCH_STEPS, bisections: SEARCH_BISECTIONS };
    assert_eq!(ReliefSearch::best_of(&plan(&tables)), linear);
    // Heights alone are no sign that a scene has relief.
    assert_eq!(Technique::of_plan(&plan(&tables)), [Technique::Surface]);
    for (table, search) in [
        (Semantic::HemisphereDepth, linear),
        (Semantic::RelaxedConeMap, ReliefSearch::RelaxedConeSteps { bisections: SEARCH_BISECTIONS }),
        (Semantic::ConeMap, ReliefSearch::ConeSteps),
        (Semantic::MaximumHeight, ReliefSearch::MaximumMip),
    ] {
        tables.push(table);
        let expected = [Technique::Surface, Technique::Relief(search), Technique::ReliefShadow];
        assert_eq!(Technique::of_plan(&plan(&tables)), expected);
    }
}

#[test]
fn errors_name_technique_and_table() {
    let plan = plan(&[Semantic::Height, Semantic::HorizonElevation]);
    let refused = |techniques: &[Technique]| Shader::compose(&plan, techniques, &ShaderOptions::default()).unwrap_err();
    let missing = refused(&[Technique::Surface, Technique::CurvedShadow]);
    assert_eq!(missing, ComposeError::Missing { technique: Technique::CurvedShadow, table: Semantic::HorizonDistance });
    assert_eq!(missing.to_string(), "curved shadow needs the table distance, which is not loaded");
    let no_search = refused(&[Technique::ReliefShadow]).to_string();
    assert_eq!(no_search, "relief shadow needs a way to find relief; name a relief technique beside it");
    let two = refused(&[SEARCHES[0], SEARCHES[4]].map(Technique::Relief)).to_string();
    let expected = "relief by linear search and relief by maximum mip are both named; a shader finds relief in one way";
    assert_eq!(two, expected);
}

#[test]
fn a_technique_named_twice_is_there_once() {
    let plan = plan(&FLAT);
    let once = composed(&plan, &[Technique::Sky], Sampling::Filtered);
    assert_eq!(composed(&plan, &[Technique::Sky, Technique::Sky], Sampling::Filtered), once);
    assert_eq!(bound(&once), [(0, "parameters"), (1, "sampler"), (7, "sky_visibility"), (8, "bent_normal")]);
}
