//! Heat maps: where which colour is.

use barchan_shade::heat_map;

fn grey(share: f64) -> [u8; 3] {
    [(255.0 * share).round() as u8; 3]
}

#[test]
fn counts_are_coloured_up_to_the_greatest_and_what_saw_nothing_is_background() {
    let counts: Vec<_> = [Some(0), Some(5), Some(10), Some(99), None].into_iter().chain([None; 35]).collect();
    let picture = heat_map(&counts, 40, 10, grey);
    let pixel = |column: usize| &picture.rgb[3 * column..3 * column + 3];
    assert_eq!((pixel(0), pixel(1), pixel(2), pixel(3)), (&[0; 3][..], &[128; 3][..], &[255; 3][..], &[255; 3][..]));
    assert_eq!(pixel(4), pixel(39));
}

#[test]
fn the_legend_runs_from_nothing_to_the_greatest_below_the_picture() {
    let picture = heat_map(&vec![None; 64 * 3], 64, 120, grey);
    assert!(picture.width == 64 && picture.height > 3 + 20);
    assert_eq!(picture.rgb.len(), 3 * 64 * picture.height as usize);
    let row = |row: usize| picture.rgb[3 * 64 * row..3 * 64 * (row + 1)].chunks_exact(3);
    // Somewhere in the middle of the bar: from black to white, never back.
    let bar: Vec<_> = row(3 + 10).map(|pixel| pixel[0]).skip(6).take(52).collect();
    assert!(bar[0] == 0 && bar[51] == 255 && bar.is_sorted());
}

#[test]
fn a_picture_narrower_than_its_legend_is_still_one() {
    for width in 1..16 {
        let picture = heat_map(&vec![Some(3); 2 * width as usize], width, 0, grey);
        assert_eq!(picture.rgb.len(), 3 * (picture.width * picture.height) as usize);
    }
}
