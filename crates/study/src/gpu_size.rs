//! Bytes that the reader adds to a program.
//!
//! Two programs draw the same kind of picture by `wgpu`, without and with the reader; two others, without `wgpu`, read a file, and one
//! of them opens it, plans its upload and puts a shader together. They are examples of `barchan-wgpu`, built for size by nobody: the
//! workspace's `size` profile is the release profile, stripped. What the linker finds that a program cannot reach is not in it.

use crate::{Record, Setting};

/// The profile that programs are weighed in.
pub const PROFILE: &str = "size";

/// A program that is weighed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Program {
    /// The example of `barchan-wgpu`.
    pub example: &'static str,
    /// Whether it is built with the feature `device`.
    pub has_device: bool,
    /// What it is weighed against.
    pub against: Option<&'static str>,
}

/// All of them, each after what it is weighed against.
pub const PROGRAMS: [Program; 4] = [
    Program { example: "size_empty", has_device: false, against: None },
    Program { example: "size_plan", has_device: false, against: Some("size_empty") },
    Program { example: "size_without", has_device: true, against: None },
    Program { example: "size_with", has_device: true, against: Some("size_without") },
];

/// The record of a program of so many bytes.
#[must_use]
pub fn record(program: &Program, bytes: u64) -> Record {
    let setting = Setting::default().with("program", program.example).with("profile", PROFILE);
    Record { technique: "program".to_owned(), setting, bytes: Some(bytes), ..Record::default() }
}
