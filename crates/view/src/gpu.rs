//! A device of this machine.

use std::future::Future;

use crate::GpuError;

/// A device, real or software, and its queue.
#[derive(Debug)]
pub struct Gpu {
    /// What it is.
    pub info: wgpu::AdapterInfo,
    /// The device.
    pub device: wgpu::Device,
    /// Its queue.
    pub queue: wgpu::Queue,
}

impl Gpu {
    /// Opens the first GPU there is, a real one before a software one, with all that it can do.
    ///
    /// # Errors
    /// No GPU; the message names what installs one.
    pub fn open() -> Result<Self, GpuError> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        };
        let adapter = wait(instance.request_adapter(&options)).map_err(|error| no_adapter(&error))?;
        let optional = wgpu::Features::FLOAT32_FILTERABLE | wgpu::Features::TIMESTAMP_QUERY;
        let (device, queue) = wait(adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("barchan"),
            required_features: adapter.features() & optional,
            required_limits: adapter.limits(),
            ..Default::default()
        }))
        .map_err(|error| no_adapter(&error))?;
        // What is refused is asked for in error scopes; what comes besides must not end the program.
        device.on_uncaptured_error(std::sync::Arc::new(|_| ()));
        Ok(Self { info: adapter.get_info(), device, queue })
    }

    /// Does something on the device, and says what it refused.
    ///
    /// # Errors
    /// What the device refused.
    pub fn checked<T>(&self, work: impl FnOnce(&wgpu::Device) -> T) -> Result<T, GpuError> {
        let filters = [wgpu::ErrorFilter::Validation, wgpu::ErrorFilter::OutOfMemory, wgpu::ErrorFilter::Internal];
        let scopes = filters.map(|filter| self.device.push_error_scope(filter));
        let done = work(&self.device);
        // The last scope is the innermost.
        let errors: Vec<_> = scopes.into_iter().rev().filter_map(|scope| wait(scope.pop())).collect();
        match errors.first() {
            Some(error) => Err(GpuError::Device { reason: error.to_string() }),
            None => Ok(done),
        }
    }

    /// Waits until all that was submitted is done.
    ///
    /// # Errors
    /// A device that is lost.
    pub fn finish(&self) -> Result<(), GpuError> {
        let polled = self.device.poll(wgpu::PollType::wait_indefinitely());
        polled.map(|_| ()).map_err(|error| GpuError::Device { reason: error.to_string() })
    }

    /// What is in a buffer that can be mapped, once all that was submitted is done.
    pub(crate) fn read(&self, buffer: &wgpu::Buffer) -> Result<Vec<u8>, GpuError> {
        let (sender, receiver) = std::sync::mpsc::channel();
        buffer.slice(..).map_async(wgpu::MapMode::Read, move |mapped| drop(sender.send(mapped)));
        self.finish()?;
        let lost = |reason: String| GpuError::Device { reason };
        receiver.recv().map_err(|error| lost(error.to_string()))?.map_err(|error| lost(error.to_string()))?;
        let bytes = buffer.slice(..).get_mapped_range().map_err(|error| lost(error.to_string()))?.to_vec();
        buffer.unmap();
        Ok(bytes)
    }
}

/// Waits for something that the device does.
pub(crate) fn wait<T>(future: impl Future<Output = T>) -> T {
    pollster::block_on(future)
}

fn no_adapter(error: &dyn std::error::Error) -> GpuError {
    GpuError::NoAdapter { reason: error.to_string() }
}
