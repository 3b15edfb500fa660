//! Seams, mirrored and missing texture coordinates, and meshes that are no clean surface.

use barchan_asset::VertexFlags;
use barchan_bakers::Exec;
use barchan_bakers::curvature::{VertexCurvature, forms};
use barchan_field::Mesh;
use core::f64::consts::TAU;
use glam::{DVec2, DVec3};

use super::support::*;

#[test]
fn without_texture_coordinates_there_are_no_forms() {
    let case = Case::of(patch, 4);
    let bare = Mesh::new(case.mesh.positions().to_vec(), case.mesh.triangles().to_vec()).unwrap();
    assert_eq!(forms(&bare, &case.curvature, &Exec::new(1).unwrap()), None);
}

#[test]
fn mirrored_coordinates_are_flagged_and_do_not_turn_the_curvature() {
    let case = Case::of(patch, 8);
    let mirrored = case.with_uvs(|uv| DVec2::new(1.0 - uv.x, uv.y));
    for (straight, found) in case.forms().into_iter().zip(mirrored.forms()) {
        assert_eq!(found.flags, VertexFlags::MIRRORED_UV);
        let turned = |[a, b, c]: [f64; 3]| [a, -b, c];
        assert!(difference(found.first, turned(straight.first)) < 1e-10);
        assert!(difference(found.second, turned(straight.second)) < 1e-10);
    }
}

#[test]
fn on_a_line_of_mirroring_one_side_speaks() {
    // u runs up half around the cylinder and down again: at the seam, too, both sides have the same texture coordinates.
    let folded = closed_cylinder().with_uvs(|uv| DVec2::new(0.5 - (uv.x - 0.5).abs(), uv.y));
    for (found, uv) in folded.forms().into_iter().zip(closed_cylinder().mesh.uvs().unwrap()) {
        let length = TAU * 2.0;
        assert!(difference(found.first, [length * length, 0.0, 9.0]) < 5e-3, "{:?}", found.first);
        let expected = if uv.x > 0.5 && uv.x < 1.0 { VertexFlags::MIRRORED_UV } else { VertexFlags::NONE };
        // On the two lines of mirroring either side may speak.
        assert!(found.flags == expected || uv.x == 0.5 || uv.x.fract() == 0.0, "{uv}");
    }
}

#[test]
fn without_area_the_mean_curvature_stands_in() {
    let case = Case::of(patch, 8);
    let flat: [fn(DVec2) -> DVec2; 3] = [|_| DVec2::splat(0.5), |uv| DVec2::new(uv.x, 0.25), |uv| DVec2::splat(uv.x)];
    for uv in flat {
        for (found, vertex) in case.with_uvs(uv).forms().into_iter().zip(&case.curvature.vertices) {
            let mean = 0.5 * (vertex.principal[0] + vertex.principal[1]);
            assert_eq!((found.first, found.second), ([1.0, 0.0, 1.0], [mean, 0.0, mean]));
            assert_eq!(found.flags, VertexFlags::DEGENERATE_UV);
        }
    }
}

#[test]
fn a_triangle_without_texture_does_not_disturb_its_neighbours() {
    let case = Case::of(patch, 8);
    let mut triangles = case.mesh.triangles().to_vec();
    let [a, b, c] = triangles[70];
    let count = case.mesh.positions().len() as u32;
    triangles[70] = [a, b, count];
    triangles.push([a, count, c]);
    // The new vertex lies in that triangle and has the texture coordinates of its first corner, so that two triangles have none or odd ones.
    let middle = [a, b, c].map(|vertex| case.mesh.positions()[vertex as usize]).into_iter().sum::<DVec3>() / 3.0;
    let positions = case.mesh.positions().iter().copied().chain([middle]).collect();
    let uvs = case.mesh.uvs().unwrap();
    let uvs = uvs.iter().copied().chain([uvs[a as usize]]).collect();
    let mesh = Mesh::new(positions, triangles).unwrap().with_uvs(uvs).unwrap();
    let vertices = case.curvature.vertices.iter().copied().chain([VertexCurvature::UNKNOWN]).collect();
    let found = forms(&mesh, &curvature(vertices), &Exec::new(1).unwrap()).unwrap();
    for (vertex, (found, expected)) in found.iter().zip(case.forms()).enumerate() {
        assert!(difference(found.first, expected.first) < 0.1, "{vertex}: {:?} {:?}", found.first, expected.first);
    }
    assert_eq!(found[count as usize].flags, VertexFlags::DEGENERATE_UV);
}

#[test]
fn extreme_texture_coordinates_give_finite_forms() {
    let case = Case::of(patch, 4);
    for scale in [1e-300, 1e-100, 1e100, 1e300] {
        for found in case.with_uvs(|uv| uv * scale).forms() {
            assert!(found.first.into_iter().chain(found.second).all(f64::is_finite));
            assert!(found.uv_directions.into_iter().all(DVec2::is_finite));
        }
    }
}

/// A cylinder around which u runs once, with a seam of doubled vertices at u = 0 and 1, and its exact curvature.
fn closed_cylinder() -> Case {
    let (columns, rows) = (64, 8);
    let mut uvs = Vec::new();
    let mut jets = Vec::new();
    for row in 0..=rows {
        for column in 0..=columns {
            let uv = DVec2::new(f64::from(column) / f64::from(columns), f64::from(row) / f64::from(rows));
            uvs.push(uv);
            jets.push(cylinder(if column == columns { 0.0 } else { TAU * uv.x }, uv.y));
        }
    }
    let triangles = (0..rows).flat_map(|row| {
        (0..columns).flat_map(move |column| {
            let a = row * (columns + 1) + column;
            [[a, a + 1, a + columns + 2], [a, a + columns + 2, a + columns + 1]]
        })
    });
    let positions = jets.iter().map(|jet: &Jet| jet.point).collect();
    let mesh = Mesh::new(positions, triangles.collect()).unwrap().with_uvs(uvs).unwrap();
    let curvature = curvature(jets.iter().map(Jet::curvature).collect());
    Case { mesh, jets, curvature }
}

