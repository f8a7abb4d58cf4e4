//! Results of an earlier run, listed before a run to find those that it removes.

use std::path::{Path, PathBuf};

/// Endings of files that exist only during a run.
const OF_RUNS: [&str; 2] = [".lock", ".part"];

/// Files and folders that exist before a run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Earlier(Vec<PathBuf>);

impl Earlier {
    /// The results `NAME.*` in `folder`, in order.
    pub fn new(folder: &Path, name: &str) -> Self {
        let begin = format!("{name}.");
        let is_result = |path: &PathBuf| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with(&begin) && !OF_RUNS.iter().any(|ending| name.ends_with(ending))
        };
        let entries = std::fs::read_dir(folder);
        let entries = entries.into_iter().flatten().flatten();
        let paths = entries.map(|entry| entry.path());
        let mut found: Vec<_> = paths.filter(is_result).collect();
        found.sort();
        Self(found)
    }

    /// The same with further `files`, if they exist.
    pub fn with(mut self, files: impl IntoIterator<Item = PathBuf>) -> Self {
        self.0
            .extend(files.into_iter().filter(|file| file.exists()));
        self
    }

    /// Those that no longer exist.
    pub fn removed(self) -> Vec<PathBuf> {
        let mut files = self.0;
        files.retain(|file| !file.exists());
        files
    }
}

/// The list of `removed` results, for a report; empty without any.
pub fn removed_text(removed: &[PathBuf]) -> String {
    if removed.is_empty() {
        return String::new();
    }
    let lines = removed.iter().map(|file| format!("  {}\n", file.display()));
    "\nRemoved: results of an earlier run\n".to_owned() + &lines.collect::<String>()
}

/// A remark on each of the `removed` results, for a run without a report.
pub fn removed_remarks(removed: &[PathBuf]) -> impl Iterator<Item = String> {
    let remark = |file: &PathBuf| format!("removed: {}, of an earlier run", file.display());
    removed.iter().map(remark)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_that_a_run_removes_are_found() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let all = ["a.txt", "a.csv", "a.run.lock", "ab.txt", "other.dat"];
        for name in all {
            std::fs::write(at(name), "").unwrap();
        }
        let earlier = Earlier::new(folder.path(), "a").with(["other.dat", "absent"].map(at));
        assert_eq!(earlier.0, ["a.csv", "a.txt", "other.dat"].map(at));
        assert_eq!(earlier.clone().removed(), [""; 0].map(at));
        for name in all {
            std::fs::remove_file(at(name)).unwrap();
        }
        std::fs::write(at("a.csv"), "").unwrap();
        let removed = earlier.removed();
        assert_eq!(removed, ["a.txt", "other.dat"].map(at));
        let names = ["b", "c"].map(PathBuf::from);
        let expected = "\nRemoved: results of an earlier run\n  b\n  c\n";
        assert_eq!(removed_text(&names), expected);
        assert_eq!(removed_text(&[]), "");
        let first = removed_remarks(&names).next();
        assert_eq!(first.as_deref(), Some("removed: b, of an earlier run"));
    }
}
