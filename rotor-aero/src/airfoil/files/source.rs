//! Texts of files.

use std::path::Path;

use shared_geom::document::read_text;
use shared_geom::error::Diagnostics;
use shared_geom::files::read_bytes;

/// The text of a file; bytes that are no UTF-8, as in old comments, are replaced.
///
/// # Errors
/// A file that cannot be read.
pub(super) fn text_of(path: &Path) -> Result<String, Diagnostics> {
    match read_bytes(path) {
        Ok(bytes) => Ok(String::from_utf8_lossy(&bytes).into_owned()),
        // The message with the files beside it.
        Err(_) => read_text(path),
    }
}
