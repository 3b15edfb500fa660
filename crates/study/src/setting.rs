//! What was set, in words that a reader and a program both understand.

use std::fmt::{self, Display};
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use crate::StudyError;

/// Names and values in a fixed order: `method=sweep directions=32`. Each technique has its own names.
#[derive(Debug, Clone, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct Setting(Vec<(String, String)>);

impl Setting {
    /// The setting with one more value.
    ///
    /// # Panics
    /// If the name or the value is empty or contains `=` or white space: it could not be read back.
    #[must_use]
    pub fn with(mut self, name: &str, value: impl Display) -> Self {
        let value = value.to_string();
        assert!(is_word(name) && is_word(&value), "`{name}={value}` could not be read back");
        self.0.push((name.to_owned(), value));
        self
    }

    /// The value of a name.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<&str> {
        self.0.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
    }

    /// The setting without a name.
    #[must_use]
    pub fn without(&self, name: &str) -> Self {
        Self(self.0.iter().filter(|(known, _)| known != name).cloned().collect())
    }
}

fn is_word(text: &str) -> bool {
    !text.is_empty() && !text.contains(|c: char| c == '=' || c.is_whitespace())
}

impl Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (name, value)) in self.0.iter().enumerate() {
            let gap = if index == 0 { "" } else { " " };
            write!(f, "{gap}{name}={value}")?;
        }
        Ok(())
    }
}

impl FromStr for Setting {
    type Err = StudyError;

    fn from_str(text: &str) -> Result<Self, StudyError> {
        let pair = |word: &str| match word.split_once('=') {
            Some((name, value)) if is_word(name) && is_word(value) => Ok((name.to_owned(), value.to_owned())),
            _ => Err(StudyError::Setting { text: text.to_owned() }),
        };
        Ok(Self(text.split_whitespace().map(pair).collect::<Result<_, _>>()?))
    }
}

impl From<Setting> for String {
    fn from(setting: Setting) -> Self {
        setting.to_string()
    }
}

impl TryFrom<String> for Setting {
    type Error = StudyError;

    fn try_from(text: String) -> Result<Self, StudyError> {
        text.parse()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setting_reads_back_as_it_was_written() {
        let setting = Setting::default().with("method", "sweep").with("directions", 32);
        assert_eq!(setting.to_string(), "method=sweep directions=32");
        assert_eq!(setting.to_string().parse::<Setting>().unwrap(), setting);
        assert_eq!((setting.get("directions"), setting.get("threads")), (Some("32"), None));
        assert_eq!(setting.without("method").to_string(), "directions=32");
        assert_eq!("".parse::<Setting>().unwrap(), Setting::default());
    }

    #[test]
    fn words_without_a_name_or_a_value_are_refused() {
        for text in ["sweep", "method=", "=sweep", "a=b=c"] {
            assert!(text.parse::<Setting>().unwrap_err().to_string().contains(text));
        }
    }

    #[test]
    #[should_panic(expected = "could not be read back")]
    fn a_value_with_a_space_is_a_mistake_of_the_caller() {
        let _ = Setting::default().with("method", "line sweep");
    }
}
