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

use super::estimate::Shape;
use super::jet::{LANES, Solver};
use super::narrow::{BLOCK, Found};
use super::patch::{Fitter, Patch, Reach};
use super::sheets::Sheets;
use super::tensor::Tensor;
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
/// Neighbours of one point that have a say, at most.
const MAX_JURY: usize = 32;
/// Median deviations beyond which a point is overruled.
const OUTLYING: f64 = 3.0;
/// The error, relative to the curvature of the whole, above which noise is worth a second pass.
const NOISY: f64 = 5e-3;
/// How many times as much a jet of two degrees less may leave over, if it is noise.
const MOST_GROWTH: f64 = 2.0;

/// What a candidate is expected to be off by, lengths in [`unit_of`] the mesh: squares of curvatures of any mesh fit f32.
#[derive(Debug, Clone, Copy, Default)]
struct Outlook {
    /// Squared, by what its degree cannot follow.
    bias: [f32; CANDIDATES],
    /// Under unit noise.
    variance: [f32; CANDIDATES],
}

/// The noise of a mesh, squared, and the length in which outlooks are.
#[derive(Debug, Clone, Copy)]
struct Noise {
    squared: f64,
    unit: f64,
}

/// A power of two about as long as an edge: scaling by it rounds nothing.
fn unit_of(sheets: &Sheets) -> f64 {
    libm::exp2(libm::floor(libm::log2(sheets.report.mean_edge)))
}

/// The noise of the vertices, squared, if it shows in the curvature. What a jet leaves over may as well be shape that it cannot follow; but then
/// one of a lower degree leaves over far more.
pub(super) fn noise(found: &[Found]) -> Option<f64> {
    let residues = || found.iter().filter_map(|found| found.residue);
    let noise = median(residues().map(|residue| residue.fine))?;
    let growth = median(residues().filter(|residue| residue.fine > 0.0).map(|residue| residue.coarse / residue.fine))?;
    let variance = median(found.iter().map(|found| found.variance).filter(|variance| variance.is_finite()))?;
    let strongest = |found: &Found| found.curvature.principal[0].abs().max(found.curvature.principal[1].abs());
    let squared = median(found.iter().map(|found| strongest(found) * strongest(found)))?;
    (growth < MOST_GROWTH && noise * variance > NOISY * NOISY * squared).then_some(noise)
}

fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    let middle = values.len() / 2;
    (!values.is_empty()).then(|| *values.select_nth_unstable_by(middle, f64::total_cmp).1)
}

/// Fits every point again, as widely as the surface allows.
pub(super) fn refit(sheets: &Sheets, noise: f64, found: &mut [Found], exec: &Exec) {
    let noise = Noise { squared: noise, unit: unit_of(sheets) };
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
    silence_outliers(sheets, found, exec);
}

/// Bias and variance of every candidate, in a block of points that begins with `first`.
#[inline(always)]
fn look_out<S: Simd>(simd: S, fitter: &mut Fitter<'_>, noise: Noise, first: usize, outlooks: &mut [Outlook]) {
    let mut solver = Solver::new(simd);
    let area = noise.unit * noise.unit;
    for (start, outlooks) in (first..).step_by(LANES).zip(outlooks.chunks_mut(LANES)) {
        let mut guesses = [[[Guess::default(); DEGREES.len()]; WIDTHS.len()]; LANES];
        for (index, width) in WIDTHS.into_iter().enumerate() {
            let reaches: [Reach; LANES] = std::array::from_fn(|lane| (start + lane.min(outlooks.len() - 1), width));
            let patches = fitter.fit::<_, 4>(simd, &mut solver, &reaches);
            for (lane, outlook) in outlooks.iter_mut().enumerate() {
                for (slot, degree) in DEGREES.into_iter().enumerate() {
                    let guess = Guess::of(&patches[lane], degree);
                    let bias = if index < STEP {
                        0.0
                    } else {
                        bias(&guess, &guesses[lane][index - STEP][slot], index, degree, noise.squared)
                    };
                    outlook.bias[index * DEGREES.len() + slot] = (bias * area) as f32;
                    outlook.variance[index * DEGREES.len() + slot] = (guess.variance * area * area) as f32;
                    guesses[lane][index][slot] = guess;
                }
            }
        }
    }
}

