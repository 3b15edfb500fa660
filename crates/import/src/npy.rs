//! NPY: one two-dimensional array of integers up to 32 bits or of floats.
//!
//! The header, a Python dictionary of three known keys, is parsed here and not by a library: the ones we found parse all of
//! Python's literals and so recurse, multiply the shape unchecked, and allocate what a length field says.

use half::f16;

use crate::{
    DecodeError, Format, HeightMapOptions,
    channel::pick,
    limits::{Claim, reserved},
    samples::{RawMap, Samples},
};

const FORMAT: Format = Format::Npy;
/// NumPy's own limit on the header of a file it does not trust.
const MAX_HEADER_BYTES: usize = 10_000;

pub(crate) fn decode(bytes: &[u8], options: &HeightMapOptions) -> Result<RawMap, DecodeError> {
    let (text, data) = split(bytes)?;
    let header = Header::parse(text)?;
    let &[rows, columns] = header.shape.as_slice() else {
        let sides: Vec<String> = header.shape.iter().map(u64::to_string).collect();
        let found = format!("an array of {} dimensions ({})", sides.len(), sides.join(" × "));
        return Err(DecodeError::Unsupported { format: FORMAT, found, accepted: "an array of rows × columns" });
    };
    let names = ["Y".to_owned()];
    pick(FORMAT, &names, options.channel.as_deref())?;

    let element = header.element_bytes()?;
    let (width, height) = Claim::new(FORMAT, columns, rows, element * 8).check(bytes.len(), options.max_texels)?;
    // An array is not compressed: what is promised must be there. What comes after it is not ours.
    let promised = columns * rows * element;
    if promised > data.len() as u64 {
        let reason = format!("its header promises {promised} bytes of samples, and {} follow", data.len());
        return Err(DecodeError::damaged(FORMAT, &reason));
    }
    let order = Order { width: width as usize, height: height as usize, fortran: header.fortran_order };
    let samples = header.samples(data, &order)?;
    let sample_type = samples.sample_type();
    let [channel] = names;
    Ok(RawMap { format: FORMAT, width, height, samples, sample_type, channel, no_data: None })
}

/// The header's text and the bytes after it.
fn split(bytes: &[u8]) -> Result<(&str, &[u8]), DecodeError> {
    let short = || DecodeError::damaged(FORMAT, &"it ends within its header");
    let &[_, _, _, _, _, _, major, minor, a, b, ..] = bytes else { return Err(short()) };
    let (start, len) = match (major, minor) {
        (1, 0) => (10, usize::from(u16::from_le_bytes([a, b]))),
        (2 | 3, 0) => {
            let &[c, d] = bytes.get(10..12).and_then(|s| s.first_chunk()).ok_or_else(short)?;
            (12, u32::from_le_bytes([a, b, c, d]) as usize)
        }
        _ => {
            let found = format!("version {major}.{minor}");
            return Err(DecodeError::Unsupported { format: FORMAT, found, accepted: "version 1.0, 2.0 or 3.0" });
        }
    };
    if len > MAX_HEADER_BYTES {
        let found = format!("a header of {len} bytes");
        return Err(DecodeError::Unsupported { format: FORMAT, found, accepted: "one of up to 10000 bytes" });
    }
    let (text, data) = bytes[start..].split_at_checked(len).ok_or_else(short)?;
    let text = str::from_utf8(text).map_err(|_| DecodeError::damaged(FORMAT, &"its header is not text"))?;
    Ok((text, data))
}

/// What the dictionary says.
#[derive(Debug, PartialEq)]
struct Header {
    /// Byte order, kind and bytes of an element, such as `<f4`.
    descr: String,
    fortran_order: bool,
    shape: Vec<u64>,
}

impl Header {
    fn parse(text: &str) -> Result<Self, DecodeError> {
        let (mut descr, mut fortran_order, mut shape) = (None, None, None);
        let mut words = Words { rest: text.trim() };
        words.expect('{')?;
        while !words.accept('}') {
            let key = words.string()?;
            words.expect(':')?;
            match key {
                "descr" if words.rest.starts_with('[') => {
                    let found = "a structured dtype".to_owned();
                    return Err(DecodeError::Unsupported { format: FORMAT, found, accepted: ACCEPTED });
                }
                "descr" => descr = Some(words.string()?.to_owned()),
                "fortran_order" => fortran_order = Some(words.boolean()?),
                "shape" => shape = Some(words.shape()?),
                _ => return Err(words.unexpected()),
            }
            if !words.accept(',') && !words.rest.starts_with('}') {
                return Err(words.unexpected());
            }
        }
        match (descr, fortran_order, shape) {
            (Some(descr), Some(fortran_order), Some(shape)) => Ok(Self { descr, fortran_order, shape }),
            _ => Err(DecodeError::damaged(FORMAT, &"its header lacks descr, fortran_order or shape")),
        }
    }

    fn element_bytes(&self) -> Result<u64, DecodeError> {
        match self.descr.get(1..) {
            Some("u1" | "i1") => Ok(1),
            Some("u2" | "i2" | "f2") => Ok(2),
            Some("u4" | "i4" | "f4") => Ok(4),
            Some("f8") => Ok(8),
            _ => Err(self.unsupported()),
        }
    }

