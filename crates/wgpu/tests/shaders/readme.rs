//! The README lists what the tables of three samples allow and bind, as the example `shaders` prints it.

use barchan_asset::{Encoding, Semantic};
use barchan_wgpu::{BindingKind, DeviceLimits, Sampling, Shape, Technique};

use crate::{composed, plan_of};

const README: &str = include_str!("../../README.md");

/// The block of a sample: what stands between the fences behind its name.
fn block(sample: &str) -> Vec<&'static str> {
    let (_, rest) = README.split_once(sample).unwrap();
    let (_, rest) = rest.split_once("```text\n").unwrap();
    rest.split_once("```").unwrap().0.lines().filter(|line| !line.is_empty()).collect()
}

/// The same block for these tables; all techniques that they allow, or these.
fn expected(tables: &[Semantic], limits: &DeviceLimits, only: Option<&[Technique]>) -> Vec<String> {
    let plan = plan_of(tables, Encoding::Compact, limits);
    let techniques = only.map_or_else(|| Technique::of_plan(&plan), <[_]>::to_vec);
    let shader = composed(&plan, &techniques, Sampling::Filtered);
    let functions = techniques.iter().map(|of| format!("{}: {}", of.name(), of.functions().join(", ")));
    let bindings = shader.bindings().iter().map(|binding| {
        let what = match binding.kind {
            BindingKind::Texture { table, shape, .. } => {
                let ty = match shape {
                    Shape::D2 => "texture_2d<f32>",
                    Shape::D2Array => "texture_2d_array<f32>",
                    Shape::D3 => "texture_3d<f32>",
                };
                format!("{ty}: {}", table.kind().name().unwrap())
            }
            BindingKind::Parameters => "uniform buffer: the numbers of the tables".to_owned(),
            _ => "sampler: linear".to_owned(),
        };
        format!("@group(0) @binding({})  {what}", binding.binding)
    });
    functions.chain(bindings).collect()
}

#[test]
fn a_flat_terrain() {
    use Semantic::{BentNormal, Height, HorizonElevation, SkyVisibility};
    let tables = [Height, HorizonElevation, SkyVisibility, BentNormal];
    assert_eq!(block("samples/dunes.ron"), expected(&tables, &DeviceLimits::WEBGPU, None));
}

#[test]
fn a_curved_surface() {
    let tables = &Semantic::ALL[..8];
    let only = [Technique::CurvedShadow, Technique::Sky];
    assert_eq!(block("samples/rippled_torus.ron"), expected(tables, &DeviceLimits::WEBGPU, Some(&only)));
}

#[test]
fn relief_with_a_volume() {
    use Semantic::{Height, HemisphereDepth, HorizonElevation, MaximumHeight};
    let tables = [Height, HorizonElevation, HemisphereDepth, MaximumHeight];
    // Room for the azimuths of the horizon, not for all cells of the hemisphere.
    let limits = DeviceLimits { max_layers: 4, ..DeviceLimits::WEBGPU };
    assert_eq!(block("samples/relief.ron"), expected(&tables, &limits, None));
}