/// The squared bias of the wider of two estimates, as far as their difference tells: 0 where one of them is not determined, so that a point
/// says nothing to its surroundings.
fn bias(wide: &Guess, narrow: &Guess, index: usize, degree: usize, noise: f64) -> f64 {
    if !(wide.variance.is_finite() && narrow.variance.is_finite()) {
        return 0.0;
    }
    let shrunk = WIDTHS[index - STEP] as f64 / WIDTHS[index] as f64;
    // The bias of degrees 2 and 3 grows with the square of the radius, that of 4 with its fourth power.
    let part = if degree < 4 { 1.0 - shrunk } else { 1.0 - shrunk * shrunk };
    (wide.tensor.squared_difference(&narrow.tensor) - noise * (narrow.variance - wide.variance)) / (part * part)
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
    noise: Noise,
    first: usize,
    found: &mut [Found],
    outlooks: &[Outlook],
) {
    let mut solver = Solver::new(simd);
    let area = noise.unit * noise.unit;
    let mut chosen: Vec<(usize, Choice)> = Vec::new();
    for (index, (found, outlook)) in found.iter().zip(outlooks).enumerate() {
        let choice = outlook.best(noise.squared / area);
        if choice.error < noise.squared * found.variance * area {
            chosen.push((first + index, choice));
        }
    }
    for chosen in chosen.chunks(LANES) {
        let reaches: Vec<Reach> = chosen.iter().map(|&(point, choice)| (point, choice.width)).collect();
        let patches = fitter.fit::<_, 4>(simd, &mut solver, &reaches);
        for (&(point, choice), patch) in chosen.iter().zip(&patches) {
            let shape = Shape::of(patch, choice.degree);
            found[point - first].curvature = fitter.vertex(point, &patch.frame, &shape);
        }
    }
}

/// Points that disagree with all around them take the median of their surroundings: two rings, as a corner has few neighbours.
fn silence_outliers(sheets: &Sheets, found: &mut [Found], exec: &Exec) {
    let tensor = |found: &Found| Tensor::of(found.curvature.principal, found.curvature.directions);
    let tensors: Vec<Tensor> = found.iter().map(tensor).collect();
    let blocks = found.chunks_mut(BLOCK).collect();
    exec.for_each_quietly(blocks, |block, found: &mut [Found]| {
        let mut jury = Vec::new();
        for (point, found) in (block * BLOCK..).zip(found) {
            jury.clear();
            for &next in sheets.around(point).iter().take(MAX_JURY) {
                jury.push(next);
                jury.extend(
                    sheets.around(next as usize).iter().take(MAX_JURY).filter(|&&other| other as usize != point),
                );
            }
            let jurors = || jury.iter().map(|&juror| &tensors[juror as usize]);
            let verdict = Tensor(std::array::from_fn(|component| {
                median(jurors().map(|tensor| tensor.0[component])).unwrap_or(0.0)
            }));
            let Some(spread) = median(jurors().map(|tensor| tensor.squared_difference(&verdict))) else {
                continue;
            };
            if tensors[point].squared_difference(&verdict) > OUTLYING * OUTLYING * spread {
                found.curvature = verdict.at(&found.curvature);
            }
        }
    });
}

/// A candidate and its expected squared error, lengths as in [`Outlook`].
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

/// What one candidate says.
#[derive(Debug, Clone, Copy, Default)]
struct Guess {
    tensor: Tensor,
    /// Under unit noise.
    variance: f64,
}

impl Guess {
    /// A degree that was not determined has infinite variance.
    fn of(patch: &Patch, degree: usize) -> Self {
        if degree > patch.fits.degrees {
            return Self { tensor: Tensor::default(), variance: f64::INFINITY };
        }
        let shape = Shape::of(patch, degree);
        let (principal, directions, _) = shape.principal(&patch.frame);
        Self { tensor: Tensor::of(principal, directions), variance: shape.variance }
    }
}
