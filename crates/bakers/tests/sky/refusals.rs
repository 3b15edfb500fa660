//! What is refused, in whose words, and what is a mistake of the caller.

use barchan_bakers::Exec;
use barchan_bakers::horizon::Azimuths;
use barchan_bakers::sky::{SkyAccumulator, SkyMap, SkyParams};
use barchan_field::{Edge, HeightField};

use crate::support::{fill, grid};

fn field() -> HeightField {
    fill(grid((2, 2), (1.0, 1.0), Edge::Clamp), |_, _| 0.0)
}

fn refusal(azimuths: Azimuths) -> String {
    SkyAccumulator::new(&field(), &azimuths, SkyParams::ALL).err().expect("a refusal").to_string()
}

#[test]
fn an_arc() {
    let said = refusal(Azimuths::Arc { first_degrees: 10.0, last_degrees: 170.5, count: 9 });
    let why = "the sky is all around a texel: only the full circle of azimuths is accepted where it is baked";
    assert_eq!(said, format!("arc is 10 to 170.5; {why}"));
}

#[test]
fn too_few_and_too_many_azimuths() {
    for count in [0, 1, 2, 2049] {
        let said = format!("directions is {count}; 3 to 2048 azimuths are accepted where a sky is baked");
        assert_eq!(refusal(Azimuths::full_circle(count)), said);
    }
}

/// Adds directions of level horizons.
fn add(directions: &[u32], elevations: usize) -> SkyMap {
    let (field, exec) = (field(), Exec::new(1).unwrap());
    let mut sky = SkyAccumulator::new(&field, &Azimuths::full_circle(3), SkyParams::ALL).unwrap();
    for &direction in directions {
        sky.add(direction, &vec![0.0; elevations], &exec);
    }
    sky.finish(&exec).unwrap()
}

#[test]
#[should_panic(expected = "in order")]
fn a_direction_out_of_order() {
    add(&[0, 2, 1], 4);
}

#[test]
#[should_panic(expected = "in order")]
fn a_direction_twice() {
    add(&[0, 0, 1, 2], 4);
}

#[test]
#[should_panic(expected = "there are 3 directions")]
fn a_direction_too_many() {
    add(&[0, 1, 2, 3], 4);
}

#[test]
#[should_panic(expected = "a direction is missing")]
fn a_direction_left_out() {
    add(&[0, 1], 4);
}

#[test]
#[should_panic(expected = "one elevation to a texel")]
fn elevations_of_another_field() {
    add(&[0], 3);
}

#[test]
fn a_table_not_asked_for_is_not_there_and_changes_no_other() {
    let (field, exec) =
        (fill(grid((5, 4), (1.0, 1.0), Edge::Wrap), |column, row| (column * row % 3) as f32), Exec::new(1));
    let exec = exec.unwrap();
    let bake = |params: SkyParams| {
        let mut sky = SkyAccumulator::new(&field, &Azimuths::full_circle(7), params).unwrap();
        for direction in 0..7 {
            sky.add(direction, &[0.1 * direction as f32; 20], &exec);
        }
        sky.finish(&exec).unwrap()
    };
    let all = bake(SkyParams::ALL);
    for wanted in 0..8 {
        let [visibility, bent_normal, aperture_cone] = [1, 2, 4].map(|table| wanted & table != 0);
        let some = bake(SkyParams { visibility, bent_normal, aperture_cone });
        assert_eq!(some.visibility, all.visibility.clone().filter(|_| visibility));
        assert_eq!(some.bent_normal, all.bent_normal.clone().filter(|_| bent_normal));
        assert_eq!(some.aperture_cone, all.aperture_cone.clone().filter(|_| aperture_cone));
    }
}
