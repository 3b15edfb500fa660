//! Records as CSV, the machine named in the first line.
//!
//! A column is a field of [`Record`], in its order; what was not measured is empty. The first line is a comment,
//! `# machine: …`.

use crate::{Record, StudyError};

const MACHINE: &str = "# machine: ";

/// The records of one run on one machine.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RecordFile {
    /// What they were measured on, in one line.
    pub machine: String,
    /// The records.
    pub records: Vec<Record>,
}

impl RecordFile {
    /// The file's text.
    ///
    /// # Errors
    /// None in practice: every field of a record has a place in CSV.
    pub fn to_csv(&self) -> Result<String, StudyError> {
        let mut writer = ::csv::Writer::from_writer(Vec::new());
        for record in &self.records {
            writer.serialize(record.clone().rounded())?;
        }
        let body = writer.into_inner().map_err(|error| ::csv::Error::from(error.into_error()))?;
        // One line, whatever the machine calls itself.
        let machine: Vec<&str> = self.machine.split_whitespace().collect();
        Ok(format!("{MACHINE}{}\n{}", machine.join(" "), String::from_utf8_lossy(&body)))
    }

    /// The records of such a text.
    ///
    /// # Errors
    /// A column that is not a record's, or a value that is not its column's.
    pub fn from_csv(text: &str) -> Result<Self, StudyError> {
        let machine = text.lines().find_map(|line| line.strip_prefix(MACHINE)).unwrap_or_default().to_owned();
        let mut reader = ::csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
        let records = reader.deserialize().collect::<Result<_, _>>()?;
        Ok(Self { machine, records })
    }

    /// The file, and after its records those of `previous` that were measured on other GPUs: what one machine measures does not drop
    /// what another one did.
    #[must_use]
    pub fn with_other_devices(mut self, previous: &Self) -> Self {
        let is_measured = |device| self.records.iter().any(|record| record.device.as_ref() == Some(device));
        let others = previous.records.iter().filter(|record| record.device.as_ref().is_some_and(|d| !is_measured(d)));
        let others: Vec<Record> = others.cloned().collect();
        self.records.extend(others);
        self
    }
}
