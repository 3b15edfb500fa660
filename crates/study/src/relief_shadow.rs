//! Shadow by relief rays, by the paper's road and by the safe one, against the exact trace.

use std::f64::consts::TAU;

use barchan_shade::{
    LinearSearch, Relief, ReliefRoad, ReliefSearch, ReliefShadow, SHADOW_TOLERANCE, ShadowAnswer, TracedRelief,
};
use glam::DVec3;

use crate::hemisphere_occlusion::Occlusions;
use crate::hemisphere_spec::{HemisphereSpec, Layers};
use crate::relief_point::ReliefPoint;
use crate::relief_rays::towards;
use crate::relief_search::MAX_POLAR;
use crate::relief_tables::{BISECTIONS, STEPS};
use crate::sample::unit;
use crate::{Quantity, Record, Scene, Setting, StudyError};

/// Angles of lights from the normal, degrees.
const LIGHTS: [f64; 3] = [30.0, 60.0, 75.0];

/// The records of one relief under lights at several angles, from all azimuths.
pub(crate) fn records(
    study: &Occlusions<'_>,
    (scene, relief): (&Scene, &Relief<'_>),
    cones: &dyn ReliefSearch,
) -> Result<Vec<Record>, StudyError> {
    let size = study.sizes.last().copied().unwrap_or(1);
    let baked = |spec: HemisphereSpec| {
        HemisphereSpec { size, ..spec }.bake(&scene.field, Layers::AtAngles(&LIGHTS), study.exec)
    };
    let (nearest, conservative) =
        (baked(HemisphereSpec::paper(MAX_POLAR))?, baked(HemisphereSpec::conservative(MAX_POLAR))?);
    let (nearest, conservative) = (nearest.start(relief)?, conservative.start(relief)?);
    let (traced, linear) = (TracedRelief::new(relief), LinearSearch::new(relief, STEPS, BISECTIONS));
    let roads: [(&str, ReliefRoad<'_>); 3] = [
        ("linear", ReliefRoad { depth_map: None, search: &linear }),
        ("nearest_linear", ReliefRoad { depth_map: Some(&nearest), search: &linear }),
        ("conservative_cone_steps", ReliefRoad { depth_map: Some(&conservative), search: cones }),
    ];
    let shadow = |road| ReliefShadow { relief: *relief, road, tolerance: SHADOW_TOLERANCE };
    let truth = shadow(ReliefRoad { depth_map: None, search: &traced });
    let mut records = Vec::new();
    for angle in LIGHTS {
        let tests: Vec<(ReliefPoint, DVec3)> = (0..study.shadows).map(|index| test(relief, angle, index)).collect();
        let decide = |shadow: &ReliefShadow<'_>| -> Vec<_> {
            tests.iter().map(|(point, light)| shadow.at(point.place, point.depth, *light)).collect()
        };
        let expected = decide(&truth);
        for (name, road) in roads {
            let found = decide(&shadow(road));
            let wrong = found.iter().zip(&expected).filter(|(found, expected)| found.in_shadow != expected.in_shadow);
            let count = found.len() as f64;
            let mean = |of: fn(&ShadowAnswer) -> u32| {
                Some(found.iter().map(|found| f64::from(of(found))).sum::<f64>() / count)
            };
            let setting = Setting::default().with("road", name).with("angle", angle);
            records.push(Record {
                quantity: Some(Quantity::ReliefShadow),
                samples: Some(study.shadows),
                wrong_share: Some(wrong.count() as f64 / count),
                mean: Some(expected.iter().filter(|answer| answer.in_shadow).count() as f64 / count),
                height_fetches: mean(|found| found.fetches.heights),
                table_fetches: mean(|found| found.fetches.tables),
                ..Record::new("relief_shadow", setting, scene)
            });
        }
    }
    Ok(records)
}

/// A point and the light that it is asked about.
fn test(relief: &Relief<'_>, angle_degrees: f64, index: u64) -> (ReliefPoint, DVec3) {
    let azimuth = TAU * unit(1_000_000_007 + index);
    (ReliefPoint::anywhere(relief, index), towards(angle_degrees.to_radians(), azimuth))
}
