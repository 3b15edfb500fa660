//! Damaged files of every kind through every command: an exit code, never a panic or a signal. The seeds are fixed.

use barchan_asset::vectors::reseal;

use crate::support::{Place, Random, Torus, bumpy, noise, npy};

/// The program may succeed, refuse or find a difference; it may not crash, and what it says of an error is one line.
fn survives(place: &Place, words: &str, what: &str) {
    let run = place.run(words);
    match run.code {
        Some(0) => assert_eq!(run.stderr, "", "{words}: {what}"),
        // The findings or differences are on stdout.
        Some(2 | 3) if words.starts_with("validate") || words.starts_with("compare") => {}
        Some(1 | 2 | 4) => assert!(!run.message().is_empty()),
        code => panic!("{words} ended with {code:?}: {what}\n{}", run.stderr),
    }
}

/// Some bytes overwritten, taken out, doubled or cut off.
fn mutated(original: &[u8], alphabet: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = original.to_vec();
    for _ in 0..=random.below(3) {
        let at = random.below(bytes.len().max(1)).min(bytes.len().saturating_sub(1));
        let byte = if alphabet.is_empty() { random.next() as u8 } else { alphabet[random.below(alphabet.len())] };
        match random.below(8) {
            _ if bytes.is_empty() => bytes.push(byte),
            0 => bytes.truncate(at),
            1 => bytes.insert(at, byte),
            2 => drop(bytes.remove(at)),
            3 => {
                let end = (at + 1 + random.below(16)).min(bytes.len());
                let piece = bytes[at..end].to_vec();
                bytes.splice(at..at, piece);
            }
            _ => bytes[at] = byte,
        }
    }
    bytes
}

#[test]
fn random_bytes_are_survived_by_every_command() {
    let place = Place::new();
    let mut random = Random(0xBA2C);
    let magics: [&[u8]; 11] = [
        b"",
        b"\x89BARCHAN\r\n\x1a\n",
        b"\x89PNG\r\n\x1a\n",
        b"\x93NUMPY\x01\0",
        b"II*\0",
        b"MM\0*",
        b"\x76\x2f\x31\x01",
        b"(",
        b"ply\nformat ascii 1.0\n",
        b"glTF\x02\0\0\0",
        b"v 0 0 0\nf 1 1 1\n",
    ];
    for round in 0..88 {
        let mut bytes = magics[round % magics.len()].to_vec();
        let length = random.below(600);
        bytes.extend((0..length).map(|_| random.next() as u8));
        place.write("a", &bytes);
        place.write("a.ron", &bytes);
        for words in ["bake a -o b", "bake a.ron -o b", "inspect a", "validate a"] {
            survives(&place, words, &format!("round {round}"));
        }
    }
}

#[test]
fn mutated_recipes_are_survived() {
    let recipe = "(
    source: Shape(shape: Dunes(dune_height: 4.0, dunes_across: 2, ripple_height: 0.1, ripples_across: 9, seed: 7),
        width: 16, height: 12),
    spacing: (0.5, 0.25), unit: metre, edge: wrap, scene: (soft_shadows: true), // a note
    height: (encoding: f16), horizon: (directions: 3, radius: 2.0, encoding: u8), compression: zstd)";
    let place = Place::new();
    let mut random = Random(0x2E1);
    for round in 0..150 {
        let text = mutated(recipe.as_bytes(), b"()[]{},:.-_\"'/\\#!r09aeN \n\xc3", &mut random);
        place.write("a.ron", &text);
        survives(&place, "bake a.ron", &format!("round {round}:\n{}", String::from_utf8_lossy(&text)));
    }
}

#[test]
fn mutated_height_maps_are_survived() {
    let place = Place::with("map.npy", npy(13, &noise(13, 11)));
    place.ok("bake map.npy --directions 4");
    place.ok("dump map.barchan height --format png -o map.png");
    place.ok("dump map.barchan height --format exr -o map.exr");
    place.write("map.tif", tiff());
    let mut random = Random(0x4E1);
    for name in ["map.npy", "map.png", "map.exr", "map.tif"] {
        let whole = place.read(name);
        for round in 0..40 {
            // Headers are where a reader may go astray.
            let head = if round % 2 == 0 { whole.len() } else { whole.len().min(160) };
            let bytes = [&mutated(&whole[..head], &[], &mut random), &whole[head..]].concat();
            place.write("a", bytes);
            survives(&place, "bake a -o b --directions 2 --radius 3 --fill 0", &format!("{name}, round {round}"));
        }
    }
}

fn tiff() -> Vec<u8> {
    let mut bytes = std::io::Cursor::new(Vec::new());
    let mut encoder = tiff::encoder::TiffEncoder::new(&mut bytes).unwrap();
    encoder.write_image::<tiff::encoder::colortype::Gray32Float>(13, 11, &noise(13, 11)).unwrap();
    bytes.into_inner()
}

