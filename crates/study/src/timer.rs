//! A fair timer.
//!
//! # How contestants are kept on an equal footing
//!
//! - **Interleaved**: A B C A B C, never A A B B C C, so that a machine that grows warm or busy does so for all of them.
//! - **Warm**: a first round touches the memory and the caches and says how long a round takes. It counts only where it
//!   takes longer than all the time there is: nothing that happens once matters in so long a round.
//! - **Median and spread**: of the rounds the median counts, beside it the minimum, which is what the machine can do, and
//!   the median absolute deviation, which is how much to believe it.
//! - **Two clocks**: processor time of all threads, and the wall's ([`Stopwatch`]).
//! - Results are handed back before the clock stops and dropped after it, so that freeing memory is nobody's work.
//!
//! How many threads work is the contestant's own matter: one core means that it runs one.

use std::hint::black_box;

use crate::runner::{Observer, Step};
use crate::{Elapsed, Stopwatch, StudyError};

/// Something that can be timed. What it returns is dropped off the clock.
pub struct Contestant<'a, T> {
    /// What it is called while it runs.
    pub name: String,
    /// The work: the same each time.
    pub work: Box<dyn FnMut() -> Result<T, StudyError> + 'a>,
}

/// How long contestants are timed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pace {
    /// About how many seconds to spend after the warm-up; at least one round is run.
    pub seconds: f64,
    /// The most rounds after the warm-up.
    pub max_rounds: usize,
}

/// What one contestant took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Timing {
    /// Rounds counted.
    pub rounds: usize,
    /// On the wall clock.
    pub wall: Spread,
    /// In processor time over all threads; `None` where the system does not say.
    pub cpu: Option<Spread>,
}

/// Several measurements of the same thing, in seconds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Half took no longer.
    pub median: f64,
    /// The shortest.
    pub minimum: f64,
    /// The median distance from the median.
    pub deviation: f64,
}

impl Spread {
    /// # Panics
    /// If there is nothing to take the median of.
    #[must_use]
    pub fn of(seconds: &[f64]) -> Self {
        let middle = median(seconds);
        let distances: Vec<f64> = seconds.iter().map(|s| (s - middle).abs()).collect();
        let minimum = seconds.iter().copied().fold(f64::INFINITY, f64::min);
        Self { median: middle, minimum, deviation: median(&distances) }
    }
}

/// The middle one, or the mean of the two in the middle.
fn median(numbers: &[f64]) -> f64 {
    assert!(!numbers.is_empty(), "the median of nothing");
    let mut sorted = numbers.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let half = sorted.len() / 2;
    if sorted.len() % 2 == 1 { sorted[half] } else { 0.5 * (sorted[half - 1] + sorted[half]) }
}

impl Pace {
    /// How many rounds are run after the warm-up when one takes `round_seconds`.
    #[must_use]
    pub fn rounds(&self, round_seconds: f64) -> usize {
        // A cast from a float saturates: a round that took no time at all gives the most.
        ((self.seconds / round_seconds) as usize).clamp(1, self.max_rounds.max(1))
    }
}

