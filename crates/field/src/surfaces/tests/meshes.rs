//! Tessellations: manifolds of the right kind, on the surface, even, and the same everywhere.

use std::collections::{HashMap, HashSet};

use super::*;

const PATTERNS: [Pattern; 4] =
    [Pattern::Regular { aspect: 1.0 }, Pattern::Jittered, Pattern::Random, Pattern::LongThin { aspect: 20.0 }];

fn tessellation(vertices: u32, pattern: Pattern) -> Tessellation {
    Tessellation { vertices, pattern, seed: 5, uv_seam: false }
}

/// Every example in every pattern.
fn everything(vertices: u32) -> impl Iterator<Item = (ParametricSurface, Pattern, TessellatedSurface)> {
    ParametricSurface::examples().into_iter().flat_map(move |surface| {
        PATTERNS.map(|pattern| {
            (
                surface,
                pattern,
                surface
                    .tessellate(&tessellation(vertices, pattern))
                    .unwrap_or_else(|error| panic!("{pattern:?}: {error}")),
            )
        })
    })
}

#[test]
fn smoke() {
    for (surface, pattern, found) in everything(1000) {
        eprintln!("{} {pattern:?} {}", surface.name(), found.parameters.len());
    }
}
