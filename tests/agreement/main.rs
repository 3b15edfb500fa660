//! The same bytes, the same places, the same lights: what shaders find on the GPU against the CPU twin in `barchan-shade`.
//!
//! Each test states how far the two may be apart, and why. One that fails leaves what was found, what was expected and the
//! difference as pictures in `target/agreement/`. A machine without a GPU, not even a software one, fails every test; the message
//! names what installs one.

mod band;
mod compare;
mod curved;
mod functions;
mod horizon;
mod penumbra;
mod pictures;
mod relief;
mod sky;
mod support;
mod texels;
