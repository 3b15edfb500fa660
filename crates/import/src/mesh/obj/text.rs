//! Lines, words, numbers and indices.

use std::{borrow::Cow, str};

use super::super::{MeshError, seams::NONE};
use crate::{DecodeError, Format, detect::without_mark};

/// A line, with those that a `\` at its end joins to it.
pub(super) struct Line<'a> {
    /// The first of them, counted from 1.
    pub(super) number: u64,
    text: Cow<'a, [u8]>,
}

/// The lines that are neither blank nor comments.
pub(super) fn lines(bytes: &[u8]) -> impl Iterator<Item = Line<'_>> {
    let bytes = without_mark(bytes);
    let ends = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
    let mut rest = bytes.split(move |&b| b == ends).map(<[u8]>::trim_ascii).zip(1_u64..);
    std::iter::from_fn(move || {
        let (first, number) = rest.find(|(line, _)| !line.is_empty() && line[0] != b'#')?;
        let Some(mut head) = first.strip_suffix(b"\\") else {
            return Some(Line { number, text: Cow::Borrowed(first) });
        };
        let mut joined = Vec::new();
        loop {
            joined.extend_from_slice(head);
            joined.push(b' ');
            let next = rest.next().map_or(&b""[..], |(line, _)| line);
            match next.strip_suffix(b"\\") {
                Some(more) => head = more,
                None => {
                    joined.extend_from_slice(next);
                    return Some(Line { number, text: Cow::Owned(joined) });
                }
            }
        }
    })
}

impl Line<'_> {
    /// Up to a comment.
    pub(super) fn words(&self) -> impl Iterator<Item = &[u8]> {
        let words = self.text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        words.take_while(|word| word[0] != b'#')
    }

    /// The first numbers of `words`, of which `needed` must be there; 0 stands for the rest.
    pub(super) fn numbers<'a, const N: usize>(
        &self,
        words: impl Iterator<Item = &'a [u8]>,
        needed: usize,
    ) -> Result<[f64; N], DecodeError> {
        let mut numbers = [0.0; N];
        let mut found = 0;
        for (number, word) in numbers.iter_mut().zip(words) {
            *number = self.number_of(word)?;
            found += 1;
        }
        if found < needed {
            return Err(self.damaged(&format!("there are {found} numbers; {needed} are needed")));
        }
        Ok(numbers)
    }

    fn number_of(&self, word: &[u8]) -> Result<f64, DecodeError> {
        match str::from_utf8(word).ok().and_then(|word| word.parse().ok()) {
            Some(number) => Ok(number),
            // As C libraries write what is not a number: nan(ind), -1.#IND.
            None if is_c_nan(word) => Ok(f64::NAN),
            None => Err(self.damaged(&format!("`{}` is not a number", shown(word)))),
        }
    }

    pub(super) fn not_there(&self, word: &[u8], index: i64, count: usize, kind: &str) -> DecodeError {
        self.damaged(&format!(
            "the corner `{}` names {kind} {index}, where {count} were given so far; numbers count from 1, and from -1 backwards",
            shown(word)
        ))
    }

    pub(super) fn not_a_corner(&self, word: &[u8]) -> DecodeError {
        self.damaged(&format!(
            "`{}` is not the corner of a face; v, v/vt, v//vn or v/vt/vn in whole numbers would be accepted",
            shown(word)
        ))
    }

    pub(super) fn damaged(&self, reason: &str) -> DecodeError {
        MeshError::Line { format: Format::Obj, line: self.number, reason: reason.to_owned() }.into()
    }
}

/// What an index names, counted from 0, where there are `count` so far.
pub(super) fn from_zero(index: i64, count: usize) -> Option<u32> {
    let from_zero = if index < 0 { count as i64 + index } else { index - 1 };
    // The two largest stand for "none" and "unused".
    u32::try_from(from_zero).ok().filter(|from_zero| *from_zero < NONE - 1)
}

/// A whole number of at most 18 digits.
pub(super) fn integer(word: &[u8]) -> Option<i64> {
    let (sign, digits) = match word {
        [b'-', digits @ ..] => (-1, digits),
        [b'+', digits @ ..] => (1, digits),
        digits => (1, digits),
    };
    if digits.is_empty() || digits.len() > 18 || !digits.iter().all(u8::is_ascii_digit) {
        return None;
    }
    Some(sign * digits.iter().fold(0, |value, digit| 10 * value + i64::from(digit - b'0')))
}

fn is_c_nan(word: &[u8]) -> bool {
    let word = word.strip_prefix(b"-").unwrap_or(word);
    let starts = |with: &[u8]| word.get(..with.len()).is_some_and(|start| start.eq_ignore_ascii_case(with));
    starts(b"nan(") || starts(b"1.#")
}

/// A word for a message: short, printable.
fn shown(word: &[u8]) -> String {
    let text = String::from_utf8_lossy(&word[..word.len().min(40)]);
    text.chars().filter(|c| !c.is_control()).collect()
}
