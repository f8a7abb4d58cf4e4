//! Makes the build id of the program, `SECTION_ANALYZER_BUILD`: a fingerprint of its
//! sources, the versions of its dependencies, and the settings of its compilation.
//!
//! Two programs with the same id give the same results; a program built from changed
//! sources has another id. Only files next to this one are read, so that the id is
//! available without git, and in a package as in the workspace.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use sha2::{Digest, Sha256};

/// Files on which the results depend, relative to the folder of this file. Files that do
/// not exist are ignored (a package has its own list of versions).
const SOURCES: [&str; 7] = [
    "src",
    "Cargo.toml",
    "Cargo.lock",
    "../shared-geom/src",
    "../shared-geom/Cargo.toml",
    "../Cargo.toml",
    "../Cargo.lock",
];

/// Compiler settings that can change the last digits.
const SETTINGS: [&str; 5] = [
    "TARGET",
    "OPT_LEVEL",
    "CARGO_CFG_TARGET_FEATURE",
    "CARGO_CFG_DEBUG_ASSERTIONS",
    "CARGO_ENCODED_RUSTFLAGS",
];

fn main() {
    let mut hasher = Sha256::new();
    for source in SOURCES.map(Path::new).into_iter().filter(|at| at.exists()) {
        println!("cargo::rerun-if-changed={}", source.display());
        for file in files_in(source) {
            let content = fs::read(&file).unwrap_or_default();
            add(&mut hasher, file.to_string_lossy().as_bytes());
            add(&mut hasher, &content);
        }
    }
    for setting in SETTINGS {
        let value = env::var(setting).unwrap_or_default();
        add(&mut hasher, value.as_bytes());
    }
    add(&mut hasher, &compiler());
    let digits = hasher.finalize();
    let id: String = digits.iter().map(|byte| format!("{byte:02x}")).collect();
    println!("cargo::rustc-env=SECTION_ANALYZER_BUILD={id}");
}

/// Adds a part with its length, so that parts stay distinct.
fn add(hasher: &mut Sha256, part: &[u8]) {
    hasher.update((part.len() as u64).to_le_bytes());
    hasher.update(part);
}

/// The file `at`, or all files of this folder and its subfolders, in order.
fn files_in(at: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(at) else {
        return vec![at.to_owned()];
    };
    let mut inside: Vec<_> = entries.filter_map(Result::ok).collect();
    inside.sort_by_key(fs::DirEntry::path);
    inside
        .iter()
        .flat_map(|entry| files_in(&entry.path()))
        .collect()
}

/// The name of the compiler and its version.
fn compiler() -> Vec<u8> {
    let program = env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    let reported = Command::new(program).arg("-vV").output();
    reported.map(|reported| reported.stdout).unwrap_or_default()
}
