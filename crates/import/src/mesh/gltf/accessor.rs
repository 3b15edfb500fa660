//! Numbers out of buffers: strided, quantised, sparse.

use super::{
    FORMAT, MeshError,
    buffers::Buffers,
    damaged,
    json::{Accessor, Document, Sparse},
};
use crate::{DecodeError, limits::reserved};

pub(super) struct Reader<'a> {
    pub(super) document: &'a Document,
    pub(super) buffers: Buffers<'a>,
}

/// The type of a number.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn new(code: u32) -> Result<Self, DecodeError> {
        Ok(match code {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return Err(damaged(&format!("an accessor has the component type {code}"))),
        })
    }

    fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// The first number of `bytes`.
    fn read(self, bytes: &[u8]) -> f64 {
        match (self, bytes) {
            (Self::I8, &[a, ..]) => i8::from_le_bytes([a]).into(),
            (Self::U8, &[a, ..]) => a.into(),
            (Self::I16, &[a, b, ..]) => i16::from_le_bytes([a, b]).into(),
            (Self::U16, &[a, b, ..]) => u16::from_le_bytes([a, b]).into(),
            (Self::U32, &[a, b, c, d, ..]) => u32::from_le_bytes([a, b, c, d]).into(),
            (Self::F32, &[a, b, c, d, ..]) => f32::from_le_bytes([a, b, c, d]).into(),
            // Elements are cut to their size before.
            _ => f64::NAN,
        }
    }

    /// What a normalised integer stands for.
    fn normalised(self, value: f64) -> f64 {
        match self {
            Self::I8 => (value / 127.0).max(-1.0),
            Self::U8 => value / 255.0,
            Self::I16 => (value / 32767.0).max(-1.0),
            Self::U16 => value / 65535.0,
            Self::U32 | Self::F32 => value,
        }
    }
}

/// Elements side by side in a buffer, all of them within it.
struct Elements<'b> {
    bytes: &'b [u8],
    stride: usize,
    component: Component,
    count: usize,
}

impl Elements<'_> {
    fn get<const N: usize>(&self, at: usize) -> [f64; N] {
        let element = &self.bytes[at * self.stride..];
        std::array::from_fn(|i| self.component.read(&element[i * self.component.bytes()..]))
    }
}

impl Reader<'_> {
    /// N numbers per vertex, of any type but u32.
    pub(super) fn vectors<const N: usize>(&mut self, number: usize) -> Result<Vec<[f64; N]>, DecodeError> {
        let accessor = self.accessor(number, &format!("VEC{N}"))?;
        let component = Component::new(accessor.component_type)?;
        if component == Component::U32 {
            return Err(damaged(&format!("accessor {number} has vertices of unsigned ints")));
        }
        let mut values = self.values(number, accessor, component)?;
        if accessor.normalized {
            values.iter_mut().for_each(|value: &mut [f64; N]| *value = value.map(|value| component.normalised(value)));
        }
        Ok(values)
    }

    /// Indices of triangle corners, each less than `vertices`.
    pub(super) fn indices(&mut self, number: usize, vertices: usize) -> Result<Vec<u32>, DecodeError> {
        let accessor = self.accessor(number, "SCALAR")?;
        let component = Component::new(accessor.component_type)?;
        if !matches!(component, Component::U8 | Component::U16 | Component::U32) {
            return Err(damaged(&format!("accessor {number} has indices that are not unsigned integers")));
        }
        let values = self.values(number, accessor, component)?;
        let mut indices = reserved(values.len())?;
        for (at, [index]) in values.into_iter().enumerate() {
            if index >= vertices as f64 {
                let (face, vertices) = (at as u64 / 3, vertices as u64);
                return Err(MeshError::Corner { format: FORMAT, face, vertex: index as i64, vertices }.into());
            }
            indices.push(index as u32);
        }
        Ok(indices)
    }

    /// How many elements an accessor promises; none where it is not there, which reading it finds out.
    pub(super) fn count(&self, number: usize) -> u64 {
        self.document.accessors.get(number).map_or(0, |accessor| accessor.count)
    }

    /// Fetches the buffers of an accessor, so that what it may promise is known.
    pub(super) fn fetch(&mut self, number: usize) -> Result<(), DecodeError> {
        let Some(accessor) = self.document.accessors.get(number) else { return Ok(()) };
        let sparse = accessor.sparse.as_ref();
        let views = [
            accessor.buffer_view,
            sparse.map(|sparse| sparse.indices.buffer_view),
            sparse.map(|sparse| sparse.values.buffer_view),
        ];
        for view in views.into_iter().flatten() {
            if let Some(about) = self.document.buffer_views.get(view) {
                self.buffers.fetch(about.buffer)?;
            }
        }
        Ok(())
    }

    /// Refuses more than one thing per byte of what was read.
    pub(super) fn check_total(&self, things: &str, count: u64) -> Result<(), DecodeError> {
        let possible = self.buffers.total_bytes();
        if count > possible {
            return Err(implausible(things.to_owned(), count, possible, possible));
        }
        Ok(())
    }
}

