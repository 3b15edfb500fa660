//! Pictures and numbers by the GPU, without a window, through the reader.
//!
//! A [`Gpu`] is a device of this machine, real or software. A [`ProbePass`] draws the numbers of one technique, a place a pixel, and
//! reads them back: what tests hold against the CPU twin. A [`TimedPass`] says how long the GPU takes for them. A [`Canvas`] draws
//! pictures.

mod error;
mod gpu;
mod pictures;
mod probe;
mod target;
mod timing;

pub use error::GpuError;
pub use gpu::Gpu;
pub use pictures::{Canvas, GpuPicture, GpuPixel, PictureBase, PictureLight, ReliefView, SkyDirection, TopView};
pub use probe::{Probe, ProbePass};
pub use timing::TimedPass;
