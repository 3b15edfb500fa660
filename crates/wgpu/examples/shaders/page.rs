//! The page of the published shaders.

use std::collections::BTreeMap;

use barchan_asset::Semantic;
use barchan_wgpu::{BindingKind, PARAMETER_BYTES, Shader, TABLE_BYTES};
use naga::TypeInner;

use crate::Outcome;
use crate::functions::{Function, documented, fields};
use crate::names;
use crate::published::Published;

const HEAD: &str = "# The published shaders

Written by `cargo xtask shaders`, not by hand. Each technique is one `.wgsl` file without imports, and the same by naga as SPIR-V 1.0
(`.spv`), GLSL ES 3 (`.frag`), HLSL of shader model 5 (`.hlsl`) and Metal shading language 2 (`.metal`), for engines without wgpu.
An engine takes the functions; the entry points, *probes*, draw four numbers a place into a floating-point target, for tests and
first light. `.frag` has the last probe of its shader as `main`; `probe.vert` is the vertex stage of all.

They are what `Shader::compose` gives with `Sampling::Filtered` and tables of 8 or 16 bits, in layered textures. Tables of 32-bit floats
on a device that does not filter these, volumes, and other sets of techniques in one file:
`cargo run -p barchan-wgpu --example shaders -- wgsl FILE.barchan` prints the WGSL of an asset.

No bounds checks were added: every loop has a bound, and places are brought inside a table before its texels are loaded. SPIR-V and GLSL
have WebGPU's clip space, that of Direct3D and Metal. In HLSL the sampler has a register of its own, in place of naga's table of all
samplers. CI holds `.spv` against `spirv-val`, `.frag`, `.vert` and `.hlsl` against `glslangValidator`; nothing on Linux checks
Metal, which naga's own validator must do for.
";

pub(crate) fn page(shaders: &[Published]) -> Outcome<String> {
    let mut page = HEAD.to_owned();
    shader_table(&mut page, shaders);
    binding_table(&mut page, shaders)?;
    uniform_tables(&mut page, shaders);
    function_lists(&mut page, shaders);
    Ok(page)
}

/// Adds a line of text.
macro_rules! line {
    ($page:expr, $($text:tt)*) => { *$page += &(format!($($text)*) + "\n") };
}

fn shader_table(page: &mut String, shaders: &[Published]) {
    line!(page, "\n## Shaders\n\n| files | what it does | tables | probes |\n|---|---|---|---|");
    for published in shaders {
        let techniques: Vec<_> = published.techniques.iter().map(|technique| technique.name()).collect();
        let probes: Vec<_> = published.techniques.iter().map(|technique| format!("`{}`", technique.probe())).collect();
        let tables = published.shader.bindings().iter().filter_map(|binding| match binding.kind {
            BindingKind::Texture { table, .. } => Some(format!("{} ({})", name(table), binding.binding)),
            _ => None,
        });
        let tables: Vec<_> = tables.collect();
        let (techniques, tables, probes) = (techniques.join(", "), tables.join(", "), probes.join(", "));
        line!(page, "| `{}` | {techniques} | {tables} | {probes} |", published.name);
    }
}

fn name(table: Semantic) -> &'static str {
    table.kind().name().unwrap_or_default()
}

/// What is bound at a number, in every language.
fn binding_table(page: &mut String, shaders: &[Published]) -> Outcome<()> {
    line!(
        page,
        "
## Bindings

A shader binds those of its tables, the sampler if it interpolates, and the uniform buffer of probes for its probes only. WGSL has them
in group 0, SPIR-V in set 0, HLSL in space 0. GLSL ES 3 has names instead of numbers, those of fragment stages here; its textures are
joined with the sampler, which is linear, with the edges of the tables as wrap modes. `maximum_mip` and `hemisphere` are only ever
loaded. A hemisphere table may have more layers than a device has of a 2-D texture; it is a volume then, and `wgsl` prints its shader.

| binding | what | WGSL | HLSL | Metal | GLSL ES 3 |
|---|---|---|---|---|---|"
    );
    let mut rows = BTreeMap::new();
    for published in shaders {
        for binding in published.shader.bindings() {
            let row = binding_row(published, binding.kind);
            if rows.entry(binding.binding).or_insert_with(|| row.clone()) != &row {
                return Err(format!("{} has binding {} in another way: {row}", published.name, binding.binding).into());
            }
        }
    }
    for (number, row) in rows {
        line!(page, "| {number} | {row} |");
    }
    Ok(())
}

