//! A .glb is JSON and one buffer in one file; a .gltf is JSON alone.

use super::damaged;
use crate::{DecodeError, detect::without_mark};

pub(super) struct Parts<'a> {
    pub(super) json: &'a [u8],
    /// The buffer inside a .glb.
    pub(super) binary: Option<&'a [u8]>,
}

pub(super) fn split(bytes: &[u8]) -> Result<Parts<'_>, DecodeError> {
    let Some(after_magic) = bytes.strip_prefix(b"glTF") else {
        return Ok(Parts { json: without_mark(bytes), binary: None });
    };
    let (version, rest) = number(after_magic)?;
    let (len, _) = number(rest)?;
    if version != 2 {
        let found = format!("the container version {version}");
        return Err(DecodeError::Unsupported { format: super::FORMAT, found, accepted: "2" });
    }
    let chunks = bytes.get(12..len as usize);
    let chunks = chunks.ok_or_else(|| damaged(&format!("it is {} bytes long and says {len}", bytes.len())))?;
    let (first, rest) = chunk(chunks)?;
    if first.kind != *b"JSON" {
        return Err(damaged("its first chunk is not JSON"));
    }
    let second = if rest.is_empty() { None } else { Some(chunk(rest)?.0) };
    // What follows, or is of another kind, belongs to extensions.
    let binary = second.filter(|chunk| chunk.kind == *b"BIN\0").map(|chunk| chunk.content);
    Ok(Parts { json: first.content, binary })
}

struct Chunk<'a> {
    kind: [u8; 4],
    content: &'a [u8],
}

/// The first chunk, and what follows it.
fn chunk(bytes: &[u8]) -> Result<(Chunk<'_>, &[u8]), DecodeError> {
    let (len, rest) = number(bytes)?;
    let parts = rest.split_first_chunk().and_then(|(kind, rest)| Some((*kind, rest.split_at_checked(len as usize)?)));
    let (kind, (content, rest)) = parts.ok_or_else(|| damaged("a chunk ends beyond the file"))?;
    Ok((Chunk { kind, content }, rest))
}

fn number(bytes: &[u8]) -> Result<(u32, &[u8]), DecodeError> {
    let (number, rest) = bytes.split_first_chunk().ok_or_else(|| damaged("it ends within its header"))?;
    Ok((u32::from_le_bytes(*number), rest))
}
