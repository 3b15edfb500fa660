//! Two files, value by value.

use crate::support::{Place, bumpy, noise, npy, parse_json};

/// Two files of heights that differ in two texels.
fn pair() -> Place {
    let mut heights = bumpy(9, 7);
    let place = Place::with("a.npy", npy(9, &heights));
    heights[2 * 9 + 5] += 0.25;
    heights[6 * 9 + 1] -= 0.5;
    place.write("b.npy", npy(9, &heights));
    for name in ["a", "b"] {
        place.ok(&format!("bake {name}.npy --encoding f32 --only height"));
    }
    place
}

#[test]
fn a_file_is_the_same_as_itself() {
    let place = pair();
    assert_eq!(
        place.ok("compare a.barchan a.barchan"),
        "height         RMS 0 units, at most 0 units\na.barchan and a.barchan: the same at tolerance 0\n"
    );
}

#[test]
fn the_first_and_the_worst_difference_are_placed() {
    let run = pair().run("compare a.barchan b.barchan");
    assert_eq!((run.code, run.stderr.as_str()), (Some(3), ""));
    let a = bumpy(9, 7);
    let place = |row: usize, column: usize, change: f32| {
        let height = a[row * 9 + column];
        format!("at layer 0, column {column}, row {row}: {height} and {}", height + change)
    };
    let rms = ((0.25_f64.powi(2) + 0.5_f64.powi(2)) / 63.0).sqrt();
    let expected = format!(
        "height         RMS {rms:.5} units, at most 0.5 units; first {}; worst {}\na.barchan and b.barchan: different at tolerance 0\n",
        place(2, 5, 0.25),
        place(6, 1, -0.5)
    );
    assert_eq!(run.stdout, expected);
}

#[test]
fn a_tolerance_accepts_what_it_says() {
    let place = pair();
    assert_eq!(place.run("compare a.barchan b.barchan --tolerance 0.5").code, Some(0));
    let run = place.run("--json compare a.barchan b.barchan --tolerance 0.3");
    let report = parse_json(&run.stdout);
    assert_eq!((run.code, &report["same"]), (Some(3), &false.into()));
    let first = &report["tables"][0]["values"]["first"];
    assert_eq!((&first["row"], &first["column"], &first["layer"]), (&6.into(), &1.into(), &0.into()));
}

#[test]
fn tables_that_cannot_be_compared_are_different() {
    let place = pair();
    place.ok("bake a.npy --encoding f32 --directions 4 -o more.barchan");
    let run = place.run("compare a.barchan more.barchan");
    assert_eq!(run.code, Some(3));
    assert!(run.stdout.contains("\nhorizon        only more.barchan has it\n"), "{}", run.stdout);
    place.ok("bake a.npy --encoding f32 --only height --spacing 2 -o wide.barchan");
    let run = place.run("compare a.barchan wide.barchan");
    assert_eq!(run.code, Some(3));
    assert!(
        run.stdout.starts_with("height         spacing is 1 × 1 in one and 2 × 2 in the other\n"),
        "{}",
        run.stdout
    );
}

#[test]
fn encodings_differ_by_no_more_than_they_state() {
    let place = Place::with("map.npy", npy(20, &noise(20, 16)));
    for encoding in ["f32", "f16", "u8"] {
        place.ok(&format!("bake map.npy --directions 8 --height-scale 5 --encoding {encoding} -o {encoding}.barchan"));
    }
    for encoding in ["f16", "u8"] {
        let stated = place.json(&format!("inspect {encoding}.barchan"));
        let run = place.run(&format!("--json compare f32.barchan {encoding}.barchan"));
        let compared = parse_json(&run.stdout);
        for table in 0..3 {
            let error = stated["sections"][table]["table"]["worst_case_error"].as_f64().unwrap();
            let values = &compared["tables"][table]["values"];
            let error = if values["unit"] == "degrees" { error.to_degrees() } else { error };
            let (max, rms) = (values["max"].as_f64().unwrap(), values["rms"].as_f64().unwrap());
            assert!(max <= error * (1.0 + 1e-6), "{encoding} {table}: {max} is more than {error}");
            assert!(rms > 0.05 * error, "{encoding} {table}: {rms} is suspiciously less than {error}");
        }
    }
}
