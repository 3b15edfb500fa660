//! Which shaders are published.

use barchan_asset::{Encoding, Semantic};
use barchan_wgpu::{
    DeviceLimits, Reader, ReliefSearch, SEARCH_BISECTIONS, SEARCH_STEPS, Selection, Shader, ShaderOptions, Technique,
    UploadPlan,
};

use crate::Outcome;
use crate::every_table::every_table;
use crate::languages::{Translations, translate};

/// A shader that is published.
pub(crate) struct Published {
    /// Its files begin with it.
    pub(crate) name: String,
    /// What it does; the first one is what it is named after.
    pub(crate) techniques: Vec<Technique>,
    /// The WGSL, and what it binds.
    pub(crate) shader: Shader,
    /// The same in other languages.
    pub(crate) translations: Translations,
}

impl Published {
    fn new(name: &str, techniques: &[Technique], plan: &UploadPlan) -> Outcome<Self> {
        let shader = Shader::compose(plan, techniques, &ShaderOptions { probes: true, ..ShaderOptions::default() })?;
        let translations = translate(shader.source()).map_err(|error| format!("{name}: {error}"))?;
        Ok(Self { name: name.to_owned(), techniques: techniques.to_vec(), shader, translations })
    }

    /// The vertex stage of its probes in GLSL: name and bytes.
    pub(crate) fn vertex_file(&self) -> (String, Vec<u8>) {
        ("probe.vert".to_owned(), self.translations.vertex.as_bytes().to_vec())
    }

    /// Its files: name and bytes.
    pub(crate) fn files(&self) -> Vec<(String, Vec<u8>)> {
        let Translations { spirv, fragments, hlsl, msl, .. } = &self.translations;
        let text = |name: String, text: &str| (name, text.as_bytes().to_vec());
        let name = &self.name;
        let mut files = vec![
            text(format!("{name}.wgsl"), self.shader.source()),
            (format!("{name}.spv"), spirv.clone()),
            text(format!("{name}.hlsl"), hlsl),
            text(format!("{name}.metal"), msl),
        ];
        // The last technique is the one that stands on the others.
        let last = self.techniques.last().map_or("", |technique| technique.probe());
        let fragment = fragments.iter().find(|fragment| fragment.entry_point == last);
        files.extend(fragment.map(|fragment| text(format!("{name}.frag"), &fragment.source)));
        files
    }
}

/// Every published shader: each technique with the tables that it cannot do without, and with those that it may have besides.
pub(crate) fn all() -> Outcome<Vec<Published>> {
    let optional = [Semantic::SweptElevation, Semantic::SweptDistance, Semantic::BentNormal, Semantic::HemisphereDepth];
    let required: Vec<_> = Semantic::ALL.into_iter().filter(|table| !optional.contains(table)).collect();
    let (least, all) = (plan(&required)?, plan(&Semantic::ALL)?);
    let mut shaders = vec![
        Published::new("surface", &[Technique::Surface], &least)?,
        Published::new("horizon_shadow", &[Technique::HorizonShadow], &least)?,
        Published::new("curved_shadow", &[Technique::CurvedShadow], &least)?,
        Published::new("curved_shadow_swept", &[Technique::CurvedShadow], &all)?,
        Published::new("penumbra", &[Technique::Penumbra], &least)?,
        Published::new("sky", &[Technique::Sky], &least)?,
        Published::new("sky_bent_normal", &[Technique::Sky], &all)?,
        Published::new("aperture_cone", &[Technique::ApertureCone], &least)?,
    ];
    let (steps, bisections) = (SEARCH_STEPS, SEARCH_BISECTIONS);
    for (name, search) in [
        ("relief_linear", ReliefSearch::Linear { steps, bisections }),
        ("relief_parallax_occlusion", ReliefSearch::ParallaxOcclusion { steps }),
        ("relief_cone_steps", ReliefSearch::ConeSteps),
        ("relief_relaxed_cone_steps", ReliefSearch::RelaxedConeSteps { bisections }),
        ("relief_maximum_mip", ReliefSearch::MaximumMip),
    ] {
        let techniques = [Technique::Relief(search), Technique::ReliefShadow];
        shaders.push(Published::new(name, &techniques, &least)?);
        shaders.push(Published::new(&format!("{name}_hemisphere"), &techniques, &all)?);
    }
    Ok(shaders)
}

/// A plan of tables as bakes store them where nobody says otherwise: 8 and 16 bits, which every device filters.
fn plan(tables: &[Semantic]) -> Outcome<UploadPlan> {
    let bytes = every_table(tables, Encoding::Compact)?;
    Ok(UploadPlan::new(&Reader::open(&bytes)?, &Selection::everything(), &DeviceLimits::WEBGPU)?)
}
