//! `arc: (180, 360)`: two numbers in parentheses, if any.

use std::fmt;
use std::marker::PhantomData;

use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

/// Reads a pair that may be left out, and says what is needed where something else is found.
pub(crate) fn optional<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
    deserializer: D,
) -> Result<Option<(T, T)>, D::Error> {
    Ok(Option::<Pair<T>>::deserialize(deserializer)?.map(|Pair(first, second)| (first, second)))
}

struct Pair<T>(T, T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Pair<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(PairVisitor(PhantomData))
    }
}

struct PairVisitor<T>(PhantomData<T>);

impl<'de, T: Deserialize<'de>> Visitor<'de> for PairVisitor<T> {
    type Value = Pair<T>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a pair of numbers in parentheses")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut numbers: A) -> Result<Pair<T>, A::Error> {
        let mut next = |index| numbers.next_element()?.ok_or_else(|| A::Error::invalid_length(index, &self));
        Ok(Pair(next(0)?, next(1)?))
    }
}
