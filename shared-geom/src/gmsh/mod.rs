//! Mesh files of gmsh: MSH 2.2 and 4.1, ascii.
//!
//! [`read`] goes once through the lines of a file, keeps what a plane section
//! mesh is made of (physical groups, nodes, points, lines, triangles,
//! quadrilaterals) and skips the sections that it does not know. References
//! between the parts are resolved at the end, so that all problems of a file are
//! told together. [`write()`] gives MSH 4.1.
//!
//! An element of an entity that stands reversed in its physical group (negative
//! tag) is reversed on reading, as gmsh does itself when it writes MSH 2.2:
//! `Physical Curve("skin") = {-1, 2}` gives lines that run on through both curves.
//!
//! # References
//! - Gmsh reference manual, sections "MSH file format" (4.1) and
//!   "MSH file format version 2 (Legacy)" (2.2).

mod build;
mod cursor;
mod element;
mod problem;
mod read22;
mod read41;
mod sections;
mod write41;

use std::path::Path;

use crate::error::{Diagnostics, Place};
use crate::mesh::Mesh;

use problem::ReadProblem;

pub use write41::write;

/// Reads the mesh in `text`, the content of a gmsh file of version 2.2 or 4.1
/// in ascii; `file` is the name for messages.
///
/// # Errors
/// Everything that is wrong with the file (about the first twenty problems),
/// each with its line.
pub fn read(text: &str, file: &str) -> Result<Mesh, Diagnostics> {
    sections::read(text, file)
}

/// Reads the mesh in the file at `path`; see [`read`].
///
/// # Errors
/// As [`read`]; also a file that cannot be read or is not text.
pub fn read_file(path: &Path) -> Result<Mesh, Diagnostics> {
    let file = path.display().to_string();
    let whole = |problem| Diagnostics::one(Place::file(&file), &problem);
    let bytes =
        std::fs::read(path).map_err(|error| whole(ReadProblem::Unreadable(error.to_string())))?;
    match std::str::from_utf8(&bytes) {
        Ok(text) => read(text, &file),
        Err(error) => {
            let (before, _) = bytes.split_at(error.valid_up_to());
            let text = String::from_utf8_lossy(before);
            Err(not_text(&text, &file))
        }
    }
}

/// The problem of a file whose text ends, after `before`, in bytes that are no
/// text: a binary mesh, or names in another encoding.
fn not_text(before: &str, file: &str) -> Diagnostics {
    match sections::format(before) {
        Err((line, problem @ ReadProblem::Binary)) => {
            Diagnostics::one(Place::line(file, line), &problem)
        }
        _ => Diagnostics::one(
            Place::line(file, before.lines().count().max(1)),
            &ReadProblem::NotText,
        ),
    }
}

#[cfg(test)]
mod malformed_tests;
#[cfg(test)]
mod read_tests;
#[cfg(test)]
mod write_tests;
