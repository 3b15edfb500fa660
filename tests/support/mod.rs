//! What the tests of the program share: a folder of their own to run it in, and readers for what it writes.
#![allow(dead_code)] // Each test program uses its own part.

use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{fs, io};

use serde_json::Value;
use tempfile::TempDir;

/// A folder of the workspace.
pub(crate) fn workspace(folder: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder)
}

/// The paths of a folder's files with an ending, sorted.
pub(crate) fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == ending));
    paths.sort();
    assert!(!paths.is_empty(), "{}: no .{ending} files", folder.display());
    paths
}

/// A temporary folder that the program runs in, so that messages name files without a path.
pub(crate) struct Place {
    folder: TempDir,
}

/// What a run of the program left.
#[derive(Debug)]
pub(crate) struct Run {
    /// The exit code; `None` if a signal ended it.
    pub(crate) code: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

impl Place {
    pub(crate) fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    /// A place with a file in it.
    pub(crate) fn with(name: &str, content: impl AsRef<[u8]>) -> Self {
        let place = Self::new();
        place.write(name, content);
        place
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.path(name), content).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub(crate) fn text(&self, name: &str) -> String {
        String::from_utf8(self.read(name)).unwrap()
    }

    /// The names of all files, hidden ones too, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(self.folder.path()).unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// Runs `barchan` in this folder; `words` are separated by blanks.
    pub(crate) fn run(&self, words: &str) -> Run {
        self.run_words(&words.split_whitespace().collect::<Vec<_>>())
    }

    pub(crate) fn run_words(&self, words: &[&str]) -> Run {
        let mut command = Command::new(env!("CARGO_BIN_EXE_barchan"));
        Run::of(command.args(words).current_dir(self.folder.path()).output())
    }

    /// Runs a shell's command in this folder, with `$BARCHAN` for the program.
    pub(crate) fn shell(&self, command: &str) -> Run {
        let mut shell = Command::new("sh");
        shell.args(["-c", command]).env("BARCHAN", env!("CARGO_BIN_EXE_barchan"));
        Run::of(shell.current_dir(self.folder.path()).output())
    }

    /// Runs a command that must succeed and say nothing on stderr; gives its stdout.
    pub(crate) fn ok(&self, words: &str) -> String {
        let run = self.run(words);
        assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""), "barchan {words}\n{}", run.stdout);
        run.stdout
    }

    /// [`Self::ok`] with `--json`, parsed.
    pub(crate) fn json(&self, words: &str) -> Value {
        parse_json(&self.ok(&format!("--json {words}")))
    }

    /// Runs a command that must fail with an exit code, without a word on stdout and with a line on stderr: the message,
    /// without the program's name.
    pub(crate) fn fails(&self, code: i32, words: &str) -> String {
        let run = self.run(words);
        assert_eq!(run.code, Some(code), "barchan {words}\n{}{}", run.stdout, run.stderr);
        assert_eq!(run.stdout, "", "barchan {words}");
        run.message()
    }

    /// Bakes a recipe into `out.barchan`.
    pub(crate) fn bake(&self, recipe: &str) {
        self.write("recipe.ron", recipe);
        self.ok("bake recipe.ron -o out.barchan");
    }

    /// Dumps a table of `file` as NPY and reads it back.
    pub(crate) fn array(&self, file: &str, table: &str) -> Array {
        self.ok(&format!("dump {file} {table} --format npy -o array.npy"));
        Array::read(&self.read("array.npy"))
    }
}

impl Run {
    fn of(output: io::Result<Output>) -> Self {
        let Output { status, stdout, stderr } = output.expect("the program starts");
        let text = |bytes| String::from_utf8(bytes).expect("the program speaks UTF-8");
        Self { code: status.code(), stdout: text(stdout), stderr: text(stderr) }
    }

    /// The one line on stderr, without the program's name.
    pub(crate) fn message(&self) -> String {
        let line = self.stderr.strip_suffix('\n').unwrap_or(&self.stderr);
        assert!(!line.contains('\n'), "one line is enough:\n{line}");
        line.strip_prefix("barchan: ").unwrap_or_else(|| panic!("a message begins with the program: {line}")).to_owned()
    }
}

pub(crate) fn parse_json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}:\n{text}"))
}

/// An array of f32, in C order.
#[derive(Debug, PartialEq)]
pub(crate) struct Array {
    pub(crate) shape: Vec<u64>,
    pub(crate) values: Vec<f32>,
}

impl Array {
    pub(crate) fn read(npy: &[u8]) -> Self {
        let file = npyz::NpyFile::new(npy).unwrap();
        assert_eq!(file.dtype().descr(), "'<f4'");
        assert_eq!(file.order(), npyz::Order::C);
        Self { shape: file.shape().to_vec(), values: file.into_vec().unwrap() }
    }

    /// One layer of `[layers, height, width]`.
    pub(crate) fn layer(&self, layer: usize) -> &[f32] {
        let texels = self.texels();
        &self.values[layer * texels..][..texels]
    }

    fn texels(&self) -> usize {
        let [.., height, width] = self.shape[..] else { panic!("{:?} has no rows", self.shape) };
        (height * width) as usize
    }
}

/// An NPY file of f32 heights, written by hand: the format is two lines long.
pub(crate) fn npy(width: usize, heights: &[f32]) -> Vec<u8> {
    let height = heights.len() / width;
    let mut header = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': ({height}, {width}), }}");
    header += &" ".repeat(63 - (header.len() + 10) % 64);
    header.push('\n');
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(heights.iter().flat_map(|height| height.to_le_bytes()));
    bytes
}

/// Something that is neither flat nor symmetric: heights from 0 to 1.
pub(crate) fn bumpy(width: usize, height: usize) -> Vec<f32> {
    let texel = |index: usize| ((index % width * 7 + index / width * 13) % 17) as f32 / 16.0;
    (0..width * height).map(texel).collect()
}

/// Heights from 0 to 1 without a pattern, so that no two places see the same horizon.
pub(crate) fn noise(width: usize, height: usize) -> Vec<f32> {
    let mut random = Random(0x9E37_79B9);
    (0..width * height).map(|_| random.below(1 << 20) as f32 / (1 << 20) as f32).collect()
}

/// A picture in colour.
pub(crate) fn rgb(png: &[u8]) -> image::RgbImage {
    image::ImageReader::with_format(Cursor::new(png), image::ImageFormat::Png).decode().unwrap().into_rgb8()
}

/// A small pseudo-random generator (xorshift64), so that every run tries the same.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    pub(crate) fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }
}
