//! Names the machine that times belong to: nothing that names its owner, host or paths.

use std::fmt;

/// What a reader must know to judge a time.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Machine {
    /// The processor, as it calls itself, with what tells its generation.
    pub processor: String,
    /// Cores that this process may use.
    pub cores: usize,
    /// Operating system and instruction set, `linux x86_64`.
    pub system: String,
    /// The widest vector instructions, if any that we use.
    pub vectors: &'static str,
    /// The compiler, `rustc 1.95.0`.
    pub compiler: &'static str,
}

impl Machine {
    /// This machine. On Linux `/proc/cpuinfo` is read: the one file this crate opens.
    #[must_use]
    pub fn this() -> Self {
        let processor = std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| processor(&text));
        let processor = processor.or_else(|| std::env::var("PROCESSOR_IDENTIFIER").ok());
        Self {
            processor: processor.unwrap_or_else(|| "unnamed processor".to_owned()),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            vectors: vectors(),
            compiler: env!("BARCHAN_COMPILER"),
        }
    }
}

impl fmt::Display for Machine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { processor, cores, system, vectors, compiler } = self;
        let plural = if *cores == 1 { "core" } else { "cores" };
        write!(f, "{processor}, {cores} {plural}, {system}, {vectors}, {compiler}")
    }
}

/// The first processor of `/proc/cpuinfo`. Virtual machines shorten the model's name: family and model say the rest.
fn processor(cpuinfo: &str) -> Option<String> {
    let value = |key: &str| {
        let line = cpuinfo.lines().find(|line| line.split(':').next().is_some_and(|name| name.trim() == key))?;
        line.split_once(':').map(|(_, value)| value.trim())
    };
    let name = value("model name")?;
    Some(match value("cpu family").zip(value("model")) {
        Some((family, model)) => format!("{name} (family {family}, model {model})"),
        None => name.to_owned(),
    })
}

#[cfg(target_arch = "x86_64")]
fn vectors() -> &'static str {
    if std::arch::is_x86_feature_detected!("avx512f") {
        "AVX-512"
    } else if std::arch::is_x86_feature_detected!("avx2") {
        "AVX2"
    } else {
        "SSE2"
    }
}

#[cfg(target_arch = "aarch64")]
fn vectors() -> &'static str {
    "NEON"
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
fn vectors() -> &'static str {
    "no vectors"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_processor_is_named_with_its_generation() {
        let text = "processor\t: 0\ncpu family\t: 26\nmodel\t\t: 2\nmodel name\t: AMD EPYC\n\nmodel name\t: Other\n";
        assert_eq!(processor(text).unwrap(), "AMD EPYC (family 26, model 2)");
        assert_eq!(processor("model name : Some Arm\n").unwrap(), "Some Arm");
        assert_eq!(processor("Hardware : board\n"), None);
    }

    #[test]
    fn this_machine_is_named_in_one_line_and_its_compiler_too() {
        let name = Machine::this().to_string();
        assert!(!name.contains('\n') && name.contains("rustc 1."), "{name}");
    }
}
