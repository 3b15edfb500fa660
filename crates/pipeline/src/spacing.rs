//! `spacing: 0.25` or `spacing: (74.0, 93.0)`.

use std::fmt;

use barchan_field::Spacing;
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};

/// Length per texel along u and v as a recipe writes it: one number for square texels, or two. Not yet checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpacingText(f64, f64);

impl Default for SpacingText {
    fn default() -> Self {
        Self(Spacing::UNIT.u(), Spacing::UNIT.v())
    }
}

impl SpacingText {
    pub(crate) fn lengths(self) -> (f64, f64) {
        (self.0, self.1)
    }
}

impl<'de> Deserialize<'de> for SpacingText {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(SpacingVisitor)
    }
}

struct SpacingVisitor;

impl<'de> Visitor<'de> for SpacingVisitor {
    type Value = SpacingText;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a length per texel, or two in parentheses (along u and along v),")
    }

    fn visit_f64<E: Error>(self, length: f64) -> Result<SpacingText, E> {
        Ok(SpacingText(length, length))
    }

    fn visit_i64<E: Error>(self, length: i64) -> Result<SpacingText, E> {
        self.visit_f64(length as f64)
    }

    fn visit_u64<E: Error>(self, length: u64) -> Result<SpacingText, E> {
        self.visit_f64(length as f64)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut lengths: A) -> Result<SpacingText, A::Error> {
        let mut next = |index| lengths.next_element()?.ok_or_else(|| A::Error::invalid_length(index, &self));
        Ok(SpacingText(next(0)?, next(1)?))
    }
}
