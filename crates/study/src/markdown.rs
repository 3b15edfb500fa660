//! Tables as markdown, and the places in a document that they are written to.
//!
//! A document says where a table goes by two lines, `<!-- name:begin -->` and `<!-- name:end -->`. What stands between
//! them belongs to the program that measures, so that no figure in a document can drift from its measurement.

use crate::StudyError;

/// A table; the first column is words, the others are numbers and aligned to the right.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows.
    #[must_use]
    pub fn new<S: Into<String>>(header: impl IntoIterator<Item = S>) -> Self {
        Self { header: header.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// Appends a row.
    ///
    /// # Panics
    /// If it has not one cell per column.
    pub fn push(&mut self, row: Vec<String>) {
        assert_eq!(row.len(), self.header.len(), "a row has one cell per column");
        self.rows.push(row);
    }

    /// Whether there is no row.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The table, a line per row.
    #[must_use]
    pub fn render(&self) -> String {
        let rule: Vec<String> =
            (0..self.header.len()).map(|column| if column == 0 { "---" } else { "---:" }.to_owned()).collect();
        let rule = format!("|{}|\n", rule.join("|"));
        let rows: String = self.rows.iter().map(|row| line(row)).collect();
        line(&self.header) + &rule + &rows
    }
}

fn line(cells: &[String]) -> String {
    // A bar would end the cell, a line break the row.
    let cells: Vec<String> = cells.iter().map(|cell| cell.replace('|', "\\|").replace('\n', " ")).collect();
    format!("| {} |\n", cells.join(" | "))
}

/// The text of a document's block, without the lines that mark it.
///
/// # Errors
/// Unless both lines stand there once, in order.
pub fn block<'a>(document: &'a str, name: &str) -> Result<&'a str, StudyError> {
    let (start, end) = block_range(document, name)?;
    Ok(&document[start..end])
}

/// The document with another text in a block.
///
/// # Errors
/// As for [`block`].
pub fn with_block(document: &str, name: &str, text: &str) -> Result<String, StudyError> {
    let (start, end) = block_range(document, name)?;
    Ok([&document[..start], text, &document[end..]].concat())
}

fn block_range(document: &str, name: &str) -> Result<(usize, usize), StudyError> {
    let (begin, end) = (format!("<!-- {name}:begin -->\n"), format!("<!-- {name}:end -->"));
    let once = |marker: &str| match document.match_indices(marker).collect::<Vec<_>>()[..] {
        [(at, _)] => Some(at),
        _ => None,
    };
    let range = once(&begin).map(|at| at + begin.len()).zip(once(&end));
    range.filter(|(start, end)| start <= end).ok_or_else(|| StudyError::Markers { name: name.to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_has_words_to_the_left_and_numbers_to_the_right() {
        let mut table = Table::new(["field", "RMS"]);
        assert!(table.is_empty());
        table.push(vec!["a|b\nc".to_owned(), "0.5°".to_owned()]);
        assert_eq!(table.render(), "| field | RMS |\n|---|---:|\n| a\\|b c | 0.5° |\n");
    }

    #[test]
    fn a_block_is_replaced_and_nothing_else() {
        let document = "before\n<!-- x:begin -->\nold\n<!-- x:end -->\n<!-- y:begin -->\n<!-- y:end -->\nafter\n";
        assert_eq!(block(document, "x").unwrap(), "old\n");
        let written = with_block(document, "x", "new\ntext\n").unwrap();
        assert_eq!(written, document.replace("old\n", "new\ntext\n"));
        assert_eq!(block(&written, "y").unwrap(), "");
    }

    #[test]
    fn a_document_without_the_markers_is_refused_by_their_name() {
        for document in ["", "<!-- x:end -->\n<!-- x:begin -->\n", "<!-- x:begin -->\n<!-- x:begin -->\n<!-- x:end -->"]
        {
            let message = block(document, "x").unwrap_err().to_string();
            assert!(message.contains("<!-- x:begin -->"), "{message}");
        }
    }
}
