//! Files appear whole or not at all.

use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

use crate::failure::Failure;

/// A file under a temporary name in the folder where it is wanted. Until it is kept, what was there before is as it was;
/// if it never is, nothing is left behind.
pub(crate) struct PendingFile<'a> {
    path: &'a Path,
    file: NamedTempFile,
}

impl<'a> PendingFile<'a> {
    pub(crate) fn create(path: &'a Path) -> Result<Self, Failure> {
        let folder = folder_of(path);
        check(path, &folder)?;
        // The kind alone, and below the bare file: the errors' own words would name the temporary file.
        let file = temporary(&folder).map_err(|error| cannot_write(path, &error.kind().into()))?;
        Ok(Self { path, file })
    }

    pub(crate) fn file(&mut self) -> &mut File {
        self.file.as_file_mut()
    }

    /// Renames the file into place, once the disk has it.
    pub(crate) fn keep(self) -> Result<(), Failure> {
        let Self { path, file } = self;
        file.as_file().sync_all().map_err(|error| cannot_write(path, &error))?;
        file.persist(path).map_err(|error| cannot_write(path, &error.error))?;
        Ok(())
    }
}

/// Writes a file whole: on any failure the previous file is as it was.
pub(crate) fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let mut pending = PendingFile::create(path)?;
    pending.file().write_all(bytes).map_err(|error| cannot_write(path, &error))?;
    pending.keep()
}

/// The system refused to write a file.
pub(crate) fn cannot_write(path: &Path, error: &std::io::Error) -> Failure {
    Failure::io(path, "cannot be written", error)
}

/// Refuses an output that cannot become a file, or that is the input, before work is spent on it.
pub(crate) fn check_writable(path: &Path, input: &Path) -> Result<(), Failure> {
    check(path, &folder_of(path))?;
    match (path.canonicalize(), input.canonicalize()) {
        (Ok(output), Ok(input)) if output == input => {
            Err(Failure::Usage(format!("{}: this is the input; another name is needed for -o", path.display())))
        }
        _ => Ok(()),
    }
}

fn check(path: &Path, folder: &Path) -> Result<(), Failure> {
    if !folder.is_dir() {
        let shown = folder.display();
        return Err(Failure::Io(format!("{}: the folder {shown} does not exist; create it first", path.display())));
    }
    if path.is_dir() {
        return Err(Failure::Io(format!("{}: this is a folder; a file name is needed", path.display())));
    }
    Ok(())
}

fn folder_of(path: &Path) -> PathBuf {
    match path.parent() {
        Some(folder) if folder != Path::new("") => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

fn temporary(folder: &Path) -> std::io::Result<NamedTempFile> {
    let mut builder = Builder::new();
    builder.prefix(".barchan-");
    // A temporary file is private by default; this one is going to be a result like any other.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}
