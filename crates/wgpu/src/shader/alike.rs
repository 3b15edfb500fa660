//! Tables that are read at one place must lie alike: a shader finds texel and layer once.

use barchan_asset::{Semantic, TextureDescriptor};

use super::{ComposeError, Technique};
use crate::UploadPlan;

/// Refuses tables of a technique that do not lie as its first one does. A hemisphere table may be coarser.
pub(super) fn check(technique: Technique, tables: &[Semantic], plan: &UploadPlan) -> Result<(), ComposeError> {
    let descriptor = |table: Semantic| plan.texture(table).map(|texture| &texture.descriptor);
    let pairs = tables.iter().enumerate().flat_map(|(k, &table)| tables[..k].iter().map(move |&other| (table, other)));
    for (table, other) in pairs {
        if let (Some(one), Some(another)) = (descriptor(table), descriptor(other))
            && let Some(field) = difference(one, another)
        {
            return Err(ComposeError::Unlike { technique, table, other, field });
        }
    }
    Ok(())
}

/// What of two tables differs, and may not.
fn difference(a: &TextureDescriptor, b: &TextureDescriptor) -> Option<&'static str> {
    let has_cells = |table: &TextureDescriptor| table.semantic == Semantic::HemisphereDepth;
    let extent = (a.width, a.height) == (b.width, b.height) || has_cells(a) || has_cells(b);
    let directions = [a, b].map(|table| table.azimuths().filter(|_| !has_cells(table)));
    let azimuths = directions[0] == directions[1] || directions.contains(&None);
    let candidates = a.candidates == b.candidates || a.candidates == 0 || b.candidates == 0;
    let edges = (a.wrap_u, a.wrap_v) == (b.wrap_u, b.wrap_v);
    let checks = [(extent, "extent"), (edges, "edges"), (azimuths, "azimuths"), (candidates, "candidates")];
    checks.into_iter().find(|(same, _)| !same).map(|(_, field)| field)
}
