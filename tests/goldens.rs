//! Pictures and words held against what they were when somebody last looked at them.
//!
//! A golden that is missing fails. Goldens are written by the command in [`WRITE`] alone, and a picture only while the
//! shadows from its horizon map agree with ray-traced ones, so that a wrong bake cannot become the measure. A picture
//! that differs is left in `target/goldens`, with one of the difference. Pictures are made of integers, IEEE arithmetic and
//! `libm`, so they are compared exactly.

mod support;

use std::fs;
use std::path::{Path, PathBuf};

use barchan_metrics::signed_colour;
use image::{Rgb, RgbImage};
use support::{Place, rgb, workspace};

const WRITE: &str = "BARCHAN_WRITE_GOLDENS=1 cargo test -p barchan-cli --test goldens";

/// The most pixels whose shadow may differ from the traced one in a picture that becomes a golden.
const MOST_WRONG: f64 = 0.01;

fn may_write() -> bool {
    std::env::var_os("BARCHAN_WRITE_GOLDENS").is_some_and(|value| value == "1")
}

/// Where goldens are, and where what does not agree with them is left.
struct Gallery {
    goldens: PathBuf,
    left: PathBuf,
    may_write: bool,
}

impl Gallery {
    fn of_the_workspace() -> Self {
        let left = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("goldens");
        Self { goldens: workspace("tests/goldens"), left, may_write: may_write() }
    }

    /// Holds a picture against its golden; `wrong_share` of its pixels differ from the traced ones.
    fn picture(&self, name: &str, actual: &RgbImage, wrong_share: f64) -> Result<(), String> {
        let golden = self.goldens.join(name);
        let expected = fs::read(&golden).ok().map(|bytes| rgb(&bytes));
        if expected.as_ref() == Some(actual) {
            return Ok(());
        }
        if self.may_write {
            if wrong_share > MOST_WRONG {
                return Err(format!("{name} is not written: {wrong_share} of its shadows differ from the traced ones"));
            }
            actual.save(&golden).unwrap();
            return Ok(());
        }
        let Some(expected) = expected else { return Err(missing(name)) };
        let path = self.leave(name, "actual");
        actual.save(&path).unwrap();
        if expected.dimensions() != actual.dimensions() {
            let (golden, found) = (expected.dimensions(), actual.dimensions());
            return Err(format!("{name} is {golden:?} pixels, the picture {found:?}; it is in {}", path.display()));
        }
        let difference = self.leave(name, "difference");
        differences(&expected, actual).save(&difference).unwrap();
        let (count, most, at) = distance(&expected, actual);
        Err(format!(
            "{name}: {count} of {} pixels differ, by {most} of 255 at most, at {at:?}; the picture is in {}, the difference in \
             {}; if it is right, {WRITE}",
            actual.pixels().len(),
            path.display(),
            difference.display()
        ))
    }

    /// Holds words against their golden.
    fn words(&self, name: &str, actual: &str) -> Result<(), String> {
        let golden = self.goldens.join(name);
        let expected = fs::read_to_string(&golden).ok();
        if expected.as_deref() == Some(actual) {
            return Ok(());
        }
        if self.may_write {
            fs::write(&golden, actual).unwrap();
            return Ok(());
        }
        let Some(expected) = expected else { return Err(missing(name)) };
        let path = self.leave(name, "actual");
        fs::write(&path, actual).unwrap();
        let lines = expected.lines().zip(actual.lines()).enumerate();
        let first = lines.map(|(line, pair)| (line + 1, pair)).find(|(_, (expected, actual))| expected != actual);
        let first = first.map_or_else(
            || "one goes on where the other ends".to_owned(),
            |(line, (expected, actual))| format!("line {line} was\n  {expected}\nand is\n  {actual}"),
        );
        Err(format!("{name}: {first}\nall of it is in {}; if it is right, {WRITE}", path.display()))
    }

