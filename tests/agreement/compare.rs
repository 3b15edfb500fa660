//! What was found against what was expected, a number a pixel, and pictures of both where they are too far apart.

use std::path::{Path, PathBuf};

use barchan_metrics::{ErrorStats, false_colour};

use crate::support::report;

/// Fails unless all but a share of `found` lie within a tolerance of `expected`; the message says how far apart they are, where,
/// and which pictures show it. Returns the greatest difference. Both are `(width, height)` numbers, row by row from the top.
#[track_caller]
pub(crate) fn agree(
    name: &str,
    size: (u32, u32),
    found: &[f64],
    expected: &[f64],
    tolerance: f64,
    allowed_share: f64,
) -> f64 {
    let worst = compare(name, size, found, expected, tolerance, allowed_share);
    let worst = worst.unwrap_or_else(|message| panic!("{message}"));
    report(name, worst, tolerance);
    worst
}

/// [`agree`] without the panic.
pub(crate) fn compare(
    name: &str,
    size: (u32, u32),
    found: &[f64],
    expected: &[f64],
    tolerance: f64,
    allowed_share: f64,
) -> Result<f64, String> {
    let numbers = size.0 as usize * size.1 as usize;
    assert_eq!((found.len(), expected.len()), (numbers, numbers), "{name}: numbers of {size:?} pixels");
    let differences: Vec<f64> =
        found.iter().zip(expected).map(|(&found, &expected)| difference(found, expected)).collect();
    let stats = ErrorStats::of(differences.iter().copied());
    let within = differences.iter().filter(|&&difference| difference <= tolerance).count();
    let beyond = numbers - within;
    if beyond as f64 <= allowed_share * numbers as f64 {
        return Ok(stats.max());
    }
    let worst = stats.worst().unwrap_or(0) as usize;
    let pictures = leave_pictures(name, size, found, expected, &differences, tolerance);
    Err(format!(
        "{name}: {beyond} of {numbers} numbers are further than {tolerance:e} from what is expected; the worst, by {:e}, is {} \
         instead of {} at ({}, {}); see {}",
        stats.max(),
        found[worst],
        expected[worst],
        worst % size.0 as usize,
        worst / size.0 as usize,
        pictures.display(),
    ))
}

/// Two that are no number agree; one that is none is infinitely wrong.
fn difference(found: f64, expected: f64) -> f64 {
    match (found.is_nan(), expected.is_nan()) {
        (true, true) => 0.0,
        (false, false) if found == expected => 0.0,
        (false, false) => (found - expected).abs(),
        _ => f64::INFINITY,
    }
}

/// Draws `NAME.found.png` and `NAME.expected.png` on one scale and `NAME.difference.png`, yellow at four tolerances; returns the
/// path of the last.
fn leave_pictures(
    name: &str,
    size: (u32, u32),
    found: &[f64],
    expected: &[f64],
    differences: &[f64],
    tolerance: f64,
) -> PathBuf {
    let finite = found.iter().chain(expected).copied().filter(|number| number.is_finite());
    let (least, greatest) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), n| (lo.min(n), hi.max(n)));
    let range = if greatest > least { greatest - least } else { 1.0 };
    let scaled = |numbers: &[f64]| numbers.iter().map(|number| (number - least) / range).collect::<Vec<_>>();
    let whole = 4.0 * tolerance.max(f64::MIN_POSITIVE);
    let differences: Vec<f64> = differences.iter().map(|difference| difference / whole).collect();
    let folder = folder();
    std::fs::create_dir_all(&folder).unwrap();
    let path = |what: &str| folder.join(format!("{name}.{what}.png"));
    draw(&path("found"), size, &scaled(found));
    draw(&path("expected"), size, &scaled(expected));
    draw(&path("difference"), size, &differences);
    path("difference")
}

/// `target/agreement`, wherever that is.
pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("agreement")
}

fn draw(path: &Path, (width, height): (u32, u32), shares: &[f64]) {
    let pixels = shares.iter().flat_map(|&share| false_colour(share)).collect();
    image::RgbImage::from_raw(width, height, pixels).unwrap().save(path).unwrap();
}

#[test]
fn what_is_within_the_tolerance_agrees() {
    let nan = f64::NAN;
    assert_eq!(compare("within", (2, 2), &[1.0, 2.0, 3.0, nan], &[1.0, 2.25, 3.0, nan], 0.25, 0.0), Ok(0.25));
    // One of four may be anything.
    assert_eq!(compare("share", (4, 1), &[1.0, 2.0, 3.0, 9.0], &[1.0, 2.0, 3.0, 4.0], 0.0, 0.25), Ok(5.0));
}

#[test]
fn what_is_not_fails_and_leaves_pictures() {
    let message =
        compare("beyond", (3, 2), &[0.0, 1.0, 2.0, 3.0, 4.5, 5.0], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], 0.25, 0.0);
    let message = message.unwrap_err();
    assert!(message.contains("1 of 6") && message.contains("(1, 1)") && message.contains("5e-1"), "{message}");
    assert!(message.ends_with("beyond.difference.png"), "{message}");
    for picture in ["found", "expected", "difference"] {
        let picture = image::open(folder().join(format!("beyond.{picture}.png"))).unwrap().to_rgb8();
        assert_eq!(picture.dimensions(), (3, 2));
    }
    let difference = image::open(folder().join("beyond.difference.png")).unwrap().to_rgb8();
    // Half of four tolerances in one pixel, nothing in the others.
    assert_eq!(difference.get_pixel(1, 1).0, false_colour(0.5));
    assert_eq!(difference.get_pixel(0, 0).0, false_colour(0.0));
}

#[test]
fn what_is_no_number_does_not_agree_with_one() {
    let no_number = compare("no_number", (1, 1), &[f64::NAN], &[1.0], 1e9, 0.0).unwrap_err();
    assert!(no_number.contains("NaN instead of 1"), "{no_number}");
}
