//! Why a file did not become a height field or a mesh. Each message is one sentence.

use std::{fmt, io, path::PathBuf};

use barchan_field::FieldError;
use thiserror::Error;

use crate::{Format, MeshError, detect::ALL};

/// Why a file on disk did not become a height field or a mesh; the message begins with its path.
#[derive(Debug, Error)]
pub enum ImportError {
    /// The file could not be read. The `cause` is part of the message.
    #[error("{}", io_message(.path, .cause))]
    Io {
        /// The path as given.
        path: PathBuf,
        /// What the operating system said.
        cause: io::Error,
    },
    /// The file was read, but its content is not usable. The `cause` is part of the message.
    #[error("{}: {cause}", .path.display())]
    Content {
        /// The path as given.
        path: PathBuf,
        /// What is wrong with it.
        cause: DecodeError,
    },
}

impl ImportError {
    /// Whether the disk is to blame, and not what is on it.
    #[must_use]
    pub fn is_io(&self) -> bool {
        matches!(self, Self::Io { .. })
    }
}

fn io_message(path: &std::path::Path, cause: &io::Error) -> String {
    let path = path.display();
    match cause.kind() {
        io::ErrorKind::NotFound => format!("{path}: there is no such file; {ALL} is needed"),
        io::ErrorKind::IsADirectory => format!("{path}: this is a folder; {ALL} is needed"),
        _ => format!("{path}: the file cannot be read ({cause})"),
    }
}

/// Why bytes did not become a height field or a mesh. Columns and rows count from 0 at the top left.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum DecodeError {
    /// There are no bytes.
    #[error("the file is empty; {needed} is needed")]
    EmptyFile {
        /// The kinds of file that would do.
        needed: &'static str,
    },
    /// The first bytes belong to none of the formats.
    #[error("the file is {found}; {needed} is needed")]
    UnknownFormat {
        /// What it seems to be.
        found: String,
        /// The kinds of file that would do.
        needed: &'static str,
    },
    /// The bytes contradict themselves or end too early.
    #[error("the {format} file is damaged: {reason}")]
    Damaged {
        /// What the file claims to be.
        format: Format,
        /// The contradiction.
        reason: String,
    },
    /// The file may be sound, but it is of a variety that is not read.
    #[error("the {format} file has {found}; {accepted} would be accepted")]
    Unsupported {
        /// The format.
        format: Format,
        /// What was found.
        found: String,
        /// What could stand in its place.
        accepted: &'static str,
    },
    /// A side is zero or beyond u32.
    #[error("the {format} image is {width} × {height} texels; both sides must be from 1 to 4294967295")]
    Extent {
        /// The format.
        format: Format,
        /// Texels along u.
        width: u64,
        /// Texels along v.
        height: u64,
    },
    /// More texels than the caller accepts.
    #[error("the {format} image has {width} × {height} texels; `max_texels` accepts {max}")]
    TooManyTexels {
        /// The format.
        format: Format,
        /// Texels along u.
        width: u64,
        /// Texels along v.
        height: u64,
        /// [`HeightMapOptions::max_texels`](crate::HeightMapOptions::max_texels).
        max: u64,
    },
    /// The header promises more than any compression could have packed into the file.
    #[error(
        "the {format} header promises {width} × {height} texels, {promised} bytes of samples; a file of {file} bytes can hold {possible} at most"
    )]
    Implausible {
        /// The format.
        format: Format,
        /// Texels along u.
        width: u64,
        /// Texels along v.
        height: u64,
        /// Bytes of all samples, uncompressed.
        promised: u128,
        /// Bytes of the file.
        file: u64,
        /// Bytes of samples accepted from such a file.
        possible: u128,
    },
    /// The system did not grant the memory.
    #[error("reading it needs a block of {bytes} bytes of memory, which the system refuses; a smaller file is needed")]
    Memory {
        /// Bytes asked for.
        bytes: u128,
    },
    /// The channel asked for is not there.
    #[error("`channel` is `{wanted}`, which the {format} file does not have; {present} would be accepted")]
    NoSuchChannel {
        /// The format.
        format: Format,
        /// The channel asked for.
        wanted: String,
        /// The channels there are.
        present: String,
    },
    /// No channel was asked for, and none stands out.
    #[error("the {format} file does not say which channel is the height; name `channel` as one of {present}")]
    WhichChannel {
        /// The format.
        format: Format,
        /// The channels there are.
        present: String,
    },
    /// No channel was asked for, and the picture is in colour.
    #[error(
        "the {format} image is in colour: at column {column}, row {row}, R, G and B are {}, {} and {}; name the `channel` that is the height",
        number(rgb[0]),
        number(rgb[1]),
        number(rgb[2])
    )]
    Colour {
        /// The format.
        format: Format,
        /// Column of the first texel that is not grey, in row order.
        column: u32,
        /// Its row.
        row: u32,
        /// Its raw samples.
        rgb: [f64; 3],
    },
    /// There are texels without a height, and no rule to fill them.
    #[error(
        "the sample at column {column}, row {row} is {}{} ({count} of {total} texels have no height); `fill` as value(HEIGHT), lowest or nearest would accept it",
        number(*.value),
        if value.is_finite() { ", which stands for no data" } else { "" }
    )]
    NoHeight {
        /// Column of the first such texel, in row order.
        column: u32,
        /// Its row.
        row: u32,
        /// Its raw sample.
        value: f64,
        /// How many texels have no height.
        count: u64,
        /// Texels in all.
        total: u64,
    },
    /// Not one texel has a height.
    #[error("none of the {total} texels has a height (the first sample is {}); at least one is needed", number(*.value))]
    AllInvalid {
        /// The first raw sample.
        value: f64,
        /// Texels in all.
        total: u64,
    },
    /// A finite sample became a height beyond f32.
    #[error(
        "the sample at column {column}, row {row} is {}, which makes a height of {}; heights up to {} would be accepted",
        number(*.value),
        number(*.scaled),
        number(f32::MAX.into())
    )]
    Overflow {
        /// Column of the first such texel, in row order.
        column: u32,
        /// Its row.
        row: u32,
        /// Its raw sample.
        value: f64,
        /// The height in f64.
        scaled: f64,
    },
    /// An option makes no sense, whatever the file.
    #[error("`{field}` is {}; {accepted} is needed", number(*.value))]
    Option {
        /// The name of the option.
        field: &'static str,
        /// Its value.
        value: f64,
        /// What would be accepted.
        accepted: &'static str,
    },
    /// What only a mesh can have wrong.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The field refused the heights, or the mesh its vertices.
    #[error(transparent)]
    Field(#[from] FieldError),
}

impl DecodeError {
    /// `reason` may be a library's message: it is made one sentence without a full stop.
    pub(crate) fn damaged(format: Format, reason: &dyn fmt::Display) -> Self {
        let reason = reason.to_string();
        let words: Vec<&str> = reason.split_whitespace().collect();
        Self::Damaged { format, reason: words.join(" ").trim_end_matches('.').to_owned() }
    }
}

/// Short for people: no forty-digit integers.
pub(crate) fn number(value: f64) -> String {
    let size = value.abs();
    if value.is_finite() && size != 0.0 && !(1e-4..1e15).contains(&size) {
        format!("{value:e}")
    } else {
        value.to_string()
    }
}
