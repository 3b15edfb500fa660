//! Reads meshes and says what was found, and how long reading took.
//!
//! ```text
//! cargo run --release -p barchan-import --example meshes -- FILE…
//! ```

#![allow(clippy::print_stdout, reason = "an example's output is its purpose")]

use std::{env, path::Path, time::Instant};

use barchan_import::{MeshOptions, read_mesh};

fn main() {
    for name in env::args().skip(1) {
        let start = Instant::now();
        match read_mesh(Path::new(&name), &MeshOptions::default()) {
            Ok(read) => println!("{name}: {:.3} s, {:?}", start.elapsed().as_secs_f64(), read.source),
            Err(error) => println!("{error}"),
        }
    }
}
