//! The cases in `cases/dynamics`, computed unchanged or with a change of their text.

use std::path::{Path, PathBuf};

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::result::FrequencyTable;

/// A copy of the folder of a case.
pub struct Case {
    folder: tempfile::TempDir,
}

impl Case {
    /// The case `name`.
    pub fn new(name: &str) -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = tempfile::tempdir().unwrap();
        for entry in std::fs::read_dir(root.join("cases/dynamics").join(name)).unwrap() {
            let entry = entry.unwrap();
            if entry.file_type().unwrap().is_file() {
                std::fs::copy(entry.path(), folder.path().join(entry.file_name())).unwrap();
            }
        }
        Self { folder }
    }

    /// Path of a file of the copy.
    pub fn path(&self, file: &str) -> PathBuf {
        self.folder.path().join(file)
    }

    /// Replaces a text of a file, which must be there.
    pub fn replace(&self, file: &str, old: &str, new: &str) {
        let text = std::fs::read_to_string(self.path(file)).unwrap();
        assert!(text.contains(old), "{file} has no \"{old}\"");
        std::fs::write(self.path(file), text.replace(old, new)).unwrap();
    }

    /// Modes requested by a dynamics file.
    pub fn modes(&self, file: &str) -> FrequencyTable {
        table(&self.path(file))
    }
}

/// Modes requested by the dynamics file at `path`.
pub fn table(path: &Path) -> FrequencyTable {
    let input = beam_dynamics::input::read(path).unwrap_or_else(|problems| panic!("{problems}"));
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome.table
}

/// Frequency \[Hz\] of the mode `name` at speed index `speed`.
pub fn frequency(table: &FrequencyTable, name: &str, speed: usize) -> f64 {
    let branch = table.branches.iter().find(|branch| branch.name == name);
    let branch = branch.unwrap_or_else(|| panic!("no mode \"{name}\""));
    branch.points[speed].as_ref().unwrap().frequency
}
