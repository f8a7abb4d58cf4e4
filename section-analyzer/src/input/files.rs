//! The files named in a section input, read once and kept for the fingerprint.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use shared_geom::document::Document;
use shared_geom::files::{names_beside, read_bytes};
use shared_geom::hash::sha256_of;
use shared_geom::mesh_file;

use super::problem::InputProblem;
use super::regions::Written;

/// All files, in the order of reading.
#[derive(Debug)]
pub(super) struct Files<'a> {
    document: &'a Document,
    contents: Vec<Vec<u8>>,
}

impl<'a> Files<'a> {
    /// Starts with the text of the input itself.
    pub fn new(document: &'a Document, text: &str) -> Self {
        Self {
            document,
            contents: vec![text.as_bytes().to_vec()],
        }
    }

    /// The path of a file named in the input.
    pub fn path(&self, written: &Written) -> PathBuf {
        self.document.path(&written.text)
    }

    /// The content of the file at `path`; a failure is noted at the line of its name.
    pub fn read(&mut self, what: &'static str, path: &Path, written: &Written) -> Option<&[u8]> {
        match read_bytes(path) {
            Ok(bytes) => {
                self.contents.push(bytes);
                self.contents.last().map(Vec::as_slice)
            }
            Err(error)
                if error.kind() == ErrorKind::NotFound
                    && self.has_no_folder(what, path, written) =>
            {
                None
            }
            Err(error) => {
                let known = match error.kind() {
                    ErrorKind::NotFound => beside(what, path),
                    _ => Vec::new(),
                };
                let reason = match error.kind() {
                    ErrorKind::NotFound => "no such file".to_owned(),
                    ErrorKind::PermissionDenied => "permission denied".to_owned(),
                    ErrorKind::IsADirectory => "it is a folder".to_owned(),
                    _ => error.to_string(),
                };
                self.unreadable((what, path), written, reason, known);
                None
            }
        }
    }

    /// Notes a file whose folder does not exist.
    fn has_no_folder(&self, what: &str, path: &Path, written: &Written) -> bool {
        let names = [what, &*written.text];
        self.document
            .is_in_missing_folder(written.line, names, path)
    }

    /// As [`Files::read`], for a file that must be text.
    pub fn read_text(
        &mut self,
        what: &'static str,
        path: &Path,
        written: &Written,
    ) -> Option<String> {
        let text = String::from_utf8(self.read(what, path, written)?.to_vec());
        if text.is_err() {
            let reason = "not a text file in UTF-8".to_owned();
            self.unreadable((what, path), written, reason, Vec::new());
        }
        text.ok()
    }

    fn unreadable(
        &self,
        (what, path): (&'static str, &Path),
        written: &Written,
        reason: String,
        known: Vec<String>,
    ) {
        let problem = InputProblem::Unreadable {
            what,
            file: path.display().to_string(),
            reason,
            known,
        };
        self.document.note(written.line, &problem);
    }

    /// The fingerprint of all files.
    pub fn hash(&self) -> String {
        let parts: Vec<_> = self.contents.iter().map(Vec::as_slice).collect();
        sha256_of(&parts)
    }
}

/// The files beside a missing one; for a mesh only meshes, in any format.
fn beside(what: &str, path: &Path) -> Vec<String> {
    let mut names = names_beside(path);
    names.retain(|name| what != "mesh" || mesh_file::has_ending(name));
    names
}
