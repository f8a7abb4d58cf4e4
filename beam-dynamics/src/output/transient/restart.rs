//! The file from which a run continues.

use std::path::Path;

use serde_json::error::Category;
use shared_geom::file_kind::FileKind;
use shared_geom::files::read_bytes;

use super::RunFileProblem;
use super::writer::{cannot_read, cannot_write};
use crate::result::Snapshot;

/// Writes a snapshot, numbers as the shortest text that is read as the same bits. An existing file
/// is replaced when the new one is complete, so that one of the two remains if the run is killed.
///
/// # Errors
/// [`RunFileProblem::Output`].
pub fn write_snapshot(snapshot: &Snapshot, path: &Path) -> Result<(), RunFileProblem> {
    let text = serde_json::to_string(snapshot)
        .map_err(|error| cannot_write(path, &std::io::Error::other(error)))?;
    let new = path.with_extension("json.new");
    std::fs::write(&new, text)
        .and_then(|()| std::fs::rename(&new, path))
        .map_err(|error| cannot_write(path, &error))
}

/// Reads a snapshot.
///
/// # Errors
/// [`RunFileProblem::Unreadable`].
pub fn read_snapshot(path: &Path) -> Result<Snapshot, RunFileProblem> {
    let bytes = read_bytes(path).map_err(|error| cannot_read(path, &error))?;
    parse_snapshot(&bytes, path)
}

/// The snapshot in the content of the file at `path`.
///
/// # Errors
/// [`RunFileProblem::Unreadable`].
pub fn parse_snapshot(bytes: &[u8], path: &Path) -> Result<Snapshot, RunFileProblem> {
    serde_json::from_slice(bytes).map_err(|error| RunFileProblem::Unreadable {
        file: path.display().to_string(),
        reason: reason(&error, bytes, path),
        remedy: "name a file NAME.restart.json that transient wrote",
    })
}

/// The reason for which the content of the file at `path` is no snapshot.
fn reason(error: &serde_json::Error, bytes: &[u8], path: &Path) -> String {
    let kind = FileKind::of(path, &String::from_utf8_lossy(bytes));
    let location = format!("line {}, column {}", error.line(), error.column());
    match (kind, error.classify()) {
        (Some(FileKind::Restart), Category::Eof) => "the restart file ends early".to_owned(),
        (Some(FileKind::Restart), _) => format!("the restart file is damaged at {location}"),
        (Some(kind), _) => format!("it is {}, expected a restart file", kind.words()),
        (None, Category::Data) => "it is not a restart file, but other JSON".to_owned(),
        (None, _) => "it is not a restart file: it is not JSON".to_owned(),
    }
}
