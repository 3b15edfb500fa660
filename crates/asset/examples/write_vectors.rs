//! Writes the vectors that are not in `formats/vectors/v1` yet. One that is there is never overwritten: a published
//! vector is forever.
//!
//! `cargo run -p barchan-asset --features write --example write_vectors`

use std::error::Error;
use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../formats/vectors/v1");
    let mut report = std::io::stdout().lock();
    for vector in barchan_asset::vectors::all()? {
        let path = folder.join(vector.name).with_extension("barchan");
        fs::create_dir_all(path.parent().unwrap_or(&folder))?;
        let outcome = match File::create_new(&path) {
            Ok(mut file) => file.write_all(&vector.bytes).map(|()| "written")?,
            Err(error) if error.kind() == ErrorKind::AlreadyExists => verdict(&path, &vector.bytes)?,
            Err(error) => return Err(error.into()),
        };
        writeln!(report, "{outcome}: {}", path.display())?;
    }
    Ok(())
}

fn verdict(path: &Path, bytes: &[u8]) -> std::io::Result<&'static str> {
    Ok(if fs::read(path)? == bytes { "unchanged" } else { "DIFFERS, left as published" })
}
