//! The second pass, for meshes whose vertices lie off the surface: wider neighbourhoods, as wide as the surface allows.
//!
//! # Theory
//!
//! Noise of standard deviation σ costs a fit to n neighbours a variance σ² V that falls with n³, and its bias, what a polynomial of its degree cannot follow,
//! grows with n. σ² is known: it is what the first pass left over, at the median of the mesh. So is V, of every
//! fit. The bias is not, but it shows in how estimates move as they widen: between two widths of one degree, n′ < n,
//!
//! > |S_n − S_n′|² is on average (1 − n′/n)² bias² + σ² (V_n′ − V_n),
//!
//! as the bias of a quadric grows with n, and the narrower estimate is the wider one plus noise that is independent of it. One point's
//! difference says little; averaged over its surroundings it does, and the width and degree of least bias² + σ² V is taken. That is
//! Oleg Lepski's idea (*On a problem of adaptive estimation in Gaussian white noise*, 1990) with the expected error itself in place of his threshold.
//!
//! Tried and not taken, on noise of a tenth of an edge: his threshold at every point by itself (RMS up to .3 where the above gives
//! .12); comparing all widths with the narrowest, whose own noise is then all one sees (.19 against .06 on a saddle).

use fearless_simd::{Level, Simd, dispatch};

use super::VertexCurvature;
use super::estimate::Shape;
use super::jet::{LANES, Solver};
use super::narrow::{BLOCK, Found};
use super::patch::{Fitter, Patch, Reach};
use super::sheets::Sheets;
use crate::Exec;

/// Neighbourhoods that are tried: each half as large again.
const WIDTHS: [usize; 7] = [32, 48, 72, 108, 162, 243, 364];
/// Degrees that are tried in each.
const DEGREES: [usize; 3] = [2, 3, 4];
const CANDIDATES: usize = WIDTHS.len() * DEGREES.len();
/// Widths between those that are compared.
const STEP: usize = 2;
/// How far the bias is averaged: rings of neighbours.
const ROUNDS: usize = 30;
/// The error, relative to the curvature of the whole, above which noise is worth a second pass.
const NOISY: f64 = 5e-3;

/// What a candidate is expected to be off by.
#[derive(Debug, Clone, Copy, Default)]
struct Outlook {
    /// Squared, by what its degree cannot follow.
    bias: [f32; CANDIDATES],
    /// Under unit noise.
    variance: [f32; CANDIDATES],
}

/// The noise of the vertices, squared, if it shows in the curvature.
pub(super) fn noise(found: &[Found]) -> Option<f64> {
    let noise = median(found.iter().filter_map(|found| found.noise))?;
    let variance = median(found.iter().map(|found| found.variance).filter(|variance| variance.is_finite()))?;
    let strongest = |found: &Found| found.curvature.principal[0].abs().max(found.curvature.principal[1].abs());
    let squared = median(found.iter().map(|found| strongest(found) * strongest(found)))?;
    (noise * variance > NOISY * NOISY * squared).then_some(noise)
}

fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Fits every point again, as widely as the surface allows.
pub(super) fn refit(sheets: &Sheets, noise: f64, found: &mut [Found], exec: &Exec) {
    let mut outlooks = vec![Outlook::default(); found.len()];
    let level = Level::new();
    let blocks = outlooks.chunks_mut(BLOCK).enumerate().collect();
    exec.for_each_with(
        blocks,
        || Fitter::new(sheets),
        |fitter, (block, outlooks): (usize, &mut [Outlook])| {
            dispatch!(level, simd => look_out(simd, fitter, noise, block * BLOCK, outlooks));
        },
    );
    average(sheets, &mut outlooks, exec);
    let blocks = found.chunks_mut(BLOCK).zip(outlooks.chunks(BLOCK)).enumerate().collect();
    exec.for_each_with(
        blocks,
        || Fitter::new(sheets),
        |fitter, (block, (found, outlooks)): (usize, (&mut [Found], &[Outlook]))| {
            dispatch!(level, simd => take_best(simd, fitter, noise, block * BLOCK, found, outlooks));
        },
    );
}

/// Bias and variance of every candidate, in a block of points that begins with `first`.
#[inline(always)]
fn look_out<S: Simd>(simd: S, fitter: &mut Fitter<'_>, noise: f64, first: usize, outlooks: &mut [Outlook]) {
    let mut solver = Solver::new(simd);
    for (start, outlooks) in (first..).step_by(LANES).zip(outlooks.chunks_mut(LANES)) {
        let mut tensors = [[[Tensor::default(); DEGREES.len()]; WIDTHS.len()]; LANES];
        for (index, width) in WIDTHS.into_iter().enumerate() {
            let reaches: [Reach; LANES] = std::array::from_fn(|lane| (start + lane.min(outlooks.len() - 1), width));
            let patches = fitter.fit::<_, 4>(simd, &mut solver, &reaches);
            for (lane, outlook) in outlooks.iter_mut().enumerate() {
                for (slot, degree) in DEGREES.into_iter().enumerate() {
                    let tensor = Tensor::of(&patches[lane], degree);
                    let bias = if index < STEP {
                        0.0
                    } else {
                        bias(&tensor, &tensors[lane][index - STEP][slot], index, degree, noise)
                    };
                    outlook.bias[index * DEGREES.len() + slot] = bias as f32;
                    outlook.variance[index * DEGREES.len() + slot] = tensor.variance as f32;
                    tensors[lane][index][slot] = tensor;
                }
            }
        }
    }
}

