//! Everything that can be wrong with a file, as numbered findings.

mod companions;
mod curvature;
mod findings;
mod maxima;
mod values;

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

pub use findings::{FINDINGS, Finding, FindingKind, Severity};

use crate::asset::table_end;
use crate::bytes::first_nonzero;
use crate::write::IdentityHasher;
use crate::{Asset, Limits, MINOR, Section, SectionKind};

/// Checks everything the format asks of a file: structure, checksums, padding, identity, descriptors, decoded lengths
/// and values. An empty list means that nothing is wrong.
///
/// Reads every byte and decodes every payload, one at a time, within `limits`. A file that cannot be opened has one
/// finding: nothing behind a broken structure can be trusted.
#[must_use]
pub fn validate(bytes: &[u8], limits: &Limits) -> Vec<Finding> {
    let mut report = Report::default();
    match Asset::open(bytes) {
        Ok(asset) => report.asset(&asset, limits),
        Err(error) => report.add(error.id(), None, error.to_string()),
    }
    report.findings
}

#[derive(Default)]
struct Report {
    findings: Vec<Finding>,
    identity: IdentityHasher,
    /// The first section that could not be decoded: without it there is no identity.
    undecoded: Option<SectionKind>,
}

impl Report {
    fn add(&mut self, id: &'static str, section: Option<SectionKind>, message: String) {
        self.findings.push(Finding { id, severity: findings::severity(id), section, message });
    }

    fn asset(&mut self, asset: &Asset<'_>, limits: &Limits) {
        self.versions(asset);
        let mut end = table_end(asset.sections().len() as u32);
        for section in asset.sections() {
            self.gap(asset.bytes(), end, &section);
            self.section(&section, limits);
            end = section.end();
        }
        companions::check(asset, |id, kind, message| self.add(id, Some(kind), message));
        self.identity(asset);
    }

    fn versions(&mut self, asset: &Asset<'_>) {
        let (major, minor) = asset.version();
        if minor > MINOR {
            self.add("B0109", None, format!("the file has version {major}.{minor}; this reader knows {major}.{MINOR}"));
        }
        let bits = asset.optional_features();
        if bits != 0 {
            self.add("B0110", None, format!("optional features {bits:#018x} are not known and were ignored"));
        }
    }

    /// The padding from `end` of what comes before to the start of `section`.
    fn gap(&mut self, file: &[u8], end: u64, section: &Section<'_>) {
        let gap = &file[end as usize..section.offset() as usize];
        if let Some(at) = first_nonzero(gap) {
            let at = end + at as u64;
            self.add("B0303", Some(section.kind()), format!("the padding byte at {at} before the section is not zero"));
        }
    }

    fn section(&mut self, section: &Section<'_>, limits: &Limits) {
        let kind = Some(section.kind());
        if !section.is_intact() {
            let stated = section.crc32();
            self.add("B0301", kind, format!("the section is damaged: its bytes do not have CRC-32 {stated:#010x}"));
        }
        if let Some(at) = first_nonzero(section.descriptor_padding()) {
            let at = section.descriptor_bytes().len() + at;
            self.add("B0302", kind, format!("the padding byte at {at} behind the descriptor is not zero"));
        }
        let payload = match section.payload(limits) {
            Ok(payload) => payload,
            Err(error) => {
                self.undecoded = self.undecoded.or(kind);
                return self.add(error.id(), kind, error.to_string());
            }
        };
        self.identity.section(section.kind(), section.version(), section.descriptor_bytes(), &payload);
        if section.kind().name().is_none() {
            self.add("B0214", kind, "the section's kind is not known and was skipped".into());
        } else if !section.is_known() {
            let found = section.version();
            self.add("B0215", kind, format!("section version {found} is not known and was skipped"));
        } else if section.kind() == SectionKind::PROVENANCE {
            self.provenance(section, &payload);
        } else if section.kind() == SectionKind::CURVATURE {
            self.curvature(section, &payload);
        } else {
            self.texture(section, &payload);
        }
    }

    fn provenance(&mut self, section: &Section<'_>, payload: &[u8]) {
        let kind = Some(section.kind());
        if let Err(error) = core::str::from_utf8(payload) {
            self.add("B0601", kind, format!("the provenance is not UTF-8: {error}"));
        }
        let length = section.descriptor_bytes().len();
        if length != 0 {
            self.add("B0602", kind, format!("the provenance has a descriptor of {length} bytes; none is accepted"));
        }
    }

    fn curvature(&mut self, section: &Section<'_>, payload: &[u8]) {
        let table = section.curvature().and_then(|descriptor| crate::CurvatureView::new(descriptor, payload));
        match table {
            Ok(table) => curvature::check(&table, |id, message| self.add(id, Some(section.kind()), message)),
            Err(error) => self.add(error.id(), Some(section.kind()), error.to_string()),
        }
    }

    fn texture(&mut self, section: &Section<'_>, payload: &[u8]) {
        let table = section.texture().and_then(|descriptor| crate::TableView::new(descriptor, payload));
        match table {
            Ok(table) => {
                values::check(&table, |id, message| self.add(id, Some(section.kind()), message));
                maxima::check(&table, |id, message| self.add(id, Some(section.kind()), message));
            }
            Err(error) => self.add(error.id(), Some(section.kind()), error.to_string()),
        }
    }

    fn identity(&mut self, asset: &Asset<'_>) {
        if let Some(kind) = self.undecoded {
            self.add("B0112", None, format!("the content identity could not be checked: {kind} was not decoded"));
        } else if self.identity.finish() != asset.identity() {
            self.add("B0111", None, "the stated content identity is not that of the content".into());
        }
    }
}
