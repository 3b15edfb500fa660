//! The one list of findings. A number never changes its meaning; `formats/barchan-v1.md` prints this list.

use core::fmt;
use std::string::String;

use crate::SectionKind;

/// How bad a finding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// The file conforms, but not all of it is known or could be checked.
    Warning,
    /// The file does not conform.
    Error,
}

impl Severity {
    /// `warning` or `error`.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// Something that is wrong with a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// Its number, such as `B0301`; see [`FINDINGS`].
    pub id: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// The section it is about; `None` for the file.
    pub section: Option<SectionKind>,
    /// One sentence with the values found and what would be accepted.
    pub message: String,
}

/// `error B0301 (HORZ): message`.
impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.severity.name(), self.id)?;
        if let Some(kind) = self.section {
            write!(f, " ({kind})")?;
        }
        write!(f, ": {}", self.message)
    }
}

/// What a number stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FindingKind {
    /// The number.
    pub id: &'static str,
    /// How bad it is.
    pub severity: Severity,
    /// What it says about a file.
    pub summary: &'static str,
}

const fn error(id: &'static str, summary: &'static str) -> FindingKind {
    FindingKind { id, severity: Severity::Error, summary }
}

const fn warning(id: &'static str, summary: &'static str) -> FindingKind {
    FindingKind { id, severity: Severity::Warning, summary }
}

/// Every finding there is, by number.
pub const FINDINGS: [FindingKind; 68] = [
    error("B0101", "fewer bytes than a header"),
    error("B0102", "not the magic"),
    error("B0103", "unsupported major version"),
    error("B0104", "file_size is not the length of the file"),
    error("B0105", "section_count out of bounds"),
    error("B0106", "header CRC-32 mismatch"),
    error("B0107", "unknown required feature"),
    error("B0108", "reserved header byte not zero"),
    warning("B0109", "newer minor version"),
    warning("B0110", "unknown optional feature"),
    error("B0111", "content identity mismatch"),
    warning("B0112", "content identity could not be checked"),
    error("B0201", "section kind not four ASCII letters or digits"),
    error("B0202", "section kind occurs twice"),
    error("B0203", "unknown section flag"),
    error("B0204", "unknown critical section"),
    error("B0205", "unsupported version of a critical section"),
    error("B0206", "unsupported codec of a critical section"),
    error("B0207", "descriptor_length out of bounds"),
    error("B0208", "section offset leaves a hole or overlaps"),
    error("B0209", "section reaches beyond the file"),
    error("B0210", "raw section with two different lengths"),
    error("B0211", "section without bytes"),
    error("B0212", "reserved byte of a table row not zero"),
    error("B0213", "bytes behind the last section"),
    warning("B0214", "unknown ancillary section"),
    warning("B0215", "unsupported version of an ancillary section"),
    warning("B0216", "unsupported codec of an ancillary section"),
    error("B0301", "section CRC-32 mismatch"),
    error("B0302", "padding behind a descriptor not zero"),
    error("B0303", "padding before a section not zero"),
    error("B0304", "decoded length beyond the caller's limit"),
    error("B0305", "zstd frame cannot be decoded, or its window is too large"),
    error("B0306", "decoded length is not raw_length"),
    error("B0307", "bytes behind the zstd frame"),
    error("B0401", "texture descriptor not 256 bytes"),
    error("B0402", "reserved descriptor byte not zero"),
    error("B0403", "descriptor number that stands for nothing or does not fit"),
    error("B0404", "extent out of bounds"),
    error("B0405", "real number out of bounds"),
    error("B0406", "semantic does not match the section kind"),
    error("B0407", "payload length does not follow from the extent"),
    error("B0408", "format with another number of channels than the semantic"),
    error("B0409", "transfer that does not fit the semantic"),
    error("B0410", "azimuths neither a full circle nor an arc"),
    error("B0411", "candidates that do not fit the layers or the semantic"),
    error("B0412", "curvature descriptor of another length than its columns ask for"),
    error("B0413", "curvature column out of order, or missing"),
    error("B0414", "rings that do not divide the layers"),
    error("B0501", "value not finite"),
    error("B0502", "value outside the stated range"),
    error("B0503", "stated range not reached by the values"),
    error("B0504", "padding between layers, columns or vectors not zero"),
    error("B0505", "stored number outside the domain of its transfer"),
    error("B0506", "direction that is not of unit length"),
    error("B0507", "first principal curvature below the second"),
    error("B0508", "principal directions that are not at right angles"),
    error("B0509", "first fundamental form that is not positive"),
    error("B0510", "unknown remark on a vertex"),
    error("B0511", "curvature of a vertex where none can be known"),
    error("B0512", "depth of a cone map outside 0 to 1"),
    error("B0513", "maximum below one that it stands for"),
    error("B0601", "provenance not UTF-8"),
    error("B0602", "provenance with a descriptor"),
    error("B0701", "swept table that does not lie as its companion does"),
    warning("B0702", "swept table without its companion"),
    error("B0703", "relief table that does not lie over the heights"),
    warning("B0704", "relief table without the heights"),
];

/// The severity of the finding with that number.
pub(super) fn severity(id: &str) -> Severity {
    FINDINGS.iter().find(|kind| kind.id == id).map_or(Severity::Error, |kind| kind.severity)
}