impl<'a> Reader<'a> {
    fn accessor(&self, number: usize, shape: &str) -> Result<&'a Accessor, DecodeError> {
        let accessor = self.document.accessors.get(number);
        let accessor = accessor.ok_or_else(|| damaged(&format!("accessor {number} is not there")))?;
        if accessor.shape != shape {
            let found: String = accessor.shape.escape_debug().take(20).collect();
            return Err(damaged(&format!("accessor {number} is of the type {found}, where {shape} is needed")));
        }
        Ok(accessor)
    }

    fn values<const N: usize>(
        &mut self,
        number: usize,
        accessor: &Accessor,
        component: Component,
    ) -> Result<Vec<[f64; N]>, DecodeError> {
        let Accessor { buffer_view, byte_offset, count, .. } = *accessor;
        let mut values = match buffer_view {
            Some(view) => {
                let elements = self.elements(view, byte_offset, count, component, N)?;
                let mut values = reserved(elements.count)?;
                values.extend((0..elements.count).map(|at| elements.get(at)));
                values
            }
            None if accessor.sparse.is_some() => {
                self.check_total(&format!("elements of accessor {number}"), count)?;
                let mut values = reserved(count as usize)?;
                values.resize(count as usize, [0.0; N]);
                values
            }
            None => return Err(damaged(&format!("accessor {number} has neither a buffer view nor sparse values"))),
        };
        if let Some(sparse) = &accessor.sparse {
            self.replace(&mut values, sparse, component)?;
        }
        Ok(values)
    }

    fn replace<const N: usize>(
        &mut self,
        values: &mut [[f64; N]],
        sparse: &Sparse,
        component: Component,
    ) -> Result<(), DecodeError> {
        let indices = &sparse.indices;
        let index_type = Component::new(indices.component_type)?;
        let places = self.elements(indices.buffer_view, indices.byte_offset, sparse.count, index_type, 1)?;
        let places: Vec<[f64; 1]> = (0..places.count).map(|at| places.get(at)).collect();
        let elements =
            self.elements(sparse.values.buffer_view, sparse.values.byte_offset, sparse.count, component, N)?;
        for (at, [place]) in places.into_iter().enumerate() {
            let value = if place >= 0.0 { values.get_mut(place as usize) } else { None };
            *value
                .ok_or_else(|| damaged(&format!("a sparse accessor replaces element {place}, which is not there")))? =
                elements.get(at);
        }
        Ok(())
    }

    /// `count` elements of `width` numbers.
    fn elements(
        &mut self,
        view: usize,
        offset: u64,
        count: u64,
        component: Component,
        width: usize,
    ) -> Result<Elements<'_>, DecodeError> {
        let about = self.document.buffer_views.get(view);
        let about = about.ok_or_else(|| damaged(&format!("buffer view {view} is not there")))?;
        self.buffers.fetch(about.buffer)?;
        let buffer = self.buffers.get(about.buffer);
        let bytes = part(buffer, about.byte_offset, Some(about.byte_length)).and_then(|view| part(view, offset, None));
        let bytes = bytes.ok_or_else(|| damaged(&format!("buffer view {view} ends beyond its buffer")))?;
        let size = (component.bytes() * width) as u64;
        let stride = about.byte_stride.unwrap_or(size);
        if stride < size {
            return Err(damaged(&format!("buffer view {view} has a stride of {stride} for elements of {size} bytes")));
        }
        let len = bytes.len() as u64;
        let possible = if len < size { 0 } else { (len - size) / stride + 1 };
        if count > possible {
            return Err(implausible(format!("elements of buffer view {view}"), count, len, possible));
        }
        Ok(Elements { bytes, stride: usize::try_from(stride).unwrap_or(usize::MAX), component, count: count as usize })
    }
}

fn part(bytes: &[u8], offset: u64, len: Option<u64>) -> Option<&[u8]> {
    let rest = bytes.get(usize::try_from(offset).ok()?..)?;
    match len {
        Some(len) => rest.get(..usize::try_from(len).ok()?),
        None => Some(rest),
    }
}

fn implausible(what: String, count: u64, bytes: u64, possible: u64) -> DecodeError {
    MeshError::Implausible { format: FORMAT, what, count, bytes, possible }.into()
}
