//! Where the numbers are: in the .glb, in the JSON as base64, or in files beside it. A buffer is fetched when it is
//! first needed, and a file once.

use std::{borrow::Cow, io};

use base64::{
    Engine, alphabet,
    engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig},
};

use super::{FORMAT, MeshError, damaged, json::Buffer};
use crate::DecodeError;

/// Base64 with or without its padding.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

pub(super) struct Buffers<'a> {
    buffers: &'a [Buffer],
    binary: Option<&'a [u8]>,
    read: &'a mut dyn FnMut(&str) -> io::Result<Vec<u8>>,
    /// What was fetched: for each buffer its place in `fetched`.
    places: Vec<Option<usize>>,
    fetched: Vec<Fetched<'a>>,
    bytes: u64,
}

struct Fetched<'a> {
    /// Of a file beside the glTF.
    name: Option<String>,
    content: Cow<'a, [u8]>,
}

impl<'a> Buffers<'a> {
    pub(super) fn new(
        buffers: &'a [Buffer],
        binary: Option<&'a [u8]>,
        file_bytes: usize,
        read: &'a mut dyn FnMut(&str) -> io::Result<Vec<u8>>,
    ) -> Self {
        let places = vec![None; buffers.len()];
        Self { buffers, binary, read, places, fetched: Vec::new(), bytes: file_bytes as u64 }
    }

    /// Bytes of the file and of all files fetched: nothing honest has more vertices or triangles.
    pub(super) fn total_bytes(&self) -> u64 {
        self.bytes
    }

    /// The files fetched, by first use.
    pub(super) fn names(self) -> Vec<String> {
        self.fetched.into_iter().filter_map(|fetched| fetched.name).collect()
    }

    /// Fetches the content of a buffer, if that was not done yet.
    pub(super) fn fetch(&mut self, number: usize) -> Result<(), DecodeError> {
        let Some(place) = self.places.get(number) else {
            return Err(damaged(&format!("buffer {number} is not there")));
        };
        if place.is_some() {
            return Ok(());
        }
        let place = self.place(number)?;
        let (found, promised) = (self.fetched[place].content.len() as u64, self.buffers[number].byte_length);
        if found < promised {
            return Err(damaged(&format!("buffer {number} has {found} of its {promised} bytes")));
        }
        self.places[number] = Some(place);
        Ok(())
    }

    /// The content of a buffer that was fetched.
    pub(super) fn get(&self, number: usize) -> &[u8] {
        match self.places.get(number) {
            Some(Some(place)) => &self.fetched[*place].content[..self.buffers[number].byte_length as usize],
            _ => &[],
        }
    }

    fn place(&mut self, number: usize) -> Result<usize, DecodeError> {
        let (name, content) = match (self.buffers[number].uri.as_deref(), self.binary) {
            (None, Some(binary)) if number == 0 => (None, Cow::Borrowed(binary)),
            (None, _) => return Err(damaged(&format!("buffer {number} has no `uri`"))),
            (Some(uri), _) => match uri.strip_prefix("data:") {
                Some(data) => (None, Cow::Owned(decode_data(number, data)?)),
                None => {
                    let name = relative_path(uri).map_err(|reason| external(uri, reason))?;
                    let known = self.fetched.iter().position(|fetched| fetched.name.as_ref() == Some(&name));
                    if let Some(place) = known {
                        return Ok(place);
                    }
                    let content = (self.read)(&name).map_err(|cause| external(uri, &cause.to_string()))?;
                    self.bytes += content.len() as u64;
                    (Some(name), Cow::Owned(content))
                }
            },
        };
        self.fetched.push(Fetched { name, content });
        Ok(self.fetched.len() - 1)
    }
}

fn external(uri: &str, reason: &str) -> DecodeError {
    let name = uri.chars().take(100).filter(|c| !c.is_control()).collect();
    MeshError::External { format: FORMAT, name, reason: reason.to_owned() }.into()
}

/// `application/octet-stream;base64,…`, after `data:`.
fn decode_data(number: usize, data: &str) -> Result<Vec<u8>, DecodeError> {
    let text = data.split_once(',').filter(|(kind, _)| kind.ends_with(";base64"));
    let (_, text) = text.ok_or_else(|| damaged(&format!("the data of buffer {number} is not in base64")))?;
    BASE64.decode(text).map_err(|cause| damaged(&format!("the base64 of buffer {number} has an error: {cause}")))
}

/// The path that a URI names below the folder of the file, and below it only.
fn relative_path(uri: &str) -> Result<String, &'static str> {
    let path = percent_decoded(uri).ok_or("its percent signs do not make UTF-8")?;
    if path.contains(['\\', ':', '\0']) || path.starts_with('/') {
        return Err("it is not a relative path");
    }
    let parts: Vec<&str> = path.split('/').filter(|part| *part != ".").collect();
    if parts.is_empty() || parts.iter().any(|part| part.is_empty() || *part == "..") {
        return Err("it does not name a file below the folder");
    }
    Ok(parts.join("/"))
}

fn percent_decoded(uri: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(uri.len());
    let mut rest = uri.bytes();
    while let Some(byte) = rest.next() {
        bytes.push(match byte {
            b'%' => {
                let digits = [rest.next()?, rest.next()?].map(|digit| char::from(digit).to_digit(16));
                (digits[0]? * 16 + digits[1]?) as u8
            }
            byte => byte,
        });
    }
    String::from_utf8(bytes).ok()
}
