//! Tables that only make sense beside another one.

use std::format;
use std::string::String;

use crate::{Asset, SectionKind, TextureDescriptor};

/// A swept table, what it refines, and the other swept table of its points.
const SWEPT: [(SectionKind, SectionKind); 2] =
    [(SectionKind::SWEPT_HORIZON, SectionKind::HORIZON), (SectionKind::SWEPT_DISTANCE, SectionKind::DISTANCE)];

/// Reports swept tables whose companion is missing or lies otherwise. Descriptors that cannot be read are passed over:
/// they have their own findings.
pub(super) fn check(asset: &Asset<'_>, mut add: impl FnMut(&'static str, SectionKind, String)) {
    let descriptor = |kind| asset.section(kind).and_then(|section| section.texture().ok());
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