fn binding_row(published: &Published, kind: BindingKind) -> String {
    let (what, variable, wgsl) = match kind {
        BindingKind::Parameters => {
            ("numbers of all tables", "barchan_tables".to_owned(), "var<uniform> array<BarchanTable, 12>")
        }
        BindingKind::Sampler => ("sampler", "barchan_sampler".to_owned(), "sampler"),
        BindingKind::Texture { table, shape, .. } => {
            (name(table), format!("barchan_{}_texels", name(table)), names::shape(shape))
        }
        BindingKind::Probe => ("what probes draw", "barchan_probe".to_owned(), "var<uniform> BarchanProbe"),
    };
    let translations = &published.translations;
    let register = between(&translations.hlsl, &format!("{variable} : register("), ")");
    let slot = between(&translations.msl, &format!("{variable} [["), "]]");
    let glsl = translations.fragments.iter().find_map(|fragment| fragment.names.get(&kind.number()));
    let glsl = glsl.map_or_else(|| "—".to_owned(), |name| format!("`{name}`"));
    format!("{what} | `{variable}: {wgsl}` | `{register}` | `{slot}` | {glsl}")
}

fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    let rest = text.split_once(start).map_or("", |(_, rest)| rest);
    rest.split_once(end).map_or("", |(found, _)| found)
}

/// Where each number stands in the uniform buffers.
fn uniform_tables(page: &mut String, shaders: &[Published]) {
    let tables: Vec<_> = Semantic::ALL.iter().map(|table| format!("{} {}", table.number() - 1, name(*table))).collect();
    line!(
        page,
        "\n## Uniform buffers\n\n`UploadPlan::parameters` gives the bytes of the first: {} entries of {TABLE_BYTES} bytes, {PARAMETER_BYTES} in all, \
         by tables:\n{}. Entries of tables that are not loaded are zero. Numbers are little-endian.",
        tables.len(),
        tables.join(", "),
    );
    let Some(published) = shaders.first() else { return };
    for (structure, bytes) in [("BarchanTable", TABLE_BYTES), ("BarchanProbe", Shader::PROBE_BYTES)] {
        line!(page, "\n`{structure}`, {bytes} bytes:\n\n| byte | number | type | what |\n|---|---|---|---|");
        let comments: BTreeMap<_, _> = fields(published.shader.source(), structure).into_iter().collect();
        for (offset, member, wgsl) in members(&published.translations.module, structure) {
            let comment = comments.get(&member).map_or("", String::as_str);
            line!(page, "| {offset} | `{member}` | `{wgsl}` | {comment} |");
        }
    }
}

/// Offset, name and type of the members of a structure.
fn members(module: &naga::Module, structure: &str) -> Vec<(u32, String, String)> {
    let of_type = |handle| match &module.types[handle].inner {
        TypeInner::Scalar(scalar) => scalar_name(*scalar).to_owned(),
        TypeInner::Vector { size, scalar } => format!("vec{}<{}>", *size as u8, scalar_name(*scalar)),
        other => format!("{other:?}"),
    };
    let found = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(structure)).map(|(_, ty)| &ty.inner);
    let Some(TypeInner::Struct { members, .. }) = found else { return Vec::new() };
    members.iter().map(|member| (member.offset, member.name.clone().unwrap_or_default(), of_type(member.ty))).collect()
}

fn scalar_name(scalar: naga::Scalar) -> &'static str {
    match scalar.kind {
        naga::ScalarKind::Float => "f32",
        naga::ScalarKind::Sint => "i32",
        naga::ScalarKind::Uint => "u32",
        _ => "bool",
    }
}

/// Every function that has a comment, by the shaders that it is in.
fn function_lists(page: &mut String, shaders: &[Published]) {
    let mut found: Vec<(Function, Vec<&str>)> = Vec::new();
    for published in shaders {
        for function in documented(published.shader.source()) {
            match found.iter_mut().find(|(other, _)| *other == function) {
                Some((_, names)) => names.push(&published.name),
                None => found.push((function, vec![&published.name])),
            }
        }
    }
    line!(
        page,
        "
## Functions

Places are in texels from the centre of texel (0, 0), rows downwards; directions are in the frame (u, v up the picture, height); angles
are in radians. `barchan_T_texel(texel, layer)` is the decoded value of any table T, beyond its edges too; `barchan_T_at(place, layer)`
is the value between texels, in shaders that interpolate between those of T. A game calls those in bold; the others are what these are
made of."
    );
    let called: Vec<_> = shaders.iter().flat_map(|shader| &shader.techniques).flat_map(|of| of.functions()).collect();
    let mut groups: Vec<&Vec<&str>> = Vec::new();
    for (_, names) in &found {
        if !groups.contains(&names) {
            groups.push(names);
        }
    }
    for group in groups {
        let title = if group.len() == shaders.len() { "every shader".to_owned() } else { group.join(", ") };
        line!(page, "\n### In {title}\n");
        for (function, _) in found.iter().filter(|(_, names)| names == group) {
            let bold = if called.iter().any(|name| **name == function.name()) { "**" } else { "" };
            line!(page, "- {bold}`{}`{bold}  \n  {}", function.signature, function.comment);
        }
    }
}
