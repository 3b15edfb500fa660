//! `arc: (180, 360)`: two numbers in parentheses, if any.

use std::fmt;

use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

/// Reads a pair that may be left out, and says what is needed where something else is found.
pub(crate) fn optional<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<(f64, f64)>, D::Error> {
    Ok(Option::<Pair>::deserialize(deserializer)?.map(|Pair(first, second)| (first, second)))
}

struct Pair(f64, f64);

impl<'de> Deserialize<'de> for Pair {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PairVisitor)
    }
}

struct PairVisitor;

impl<'de> Visitor<'de> for PairVisitor {
    type Value = Pair;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a pair of numbers in parentheses")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut numbers: A) -> Result<Pair, A::Error> {
        let mut next = |index| numbers.next_element()?.ok_or_else(|| A::Error::invalid_length(index, &self));
        Ok(Pair(next(0)?, next(1)?))
    }
}
