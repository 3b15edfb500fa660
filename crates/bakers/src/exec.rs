//! How work runs: the one place that knows of threads. Nothing here may change a bit of what a baker returns.

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;

use crate::BakeError;

/// A pool of worker threads and somewhere to report progress to.
pub struct Exec<'a> {
    pool: rayon::ThreadPool,
    on_progress: Option<&'a (dyn Fn(usize, usize) + Sync)>,
}

impl<'a> Exec<'a> {
    /// `threads` workers; 0 takes one per core that this process may use.
    pub fn new(threads: usize) -> Result<Self, BakeError> {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|error| BakeError::Threads { threads, reason: error.to_string() })?;
        Ok(Self { pool, on_progress: None })
    }

    /// Calls `report(done, total)` after each finished piece of work, from whichever thread finished it.
    #[must_use]
    pub fn with_progress(mut self, report: &'a (dyn Fn(usize, usize) + Sync)) -> Self {
        self.on_progress = Some(report);
        self
    }

    /// Worker threads in the pool.
    #[must_use]
    pub fn threads(&self) -> usize {
        self.pool.current_num_threads()
    }

    /// Runs `work(index, piece)` once for every piece. Each piece owns its output, so the order cannot matter.
    pub(crate) fn for_each<T: Send>(&self, pieces: Vec<T>, work: impl Fn(usize, T) + Sync) {
        let indexed = pieces.into_iter().enumerate().collect();
        self.for_each_with(indexed, || (), |(), (index, piece)| work(index, piece));
    }

    /// Runs `work(buffers, piece)` once for every piece, with buffers that a thread keeps from piece to piece.
    pub(crate) fn for_each_with<T: Send, B>(
        &self,
        pieces: Vec<T>,
        buffers: impl Fn() -> B + Sync + Send,
        work: impl Fn(&mut B, T) + Sync + Send,
    ) {
        let total = pieces.len();
        let done = AtomicUsize::new(0);
        self.spread(pieces, buffers, |buffers, piece| {
            work(buffers, piece);
            let finished = done.fetch_add(1, Ordering::Relaxed) + 1;
            if let Some(report) = self.on_progress {
                report(finished, total);
            }
        });
    }

    /// [`Exec::for_each`] without progress: for work that is itself a small part of what is being reported.
    pub(crate) fn for_each_quietly<T: Send>(&self, pieces: Vec<T>, work: impl Fn(usize, T) + Sync) {
        let indexed = pieces.into_iter().enumerate().collect();
        self.spread(indexed, || (), |(), (index, piece)| work(index, piece));
    }

    /// Sorts items of which no two are equal, so that there is only one order.
    pub(crate) fn sort_distinct<T: Ord + Send>(&self, items: &mut [T]) {
        self.pool.install(|| items.par_sort_unstable());
    }

    fn spread<T: Send, B>(
        &self,
        pieces: Vec<T>,
        buffers: impl Fn() -> B + Sync + Send,
        work: impl Fn(&mut B, T) + Sync + Send,
    ) {
        self.pool.install(|| {
            // One piece at a time: pieces are few and large, and stealing half of them would leave a thread idle.
            pieces.into_par_iter().with_max_len(1).for_each_init(buffers, |buffers, piece| work(buffers, piece));
        });
    }
}