    /// `dunes.actual.png` in the folder of what does not agree.
    fn leave(&self, name: &str, what: &str) -> PathBuf {
        fs::create_dir_all(&self.left).unwrap();
        let (stem, ending) = name.rsplit_once('.').unwrap();
        self.left.join(format!("{stem}.{what}.{ending}"))
    }
}

fn missing(name: &str) -> String {
    format!("tests/goldens/{name} is missing; this writes it: {WRITE}")
}

fn brightness(pixel: &Rgb<u8>) -> f64 {
    pixel.0.map(f64::from).iter().sum::<f64>() / 3.0
}

/// Red where the picture became brighter, blue where it became darker, full where that is most.
fn differences(expected: &RgbImage, actual: &RgbImage) -> RgbImage {
    let change = |x, y| brightness(actual.get_pixel(x, y)) - brightness(expected.get_pixel(x, y));
    let (width, height) = actual.dimensions();
    let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let most = all.map(|(x, y)| change(x, y).abs()).fold(1.0, f64::max);
    RgbImage::from_fn(width, height, |x, y| Rgb(signed_colour(change(x, y) / most)))
}

/// How many pixels differ, by how much in a channel at most, and where the first one is.
fn distance(expected: &RgbImage, actual: &RgbImage) -> (usize, u8, Option<(u32, u32)>) {
    let worst = |(_, _, a): &(u32, u32, &Rgb<u8>), b: &Rgb<u8>| {
        a.0.iter().zip(b.0).map(|(a, b)| a.abs_diff(b)).max().unwrap_or_default()
    };
    let pairs = actual.enumerate_pixels().zip(expected.pixels());
    let different: Vec<_> =
        pairs.map(|(a, b)| (a.0, a.1, worst(&a, b))).filter(|(_, _, difference)| *difference > 0).collect();
    let most = different.iter().map(|(_, _, difference)| *difference).max().unwrap_or_default();
    (different.len(), most, different.first().map(|&(x, y, _)| (x, y)))
}

/// Bakes a recipe of the gallery in a place of its own, on one thread.
fn baked(name: &str) -> (Place, String) {
    let place = Place::new();
    fs::copy(workspace("tests/goldens").join(format!("{name}.ron")), place.path(&format!("{name}.ron"))).unwrap();
    let words = place.ok(&format!("bake {name}.ron -j 1"));
    (place, words)
}

/// Hides what depends on the machine: seconds, speed, and where the program is.
fn masked(words: &str) -> String {
    let words = words.replace(env!("CARGO_BIN_EXE_barchan"), "barchan");
    let pieces: Vec<_> = words.split_inclusive(' ').collect();
    let follows = |index: usize| pieces.get(index + 1).copied().unwrap_or_default();
    let is_measured = |index: usize| {
        let next = follows(index);
        next.starts_with("Mtexel")
            || next.starts_with("Mray")
            || next.trim_end().trim_end_matches([',', '\n']) == "s"
            || next.starts_with("s\n")
    };
    let mask = |(index, piece): (usize, &&str)| match piece.trim_start_matches('(').trim_end().parse::<f64>() {
        Ok(_) if is_measured(index) => piece.replace(|c: char| c.is_ascii_digit() || c == '.', "").replace(' ', "# "),
        _ => (*piece).to_owned(),
    };
    pieces.iter().enumerate().map(mask).collect()
}

fn picture_is_golden(name: &str) {
    let (place, _) = baked(name);
    let report = place.json(&format!("render {name}.barchan --azimuth 135 --elevation 10 --compare -o lit.png"));
    let wrong_share = report["comparison"]["wrong_share"].as_f64().unwrap();
    let picture = rgb(&place.read("lit.png"));
    Gallery::of_the_workspace()
        .picture(&format!("{name}.png"), &picture, wrong_share)
        .unwrap_or_else(|why| panic!("{why}"));
}

