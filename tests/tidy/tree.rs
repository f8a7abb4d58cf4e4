//! The files of the repository, input of every rule.

use std::fs;
use std::path::Path;

use crate::source;

/// Folders that are not part of the tree, at any depth.
const SKIPPED: [&str; 3] = ["target", ".git", "out"];

/// A text file of the repository.
pub struct File {
    /// Path from the root of the repository, with forward slashes.
    pub path: String,
    /// The text, unchanged.
    pub text: String,
    /// Rust only: the text with comments, strings and characters blanked out.
    pub code: String,
    /// Rust only: for each line, whether it is compiled for tests only.
    pub is_test: Vec<bool>,
}

impl File {
    /// The file with this path and text.
    pub fn new(path: &str, text: &str) -> Self {
        let (mut code, mut is_test) = (String::new(), Vec::new());
        if path.ends_with(".rs") {
            code = source::blank(text);
            is_test = source::test_lines(&code);
            if is_test_path(path) {
                is_test.fill(true);
            }
        }
        Self {
            path: path.to_owned(),
            text: text.to_owned(),
            code,
            is_test,
        }
    }

    /// Whether this is a Rust source.
    pub fn is_rust(&self) -> bool {
        self.path.ends_with(".rs")
    }

    /// Whether this is a Markdown page.
    pub fn is_markdown(&self) -> bool {
        self.path.ends_with(".md")
    }

    /// `path:line: message`, with the line counted from zero.
    pub fn breach(&self, line: usize, message: &str) -> String {
        format!("{}:{}: {message}", self.path, line + 1)
    }

    /// Lines of blanked code that are not for tests only: number (from zero) and text.
    pub fn program_lines(&self) -> impl Iterator<Item = (usize, &str)> {
        self.code
            .lines()
            .enumerate()
            .filter(|(line, _)| !self.is_test[*line])
    }
}

/// Whether the whole file is for tests: a folder `tests`, `tests.rs`, `*_tests.rs`.
fn is_test_path(path: &str) -> bool {
    path.starts_with("tests/")
        || path.contains("/tests/")
        || path.ends_with("/tests.rs")
        || path.ends_with("_tests.rs")
}

/// All text files of the repository, in the order of their paths.
pub struct Tree {
    /// The text files.
    pub files: Vec<File>,
    /// Paths of all files and folders, text or not, from the root.
    pub paths: Vec<String>,
}

impl Tree {
    /// Reads the repository.
    pub fn read() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        let mut tree = Self {
            files: Vec::new(),
            paths: Vec::new(),
        };
        tree.walk(&root, &root);
        tree.files.sort_by(|a, b| a.path.cmp(&b.path));
        tree.paths.sort();
        tree
    }

    /// A tree of these files only, for the tests of the rules.
    #[cfg(test)]
    pub fn of(files: &[(&str, &str)]) -> Self {
        Self {
            files: files.iter().map(|(p, t)| File::new(p, t)).collect(),
            paths: files.iter().map(|(p, _)| (*p).to_owned()).collect(),
        }
    }

    /// The file at `path`.
    pub fn file(&self, path: &str) -> Option<&File> {
        self.files.iter().find(|file| file.path == path)
    }

    /// Whether there is a file or folder at `path`.
    pub fn has(&self, path: &str) -> bool {
        let path = path.trim_end_matches('/');
        self.paths.iter().any(|p| p == path)
    }

    /// The Rust sources below `folder`.
    pub fn rust_below(&self, folder: &str) -> impl Iterator<Item = &File> {
        let start = format!("{folder}/");
        self.files
            .iter()
            .filter(move |file| file.is_rust() && file.path.starts_with(&start))
    }

    fn walk(&mut self, folder: &Path, root: &Path) {
        let entries = fs::read_dir(folder).expect("a folder of the repository is readable");
        for entry in entries {
            let path = entry.expect("an entry of a folder is readable").path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if SKIPPED.contains(&name.as_ref()) {
                continue;
            }
            self.paths.push(below(&path, root));
            if path.is_dir() {
                self.walk(&path, root);
            } else if let Ok(text) = fs::read_to_string(&path) {
                self.files.push(File::new(&below(&path, root), &text));
            }
        }
    }
}

/// `path` from `root`, with forward slashes.
fn below(path: &Path, root: &Path) -> String {
    let rest = path.strip_prefix(root).unwrap_or(path);
    rest.to_string_lossy().replace('\\', "/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_repository_has_its_manifest_and_not_its_build() {
        let tree = Tree::read();
        assert!(tree.file("Cargo.toml").is_some());
        assert!(tree.has("shared-geom/src/"));
        assert!(!tree.paths.iter().any(|p| p.starts_with("target")));
    }

    #[test]
    fn test_files_are_reported_by_their_path() {
        assert!(is_test_path("tests/tidy/main.rs"));
        assert!(is_test_path("shared-geom/src/rotation_tests.rs"));
        assert!(!is_test_path("shared-geom/src/rotation.rs"));
    }
}
