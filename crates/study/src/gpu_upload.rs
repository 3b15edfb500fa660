//! How long it takes until a file is on a GPU, against its size.
//!
//! # What is compared
//!
//! - **open**: the file's structure and descriptors are checked and the upload is planned; no payload is looked at, so the size must not
//!   matter;
//! - **check**: the checksum of every byte;
//! - **upload**: open, plan, upload, and the GPU is waited for;
//! - **checked**: the same with the check;
//! - **bare**: the same bytes by one `write_texture` to a texture of the same kind, and waited for: what `wgpu` and its driver take by
//!   themselves;
//! - **pieces**: likewise, at most 16 MiB at a time and each handed over before the next: their way is over memory that was used before;
//! - **fresh**: a copy of the bytes to memory that was never touched, where the system has to find and clear every page: what an upload
//!   to a software GPU, whose textures are such memory, cannot beat;
//! - **memory**: what the machine's memory carries ([`crate::bandwidth`]).
//!
//! # What is uploaded
//!
//! A horizon in 32-bit floats, stored raw: [`SIZES`] texels along each side and azimuths. Everything is wall-clock time, warm, in turn;
//! textures are freed between the rounds, off the clock.

use std::hint::black_box;

use barchan_view::{Gpu, GpuError};
use barchan_wgpu::{DeviceLimits, GpuAsset, Reader, Selection, UploadPlan};

use crate::bandwidth::{self, Bandwidth};
use crate::gpu_device::Device;
use crate::gpu_files;
use crate::runner::Observer;
use crate::timer::{Contestant, Pace, Timing, race};
use crate::{Item, Record, Scale, Setting, StudyError};

/// Texels along each side, and azimuths, of 1, 8, 64, 256 and 512 MiB.
pub const SIZES: [(u32, u32); 5] = [(256, 4), (512, 8), (1024, 16), (2048, 16), (2048, 32)];

/// Bytes that are handed over at a time, where it is in pieces.
const PIECE: u32 = 16 << 20;

/// Files opened as one lap.
const OPENED: usize = 1000;

/// The study.
#[derive(Debug, Clone, Copy)]
pub struct Uploads {
    /// Texels and azimuths.
    pub sizes: &'static [(u32, u32)],
    /// Elements of the arrays that the memory's bandwidth is measured with.
    pub elements: usize,
    /// How long each size is timed.
    pub pace: Pace,
}

/// The study at a scale.
#[must_use]
pub fn study(scale: Scale) -> Uploads {
    match scale {
        Scale::Full => {
            Uploads { sizes: &SIZES, elements: bandwidth::ELEMENTS, pace: Pace { seconds: 20.0, max_rounds: 21 } }
        }
        Scale::Quick => Uploads {
            sizes: &SIZES[..1],
            elements: bandwidth::ELEMENTS >> 6,
            pace: Pace { seconds: 0.0, max_rounds: 1 },
        },
    }
}

/// The records of all sizes on the GPU of this machine.
///
/// # Errors
/// No GPU, or one that refuses.
pub fn measure(study: &Uploads, observe: &mut Observer<'_>) -> Result<Vec<Record>, StudyError> {
    let gpu = Gpu::open()?;
    let device = Device::of(&gpu);
    let mut records = Bandwidth::measure(1, study.elements, 5).records();
    for &(side, layers) in study.sizes {
        records.extend(study.of_size(&gpu, (side, layers), observe)?);
    }
    Ok(records.into_iter().map(|record| device.on(record)).collect())
}

impl Uploads {
    fn of_size(
        &self,
        gpu: &Gpu,
        (side, layers): (u32, u32),
        observe: &mut Observer<'_>,
    ) -> Result<Vec<Record>, StudyError> {
        let bytes = gpu_files::of_size(side, layers)?;
        let file = File { bytes: &bytes, gpu, limits: DeviceLimits::of(&gpu.device), extent: (side, layers) };
        let mut contestants = file.contestants();
        let timings = race(&mut contestants, &self.pace, observe)?;
        let records =
            contestants.iter().zip(timings).map(|(contestant, timing)| file.record(&contestant.name, &timing));
        Ok(records.collect())
    }
}

/// A file that is to come to a GPU.
#[derive(Clone, Copy)]
struct File<'a> {
    bytes: &'a [u8],
    gpu: &'a Gpu,
    limits: DeviceLimits,
    extent: (u32, u32),
}

/// What is on the GPU, until it is dropped: then it is waited for that its memory is free.
struct Held<'a, T> {
    what: Option<T>,
    gpu: &'a Gpu,
}

impl<T> Drop for Held<'_, T> {
    fn drop(&mut self) {
        drop(self.what.take());
        // What a lost device has to say, the next contestant hears.
        drop(self.gpu.finish());
    }
}

/// Something on the GPU, whatever it is.
type OnGpu<'a> = Box<dyn std::any::Any + 'a>;

