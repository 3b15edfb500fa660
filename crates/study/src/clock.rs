//! Two clocks: the wall's, and that of the processor time this program used on all its threads.
//!
//! On a machine shared with others the wall clock also counts their work; processor time does not, though caches and
//! memory are still shared.

use std::time::Instant;

/// Runs from the moment it is made.
#[derive(Debug, Clone, Copy)]
pub struct Stopwatch {
    wall: Instant,
    cpu_seconds: Option<f64>,
}

/// What a [`Stopwatch`] showed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elapsed {
    /// Seconds on the wall clock.
    pub wall_seconds: f64,
    /// Seconds of processor time over all threads of this process; `None` where the system does not say.
    pub cpu_seconds: Option<f64>,
}

impl Elapsed {
    /// The time of one core: processor time where the system says it, else the wall's.
    #[must_use]
    pub fn core_seconds(&self) -> f64 {
        self.cpu_seconds.unwrap_or(self.wall_seconds)
    }
}

impl Stopwatch {
    /// Starts both clocks.
    #[must_use]
    pub fn start() -> Self {
        Self { wall: Instant::now(), cpu_seconds: process_cpu_seconds() }
    }

    /// What has passed since the start.
    #[must_use]
    pub fn elapsed(&self) -> Elapsed {
        let cpu_seconds = process_cpu_seconds().zip(self.cpu_seconds).map(|(now, start)| now - start);
        Elapsed { wall_seconds: self.wall.elapsed().as_secs_f64(), cpu_seconds }
    }
}

#[cfg(unix)]
fn process_cpu_seconds() -> Option<f64> {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Some(time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64)
}

#[cfg(not(unix))]
fn process_cpu_seconds() -> Option<f64> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clocks_never_run_backwards() {
        let watch = Stopwatch::start();
        let (first, second) = (watch.elapsed(), watch.elapsed());
        assert!(first.wall_seconds >= 0.0 && second.wall_seconds >= first.wall_seconds);
        assert!(second.cpu_seconds >= first.cpu_seconds);
    }

    #[cfg(unix)]
    #[test]
    fn work_takes_processor_time() {
        let watch = Stopwatch::start();
        while watch.elapsed().cpu_seconds == Some(0.0) {
            std::hint::spin_loop();
        }
        assert!(watch.elapsed().cpu_seconds > Some(0.0));
    }
}