fn words_are_golden(name: &str) {
    let (place, bake) = baked(name);
    let gallery = Gallery::of_the_workspace();
    let plan = place.ok(&format!("plan {name}.ron"));
    let inspect = place.ok(&format!("inspect {name}.barchan"));
    for (command, words) in [("plan", masked(&plan)), ("bake", masked(&bake)), ("inspect", inspect)] {
        gallery.words(&format!("{name}.{command}.txt"), &words).unwrap_or_else(|why| panic!("{why}"));
    }
}

#[test]
fn dunes_in_long_shadows() {
    picture_is_golden("dunes");
}

#[test]
fn reptile_skin_in_short_shadows() {
    picture_is_golden("reptile_skin");
}

#[test]
fn what_is_said_of_a_recipe_with_a_scene() {
    words_are_golden("dunes");
}

#[test]
fn what_is_said_of_a_recipe_with_relief_mapping() {
    words_are_golden("bumps");
}

#[test]
fn what_is_said_of_a_recipe_without_one() {
    words_are_golden("reptile_skin");
}

/// Goldens themselves.
mod the_gallery {
    use super::*;

    fn gallery(folder: &tempfile::TempDir, may_write: bool) -> Gallery {
        Gallery { goldens: folder.path().to_owned(), left: folder.path().join("left"), may_write }
    }

    fn grey(level: u8) -> RgbImage {
        RgbImage::from_pixel(3, 2, Rgb([level; 3]))
    }

    #[test]
    fn refuses_what_it_does_not_have() {
        let folder = tempfile::tempdir().unwrap();
        for refusal in
            [gallery(&folder, false).picture("a.png", &grey(9), 0.0), gallery(&folder, false).words("a.png", "9")]
        {
            assert_eq!(refusal.unwrap_err(), format!("tests/goldens/a.png is missing; this writes it: {WRITE}"));
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn takes_no_picture_that_tracing_contradicts() {
        let folder = tempfile::tempdir().unwrap();
        let gallery = gallery(&folder, true);
        assert!(gallery.picture("a.png", &grey(9), 0.02).unwrap_err().starts_with("a.png is not written: 0.02 of"));
        gallery.picture("a.png", &grey(9), 0.001).unwrap();
        assert_eq!(rgb(&fs::read(folder.path().join("a.png")).unwrap()), grey(9));
    }

    #[test]
    fn shows_what_differs() {
        let folder = tempfile::tempdir().unwrap();
        gallery(&folder, true).picture("a.png", &grey(9), 0.0).unwrap();
        let mut other = grey(9);
        other.put_pixel(2, 1, Rgb([9, 14, 9]));
        let why = gallery(&folder, false).picture("a.png", &other, 0.0).unwrap_err();
        assert!(
            why.starts_with("a.png: 1 of 6 pixels differ, by 5 of 255 at most, at Some((2, 1)); the picture is in "),
            "{why}"
        );
        let left = |name: &str| rgb(&fs::read(folder.path().join("left").join(name)).unwrap());
        assert_eq!(left("a.actual.png"), other);
        assert_ne!(left("a.difference.png").get_pixel(2, 1), left("a.difference.png").get_pixel(0, 0));
    }

    #[test]
    fn shows_the_first_line_that_differs() {
        let folder = tempfile::tempdir().unwrap();
        gallery(&folder, true).words("a.txt", "one\ntwo\n").unwrap();
        let why = gallery(&folder, false).words("a.txt", "one\ntoo\n").unwrap_err();
        assert!(why.starts_with("a.txt: line 2 was\n  two\nand is\n  too\n"), "{why}");
    }

    #[test]
    fn hides_seconds_and_speed() {
        assert_eq!(
            masked(
                "in 3.61 s\ntime  source 0.55 s, horizon 2.85 s (2.9 Mtexel·direction/s on 1 thread), pack 0.01 s\n7 s"
            ),
            "in # s\ntime  source # s, horizon # s (# Mtexel·direction/s on 1 thread), pack # s\n7 s"
        );
    }
}
