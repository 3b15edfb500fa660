//! A shader in other languages, by naga.
//!
//! The binding number of WGSL is the number everywhere: the binding of set 0 in SPIR-V, the register in HLSL, the slot in MSL. GLSL ES 3
//! has names instead, and textures that are joined with their samplers.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use naga::back::{glsl, hlsl, msl, spv};
use naga::proc::BoundsCheckPolicies;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};
use naga::{AddressSpace, GlobalVariable, Handle, Module, ResourceBinding, ShaderStage, TypeInner};

use crate::Outcome;

/// A shader in every language.
pub(crate) struct Translations {
    /// What naga made of the source, for whoever asks about types.
    pub(crate) module: Module,
    /// SPIR-V, little-endian.
    pub(crate) spirv: Vec<u8>,
    /// GLSL ES 3: the vertex stage of probes.
    pub(crate) vertex: String,
    /// GLSL ES 3: a fragment stage for each probe.
    pub(crate) fragments: Vec<Fragment>,
    /// HLSL, shader model 5, all entry points.
    pub(crate) hlsl: String,
    /// Metal shading language 2, all entry points.
    pub(crate) msl: String,
}

/// A fragment stage in GLSL.
pub(crate) struct Fragment {
    /// Its name in WGSL; in GLSL it is `main`.
    pub(crate) entry_point: String,
    /// The GLSL.
    pub(crate) source: String,
    /// The name of each binding that it uses: of a block, or of a texture that is joined with its sampler.
    pub(crate) names: BTreeMap<u32, String>,
}

/// Every loop of ours has a bound, and places are brought inside the tables before texels are loaded: no checks are added.
const POLICIES: BoundsCheckPolicies = BoundsCheckPolicies {
    index: naga::proc::BoundsCheckPolicy::Unchecked,
    buffer: naga::proc::BoundsCheckPolicy::Unchecked,
    image_load: naga::proc::BoundsCheckPolicy::Unchecked,
    binding_array: naga::proc::BoundsCheckPolicy::Unchecked,
};

pub(crate) fn translate(source: &str) -> Outcome<Translations> {
    let mut module = naga::front::wgsl::parse_str(source).map_err(|error| error.emit_to_string(source))?;
    name_tables(&mut module);
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    let info = validator.validate(&module).map_err(|error| error.emit_to_string(source))?;
    let stage = |stage| module.entry_points.iter().filter(move |entry| entry.stage == stage);
    let vertex = stage(ShaderStage::Vertex).next().ok_or("it has no vertex stage")?;
    let vertex = to_glsl(&module, &info, vertex)?.source;
    let fragments = stage(ShaderStage::Fragment).map(|entry| to_glsl(&module, &info, entry)).collect::<Outcome<_>>()?;
    let (spirv, hlsl, msl) = (to_spirv(&module, &info)?, to_hlsl(&module, &info)?, to_msl(&module, &info)?);
    Ok(Translations { module, spirv, vertex, fragments, hlsl, msl })
}

/// Gives the array of the uniform buffer a name: GLSL names the block after it.
fn name_tables(module: &mut Module) {
    let uniforms = module.global_variables.iter().filter(|(_, global)| global.space == AddressSpace::Uniform);
    for ty in uniforms.map(|(_, global)| global.ty).collect::<Vec<_>>() {
        let inner = module.types[ty].inner.clone();
        if matches!(inner, TypeInner::Array { .. }) {
            module.types.replace(ty, naga::Type { name: Some("BarchanTables".to_owned()), inner });
        }
    }
}

fn to_spirv(module: &Module, info: &ModuleInfo) -> Outcome<Vec<u8>> {
    use spv::WriterFlags as Flags;
    let options = spv::Options {
        // Clip space as in WebGPU; names stay.
        flags: Flags::ADJUST_COORDINATE_SPACE | Flags::LABEL_VARYINGS | Flags::DEBUG,
        bounds_check_policies: POLICIES,
        force_loop_bounding: false,
        ..spv::Options::default()
    };
    let words = spv::write_vec(module, info, &options, None)?;
    Ok(words.into_iter().flat_map(u32::to_le_bytes).collect())
}