#[test]
fn a_seam_is_seen_from_each_side() {
    let radius = 2.0;
    for found in closed_cylinder().forms() {
        let length = TAU * radius;
        assert!(difference(found.first, [length * length, 0.0, 9.0]) < 5e-3, "{:?}", found.first);
        assert!(difference(found.second, [length * length / radius, 0.0, 0.0]) < 5e-3);
        assert_eq!(found.flags, VertexFlags::NONE);
    }
}

#[test]
fn a_soup_has_the_chart_of_the_surface() {
    for case in [Case::of(patch, 8), closed_cylinder()] {
        let corners: Vec<usize> = case.mesh.triangles().iter().flatten().map(|&vertex| vertex as usize).collect();
        let triangles = (0..corners.len() as u32 / 3).map(|triangle| [0, 1, 2].map(|corner| triangle * 3 + corner));
        let positions = corners.iter().map(|&vertex| case.mesh.positions()[vertex]).collect();
        let uvs = corners.iter().map(|&vertex| case.mesh.uvs().unwrap()[vertex]).collect();
        let soup = Case {
            mesh: Mesh::new(positions, triangles.collect()).unwrap().with_uvs(uvs).unwrap(),
            jets: corners.iter().map(|&vertex| case.jets[vertex]).collect(),
            curvature: curvature(corners.iter().map(|&vertex| case.curvature.vertices[vertex]).collect()),
        };
        let (whole, cut) = (case.forms(), soup.forms());
        let mut first_of = vec![None; whole.len()];
        for (&vertex, found) in corners.iter().zip(&cut) {
            assert!(difference(found.first, whole[vertex].first) < 1e-9);
            // Duplicates agree to the bit.
            assert_eq!(first_of[vertex].get_or_insert(*found), found);
        }
    }
}

#[test]
fn a_fin_does_not_disturb_the_surface_it_stands_on() {
    let plain = Case::of(patch, 8);
    let middle = 40;
    let foot = plain.mesh.positions()[middle];
    let mut positions = plain.mesh.positions().to_vec();
    let mut uvs = plain.mesh.uvs().unwrap().to_vec();
    let mut vertices = plain.curvature.vertices.clone();
    positions.push(foot + plain.jets[middle].normal());
    uvs.push(DVec2::new(7.0, -3.0));
    vertices.push(VertexCurvature::UNKNOWN);
    let mut triangles = plain.mesh.triangles().to_vec();
    triangles.push([middle as u32, middle as u32 + 1, 81]);
    let mesh = Mesh::new(positions, triangles).unwrap().with_uvs(uvs).unwrap();
    let found = forms(&mesh, &curvature(vertices), &Exec::new(1).unwrap()).unwrap();
    assert_eq!(found[..81], plain.forms());
}

#[test]
fn a_triangle_alone_has_a_first_form() {
    let positions = vec![DVec3::ZERO, DVec3::new(0.0, 2.0, 0.0), DVec3::new(0.0, 0.0, 3.0), DVec3::ONE];
    let uvs = vec![DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::ONE];
    let mesh = Mesh::new(positions, vec![[0, 1, 2]]).unwrap().with_uvs(uvs).unwrap();
    let unknown = |flags| VertexCurvature { flags, ..VertexCurvature::UNKNOWN };
    let mut vertices = vec![unknown(VertexFlags::DEGENERATE); 3];
    vertices.push(unknown(VertexFlags::ISOLATED));
    let found = forms(&mesh, &curvature(vertices), &Exec::new(1).unwrap()).unwrap();
    for found in &found[..3] {
        assert!(difference(found.first, [4.0, 0.0, 9.0]) < 1e-12);
        assert_eq!((found.second.map(f64::abs), found.flags), ([0.0; 3], VertexFlags::NONE));
    }
    assert_eq!((found[3].first, found[3].second), ([1.0, 0.0, 1.0], [0.0; 3]));
    assert_eq!(found[3].flags, VertexFlags::DEGENERATE_UV);
}

#[test]
fn a_hub_of_a_hundred_thousand_triangles_ends() {
    let many = 100_000;
    let mut positions = vec![DVec3::ZERO];
    positions.extend((0..many).map(|step| {
        let angle = TAU * f64::from(step) / f64::from(many);
        DVec3::new(angle.cos(), angle.sin(), 0.0)
    }));
    let uvs = positions.iter().map(|at| at.truncate() * 0.5).collect();
    let triangles = (0..many).map(|step| [0, 1 + step, 1 + (step + 1) % many]).collect();
    let mesh = Mesh::new(positions, triangles).unwrap().with_uvs(uvs).unwrap();
    let flat = vec![VertexCurvature::UNKNOWN; many as usize + 1];
    let found = forms(&mesh, &curvature(flat), &Exec::new(1).unwrap()).unwrap();
    assert!(difference(found[0].first, [4.0, 0.0, 4.0]) < 1e-9);
    assert!(difference(found[9].first, [4.0, 0.0, 4.0]) < 1e-3);
}

#[test]
fn threads_do_not_matter() {
    let case = Case::of(sphere, 100);
    let many = forms(&case.mesh, &case.curvature, &Exec::new(3).unwrap()).unwrap();
    assert_eq!(case.forms(), many);
}