/// Times contestants against each other; timings come in their order.
///
/// # Errors
/// The first error of a contestant ends the race.
pub fn race<T>(
    contestants: &mut [Contestant<'_, T>],
    pace: &Pace,
    observe: &mut Observer<'_>,
) -> Result<Vec<Timing>, StudyError> {
    let warm_up = round(contestants, &mut |_| ())?;
    let round_seconds = warm_up.iter().map(|elapsed| elapsed.wall_seconds).sum();
    let rounds = pace.rounds(round_seconds);
    let total = rounds * contestants.len();
    let kept = |elapsed| if round_seconds > pace.seconds { vec![elapsed] } else { Vec::new() };
    let mut laps: Vec<Vec<Elapsed>> = warm_up.into_iter().map(kept).collect();
    let mut done = 0;
    for _ in 0..rounds {
        let elapsed = round(contestants, &mut |name| {
            observe(&Step { done, total, what: name });
            done += 1;
        })?;
        laps.iter_mut().zip(elapsed).for_each(|(laps, elapsed)| laps.push(elapsed));
    }
    Ok(laps.iter().map(|laps| timing(laps)).collect())
}

fn round<T>(contestants: &mut [Contestant<'_, T>], announce: &mut dyn FnMut(&str)) -> Result<Vec<Elapsed>, StudyError> {
    let lap = |contestant: &mut Contestant<'_, T>| {
        announce(&contestant.name);
        let watch = Stopwatch::start();
        let result = black_box((contestant.work)()?);
        let elapsed = watch.elapsed();
        drop(result);
        Ok(elapsed)
    };
    contestants.iter_mut().map(lap).collect()
}

fn timing(laps: &[Elapsed]) -> Timing {
    let wall: Vec<f64> = laps.iter().map(|lap| lap.wall_seconds).collect();
    let cpu: Option<Vec<f64>> = laps.iter().map(|lap| lap.cpu_seconds).collect();
    Timing { rounds: laps.len(), wall: Spread::of(&wall), cpu: cpu.map(|cpu| Spread::of(&cpu)) }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use super::*;

    #[test]
    fn median_minimum_and_deviation_of_known_times() {
        assert_eq!(Spread::of(&[5.0, 1.0, 2.0]), Spread { median: 2.0, minimum: 1.0, deviation: 1.0 });
        assert_eq!(Spread::of(&[4.0, 1.0, 2.0, 3.0]), Spread { median: 2.5, minimum: 1.0, deviation: 1.0 });
        assert_eq!(Spread::of(&[7.0]), Spread { median: 7.0, minimum: 7.0, deviation: 0.0 });
    }

    #[test]
    fn one_disturbed_round_moves_neither_median_nor_deviation_far() {
        let spread = Spread::of(&[1.0, 1.1, 0.9, 1.0, 100.0]);
        assert!((spread.median, spread.minimum) == (1.0, 0.9) && spread.deviation <= 0.1 + 1e-12);
    }

    #[test]
    fn rounds_fill_the_time_but_there_is_at_least_one() {
        let pace = Pace { seconds: 10.0, max_rounds: 5 };
        assert_eq!([0.0, 1.0, 2.5, 9.0, 1000.0].map(|round| pace.rounds(round)), [5, 5, 4, 1, 1]);
    }

    #[test]
    fn contestants_take_turns_after_a_warm_up() {
        let order = RefCell::new(String::new());
        let contestant = |name: &'static str| Contestant {
            name: name.to_owned(),
            work: Box::new(|| {
                order.borrow_mut().push_str(name);
                Ok(())
            }),
        };
        let mut seen = String::new();
        let pace = Pace { seconds: 1e9, max_rounds: 2 };
        let timings = race(&mut [contestant("a"), contestant("b"), contestant("c")], &pace, &mut |step| {
            seen.push_str(&format!("{}{}/{} ", step.what, step.done, step.total));
        })
        .unwrap();
        assert_eq!(order.into_inner(), "abcabcabc");
        assert_eq!(seen, "a0/6 b1/6 c2/6 a3/6 b4/6 c5/6 ");
        assert!(timings.iter().all(|timing| timing.rounds == 2 && timing.wall.minimum <= timing.wall.median));
    }

    #[test]
    fn a_warm_up_longer_than_there_is_time_counts() {
        let mut contestants = [Contestant { name: String::new(), work: Box::new(|| Ok(())) }];
        let timings = race(&mut contestants, &Pace { seconds: -1.0, max_rounds: 9 }, &mut |_| ()).unwrap();
        assert_eq!(timings[0].rounds, 2);
    }

    #[test]
    fn a_contestant_that_fails_ends_the_race() {
        let fail = || Err(StudyError::Markers { name: "x".to_owned() });
        let mut contestants = [Contestant::<()> { name: String::new(), work: Box::new(fail) }];
        assert!(race(&mut contestants, &Pace { seconds: 1.0, max_rounds: 1 }, &mut |_| ()).is_err());
    }
}
