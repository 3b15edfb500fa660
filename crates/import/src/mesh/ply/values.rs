//! Numbers one after the other. All types of PLY fit f64 exactly.

use super::{
    damaged,
    header::{Element, Encoding, Kind, Type},
};
use crate::DecodeError;

pub(super) struct Values<'a> {
    rest: &'a [u8],
    encoding: Encoding,
}

impl<'a> Values<'a> {
    pub(super) fn new(rest: &'a [u8], encoding: Encoding) -> Self {
        Self { rest, encoding }
    }

    pub(super) fn bytes_left(&self) -> u64 {
        self.rest.len() as u64
    }

    /// The fewest bytes a property takes: in a text a digit and a space.
    pub(super) fn least_bytes(&self, kind: Kind) -> u64 {
        let (Kind::Scalar(first) | Kind::List { count: first, .. }) = kind;
        if self.encoding == Encoding::Text { 2 } else { first.bytes() as u64 }
    }

    /// The numbers of a row; 0 in place of a list, which is stepped over.
    pub(super) fn read_row(&mut self, element: &Element, row: &mut [f64]) -> Result<(), DecodeError> {
        for (value, property) in row.iter_mut().zip(&element.properties) {
            match property.kind {
                Kind::Scalar(scalar) => *value = self.next(scalar)?,
                Kind::List { count, item } => self.skip_list(count, item)?,
            }
        }
        self.end_row();
        Ok(())
    }

    /// Steps over a row but for the items of one list.
    pub(super) fn read_list_row(
        &mut self,
        element: &Element,
        list: usize,
        mut use_item: impl FnMut(f64) -> Result<(), DecodeError>,
    ) -> Result<(), DecodeError> {
        for (at, property) in element.properties.iter().enumerate() {
            match property.kind {
                Kind::Scalar(scalar) => self.skip(scalar)?,
                Kind::List { count, item } if at == list => {
                    for _ in 0..self.list_len(count, item)? {
                        use_item(self.next(item)?)?;
                    }
                }
                Kind::List { count, item } => self.skip_list(count, item)?,
            }
        }
        self.end_row();
        Ok(())
    }

    pub(super) fn skip_row(&mut self, element: &Element) -> Result<(), DecodeError> {
        self.read_list_row(element, usize::MAX, |_| Ok(()))
    }

    fn end_row(&mut self) {
        if self.encoding == Encoding::Text {
            let len = self.rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(self.rest.len());
            self.rest = &self.rest[len..];
        }
    }

    fn skip(&mut self, scalar: Type) -> Result<(), DecodeError> {
        match self.encoding {
            Encoding::Text => self.word().map(|_| ()),
            _ => self.take(scalar.bytes()).map(|_| ()),
        }
    }

    fn skip_list(&mut self, count: Type, item: Type) -> Result<(), DecodeError> {
        let len = self.list_len(count, item)?;
        match self.encoding {
            Encoding::Text => (0..len).try_for_each(|_| self.skip(item)),
            _ => self.take(len * item.bytes()).map(|_| ()),
        }
    }

    /// The length of a list, which the bytes that are left can hold.
    fn list_len(&mut self, count: Type, item: Type) -> Result<usize, DecodeError> {
        let len = self.next(count)?;
        let least = if self.encoding == Encoding::Text { 2 } else { item.bytes() };
        let possible = (self.rest.len() + 1) / least;
        if len >= 0.0 && len.fract() == 0.0 && len <= possible as f64 {
            return Ok(len as usize);
        }
        Err(damaged(&format!("a list has {len} items; 0 to {possible} fit the rest of the file")))
    }

    fn next(&mut self, scalar: Type) -> Result<f64, DecodeError> {
        match self.encoding {
            Encoding::Text => self.next_text(),
            Encoding::LittleEndian => self.next_binary(scalar, |_| {}),
            Encoding::BigEndian => self.next_binary(scalar, |bytes| bytes.reverse()),
        }
    }

    fn next_text(&mut self) -> Result<f64, DecodeError> {
        let word = self.word()?;
        let number = str::from_utf8(word).ok().and_then(|word| word.parse().ok());
        number.ok_or_else(|| {
            let shown = String::from_utf8_lossy(&word[..word.len().min(40)]);
            damaged(&format!("`{}` is not a number", shown.escape_debug()))
        })
    }

    fn word(&mut self) -> Result<&'a [u8], DecodeError> {
        let text = self.rest.trim_ascii_start();
        let len = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
        let (word, rest) = text.split_at(len);
        self.rest = rest;
        if word.is_empty() { Err(ends_too_early()) } else { Ok(word) }
    }

    fn take(&mut self, len: usize) -> Result<&'a [u8], DecodeError> {
        let (taken, rest) = self.rest.split_at_checked(len).ok_or_else(ends_too_early)?;
        self.rest = rest;
        Ok(taken)
    }

    fn next_binary(&mut self, scalar: Type, to_little: impl Fn(&mut [u8])) -> Result<f64, DecodeError> {
        let bytes = self.take(scalar.bytes())?;
        let mut padded = [0; 8];
        let number = &mut padded[..bytes.len()];
        number.copy_from_slice(bytes);
        to_little(number);
        let [a, b, c, d, ..] = padded;
        Ok(match scalar {
            Type::I8 => i8::from_le_bytes([a]).into(),
            Type::U8 => a.into(),
            Type::I16 => i16::from_le_bytes([a, b]).into(),
            Type::U16 => u16::from_le_bytes([a, b]).into(),
            Type::I32 => i32::from_le_bytes([a, b, c, d]).into(),
            Type::U32 => u32::from_le_bytes([a, b, c, d]).into(),
            Type::F32 => f32::from_le_bytes([a, b, c, d]).into(),
            Type::F64 => f64::from_le_bytes(padded),
        })
    }
}

fn ends_too_early() -> DecodeError {
    damaged("it ends before its last number")
}
