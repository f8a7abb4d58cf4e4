//! One run at a time on the files of one name: a lock that ends with its process.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read, Seek, Write};
use std::path::{Path, PathBuf};

use crate::files::OutputProblem;

/// Attempts to lock a file that is removed by another run at the same time.
const ATTEMPTS: usize = 10;

/// The lock of a run. The system releases it at the end of the process, so that a file that is
/// left by a killed run does not lock anything.
#[derive(Debug)]
pub struct RunLock {
    path: PathBuf,
    /// `None` where there are no locks.
    file: Option<File>,
}

impl RunLock {
    /// Locks the file at `path`, in a folder that exists. Where it cannot be written, nothing is
    /// locked: results cannot be written there either.
    ///
    /// # Errors
    /// [`OutputProblem::InUse`] if another run has it.
    pub fn new(path: &Path) -> Result<Self, OutputProblem> {
        for _ in 0..ATTEMPTS {
            let Ok(mut file) = open(path) else {
                return Ok(Self::none(path));
            };
            match file.try_lock() {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Err(in_use(path, &mut file)),
                Err(TryLockError::Error(_)) => return Ok(Self::none(path)),
            }
            // A full disk does not take the number, which is for messages alone.
            let _ = file
                .set_len(0)
                .and_then(|()| writeln!(file, "{}", std::process::id()));
            if is_same(path, &file) {
                let path = path.to_owned();
                let file = Some(file);
                return Ok(Self { path, file });
            }
        }
        Err(OutputProblem::InUse {
            file: path.display().to_string(),
            process: None,
        })
    }

    fn none(path: &Path) -> Self {
        Self {
            path: path.to_owned(),
            file: None,
        }
    }
}

impl Drop for RunLock {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.path);
        if let Some(file) = &self.file {
            let _ = file.unlock();
        }
    }
}

fn open(path: &Path) -> std::io::Result<File> {
    let mut options = OpenOptions::new();
    options.read(true).write(true).create(true).truncate(false);
    options.open(path)
}

/// The problem of a locked file, with the process that it names.
fn in_use(path: &Path, file: &mut File) -> OutputProblem {
    let mut text = String::new();
    let read = file.rewind().and_then(|()| file.read_to_string(&mut text));
    let process = read.ok().and_then(|_| text.trim().parse().ok());
    OutputProblem::InUse {
        file: path.display().to_string(),
        process,
    }
}

/// Whether the file at `path` is still the open one: an ending run may have removed it.
#[cfg(unix)]
fn is_same(path: &Path, file: &File) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (std::fs::metadata(path), file.metadata()) {
        (Ok(there), Ok(here)) => there.dev() == here.dev() && there.ino() == here.ino(),
        _ => false,
    }
}

/// Whether the file at `path` is still the open one: open files are not removed here.
#[cfg(not(unix))]
fn is_same(path: &Path, _: &File) -> bool {
    path.exists()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_second_run_is_refused_and_a_left_file_is_not_a_lock() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.transient.lock");
        // A file of a process that no longer exists.
        std::fs::write(&path, "4194304999\n").unwrap();
        let first = RunLock::new(&path).unwrap();
        let second = RunLock::new(&path).unwrap_err();
        let process = Some(std::process::id());
        let file = path.display().to_string();
        assert_eq!(second, OutputProblem::InUse { file, process });
        drop(first);
        assert!(!path.exists());
        drop(RunLock::new(&path).unwrap());
    }

    /// Results are refused there by their own messages.
    #[test]
    fn a_folder_that_does_not_exist_has_no_lock() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("none/x.transient.lock");
        assert!(RunLock::new(&path).is_ok());
    }
}
