//! Height maps, and files that are not.

use crate::support::{Place, bumpy, npy};

fn complaint(name: &str, content: impl AsRef<[u8]>, flags: &str) -> String {
    let place = Place::with(name, content);
    let message = place.fails(2, &format!("bake {name} {flags}"));
    assert_eq!(place.names(), [name]);
    message.strip_prefix(&format!("{name}: ")).unwrap_or_else(|| panic!("{name} is not named: {message}")).to_owned()
}

#[test]
fn an_empty_file_is_refused() {
    for name in ["a.png", "a.exr", "a.tif", "a.npy"] {
        assert_eq!(
            complaint(name, "", ""),
            "the file is empty; a PNG, EXR, TIFF, NPY, OBJ, PLY or glTF file is needed"
        );
    }
}

#[test]
fn a_file_of_another_type_is_refused_and_told_what_it_is() {
    assert_eq!(
        complaint("a.png", "Dear diary", ""),
        "the file is of an unknown format (it begins with 44 65 61 72 20 64 69 61); a PNG, EXR, TIFF, NPY, OBJ, PLY or glTF file is needed"
    );
    assert_eq!(
        complaint("a.png", b"\xff\xd8\xff\xe0", ""),
        "the file is a JPEG; a PNG, EXR, TIFF, NPY, OBJ, PLY or glTF file is needed"
    );
}

#[test]
fn a_baked_file_is_not_a_height_map_and_a_height_map_not_a_baked_file() {
    let place = Place::with("a.npy", npy(4, &bumpy(4, 4)));
    place.ok("bake a.npy");
    assert!(place.fails(2, "bake a.barchan -o b.barchan").starts_with("a.barchan: the file is "));
    for words in ["inspect a.npy", "dump a.npy height", "compare a.npy a.npy", "render a.npy -o a.png"] {
        assert!(
            place.fails(2, words).starts_with("a.npy: not a .barchan file: it starts with \"\\x93NUMPY"),
            "{words}"
        );
    }
    place.write("empty.barchan", "");
    let message = place.fails(2, "inspect empty.barchan");
    assert!(message.starts_with("empty.barchan: "), "{message}");
}

#[test]
fn a_truncated_file_is_refused() {
    let whole = npy(9, &bumpy(9, 9));
    for length in [1, 6, 10, 40, 128, whole.len() - 1] {
        let message = complaint("a.npy", &whole[..length], "");
        assert!(message.starts_with("the NPY file is damaged: ") || message.contains("unknown format"), "{message}");
    }
}

#[test]
fn a_missing_height_is_placed_and_counted() {
    let mut heights = bumpy(9, 9);
    (heights[3 * 9 + 4], heights[8 * 9]) = (f32::NAN, f32::INFINITY);
    assert_eq!(
        complaint("a.npy", npy(9, &heights), ""),
        "the sample at column 4, row 3 is NaN (2 of 81 texels have no height); `fill` as value(HEIGHT), lowest or nearest \
         would accept it"
    );
    let nothing = npy(3, &[f32::NAN; 9]);
    assert_eq!(
        complaint("a.npy", &nothing, "--fill lowest"),
        "none of the 9 texels has a height (the first sample is NaN); at least one is needed"
    );
    assert_eq!(
        complaint("a.npy", npy(2, &[0.0, -9999.0]), "--no-data -9999"),
        "the sample at column 1, row 0 is -9999, which stands for no data (1 of 2 texels have no height); `fill` as \
         value(HEIGHT), lowest or nearest would accept it"
    );
}

#[test]
fn one_texel_has_no_horizon() {
    assert_eq!(
        complaint("a.npy", npy(1, &[3.0]), ""),
        "source: the height map is 1 × 1 texels; a horizon needs at least 2 texels"
    );
    let place = Place::with("a.npy", npy(1, &[3.0]));
    place.ok("bake a.npy --only height");
    assert_eq!(place.ok("dump a.barchan"), "# height in units, 1 × 1\n         3\n");
}

#[test]
fn a_height_beyond_f32_is_refused() {
    let message = complaint("a.npy", npy(2, &[1.0, 2.0]), "--height-scale 1e39");
    assert!(message.starts_with("the sample at column 0, row 0 is 1, which makes a height of 1e39; "), "{message}");
}

#[test]
fn a_radius_of_more_texels_than_are_searched_is_refused() {
    assert_eq!(
        complaint("a.npy", npy(2, &[1.0, 2.0]), "--radius 131073"),
        "horizon: radius is 131073; a positive length of at most 131072 texels is accepted"
    );
}

#[test]
fn a_channel_that_is_not_there_is_named() {
    assert_eq!(
        complaint("a.npy", npy(2, &[1.0, 2.0]), "--channel Z"),
        "`channel` is `Z`, which the NPY file does not have; Y would be accepted"
    );
}
