//! Files that a document names in folders that do not exist: one message for each folder.

use std::path::Path;

use super::{Document, DocumentProblem};
use crate::error::Diagnostics;
use crate::files::MissingFolder;

/// A missing folder, and the first key that names a file in it.
#[derive(Debug)]
pub(super) struct Absent {
    folder: MissingFolder,
    line: usize,
    key: String,
    name: String,
    /// Number of further files.
    others: usize,
}

impl Document {
    /// Whether the folder of `path`, the file that `key` on `line` names as `written`, does not exist;
    /// this is noted, once for all files in it.
    pub fn is_in_missing_folder(
        &self,
        line: usize,
        [key, written]: [&str; 2],
        path: &Path,
    ) -> bool {
        let Some(folder) = MissingFolder::before(path) else {
            return false;
        };
        let mut absent = self.absent.borrow_mut();
        match absent.iter_mut().find(|known| known.folder == folder) {
            Some(known) => known.others += 1,
            None => absent.push(Absent {
                folder,
                line,
                key: key.to_owned(),
                name: written.to_owned(),
                others: 0,
            }),
        }
        true
    }

    /// Adds the missing folders to the problems.
    pub(super) fn note_folders(&self, problems: &mut Diagnostics) {
        for absent in self.absent.take() {
            let problem = DocumentProblem::NoFolder {
                key: absent.key,
                name: absent.name,
                folder: absent.folder,
                others: absent.others,
            };
            problems.push(self.location(absent.line), &problem);
        }
    }
}
