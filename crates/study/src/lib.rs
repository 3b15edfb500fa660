//! Error against run time: how far a technique is from the truth, what a texel or pixel costs, and what it weighs.
//!
//! # Theory
//!
//! No setting is chosen by feel. A [`Record`] is one technique at one setting on one scene: its error against a slow,
//! exact twin, its time, its bytes. A study is a list of records, and a table in the docs is a view of such a list, so
//! that no figure in the docs can be older than its measurement.
//!
//! What is measured, in the order of trust it deserves:
//!
//! - **error** is the same on every machine, and a change of it is a change of the code;
//! - **bytes** likewise;
//! - **time** belongs to a machine, which is therefore named ([`Machine`]), and to what else ran on it: [`timer`] says how
//!   contestants are kept on an equal footing. How fast it could have been is the machine's memory [`bandwidth`].
//!
//! # Conventions
//!
//! Nothing here prints, and nothing but [`Machine::this`] opens a file: fields come in, records and text go out. The
//! program behind `cargo xtask bench` is the example `study`. A technique is studied in a file of its own, named after
//! it: [`horizon_speed`], [`horizon_accuracy`], [`horizon_shadow`], [`horizon_curvature`] of height fields,
//! [`curved_effect`], [`curved_shadow`] of relief on curved surfaces, [`curvature_accuracy`], [`curvature_speed`],
//! [`curvature_interpolation`] of meshes, [`hemisphere_paper`], [`relief_search`], [`relief_start`],
//! [`hemisphere_occlusion`], [`hemisphere_speed`] of relief mapping, [`gpu_time`], [`gpu_upload`], [`gpu_size`] of the reader on a
//! GPU; how its records read in the docs is in [`report`], and as pictures in [`chart`].

pub mod bandwidth;
pub mod chart;
mod clock;
mod csv;
pub mod curvature_accuracy;
pub mod curvature_interpolation;
pub mod curvature_speed;
pub mod curved_effect;
pub mod curved_pictures;
pub mod curved_shadow;
mod error;
mod figure_tables;
pub mod figures;
mod gpu_cases;
mod gpu_device;
mod gpu_files;
pub mod gpu_size;
pub mod gpu_time;
pub mod gpu_upload;
pub mod hemisphere_occlusion;
pub mod hemisphere_paper;
pub mod hemisphere_spec;
pub mod hemisphere_speed;
pub mod horizon_accuracy;
pub mod horizon_curvature;
mod horizon_point;
pub mod horizon_shadow;
pub mod horizon_speed;
mod machine;
pub mod markdown;
mod occlusion_forms;
mod points;
mod reading;
mod record;
pub mod relief_method;
mod relief_point;
pub mod relief_rays;
pub mod relief_search;
mod relief_seeker;
mod relief_shadow;
pub mod relief_start;
mod relief_tables;
pub mod reliefs;
pub mod report;
mod runner;
mod sample;
pub mod scenes;
mod setting;
mod start_faults;
mod tables;
pub mod timer;
pub mod triangle_forms;

pub use clock::{Elapsed, Stopwatch};
pub use csv::RecordFile;
pub use error::StudyError;
pub use machine::Machine;
pub use record::{Item, Norms, Quantity, Record};
pub use runner::{Observer, Step, Study, run};
pub use scenes::Scene;
pub use setting::Setting;

/// How much of a study is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// What the docs quote: minutes.
    Full,
    /// Whether it runs at all: seconds, and no figure worth quoting.
    Quick,
}
