//! How long the GPU takes to draw a probe, by its own clock.
//!
//! # What is timed
//!
//! A timestamp before the render pass and one after it; neither what is submitted and waited for, nor what is copied back, is between
//! them. The pass clears a target of four 32-bit floats a pixel and draws one triangle over it.
//!
//! Clocks of GPUs tick in steps (some in microseconds), and GPUs that have rested take a while to run at full speed: a size that takes
//! milliseconds, drawn again and again, is what to trust.

use crate::probe::{FORMAT, ProbePass};
use crate::target::Target;
use crate::{Gpu, GpuError, Probe};

/// A pass whose probes are drawn for their time alone: the target stays on the GPU.
#[derive(Debug)]
pub struct TimedPass<'a> {
    pass: &'a ProbePass<'a>,
    size: (u32, u32),
    target: Target,
    /// None where the adapter has no timestamps.
    clock: Option<Clock>,
}

/// Two timestamps, and the way they come back.
#[derive(Debug)]
struct Clock {
    set: wgpu::QuerySet,
    resolved: wgpu::Buffer,
    read_back: wgpu::Buffer,
    /// Of a tick.
    seconds: f64,
}

/// Bytes of two timestamps.
const TIMESTAMPS: u64 = 2 * wgpu::QUERY_SIZE as u64;

impl<'a> TimedPass<'a> {
    /// A target of `size` pixels across and down for the probes of a pass.
    ///
    /// # Errors
    /// A device that refuses.
    pub fn new(pass: &'a ProbePass<'a>, size: (u32, u32)) -> Result<Self, GpuError> {
        let gpu = pass.gpu();
        let (target, clock) = gpu.checked(|device| (Target::new(device, FORMAT, size), Clock::new(gpu)))?;
        Ok(Self { pass, size, target, clock })
    }

    /// Draws, waits until it is done, and says how many seconds the GPU was at it; `None` where it has no clock, or one that ran
    /// backwards. The size of the probe is that of the target, whatever it says itself.
    ///
    /// # Errors
    /// A device that refuses or is lost.
    pub fn draw(&self, probe: &Probe) -> Result<Option<f64>, GpuError> {
        let gpu = self.pass.gpu();
        self.pass.set(&Probe { size: self.size, ..*probe });
        gpu.checked(|device| {
            let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            self.pass.encode(&mut encoder, &self.target, self.clock.as_ref().map(Clock::writes));
            if let Some(clock) = &self.clock {
                encoder.resolve_query_set(&clock.set, 0..2, &clock.resolved, 0);
                encoder.copy_buffer_to_buffer(&clock.resolved, 0, &clock.read_back, 0, TIMESTAMPS);
            }
            gpu.queue.submit([encoder.finish()]);
        })?;
        match &self.clock {
            Some(clock) => clock.read(gpu),
            None => gpu.finish().map(|()| None),
        }
    }
}

impl Clock {
    fn new(gpu: &Gpu) -> Option<Self> {
        if !gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY) {
            return None;
        }
        let buffer = |usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("timestamps"),
                size: TIMESTAMPS,
                usage,
                mapped_at_creation: false,
            })
        };
        Some(Self {
            set: gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("timestamps"),
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            }),
            resolved: buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC),
            read_back: buffer(wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ),
            seconds: 1e-9 * f64::from(gpu.queue.get_timestamp_period()),
        })
    }

    fn writes(&self) -> wgpu::RenderPassTimestampWrites<'_> {
        wgpu::RenderPassTimestampWrites {
            query_set: &self.set,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        }
    }

    fn read(&self, gpu: &Gpu) -> Result<Option<f64>, GpuError> {
        let bytes = gpu.read(&self.read_back)?;
        let ticks = |at: usize| {
            let word = bytes.get(at..at + 8)?;
            Some(u64::from_le_bytes(word.try_into().ok()?))
        };
        let passed = ticks(0).zip(ticks(8)).and_then(|(start, end)| end.checked_sub(start));
        Ok(passed.filter(|ticks| *ticks > 0).map(|ticks| ticks as f64 * self.seconds))
    }
}