/// The squared bias of the wider of two estimates, as far as their difference tells.
fn bias(wide: &Tensor, narrow: &Tensor, index: usize, degree: usize, noise: f64) -> f64 {
    let shrunk = WIDTHS[index - STEP] as f64 / WIDTHS[index] as f64;
    // The bias of degrees 2 and 3 grows with the square of the radius, that of 4 with its fourth power.
    let part = if degree < 4 { 1.0 - shrunk } else { 1.0 - shrunk * shrunk };
    (wide.squared_difference(narrow) - noise * (narrow.variance - wide.variance)) / (part * part)
}

/// Averages the biases over the surroundings of every point.
fn average(sheets: &Sheets, outlooks: &mut [Outlook], exec: &Exec) {
    let mut averaged = outlooks.to_vec();
    let (mut from, mut to) = (&mut *outlooks, &mut averaged[..]);
    for _ in 0..ROUNDS {
        let source = &*from;
        let blocks = to.chunks_mut(BLOCK).collect();
        exec.for_each_quietly(blocks, |block, outlooks: &mut [Outlook]| {
            for (point, outlook) in (block * BLOCK..).zip(outlooks) {
                let around = sheets.around(point);
                let mut sum = source[point].bias;
                for &next in around {
                    for (sum, bias) in sum.iter_mut().zip(&source[next as usize].bias) {
                        *sum += bias;
                    }
                }
                outlook.bias = sum.map(|sum| sum / (around.len() + 1) as f32);
            }
        });
        std::mem::swap(&mut from, &mut to);
    }
}

/// Fits every point of a block once more, by the candidate of least expected error.
#[inline(always)]
fn take_best<S: Simd>(
    simd: S,
    fitter: &mut Fitter<'_>,
    noise: f64,
    first: usize,
    found: &mut [Found],
    outlooks: &[Outlook],
) {
    let mut solver = Solver::new(simd);
    let mut chosen: Vec<(usize, Choice)> = Vec::new();
    for (index, (found, outlook)) in found.iter().zip(outlooks).enumerate() {
        let choice = outlook.best(noise);
        if choice.error < noise * found.variance {
            chosen.push((first + index, choice));
        }
    }
    for chosen in chosen.chunks(LANES) {
        let reaches: Vec<Reach> = chosen.iter().map(|&(point, choice)| (point, choice.width)).collect();
        let patches = fitter.fit::<_, 4>(simd, &mut solver, &reaches);
        for (&(point, choice), patch) in chosen.iter().zip(&patches) {
            let shape = Shape::of(patch, choice.degree);
            let curvature: VertexCurvature = fitter.vertex(point, &patch.frame, &shape);
            found[point - first] = Found { curvature, noise: Some(noise), variance: shape.variance };
        }
    }
}

/// A candidate and its expected squared error.
#[derive(Debug, Clone, Copy)]
struct Choice {
    width: usize,
    degree: usize,
    error: f64,
}

impl Outlook {
    fn best(&self, noise: f64) -> Choice {
        let mut best = Choice { width: WIDTHS[0], degree: DEGREES[0], error: f64::INFINITY };
        for (index, width) in WIDTHS.into_iter().enumerate() {
            for (slot, degree) in DEGREES.into_iter().enumerate() {
                let candidate = index * DEGREES.len() + slot;
                let error = f64::from(self.bias[candidate].max(0.0)) + noise * f64::from(self.variance[candidate]);
                if error < best.error {
                    best = Choice { width, degree, error };
                }
            }
        }
        best
    }
}

/// A shape as a tensor in space, so that shapes in different frames can be compared.
#[derive(Debug, Clone, Copy, Default)]
struct Tensor {
    /// xx, yy, zz, xy, yz, zx.
    components: [f64; 6],
    variance: f64,
}

impl Tensor {
    /// A degree that was not determined has infinite variance.
    fn of(patch: &Patch, degree: usize) -> Self {
        if degree > patch.fits.degrees {
            return Self { components: [0.0; 6], variance: f64::INFINITY };
        }
        let shape = Shape::of(patch, degree);
        let (principal, directions, _) = shape.principal(&patch.frame);
        let mut components = [0.0; 6];
        for (curvature, along) in principal.into_iter().zip(directions) {
            let products = [
                along.x * along.x,
                along.y * along.y,
                along.z * along.z,
                along.x * along.y,
                along.y * along.z,
                along.z * along.x,
            ];
            for (component, product) in components.iter_mut().zip(products) {
                *component += curvature * product;
            }
        }
        Self { components, variance: shape.variance }
    }

    fn squared_difference(&self, other: &Self) -> f64 {
        let difference: [f64; 6] = std::array::from_fn(|index| self.components[index] - other.components[index]);
        let squares = difference.map(|difference| difference * difference);
        squares[0] + squares[1] + squares[2] + 2.0 * (squares[3] + squares[4] + squares[5])
    }
}
