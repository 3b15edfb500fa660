//! Outputs that cannot be written. What was there before stays, and nothing is left lying about.

use crate::support::{Place, Run, noise, npy};

const OLD: &[u8] = b"the previous output";

fn place() -> Place {
    let place = Place::with("map.npy", npy(40, &noise(40, 40)));
    place.write("out.barchan", OLD);
    place
}

#[test]
fn a_folder_that_does_not_exist_is_named() {
    let place = place();
    assert_eq!(
        place.fails(4, "bake map.npy -o none/out.barchan"),
        "none/out.barchan: the folder none does not exist; create it first"
    );
    place.ok("bake map.npy --directions 4");
    for words in ["render map.barchan -o none/a.png", "dump map.barchan height -o none/a.txt"] {
        assert!(place.fails(4, words).ends_with(": the folder none does not exist; create it first"));
    }
}

#[test]
fn a_folder_is_no_output_file() {
    let place = place();
    std::fs::create_dir(place.path("folder")).unwrap();
    assert_eq!(place.fails(4, "bake map.npy -o folder"), "folder: this is a folder; a file name is needed");
    assert_eq!(
        place.fails(4, "bake map.npy -o out.barchan/a"),
        "out.barchan/a: the folder out.barchan does not exist; create it first"
    );
}

#[test]
fn the_input_is_never_the_output() {
    let place = place();
    let map = place.read("map.npy");
    let refused = |output: &str| format!("{output}: this is the input; another name is needed for -o");
    assert_eq!(place.fails(1, "bake map.npy -o ./map.npy"), refused("./map.npy"));
    assert!(place.read("map.npy") == map);
    place.ok("bake map.npy --directions 4");
    assert_eq!(place.fails(1, "dump map.barchan height -o map.barchan"), refused("map.barchan"));
    assert_eq!(place.fails(1, "render map.barchan -o map.barchan"), refused("map.barchan"));
    place.ok("validate map.barchan");
}

#[test]
fn a_bake_that_fails_leaves_the_previous_output() {
    let place = place();
    place.write("bad.npy", npy(2, &[f32::NAN; 4]));
    place.fails(2, "bake bad.npy -o out.barchan");
    place.fails(2, "bake map.npy --radius 1e9 -o out.barchan");
    assert_eq!(place.read("out.barchan"), OLD);
    assert_eq!(place.names(), ["bad.npy", "map.npy", "out.barchan"]);
}

/// Runs a command that may write no file of more than 4 KiB, as if the disk were full.
#[cfg(unix)]
fn on_a_full_disk(place: &Place, words: &str) -> Run {
    // The signal is ignored, so that writing fails with an error, as it does on a full disk.
    place.shell(&format!("trap '' XFSZ; ulimit -f 8; exec \"$BARCHAN\" {words}"))
}

#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_previous_output_and_no_temporary_file() {
    let place = place();
    place.ok("bake map.npy --directions 4 -o small.barchan");
    let names = place.names();
    for (words, output) in [
        ("bake map.npy -o out.barchan", "out.barchan"),
        ("dump small.barchan horizon --format npy -o out.barchan", "out.barchan"),
        ("render small.barchan --scale 8 -o out.barchan", "out.barchan"),
        ("bake map.npy -o new.barchan", "new.barchan"),
    ] {
        let run = on_a_full_disk(&place, words);
        assert_eq!((run.code, run.stdout.as_str()), (Some(4), ""), "{words}\n{}", run.stderr);
        let too_large = std::io::Error::from_raw_os_error(27);
        assert_eq!(run.message(), format!("{output}: cannot be written: {too_large}"));
        assert_eq!(place.read("out.barchan"), OLD, "{words}");
        assert_eq!(place.names(), names, "{words}");
    }
    // What fits is written.
    assert_eq!(on_a_full_disk(&place, "bake map.npy --only height --encoding u8 -o new.barchan").code, Some(4));
    assert_eq!(on_a_full_disk(&place, "dump small.barchan height --layer 0 --format png -o small.png").code, Some(0));
}

#[cfg(target_os = "linux")]
#[test]
fn a_folder_that_takes_no_files_is_the_systems_fault() {
    let message = place().fails(4, "bake map.npy --directions 4 -o /proc/out.barchan");
    assert!(message.starts_with("/proc/out.barchan: cannot be written: "), "{message}");
    assert!(!message.contains(".barchan-"), "the temporary name is nobody's business: {message}");
}

#[cfg(unix)]
#[test]
fn a_reader_that_stops_listening_is_no_error() {
    let place = place();
    place.ok("bake map.npy");
    let run = place.shell("\"$BARCHAN\" dump map.barchan horizon --format csv | head -n 1");
    assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""));
    assert_eq!(run.stdout, "direction,azimuth_degrees,row,column,elevation_degrees,slope\n");
}

#[cfg(target_os = "linux")]
#[test]
fn a_standard_output_that_is_full_is_an_error() {
    let place = place();
    place.ok("bake map.npy --directions 4");
    let run = place.shell("\"$BARCHAN\" dump map.barchan height > /dev/full");
    assert_eq!(
        (run.code, run.message().as_str()),
        (Some(4), "standard output: cannot be written: No space left on device (os error 28)")
    );
}
