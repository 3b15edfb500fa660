//! The published vectors of `formats/`, and damaged files, through the program. What a stranger's file may do to the reader
//! is tested exhaustively in `crates/asset`.

mod support;

use std::path::Path;

use support::{Place, Random, bumpy, files, npy, workspace};

const VECTORS: &str = "formats/vectors/v1";

/// Vectors that a reader of version 1.0 accepts with a warning, and the findings.
const WARNED: [(&str, &[&str]); 2] = [("newer-minor", &["B0109", "B0110"]), ("unknown-ancillary", &["B0214"])];

/// Vectors that a reader refuses, the finding and the reason.
const REFUSED: [(&str, &str, &str); 5] = [
    ("newer-section", "B0205", "HORZ"),
    ("newline-damage", "B0102", "newlines or 8-bit characters were altered in a transfer"),
    ("required-feature", "B0107", "the file requires features 0x0000000000010000"),
    ("unknown-critical", "B0204", "NOTE"),
    ("unknown-major", "B0103", "version 2"),
];

fn stem(path: &Path) -> String {
    path.file_stem().unwrap().to_string_lossy().into_owned()
}

fn ids(findings: &serde_json::Value) -> Vec<String> {
    let findings = findings["findings"].as_array().unwrap();
    findings.iter().map(|finding| finding["id"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn every_published_vector_is_valid_and_can_be_inspected() {
    let place = Place::new();
    for path in files(&workspace(VECTORS), "barchan") {
        let (name, file) = (stem(&path), path.display());
        let findings = place.json(&format!("validate {file}"));
        let warned = WARNED.iter().find(|(warned, _)| *warned == name).map_or(&[][..], |(_, ids)| ids);
        assert_eq!(findings["valid"], true, "{name}: {findings}");
        assert_eq!(ids(&findings), warned, "{name}: {findings}");
        let inspected = place.json(&format!("inspect {file}"));
        assert!(inspected["sections"].as_array().unwrap().iter().all(|section| section["intact"] == true), "{name}");
        assert!(place.ok(&format!("inspect {file}")).starts_with("file "), "{name}");
    }
}

#[test]
fn every_refused_vector_is_refused_by_name() {
    let place = Place::new();
    let refused = files(&workspace(VECTORS).join("refused"), "barchan");
    assert_eq!(refused.iter().map(|path| stem(path)).collect::<Vec<_>>(), REFUSED.map(|(name, ..)| name));
    for (path, (name, id, reason)) in refused.iter().zip(REFUSED) {
        let file = path.display().to_string();
        for words in [format!("inspect {file}"), format!("dump {file} height"), format!("compare {file} {file}")] {
            let message = place.fails(2, &words);
            assert!(message.starts_with(&format!("{file}: ")), "{message}");
            assert!(message.contains(reason), "{name}: {message}");
        }
        let run = place.run(&format!("--json validate {file}"));
        let findings = support::parse_json(&run.stdout);
        assert_eq!((run.code, &findings["valid"]), (Some(2), &false.into()), "{name}");
        assert_eq!(ids(&findings)[0], id, "{name}: {findings}");
    }
}

#[test]
fn an_unknown_ancillary_section_does_not_keep_a_table_from_being_read() {
    let place = Place::new();
    let file = workspace(VECTORS).join("unknown-ancillary.barchan");
    let listed = place.ok(&format!("inspect {}", file.display()));
    assert!(listed.contains("\nNOTE "), "{listed}");
    assert!(place.ok(&format!("dump {}", file.display())).starts_with("# "));
}

/// A small file with every table.
fn sample() -> (Place, Vec<u8>) {
    let place = Place::with("map.npy", npy(8, &bumpy(8, 6)));
    place.ok("bake map.npy --directions 4 -o whole.barchan");
    let bytes = place.read("whole.barchan");
    (place, bytes)
}

#[test]
fn a_flipped_bit_is_found() {
    let (place, whole) = sample();
    let mut random = Random(7);
    for _ in 0..40 {
        let (at, bit) = (random.below(whole.len()), random.below(8));
        let mut damaged = whole.clone();
        damaged[at] ^= 1 << bit;
        place.write("damaged.barchan", damaged);
        let run = place.run("validate damaged.barchan");
        assert_eq!((run.code, run.stderr.as_str()), (Some(2), ""), "bit {bit} of byte {at}: {}", run.stdout);
        assert!(run.stdout.contains("damaged.barchan: NOT valid, "), "{}", run.stdout);
    }
}

#[test]
fn a_cut_file_is_refused_at_any_length() {
    let (place, whole) = sample();
    let mut random = Random(8);
    let lengths = (0..30).map(|_| random.below(whole.len())).chain([0, 1, 11, 12, 127, 128, 4096, whole.len() - 1]);
    for length in lengths {
        place.write("cut.barchan", &whole[..length]);
        assert_eq!(place.run("validate cut.barchan").code, Some(2), "{length} bytes");
        assert!(place.fails(2, "inspect cut.barchan").starts_with("cut.barchan: "), "{length} bytes");
    }
    place.write("long.barchan", [whole.as_slice(), b"\n"].concat());
    assert_eq!(place.run("validate long.barchan").code, Some(2));
}

#[test]
fn damage_to_a_table_is_named_where_it_matters() {
    let (place, mut bytes) = sample();
    let horizon = place.json("inspect whole.barchan")["sections"][1]["offset"].as_u64().unwrap() as usize;
    // Behind the descriptor of 256 bytes.
    bytes[horizon + 256] ^= 1;
    place.write("damaged.barchan", bytes);
    let damage = "damaged.barchan: horizon: the checksum does not match; the file is damaged";
    assert_eq!(place.fails(2, "dump damaged.barchan horizon"), damage);
    assert_eq!(place.fails(2, "render damaged.barchan -o lit.png"), damage);
    assert_eq!(place.fails(2, "compare damaged.barchan whole.barchan"), damage);
    assert!(place.ok("inspect damaged.barchan").contains(", DAMAGED: checksum mismatch\n"));
    // The tables that are whole can still be had.
    place.ok("dump damaged.barchan height");
}