impl<'a> File<'a> {
    fn contestants(self) -> Vec<Contestant<'a, Held<'a, OnGpu<'static>>>> {
        let contestant = |name: &str, work: fn(Self) -> Result<Option<OnGpu<'static>>, StudyError>| Contestant {
            name: name.to_owned(),
            work: Box::new(move || Ok(Held { what: work(self)?, gpu: self.gpu })),
        };
        vec![
            contestant("open", |file| {
                (0..OPENED).try_for_each(|_| black_box(file).plan().map(|plan| drop(black_box(plan))))?;
                Ok(None)
            }),
            contestant("check", |file| {
                Reader::open(file.bytes)?.check_bytes()?;
                Ok(None)
            }),
            contestant("upload", |file| Ok(Some(Box::new(file.upload()?)))),
            contestant("checked", |file| {
                Reader::open(file.bytes)?.check_bytes()?;
                Ok(Some(Box::new(file.upload()?)))
            }),
            contestant("bare", |file| Ok(Some(Box::new(file.write_texture(u32::MAX)?)))),
            contestant("pieces", |file| Ok(Some(Box::new(file.write_texture(file.layers_of(PIECE))?)))),
            contestant("fresh", |file| Ok(Some(Box::new(file.bytes.to_vec())))),
        ]
    }

    fn plan(&self) -> Result<(Reader<'a>, UploadPlan), StudyError> {
        let reader = Reader::open(self.bytes)?;
        let plan = UploadPlan::new(&reader, &Selection::everything(), &self.limits)?;
        Ok((reader, plan))
    }

    fn upload(&self) -> Result<GpuAsset, StudyError> {
        let (reader, plan) = self.plan()?;
        let Gpu { device, queue, .. } = self.gpu;
        let asset = pollster::block_on(GpuAsset::upload(device, queue, &reader, &plan))?;
        self.wait()?;
        Ok(asset)
    }

    /// What has been handed over is carried out.
    fn wait(&self) -> Result<(), GpuError> {
        self.gpu.queue.submit([]);
        self.gpu.finish()
    }

    /// How many layers have at most so many bytes; one has in any case.
    fn layers_of(&self, bytes: u32) -> u32 {
        (bytes / (4 * self.extent.0 * self.extent.0)).max(1)
    }

    /// The same bytes to a texture of the same kind, so many layers at a time: the last ones of the file, which are as good as any.
    fn write_texture(&self, layers_at_once: u32) -> Result<wgpu::Texture, StudyError> {
        let (side, layers) = self.extent;
        let texture = self.gpu.checked(|device| texture(device, self.extent))?;
        let layer_bytes = 4 * side as usize * side as usize;
        let texels = &self.bytes[self.bytes.len().saturating_sub(layer_bytes * layers as usize)..];
        let at_once = layers_at_once.min(layers);
        for (first, piece) in (0..).step_by(at_once as usize).zip(texels.chunks(layer_bytes * at_once as usize)) {
            let origin = wgpu::Origin3d { z: first, ..wgpu::Origin3d::ZERO };
            let to = wgpu::TexelCopyTextureInfo { origin, ..texture.as_image_copy() };
            let (bytes_per_row, rows_per_image) = (Some(4 * side), Some(side));
            let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row, rows_per_image };
            let depth_or_array_layers = at_once.min(layers - first);
            let size = wgpu::Extent3d { width: side, height: side, depth_or_array_layers };
            self.gpu.queue.write_texture(to, piece, layout, size);
            self.gpu.queue.submit([]);
        }
        self.wait()?;
        Ok(texture)
    }

    fn record(&self, step: &str, timing: &Timing) -> Record {
        let (side, layers) = self.extent;
        let (per, items) =
            if step == "open" { (Item::File, OPENED as f64) } else { (Item::Byte, self.bytes.len() as f64) };
        Record {
            technique: "upload".to_owned(),
            setting: Setting::default().with("step", step).with("layers", layers),
            width: side,
            height: side,
            bytes: Some(self.bytes.len() as u64),
            ..Record::default()
        }
        .with_timing(timing, per, items)
    }
}

/// 32-bit floats, so many along each side and layers.
fn texture(device: &wgpu::Device, (side, layers): (u32, u32)) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("bare"),
        size: wgpu::Extent3d { width: side, height: side, depth_or_array_layers: layers },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::R32Float,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_step_of_a_file_is_timed() {
        let records = measure(&study(Scale::Quick), &mut |_| ()).unwrap();
        let steps: Vec<_> = records.iter().filter_map(|record| record.setting.get("step")).collect();
        assert_eq!(steps, ["open", "check", "upload", "checked", "bare", "pieces", "fresh"]);
        for record in &records {
            assert!(record.wall_ns_min > Some(0.0) && record.device.is_some(), "{record:?}");
        }
        let file = records.iter().find(|record| record.technique == "upload").unwrap();
        assert!(file.bytes > Some(1 << 20) && file.per == Some(Item::File));
    }
}
