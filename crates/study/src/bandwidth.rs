//! What the machine's memory can carry: the bound of a baker that does nothing but read heights and write tables.
//!
//! After John McCalpin, *Memory Bandwidth and Machine Balance in Current High Performance Computers*, 1995 (STREAM): *copy*
//! is a = b, two transfers an element, *triad* is a = b + s·c, three. Arrays lie far beyond the caches. Bytes are counted
//! as STREAM counts them, as the program asks for them: that a store may first fetch its cache line is left out, there
//! as in our own minimum.

use std::hint::black_box;
use std::time::Instant;

use crate::{Item, Record, Setting};

/// Elements of each of the three arrays in a full measurement: 128 MiB each.
pub const ELEMENTS: usize = 32 << 20;

/// Memory traffic measured, in bytes per nanosecond (GB/s): the best of several rounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bandwidth {
    /// Threads at work.
    pub threads: usize,
    /// Of a = b.
    pub copy: f64,
    /// Of a = b + s·c.
    pub triad: f64,
}

impl Bandwidth {
    /// Measures with `threads` threads on arrays of `elements` f32, `rounds` times.
    #[must_use]
    pub fn measure(threads: usize, elements: usize, rounds: usize) -> Self {
        let threads = threads.max(1);
        let (mut a, b, c) = (vec![0.0; elements], vec![1.0; elements], vec![2.0; elements]);
        let mut best = Self { threads, copy: 0.0, triad: 0.0 };
        for _ in 0..rounds.max(1) {
            let copy = seconds(threads, &mut a, &b, &c, |a, b, _| a.copy_from_slice(b));
            let triad = seconds(threads, &mut a, &b, &c, triad);
            let rate = |transfers: usize, seconds: f64| 1e-9 * (4 * transfers * elements) as f64 / seconds;
            best.copy = best.copy.max(rate(2, copy));
            best.triad = best.triad.max(rate(3, triad));
        }
        best
    }

    /// The better of the two.
    #[must_use]
    pub fn best(&self) -> f64 {
        self.copy.max(self.triad)
    }

    /// Copy and triad as records: nanoseconds per byte on the wall clock.
    #[must_use]
    pub fn records(&self) -> Vec<Record> {
        let record = |kernel: &str, rate: f64| Record {
            technique: "memory".to_owned(),
            setting: Setting::default().with("kernel", kernel).with("threads", self.threads),
            per: Some(Item::Byte),
            wall_ns_min: Some(1.0 / rate),
            ..Record::default()
        };
        vec![record("copy", self.copy), record("triad", self.triad)]
    }
}

fn triad(a: &mut [f32], b: &[f32], c: &[f32]) {
    let scale = black_box(3.0);
    for ((a, b), c) in a.iter_mut().zip(b).zip(c) {
        *a = b + scale * c;
    }
}

/// The wall-clock time of a kernel over the arrays, cut into one piece per thread.
fn seconds(threads: usize, a: &mut [f32], b: &[f32], c: &[f32], kernel: fn(&mut [f32], &[f32], &[f32])) -> f64 {
    let piece = a.len().div_ceil(threads).max(1);
    let start = Instant::now();
    // Threads are started on the clock; that costs some 1e-4 s of the 1e-2 s measured.
    std::thread::scope(|scope| {
        for ((a, b), c) in a.chunks_mut(piece).zip(b.chunks(piece)).zip(c.chunks(piece)) {
            scope.spawn(move || kernel(black_box(a), b, c));
        }
    });
    start.elapsed().as_secs_f64()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measured_bandwidth_is_positive_and_finite() {
        for threads in [1, 2, 3] {
            let bandwidth = Bandwidth::measure(threads, 1 << 16, 2);
            assert!(bandwidth.copy > 0.0 && bandwidth.triad > 0.0 && bandwidth.best().is_finite(), "{bandwidth:?}");
        }
    }

    #[test]
    fn the_kernels_do_what_stream_says() {
        let (mut a, b, c) = (vec![0.0; 5], vec![1.0; 5], vec![2.0; 5]);
        let _ = seconds(2, &mut a, &b, &c, triad);
        assert_eq!(a, [7.0; 5]);
    }

    #[test]
    fn a_record_holds_the_time_of_a_byte() {
        let records = Bandwidth { threads: 2, copy: 8.0, triad: 10.0 }.records();
        assert_eq!(records[0].setting.to_string(), "kernel=copy threads=2");
        assert_eq!((records[0].wall_ns_min, records[1].wall_ns_min), (Some(0.125), Some(0.1)));
    }
}
