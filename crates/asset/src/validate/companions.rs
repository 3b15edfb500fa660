//! Tables that only make sense beside another one.

use std::format;
use std::string::String;

use crate::{Asset, ReliefRange, SectionKind, Semantic, TextureDescriptor};

/// What lengths that are meant to be equal may differ by, of themselves: the rounding of another writer's f64.
const SLACK: f64 = 1e-9;

/// A swept table, what it refines, and the other swept table of its points.
const SWEPT: [(SectionKind, SectionKind); 2] =
    [(SectionKind::SWEPT_HORIZON, SectionKind::HORIZON), (SectionKind::SWEPT_DISTANCE, SectionKind::DISTANCE)];

/// Reports tables whose companion is missing or lies otherwise. Descriptors that cannot be read are passed over:
/// they have their own findings.
pub(super) fn check(asset: &Asset<'_>, mut add: impl FnMut(&'static str, SectionKind, String)) {
    swept(asset, &mut add);
    reliefs(asset, &mut add);
}

fn descriptor(asset: &Asset<'_>, kind: SectionKind) -> Option<TextureDescriptor> {
    asset.section(kind).and_then(|section| section.texture().ok())
}

fn swept(asset: &Asset<'_>, add: &mut impl FnMut(&'static str, SectionKind, String)) {
    let descriptor = |kind| descriptor(asset, kind);
    for (swept_kind, kind) in SWEPT {
        let Some(swept) = descriptor(swept_kind) else { continue };
        if asset.section(kind).is_none() {
            add("B0702", swept_kind, format!("there is no {kind} section, which {swept_kind} refines"));
        }
        if descriptor(kind).is_some_and(|flat| !lies_as(&swept, &flat)) {
            add("B0701", swept_kind, format!("extent, spacing, wrap, azimuths or radius are not those of {kind}"));
        }
    }
    let [horizon, distance] = SWEPT.map(|(kind, _)| descriptor(kind));
    if let (Some(horizon), Some(distance)) = (horizon, distance)
        && !(lies_as(&horizon, &distance) && same_sweep(&horizon, &distance))
    {
        let message = "its place, candidates or curvatures are not those of SWHZ";
        add("B0701", SectionKind::SWEPT_DISTANCE, message.into());
    }
}

/// Whatever a ray finds with a relief table it finds on the surface of `HGHT`.
fn reliefs(asset: &Asset<'_>, add: &mut impl FnMut(&'static str, SectionKind, String)) {
    let semantics = Semantic::ALL.into_iter().filter(|semantic| semantic.is_relief_search());
    for table in semantics.filter_map(|semantic| descriptor(asset, semantic.kind())) {
        let kind = table.semantic.kind();
        if asset.section(SectionKind::HEIGHT).is_none() {
            add("B0704", kind, format!("there is no HGHT section, whose surface {kind} is of"));
        }
        let difference = descriptor(asset, SectionKind::HEIGHT).and_then(|heights| difference(&table, &heights));
        if let Some(what) = difference {
            add("B0703", kind, format!("{what} not those of HGHT"));
        }
    }
}

/// What of a relief table is not as the heights ask.
fn difference(table: &TextureDescriptor, heights: &TextureDescriptor) -> Option<String> {
    let edges = |d: &TextureDescriptor| (d.wrap_u, d.wrap_v, d.length_unit);
    if edges(table) != edges(heights) {
        return Some("wrap or length unit are".into());
    }
    let (a, b) = (lengths(table), lengths(heights));
    if !(same(a[0], b[0]) && same(a[1], b[1])) {
        return Some(format!("its lengths, {} by {}, are", a[0], a[1]));
    }
    let extent = |d: &TextureDescriptor| (d.width, d.height);
    if table.semantic == Semantic::MaximumHeight && extent(table) != extent(heights) {
        return Some(format!("its {} × {} texels are", table.width, table.height));
    }
    let relief = table.relief()?;
    let of_heights = ReliefRange { top: heights.range_max, thickness: heights.range_max - heights.range_min };
    let size = of_heights.top.abs().max(of_heights.thickness);
    let near = |a: f64, b: f64| (a - b).abs() <= SLACK * size;
    let as_high = near(relief.top, of_heights.top) && near(relief.thickness, of_heights.thickness);
    (!as_high).then(|| format!("its top {} and thickness {} are", relief.top, relief.thickness))
}

/// The lengths of the whole table along u and along v.
fn lengths(d: &TextureDescriptor) -> [f64; 2] {
    [d.spacing_u * f64::from(d.width), d.spacing_v * f64::from(d.height)]
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SLACK * b
}

/// Whether texels and azimuths of two tables are the same.
fn lies_as(a: &TextureDescriptor, b: &TextureDescriptor) -> bool {
    let extent = |d: &TextureDescriptor| (d.width, d.height, d.wrap_u, d.wrap_v, d.length_unit);
    let lengths = |d: &TextureDescriptor| (d.spacing_u, d.spacing_v, d.search_radius);
    extent(a) == extent(b) && lengths(a) == lengths(b) && a.azimuths() == b.azimuths()
}

fn same_sweep(a: &TextureDescriptor, b: &TextureDescriptor) -> bool {
    let sweep = |d: &TextureDescriptor| (d.candidates, d.curvature_min, d.curvature_max);
    sweep(a) == sweep(b)
}