#[test]
fn mutated_meshes_are_survived() {
    let torus = Torus { around: 7, along: 5 };
    let place = Place::new();
    let mut random = Random(0x3E5);
    for (name, whole) in [("obj", torus.obj_with_uvs().into_bytes()), ("ply", torus.ply()), ("glb", torus.glb())] {
        for round in 0..40 {
            // Headers are where a reader may go astray.
            let head = if round % 2 == 0 { whole.len() } else { whole.len().min(700) };
            let bytes = [&mutated(&whole[..head], &[], &mut random), &whole[head..]].concat();
            place.write("a", bytes);
            survives(&place, "bake a -o b", &format!("{name}, round {round}"));
        }
    }
}

#[test]
fn mutated_curvature_is_survived_by_every_command() {
    let place = Place::with("torus.obj", Torus { around: 7, along: 5 }.obj_with_uvs());
    let mut random = Random(0xC0DE);
    for compression in ["none", "zstd"] {
        place.ok(&format!("bake torus.obj --compression {compression} -o whole.barchan"));
        let whole = place.read("whole.barchan");
        for round in 0..30 {
            let mut bytes = mutated(&whole, &[], &mut random);
            // Every other time with the right checksums, so that what is behind them is read.
            if round % 2 == 0 {
                reseal(&mut bytes);
            }
            place.write("a.barchan", &bytes);
            for words in [
                "inspect a.barchan",
                "validate a.barchan",
                "dump a.barchan curvature --format csv -o a.csv",
                "dump a.barchan curvature --format ply --mesh torus.obj -o a.ply",
                "dump a.barchan curvature --format png --mesh torus.obj --size 40 -o a.png",
                "compare whole.barchan a.barchan",
            ] {
                survives(&place, words, &format!("{compression}, round {round}"));
            }
        }
    }
}

#[test]
fn mutated_assets_are_survived_by_every_command() {
    let place = Place::with("map.npy", npy(6, &noise(6, 5)));
    let mut random = Random(0xA55E);
    for compression in ["none", "zstd"] {
        place.ok(&format!("bake map.npy --directions 3 --compression {compression} -o whole.barchan"));
        let whole = place.read("whole.barchan");
        for round in 0..40 {
            let mut bytes = mutated(&whole, &[], &mut random);
            // Every other time with the right checksums, so that what is behind them is read.
            if round % 2 == 0 {
                reseal(&mut bytes);
            }
            place.write("a.barchan", &bytes);
            for words in [
                "inspect a.barchan",
                "validate a.barchan",
                "dump a.barchan horizon --format npy -o a.npy",
                "compare whole.barchan a.barchan",
                "render a.barchan -o a.png",
            ] {
                survives(&place, words, &format!("{compression}, round {round}"));
            }
        }
    }
}

#[test]
fn a_small_file_cannot_claim_much_memory() {
    let place = Place::with("map.npy", npy(40, &bumpy(40, 40)));
    place.ok("bake map.npy --only height --compression zstd -o a.barchan");
    let mut bytes = place.read("a.barchan");
    // raw_length in the section table, and a frame behind the descriptor that promises the same: 60 GB.
    let claim = 60_000_000_000_u64.to_le_bytes();
    bytes[128 + 32..][..8].copy_from_slice(&claim);
    let frame = [&[0x28, 0xb5, 0x2f, 0xfd, 0xc0, 0x68][..], &claim].concat();
    bytes[4096 + 256..][..frame.len()].copy_from_slice(&frame);
    reseal(&mut bytes);
    place.write("a.barchan", &bytes);
    let findings = place.run("validate a.barchan");
    assert_eq!(findings.code, Some(2));
    let limit = bytes.len() * 32768;
    let words = format!("raw_length is 60000000000; at most {limit} bytes are accepted");
    assert!(findings.stdout.contains("B0304") && findings.stdout.contains(&words), "{}", findings.stdout);
    place.fails(2, "dump a.barchan height");
}

#[test]
fn hostile_descriptors_are_survived() {
    let place = Place::with("map.npy", npy(6, &noise(6, 5)));
    place.ok("bake map.npy --directions 3 -o whole.barchan");
    let whole = place.read("whole.barchan");
    let mut random = Random(0xDE5C);
    for round in 0..60 {
        let mut bytes = whole.clone();
        let at = if round % 2 == 0 { 128 + random.below(4 * 64) } else { 4096 + random.below(128) };
        bytes[at] = [0, 1, 0x7f, 0x80, 0xff][random.below(5)];
        reseal(&mut bytes);
        place.write("a.barchan", &bytes);
        for words in ["validate a.barchan", "inspect a.barchan", "dump a.barchan height", "render a.barchan -o a.png"] {
            survives(&place, words, &format!("byte {at}"));
        }
    }
}
