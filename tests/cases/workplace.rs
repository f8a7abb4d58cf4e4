//! Copies of the cases, and the programs run in them.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::TempDir;

/// The commands name files relative to the working folder, of which a process has one.
static WORKING_FOLDER: Mutex<()> = Mutex::new(());

/// A copy of a folder of the repository, in which commands run.
pub struct Workplace {
    _guard: MutexGuard<'static, ()>,
    copy: TempDir,
}

/// Result of a command.
pub struct Run {
    pub code: u8,
    pub out: String,
    pub err: String,
}

/// The top folder of the repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let (path, name) = (entry.path(), entry.file_name());
        if path.is_dir() && name != "results" {
            copy(&path, &to.join(name));
        } else if path.is_file() {
            std::fs::copy(path, to.join(name)).unwrap();
        }
    }
}

impl Workplace {
    /// A copy of these folders of the repository, with the working folder in `inner`.
    pub fn new(folders: &[&str], inner: &str) -> Self {
        // A test that failed in its copy has no effect on others.
        let guard = WORKING_FOLDER
            .lock()
            .unwrap_or_else(PoisonError::into_inner);
        let workplace = tempfile::tempdir().unwrap();
        for folder in folders {
            copy(&root().join(folder), &workplace.path().join(folder));
        }
        std::env::set_current_dir(workplace.path().join(inner)).unwrap();
        Self {
            _guard: guard,
            copy: workplace,
        }
    }

    /// The copy of a file of the repository.
    pub fn path(&self, file: &str) -> PathBuf {
        self.copy.path().join(file)
    }

    /// Runs a command as typed; words with spaces are in double quotes.
    pub fn run(&self, command: &str) -> Run {
        let words: Vec<OsString> = words(command).into_iter().map(OsString::from).collect();
        let (mut out, mut err) = (Vec::new(), Vec::new());
        let code = match words[0].to_str() {
            Some("section-analyzer") => section_analyzer::cli::run(words, &mut out, &mut err),
            Some("beam-dynamics") => beam_dynamics::cli::run(words, &mut out, &mut err),
            _ => panic!("{command}: not a program of ours"),
        };
        Run {
            code,
            out: String::from_utf8(out).unwrap(),
            err: String::from_utf8(err).unwrap(),
        }
    }
}

impl Drop for Workplace {
    fn drop(&mut self) {
        // Some systems cannot remove the copy from within it.
        let _ = std::env::set_current_dir(root());
    }
}

/// The words of a command line.
fn words(command: &str) -> Vec<String> {
    let quoted = command.split('"').enumerate();
    let words = quoted.flat_map(|(i, piece)| match i % 2 {
        0 => piece.split_whitespace().map(str::to_owned).collect(),
        _ => vec![piece.to_owned()],
    });
    words.collect()
}
