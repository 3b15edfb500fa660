//! `barchan validate`: every byte of a file, checked.

use barchan_asset::{Severity, validate};
use serde::Serialize;

use crate::args::FileArguments;
use crate::asset_file::AssetFile;
use crate::console;
use crate::failure::{ExitStatus, Failure};

#[derive(Serialize)]
struct Report {
    schema: &'static str,
    file: String,
    valid: bool,
    findings: Vec<FindingReport>,
}

#[derive(Serialize)]
struct FindingReport {
    id: &'static str,
    severity: &'static str,
    section: Option<String>,
    message: String,
    #[serde(skip)]
    words: String,
}

pub(crate) fn run(arguments: &FileArguments, json: bool) -> Result<ExitStatus, Failure> {
    let file = AssetFile::read(&arguments.file)?;
    let findings = validate(&file.bytes, &file.limits());
    let valid = findings.iter().all(|finding| finding.severity != Severity::Error);
    let findings = findings.into_iter().map(|finding| FindingReport {
        words: finding.to_string(),
        id: finding.id,
        severity: finding.severity.name(),
        section: finding.section.map(|kind| kind.to_string()),
        message: finding.message,
    });
    let file = file.path.display().to_string();
    let report = Report { schema: "barchan.validate/1", file, valid, findings: findings.collect() };
    console::present(&report, json, describe)?;
    Ok(if valid { ExitStatus::Success } else { ExitStatus::BadInput })
}

fn describe(report: &Report) -> String {
    let verdict = if report.valid { "valid" } else { "NOT valid" };
    let findings: String = report.findings.iter().map(|finding| format!("{}\n", finding.words)).collect();
    format!("{findings}{}: {verdict}, {} findings\n", report.file, report.findings.len())
}
