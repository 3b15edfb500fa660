//! Relaxed cone stepping: steps until inside the relief, then bisection.
//!
//! A relaxed cone is the widest in which a ray meets the surface once at most, so that steps are longer and the last one
//! goes into the relief. Fabio Policarpo, Manuel Oliveira, *Relaxed Cone Stepping for Relief Mapping*, GPU Gems 3, 2007.
//!
//! # Departures
//!
//! - The paper takes 15 steps and bisects wherever they lead. Here steps go on until one ends inside; one is at least 2⁻¹⁰ of
//!   the thickness, so that they end.
//! - The hit is the middle of what bisection leaves.

use barchan_asset::RelaxedConeMapView;

use super::cones::{Cones, step};
use super::linear::bisect;
use super::matching::{MismatchedRelief, check_range, check_texels};
use super::start::{Left, STEP_BACK, leave_relief};
use super::{Fetches, Found, Relief, ReliefRay, ReliefSearch, Start};

/// The least step, as a part of the thickness.
const LEAST_STEP: f64 = 1.0 / 1024.0;

/// Relaxed cone stepping with a bisection.
#[derive(Debug, Clone)]
pub struct RelaxedConeSteps<'a> {
    relief: Relief<'a>,
    cones: Cones,
    bisections: u32,
}

impl<'a> RelaxedConeSteps<'a> {
    /// Of a relaxed cone map and the heights it was baked of; the last step is halved `bisections` times, 64 at most.
    ///
    /// # Errors
    /// A table with another size, spacing, edge or range of depths.
    pub fn new(relief: &Relief<'a>, cones: &RelaxedConeMapView<'_>, bisections: u32) -> Result<Self, MismatchedRelief> {
        check_texels(relief, cones.descriptor(), "relaxed cone map")?;
        check_range(relief, cones.relief(), "relaxed cone map")?;
        Ok(Self { relief: *relief, cones: Cones::new(&cones.table()), bisections })
    }

    /// Steps until one ends inside. The floor is inside without a look.
    fn first_inside(&self, ray: &ReliefRay, start: f64, fetches: &mut Fetches) -> (f64, f64) {
        let (mut outside, mut depth) = (start, start);
        while depth < 1.0 {
            *fetches += Fetches::TABLE;
            let (gap, ratio) = self.cones.sample(ray, depth);
            if gap <= 0.0 {
                return (outside, depth);
            }
            outside = depth;
            depth += step(ray, gap, ratio).max(LEAST_STEP);
        }
        (outside, 1.0)
    }
}

impl ReliefSearch for RelaxedConeSteps<'_> {
    fn name(&self) -> &'static str {
        "relaxed cone steps"
    }

    fn find(&self, ray: &ReliefRay, start: Start) -> Found {
        let mut fetches = start.fetches;
        let around = match leave_relief(&self.relief, ray, start, STEP_BACK, &mut fetches) {
            Left::Within(outside, inside) => (outside, inside),
            Left::Behind(outside) => self.first_inside(ray, outside, &mut fetches),
        };
        Found { depth: bisect(&self.relief, ray, around, self.bisections, &mut fetches), fetches }
    }
}