fn to_glsl(module: &Module, info: &ModuleInfo, entry: &naga::EntryPoint) -> Outcome<Fragment> {
    let options = glsl::Options {
        version: glsl::Version::new_gles(300),
        writer_flags: glsl::WriterFlags::ADJUST_COORDINATE_SPACE,
        ..glsl::Options::default()
    };
    let pipeline =
        glsl::PipelineOptions { shader_stage: entry.stage, entry_point: entry.name.clone(), multiview: None };
    let mut source = String::new();
    let reflected = glsl::Writer::new(&mut source, module, info, &options, &pipeline, POLICIES)?.write()?;
    let textures = reflected.texture_mapping.iter().map(|(name, mapping)| (mapping.texture, name));
    let blocks = reflected.uniforms.iter().map(|(global, name)| (*global, name));
    let number =
        |global: Handle<GlobalVariable>| module.global_variables[global].binding.map(|binding| binding.binding);
    let names = textures.chain(blocks).filter_map(|(global, name)| Some((number(global)?, name.clone()))).collect();
    Ok(Fragment { entry_point: entry.name.clone(), source, names })
}

/// The bindings of a module, and what is bound.
fn bound(module: &Module) -> impl Iterator<Item = (ResourceBinding, Resource)> + '_ {
    module.global_variables.iter().filter_map(|(_, global)| {
        let resource = match (global.space, &module.types[global.ty].inner) {
            (AddressSpace::Uniform, _) => Resource::Buffer,
            (_, TypeInner::Sampler { .. }) => Resource::Sampler,
            _ => Resource::Texture,
        };
        Some((global.binding?, resource))
    })
}

enum Resource {
    Buffer,
    Sampler,
    Texture,
}

fn to_hlsl(module: &Module, info: &ModuleInfo) -> Outcome<String> {
    let target = |binding: ResourceBinding| hlsl::BindTarget { register: binding.binding, ..Default::default() };
    let options = hlsl::Options {
        shader_model: hlsl::ShaderModel::V5_0,
        binding_map: bound(module).map(|(binding, _)| (binding, target(binding))).collect(),
        restrict_indexing: false,
        force_loop_bounding: false,
        // The table of samplers, which goes again below.
        sampler_buffer_binding_map: [(hlsl::SamplerIndexBufferKey { group: 0 }, hlsl::BindTarget::default())].into(),
        fake_missing_bindings: false,
        ..hlsl::Options::default()
    };
    let mut source = String::new();
    hlsl::Writer::new(&mut source, &options, &hlsl::PipelineOptions::default()).write(module, info, None)?;
    with_own_sampler(&source)
}

/// naga takes samplers out of a table of all of them, which only its own back end sets up: ours has a register instead.
fn with_own_sampler(source: &str) -> Outcome<String> {
    let mut out = String::with_capacity(source.len());
    for line in source.lines() {
        let is_table = ["nagaSamplerHeap[2048]", "nagaComparisonSamplerHeap[2048]", "nagaGroup0SamplerIndexArray :"]
            .iter()
            .any(|declared| line.contains(declared));
        if line.starts_with("static const SamplerState barchan_sampler = ") {
            writeln!(out, "SamplerState barchan_sampler : register(s1);")?;
        } else if !is_table {
            writeln!(out, "{line}")?;
        }
    }
    if out.contains("SamplerHeap") || out.contains("SamplerIndexArray") {
        return Err("naga writes samplers in another way than this example knows".into());
    }
    Ok(out)
}

fn to_msl(module: &Module, info: &ModuleInfo) -> Outcome<String> {
    let target = |binding: ResourceBinding, resource| -> Outcome<(ResourceBinding, msl::BindTarget)> {
        let (slot, mut target) = (u8::try_from(binding.binding)?, msl::BindTarget::default());
        match resource {
            Resource::Buffer => target.buffer = Some(slot),
            Resource::Sampler => target.sampler = Some(msl::BindSamplerTarget::Resource(slot)),
            Resource::Texture => target.texture = Some(slot),
        }
        Ok((binding, target))
    };
    let resources: msl::BindingMap =
        bound(module).map(|(binding, resource)| target(binding, resource)).collect::<Outcome<_>>()?;
    let of_entry = msl::EntryPointResources { resources, ..Default::default() };
    let options = msl::Options {
        lang_version: (2, 0),
        per_entry_point_map: module.entry_points.iter().map(|entry| (entry.name.clone(), of_entry.clone())).collect(),
        fake_missing_bindings: false,
        bounds_check_policies: POLICIES,
        force_loop_bounding: false,
        ..msl::Options::default()
    };
    let (source, written) = msl::write_string(module, info, &options, &msl::PipelineOptions::default())?;
    for name in written.entry_point_names {
        name?;
    }
    Ok(source)
}
