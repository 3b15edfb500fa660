//! The format pages and the code say the same.

use std::fs;
use std::path::PathBuf;

use barchan_asset::{
    CurvatureColumn, DepthMode, FINDINGS, MAX_EXTENT, MAX_LAYERS, MAX_SECTIONS, RingSpacing, SectionKind, VertexFlags,
    vectors,
};

fn page(name: &str) -> String {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../formats").join(name);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
fn the_container_page_lists_every_finding_and_no_other() {
    let page = page("barchan-v1.md");
    let listed: Vec<&str> = page.lines().filter(|line| line.starts_with("| B0")).collect();
    let expected: Vec<String> =
        FINDINGS.iter().map(|kind| format!("| {} | {} | {} |", kind.id, kind.severity.name(), kind.summary)).collect();
    assert_eq!(listed, expected);
}

#[test]
fn the_container_page_names_every_kind_bound_and_vector() {
    let page = page("barchan-v1.md");
    for kind in SectionKind::known() {
        assert!(page.contains(&format!("`{kind}`")), "{kind}");
    }
    for bound in [MAX_SECTIONS, MAX_EXTENT, MAX_LAYERS] {
        assert!(page.contains(&format!(" {bound}")), "{bound}");
    }
    for vector in vectors::all().unwrap() {
        assert!(page.contains(&format!("`{}`", vector.name)), "{}", vector.name);
    }
}

#[test]
fn the_worked_examples_are_the_published_vectors() {
    assert!(hex_lines("barchan-v1.md", "height-u8-repeat-clamp") >= 20);
    assert_eq!(hex_lines("curvature-v1.md", "curvature-principal"), 4);
    assert_eq!(hex_lines("hemisphere-v1.md", "hemisphere-arc"), 16);
}

/// How many hex lines a page has; they are the bytes of that vector.
fn hex_lines(name: &str, vector: &str) -> usize {
    let page = page(name);
    let vector = vectors::all().unwrap().into_iter().find(|listed| listed.name == vector).unwrap();
    let mut lines = 0;
    for line in page.lines().filter(|line| line.len() > 9 && line.as_bytes()[4..6] == *b"  ") {
        let Ok(at) = usize::from_str_radix(&line[..4], 16) else { continue };
        let hex = line[6..].split("   ").next().unwrap_or_default();
        for (i, byte) in hex.split_whitespace().enumerate() {
            assert_eq!(u8::from_str_radix(byte, 16), Ok(vector.bytes[at + i]), "{at:#06x} + {i}");
        }
        lines += 1;
    }
    lines
}

#[test]
fn the_hemisphere_page_lists_every_ring_spacing_and_depth_mode() {
    let page = page("hemisphere-v1.md");
    let spacings = [RingSpacing::EqualAngles, RingSpacing::SquaredTangents].map(|s| (s.number(), s.name()));
    let modes = [DepthMode::Nearest, DepthMode::Conservative].map(|mode| (mode.number(), mode.name()));
    for (number, name) in spacings.into_iter().chain(modes) {
        assert!(page.contains(&format!("| {number} | {} |", name.replace('_', " "))), "{name}");
    }
}

#[test]
fn the_curvature_page_lists_every_column_format_and_remark() {
    let page = page("curvature-v1.md");
    for column in CurvatureColumn::ALL {
        let [exact, small] = column.formats().map(|format| format!("{} `{}`", format.number(), format.name()));
        let row = page.lines().find(|line| line.starts_with(&format!("| {} | {} |", column.number(), column.name())));
        assert!(row.is_some_and(|row| row.contains(&exact) && row.contains(&small)), "{row:?}");
    }
    for (flag, name) in VertexFlags::ALL {
        assert!(page.contains(&format!("| {} | {name} |", flag.0.trailing_zeros())), "{name}");
    }
}