    /// The elements in row order; `data` holds them all.
    fn samples(&self, data: &[u8], order: &Order) -> Result<Samples, DecodeError> {
        macro_rules! read {
            ($variant:ident, $type:ty, $from:ident) => {
                Samples::$variant(order.gather(data.as_chunks().0, <$type>::$from)?)
            };
        }
        Ok(match self.descr.as_str() {
            "|u1" | "<u1" | ">u1" => read!(U8, u8, from_le_bytes),
            "|i1" | "<i1" | ">i1" => read!(I8, i8, from_le_bytes),
            "<u2" => read!(U16, u16, from_le_bytes),
            ">u2" => read!(U16, u16, from_be_bytes),
            "<i2" => read!(I16, i16, from_le_bytes),
            ">i2" => read!(I16, i16, from_be_bytes),
            "<u4" => read!(U32, u32, from_le_bytes),
            ">u4" => read!(U32, u32, from_be_bytes),
            "<i4" => read!(I32, i32, from_le_bytes),
            ">i4" => read!(I32, i32, from_be_bytes),
            "<f2" => read!(F16, f16, from_le_bytes),
            ">f2" => read!(F16, f16, from_be_bytes),
            "<f4" => read!(F32, f32, from_le_bytes),
            ">f4" => read!(F32, f32, from_be_bytes),
            "<f8" => read!(F64, f64, from_le_bytes),
            ">f8" => read!(F64, f64, from_be_bytes),
            _ => return Err(self.unsupported()),
        })
    }

    fn unsupported(&self) -> DecodeError {
        let descr: String = self.descr.chars().filter(|c| !c.is_control()).take(16).collect();
        DecodeError::Unsupported { format: FORMAT, found: format!("the dtype `{descr}`"), accepted: ACCEPTED }
    }
}

const ACCEPTED: &str = "u1, u2, u4, i1, i2, i4, f2, f4 or f8, in either byte order,";

/// Where the element of a texel lies.
struct Order {
    width: usize,
    height: usize,
    /// Whether columns, not rows, are contiguous.
    fortran: bool,
}

impl Order {
    fn gather<const N: usize, T>(&self, elements: &[[u8; N]], from: fn([u8; N]) -> T) -> Result<Vec<T>, DecodeError> {
        let Self { width, height, fortran } = *self;
        let mut samples = reserved(width * height)?;
        if fortran {
            for row in 0..height {
                samples.extend((0..width).map(|column| from(elements[column * height + row])));
            }
        } else {
            samples.extend(elements[..width * height].iter().map(|&element| from(element)));
        }
        Ok(samples)
    }
}

/// The header's text, taken word by word.
struct Words<'a> {
    rest: &'a str,
}

impl<'a> Words<'a> {
    fn accept(&mut self, wanted: char) -> bool {
        let rest = self.rest.strip_prefix(wanted);
        self.rest = rest.unwrap_or(self.rest).trim_start();
        rest.is_some()
    }

    fn expect(&mut self, wanted: char) -> Result<(), DecodeError> {
        if self.accept(wanted) { Ok(()) } else { Err(self.unexpected()) }
    }

    fn advance(&mut self, bytes: usize) -> &'a str {
        let (word, rest) = self.rest.split_at(bytes);
        self.rest = rest.trim_start();
        word
    }

    fn string(&mut self) -> Result<&'a str, DecodeError> {
        let quote = self.rest.chars().next().filter(|c| matches!(c, '\'' | '"')).ok_or_else(|| self.unexpected())?;
        let len = self.rest[1..].find(quote).ok_or_else(|| self.unexpected())?;
        Ok(&self.advance(len + 2)[1..=len])
    }

    fn boolean(&mut self) -> Result<bool, DecodeError> {
        match self.rest.find(|c: char| !c.is_ascii_alphabetic()).map(|len| self.advance(len)) {
            Some("True") => Ok(true),
            Some("False") => Ok(false),
            _ => Err(self.unexpected()),
        }
    }

    fn shape(&mut self) -> Result<Vec<u64>, DecodeError> {
        let mut sides = Vec::new();
        self.expect('(')?;
        while !self.accept(')') {
            let digits = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
            sides.push(self.rest[..digits].parse().map_err(|_| self.unexpected())?);
            self.advance(digits);
            self.accept('L'); // Python 2 wrote long integers so.
            if !self.accept(',') && !self.rest.starts_with(')') {
                return Err(self.unexpected());
            }
        }
        Ok(sides)
    }

    fn unexpected(&self) -> DecodeError {
        let rest: String = self.rest.chars().filter(|c| !c.is_control()).take(16).collect();
        DecodeError::damaged(FORMAT, &format_args!("its header cannot be understood from `{rest}` on"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headers_of_several_writers() {
        let expected = Header { descr: ">f8".into(), fortran_order: true, shape: vec![3, 2] };
        for text in [
            "{'descr': '>f8', 'fortran_order': True, 'shape': (3, 2), }           \n",
            "{\"descr\":\">f8\",\"fortran_order\":True,\"shape\":(3,2)}",
            "{'shape': (3L, 2L), 'fortran_order': True, 'descr': '>f8'}\n",
        ] {
            assert_eq!(Header::parse(text).as_ref(), Ok(&expected), "{text}");
        }
        assert_eq!(Header::parse("{'descr': '<f4', 'fortran_order': False, 'shape': ()}").unwrap().shape, [0_u64; 0]);
    }

    #[test]
    fn headers_that_are_not() {
        for text in
            ["", "{", "{}", "[[[[", "{'descr': '<f4'", "{'descr", "{'shape': (1,, 2)}", "{'shape': (-1, 2)}", "{1: 2}"]
        {
            assert!(Header::parse(text).is_err(), "{text}");
        }
    }
}
