//! What a recipe's text gets wrong, in words that name the field, what was found and what would be accepted.

use ron::error::{Position, SpannedError};

use crate::RecipeError;

/// Words an error of the RON parser, met at `field` (`horizon.directions`; empty for the recipe itself) of `text`.
pub(crate) fn error(text: &str, field: &str, error: &SpannedError) -> RecipeError {
    let start = error.span.start;
    RecipeError::Syntax { line: start.line, column: start.col, reason: reason(text, field, error) }
}

fn reason(text: &str, field: &str, error: &SpannedError) -> String {
    use ron::Error::{DuplicateStructField, MissingStructField, NoSuchEnumVariant, NoSuchStructField};
    match &error.code {
        NoSuchStructField { expected, found, .. } => unknown("field", found, expected),
        NoSuchEnumVariant { expected, found, .. } => unknown("value", found, expected),
        MissingStructField { field: missing, .. } => format!("{}the field `{missing}` is missing", prefix(field)),
        DuplicateStructField { field: double, .. } => format!("{}the field `{double}` is there twice", prefix(field)),
        code => match needed(code) {
            Some(needed) if !field.is_empty() => match value_around(text, error.span.start) {
                found if found.is_empty() => format!("`{field}` has no value; {needed} is needed"),
                found => format!("`{field}` is `{found}`; {needed} is needed"),
            },
            Some(needed) => format!("{needed} is needed"),
            None => format!("{}{}", prefix(field), grammar(code)),
        },
    }
}

/// What a field wanted, where the parser says no more than its type.
fn needed(code: &ron::Error) -> Option<String> {
    use ron::Error as E;
    let words = match code {
        E::ExpectedInteger => "a whole number",
        E::IntegerOutOfBounds => "a whole number within the field's range",
        E::ExpectedFloat => "a number",
        E::ExpectedBoolean => "true or false",
        E::ExpectedString => "a text in double quotes",
        E::ExpectedIdentifier | E::SuggestRawIdentifier(_) => "a name without quotes",
        E::ExpectedNamedStructLike(_) | E::ExpectedStructLike => "a list of fields in parentheses",
        E::InvalidValueForType { expected, .. } | E::ExpectedDifferentLength { expected, .. } => expected,
        _ => return None,
    };
    Some(words.to_owned())
}

/// What breaks the text itself.
fn grammar(code: &ron::Error) -> String {
    use ron::Error as E;
    match code {
        E::Eof => "the text ends too early".to_owned(),
        E::ExpectedComma => "a comma or a closing `)` is needed".to_owned(),
        E::ExpectedStructLikeEnd | E::ExpectedOptionEnd => "a closing `)` is needed".to_owned(),
        E::ExpectedStringEnd => "a closing `\"` is needed".to_owned(),
        E::TrailingCharacters => "nothing may follow the recipe's closing `)`".to_owned(),
        code => code.to_string().split_whitespace().collect::<Vec<_>>().join(" "),
    }
}

fn prefix(field: &str) -> String {
    if field.is_empty() { String::new() } else { format!("{field}: ") }
}

/// The value at a position: from the punctuation before it to the punctuation after it, at most 40 characters.
fn value_around(text: &str, position: Position) -> String {
    let line = text.lines().nth(position.line - 1).unwrap_or_default();
    let at = line.char_indices().nth(position.col - 1).map_or(line.len(), |(at, _)| at);
    let start = line[..at].rfind([':', ',', '(']).map_or(0, |before| before + 1);
    let end = line[at..].find([',', ')']).map_or(line.len(), |after| at + after);
    let value = line[start..end].trim();
    if value.chars().count() > 40 { value.chars().take(40).chain(['…']).collect() } else { value.to_owned() }
}

/// Names the nearest known word, if one is near, and all that would be accepted.
fn unknown(what: &str, found: &str, expected: &[&str]) -> String {
    let nearest = expected
        .iter()
        .map(|word| (strsim::damerau_levenshtein(found, word), word))
        .filter(|(distance, word)| *distance <= 1 + word.len().max(found.len()) / 3)
        .min_by_key(|(distance, _)| *distance);
    let hint = nearest.map(|(_, word)| format!("; did you mean `{word}`?")).unwrap_or_default();
    let list = expected.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ");
    format!("unknown {what} `{found}`{hint} (accepted: {list})")
}
