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
        // Where there is no display, a layer of Mesa that chooses between devices says so on stderr.
        command.env("NODEVICE_SELECT", "1");
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

/// A triangle mesh to be written as a file: a torus about the z axis, radii 2 and ½, its numbers exact in f32.
pub(crate) struct Torus {
    pub(crate) around: u32,
    pub(crate) along: u32,
}

impl Torus {
    pub(crate) const MAJOR: f64 = 2.0;
    pub(crate) const MINOR: f64 = 0.5;
    pub(crate) const USUAL: Self = Self { around: 48, along: 24 };

    /// The angle of vertex i about the tube, from the outer equator upwards.
    fn angle(&self, index: u32) -> f64 {
        std::f64::consts::TAU * f64::from(index % self.along) / f64::from(self.along)
    }

    pub(crate) fn positions(&self) -> Vec<[f32; 3]> {
        let vertex = |index: u32| {
            let about = std::f64::consts::TAU * f64::from(index / self.along) / f64::from(self.around);
            let (sine, cosine) = self.angle(index).sin_cos();
            let from_axis = Self::MAJOR + Self::MINOR * cosine;
            [from_axis * about.cos(), from_axis * about.sin(), Self::MINOR * sine].map(|number| number as f32)
        };
        (0..self.around * self.along).map(vertex).collect()
    }

    /// κ1 and κ2 at every vertex.
    pub(crate) fn curvature(&self) -> Vec<[f64; 2]> {
        let across = |index| {
            let cosine = self.angle(index).cos();
            cosine / (Self::MAJOR + Self::MINOR * cosine)
        };
        (0..self.around * self.along).map(|index| [1.0 / Self::MINOR, across(index)]).collect()
    }

    /// Counter-clockwise seen from outside.
    pub(crate) fn triangles(&self) -> Vec<[u32; 3]> {
        let at = |u: u32, v: u32| u % self.around * self.along + v % self.along;
        let cells = (0..self.around).flat_map(|u| (0..self.along).map(move |v| (u, v)));
        let cut = |(u, v)| [[at(u, v), at(u + 1, v), at(u + 1, v + 1)], [at(u, v), at(u + 1, v + 1), at(u, v + 1)]];
        cells.flat_map(cut).collect()
    }

    pub(crate) fn obj(&self) -> String {
        let positions = self.positions();
        let vertices = positions.iter().map(vertex_line);
        let triangles = self.triangles();
        let faces = triangles.iter().map(|triangle| {
            let [a, b, c] = triangle.map(|corner| corner + 1);
            format!("f {a} {b} {c}\n")
        });
        vertices.chain(faces).collect()
    }

    /// [`Self::obj`] with texture coordinates, which have a seam where each circle closes.
    pub(crate) fn obj_with_uvs(&self) -> String {
        let (around, along) = (self.around, self.along);
        let mut text: String = self.positions().iter().map(vertex_line).collect();
        for (u, v) in (0..=around).flat_map(|u| (0..=along).map(move |v| (u, v))) {
            text += &format!("vt {} {}\n", f64::from(u) / f64::from(around), f64::from(v) / f64::from(along));
        }
        let corner = |u: u32, v: u32| format!("{}/{}", u % around * along + v % along + 1, u * (along + 1) + v + 1);
        for (u, v) in (0..around).flat_map(|u| (0..along).map(move |v| (u, v))) {
            let [a, b, c, d] = [corner(u, v), corner(u + 1, v), corner(u + 1, v + 1), corner(u, v + 1)];
            text += &format!("f {a} {b} {c} {d}\n");
        }
        text
    }

    pub(crate) fn ply(&self) -> Vec<u8> {
        let (positions, triangles) = (self.positions(), self.triangles());
        let (vertices, faces) = (positions.len(), triangles.len());
        let mut bytes = format!(
            "ply\nformat binary_little_endian 1.0\nelement vertex {vertices}\nproperty float x\nproperty float y\n\
             property float z\nelement face {faces}\nproperty list uchar uint vertex_indices\nend_header\n"
        )
        .into_bytes();
        bytes.extend(positions.as_flattened().iter().flat_map(|number| number.to_le_bytes()));
        for triangle in &triangles {
            bytes.push(3);
            bytes.extend(triangle.iter().flat_map(|corner| corner.to_le_bytes()));
        }
        bytes
    }

    /// A glTF document, and the buffer that it does not say the place of.
    pub(crate) fn gltf(&self) -> (Value, Vec<u8>) {
        let (positions, triangles) = (self.positions(), self.triangles());
        let mut buffer: Vec<u8> = positions.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect();
        let indices_at = buffer.len();
        buffer.extend(triangles.as_flattened().iter().flat_map(|corner| corner.to_le_bytes()));
        let json = serde_json::json!({
            "asset": { "version": "2.0" },
            "buffers": [{ "byteLength": buffer.len() }],
            "bufferViews": [
                { "buffer": 0, "byteOffset": 0, "byteLength": indices_at },
                { "buffer": 0, "byteOffset": indices_at, "byteLength": buffer.len() - indices_at },
            ],
            "accessors": [
                { "bufferView": 0, "componentType": 5126, "count": positions.len(), "type": "VEC3",
                  "min": [-2.5, -2.5, -0.5], "max": [2.5, 2.5, 0.5] },
                { "bufferView": 1, "componentType": 5125, "count": 3 * triangles.len(), "type": "SCALAR" },
            ],
            "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1 }] }],
            "nodes": [{ "mesh": 0 }], "scenes": [{ "nodes": [0] }], "scene": 0,
        });
        (json, buffer)
    }

    pub(crate) fn glb(&self) -> Vec<u8> {
        let (json, buffer) = self.gltf();
        let mut json = json.to_string().into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let mut bytes = b"glTF".to_vec();
        let words = |words: &[u32]| words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>();
        bytes.extend(words(&[2, (28 + json.len() + buffer.len()) as u32, json.len() as u32, 0x4E4F_534A]));
        bytes.extend(json);
        bytes.extend(words(&[buffer.len() as u32, 0x004E_4942]));
        bytes.extend(buffer);
        bytes
    }
}

/// A position to the last bit, as a reader of f64 wants it.
fn vertex_line(position: &[f32; 3]) -> String {
    let [x, y, z] = position.map(f64::from);
    format!("v {x} {y} {z}\n")
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
