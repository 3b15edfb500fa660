//! The WGSL that reads one table.

use super::Sampling;
use crate::{Shape, TexturePlan};

/// The sampler of all tables that are filtered.
pub(super) const SAMPLER: &str = "
// Linear, with the edges of the tables as address modes.
@group(0) @binding(1) var barchan_sampler: sampler;
";

/// Its texture, and the functions that read it:
/// - `barchan_T_before_transfer(texel, layer)`: scale · stored + bias of a texel, beyond the edges too;
/// - `barchan_T_texel(texel, layer)`: its value;
/// - `barchan_T_at(place, layer)`: the value between texels, by the way of `interpolation`; nothing if nobody asks for it.
///
/// The layer of a table of mips is the level. A value is an f32, or a vector of as many numbers as a texel has.
pub(super) fn of_table(texture: &TexturePlan, interpolation: Option<Sampling>) -> String {
    let name = texture.table.kind().name().unwrap_or_default();
    let (index, binding) = (texture.table.number() - 1, texture.table.number() + 1);
    let (kind, load, sample) = match texture.shape {
        Shape::D2 => ("texture_2d", "texel, layer", "uv, 0.0"),
        Shape::D2Array => ("texture_2d_array", "texel, layer, 0", "uv, layer, 0.0"),
        Shape::D3 => ("texture_3d", "vec3<i32>(texel, layer), 0", "vec3<f32>(uv, (f32(layer) + 0.5) / LAYERS), 0.0"),
    };
    let (value, channels, vector) = match texture.format.channels() {
        1 => ("f32", "x", ""),
        2 => ("vec2<f32>", "xy", "_2"),
        _ => ("vec4<f32>", "xyzw", "_4"),
    };
    // The depth of a cone map is stored as it is.
    let plain = if texture.table.is_cone_map() { "_cone" } else { vector };
    let level = if texture.levels > 1 { "layer" } else { "0" };
    let mut source = format!(
        "
@group(0) @binding({binding}) var barchan_{name}_texels: {kind}<f32>;

const BARCHAN_{upper}: u32 = {index}u;

fn barchan_{name}_before_transfer(place: vec2<i32>, layer: i32) -> {value} {{
    let texel = barchan_inside(BARCHAN_{upper}, place, {level});
    return barchan_scaled{plain}(BARCHAN_{upper}, textureLoad(barchan_{name}_texels, {load}).{channels});
}}

fn barchan_{name}_texel(place: vec2<i32>, layer: i32) -> {value} {{
    return barchan_transferred{plain}(BARCHAN_{upper}, barchan_{name}_before_transfer(place, layer));
}}
",
        upper = name.to_uppercase(),
    );
    let sample = sample.replace("LAYERS", &format!("{}.0", texture.layers));
    source += &match interpolation {
        None => String::new(),
        Some(Sampling::Filtered) => format!(            "
fn barchan_{name}_at(place: vec2<f32>, layer: i32) -> {value} {{
    let uv = (place + 0.5) / barchan_tables[BARCHAN_{upper}].extent;
    let stored = textureSampleLevel(barchan_{name}_texels, barchan_sampler, {sample}).{channels};
    return barchan_transferred{plain}(BARCHAN_{upper}, barchan_scaled{plain}(BARCHAN_{upper}, stored));
}}
",
            upper = name.to_uppercase(),
        ),
        Some(Sampling::Loaded) => format!(
            "
fn barchan_{name}_at(place: vec2<f32>, layer: i32) -> {value} {{
    let corner = floor(place);
    let texel = vec2<i32>(corner);
    let part = place - corner;
    let upper = mix(barchan_{name}_texel(texel, layer), barchan_{name}_texel(texel + vec2<i32>(1, 0), layer), part.x);
    let lower = mix(barchan_{name}_texel(texel + vec2<i32>(0, 1), layer), barchan_{name}_texel(texel + vec2<i32>(1, 1), layer), part.x);
    return mix(upper, lower, part.y);
}}
"
        ),
    };
    source
}
