//! Which GPU a record belongs to.

use barchan_view::Gpu;

use crate::{Machine, Record};

/// What a reader must know of a GPU to judge its times.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Device {
    /// As it calls itself.
    name: String,
    is_software: bool,
    /// Its interface, its driver and its machine.
    host: String,
}

impl Device {
    pub(crate) fn of(gpu: &Gpu) -> Self {
        let info = &gpu.info;
        let driver = [info.driver.as_str(), info.driver_info.as_str()].join(" ");
        Self {
            name: info.name.clone(),
            is_software: info.device_type == wgpu::DeviceType::Cpu,
            host: format!("{:?}, {}; {}", info.backend, driver.trim(), Machine::this()),
        }
    }

    pub(crate) fn is_software(&self) -> bool {
        self.is_software
    }

    /// The record of this GPU.
    pub(crate) fn on(&self, record: Record) -> Record {
        let (device, host) = (Some(self.name.clone()), Some(self.host.clone()));
        Record { device, is_software: Some(self.is_software), host, ..record }
    }
}
