//! What a PLY file says it has.

use super::{MeshError, damaged, values::Values};
use crate::{DecodeError, Format};

/// How numbers are written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    LittleEndian,
    BigEndian,
}

pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// Bytes up to the first number.
    pub(super) len: usize,
}

/// A table of the file.
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
}

/// A column of it.
pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
}

#[derive(Clone, Copy)]
pub(super) enum Kind {
    Scalar(Type),
    List { count: Type, item: Type },
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Type {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Type {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    pub(super) fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub(super) fn is_integer(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }
}

impl Header {
    pub(super) fn read(bytes: &[u8]) -> Result<Self, DecodeError> {
        let mut lines = Lines { bytes, at: 0, number: 0 };
        lines.next()?;
        let mut encoding = None;
        let mut elements: Vec<Element> = Vec::new();
        loop {
            let line = lines.next()?;
            let words: Vec<&str> = line.split_ascii_whitespace().collect();
            match words[..] {
                ["format", name, _] => encoding = Some(lines.encoding(name)?),
                ["element", name, count] => elements.push(lines.element(name, count, &elements)?),
                ["property", "list", count, item, name] => {
                    let (count, item) = (lines.type_named(count)?, lines.type_named(item)?);
                    if !count.is_integer() {
                        return Err(lines.damaged("a list counts its items in whole numbers"));
                    }
                    lines
                        .last(&mut elements)?
                        .push(Property { name: name.to_owned(), kind: Kind::List { count, item } });
                }
                ["property", scalar, name] => {
                    let kind = Kind::Scalar(lines.type_named(scalar)?);
                    lines.last(&mut elements)?.push(Property { name: name.to_owned(), kind });
                }
                ["end_header"] => break,
                [] | ["comment" | "obj_info", ..] => {}
                _ => return Err(lines.damaged(&format!("`{line}` is not understood"))),
            }
        }
        let encoding = encoding.ok_or_else(|| damaged("the header has no `format` line"))?;
        Ok(Self { encoding, elements, len: lines.at })
    }
}

impl Element {
    /// The place of the property that is one number.
    pub(super) fn scalar(&self, name: &str) -> Option<usize> {
        let is_it = |property: &Property| property.name == name && matches!(property.kind, Kind::Scalar(_));
        self.properties.iter().position(is_it)
    }

    /// Refuses more rows than the bytes that are left can hold.
    pub(super) fn check_plausible(&self, values: &Values<'_>) -> Result<(), DecodeError> {
        let least: u64 = self.properties.iter().map(|property| values.least_bytes(property.kind)).sum();
        let bytes = values.bytes_left();
        // In a text, the last number needs no space behind it.
        let Some(possible) = (bytes + 1).checked_div(least) else { return Ok(()) };
        if self.count > possible {
            let what = format!("`{}`", self.name);
            return Err(MeshError::Implausible { format: Format::Ply, what, count: self.count, bytes, possible }.into());
        }
        Ok(())
    }
}

/// The lines of the header; they end as the first one does, so that a first number of 10 or 13 stays a number.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    number: u64,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Result<&'a str, DecodeError> {
        let ends: &[u8] = if self.bytes.starts_with(b"ply\r\n") {
            b"\r\n"
        } else if self.bytes.starts_with(b"ply\r") {
            b"\r"
        } else {
            b"\n"
        };
        let rest = &self.bytes[self.at..];
        let len = rest.windows(ends.len()).position(|window| window == ends);
        let len = len.ok_or_else(|| damaged("the header has no `end_header` line"))?;
        self.at += len + ends.len();
        self.number += 1;
        // A comment may be in any encoding.
        let is_comment = rest.starts_with(b"comment") || rest.starts_with(b"obj_info");
        let line = if is_comment { b"comment" } else { &rest[..len] };
        str::from_utf8(line).map_err(|_| self.damaged("the header is not text"))
    }

    fn encoding(&self, name: &str) -> Result<Encoding, DecodeError> {
        match name {
            "ascii" => Ok(Encoding::Text),
            "binary_little_endian" => Ok(Encoding::LittleEndian),
            "binary_big_endian" => Ok(Encoding::BigEndian),
            _ => Err(DecodeError::Unsupported {
                format: Format::Ply,
                found: format!("the format `{name}`"),
                accepted: "ascii, binary_little_endian or binary_big_endian",
            }),
        }
    }

    fn element(&self, name: &str, count: &str, before: &[Element]) -> Result<Element, DecodeError> {
        if before.iter().any(|element| element.name == name) {
            return Err(self.damaged(&format!("there are two elements `{name}`")));
        }
        let count = count.parse().map_err(|_| self.damaged(&format!("`{count}` is not a count")))?;
        Ok(Element { name: name.to_owned(), count, properties: Vec::new() })
    }

    fn type_named(&self, name: &str) -> Result<Type, DecodeError> {
        Type::named(name).ok_or_else(|| self.damaged(&format!("`{name}` is not a type")))
    }

    fn last<'e>(&self, elements: &'e mut [Element]) -> Result<&'e mut Vec<Property>, DecodeError> {
        let last = elements.last_mut().map(|element| &mut element.properties);
        last.ok_or_else(|| self.damaged("a property comes before the first element"))
    }

    fn damaged(&self, reason: &str) -> DecodeError {
        MeshError::Line { format: Format::Ply, line: self.number, reason: reason.to_owned() }.into()
    }
}
