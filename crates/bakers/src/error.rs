use thiserror::Error;

/// Why a baker refuses its parameters or its field.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum BakeError {
    /// A parameter is outside its range.
    #[error("{name} is {value}; {accepted}")]
    Parameter {
        /// The parameter, as recipes spell it.
        name: &'static str,
        /// The value given.
        value: String,
        /// What would be accepted.
        accepted: &'static str,
    },
    /// The field cannot have this table.
    #[error("the height map is {width} × {height} texels; {needed}")]
    Field {
        /// Texels along u.
        width: u32,
        /// Texels along v.
        height: u32,
        /// What would be accepted.
        needed: &'static str,
    },
    /// The table would not fit.
    #[error("{what} needs {bytes} bytes; at most {limit} are allowed")]
    TooLarge {
        /// The table.
        what: &'static str,
        /// What it would take in memory.
        bytes: u64,
        /// The bound.
        limit: u64,
    },
    /// The system refused the memory.
    #[error("{what} needs {bytes} bytes, which the system refuses; fewer texels or directions would be accepted")]
    Memory {
        /// The table.
        what: &'static str,
        /// What it would take.
        bytes: u64,
    },
    /// The threads could not be started.
    #[error("{threads} worker threads could not be started: {reason}")]
    Threads {
        /// Threads asked for; 0 means one per core.
        threads: usize,
        /// What the system said.
        reason: String,
    },
}
