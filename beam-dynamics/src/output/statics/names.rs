//! Names of the files of equilibria, and their removal.

use std::ffi::OsStr;
use std::path::Path;

use crate::output::folder::Results;
use crate::output::span_forces::SpanForces;

pub(super) const TEXT: &str = "static.txt";
pub(super) const DISPLACEMENTS: &str = "displacements.csv";
pub(super) const FORCES: &str = "forces.csv";
pub(super) const REACTIONS: &str = "reactions.csv";
pub(super) const ELECTRODES: &str = "electrodes.csv";
pub(super) const AIR: &str = "air.csv";
pub(super) const AIR_PLOT: [&str; 2] = ["air.png", "air.svg"];
pub(super) const DEFORMED: [&str; 2] = ["deformed.png", "deformed.svg"];
pub(super) const ALONG: [&str; 2] = ["forces.png", "forces.svg"];
pub(super) const PATH: [&str; 2] = ["path.png", "path.svg"];
pub(super) const SERIES: &str = "static.pvd";
/// Folder of the field files.
pub(super) const FIELDS: &str = "static";

pub(super) const SWEEP_TABLE: &str = "sweep.csv";
pub(super) const SWEEP_TEXT: &str = "sweep.txt";
pub(super) const SWEEP_PLOT: [&str; 2] = ["sweep.png", "sweep.svg"];
/// Folder of the files of each value.
pub(super) const SWEEP_FOLDER: &str = "sweep";
/// Endings of the files that a value may have.
const ENDINGS: [&str; 6] = ["txt", "csv", "png", "svg", "pvd", "vtu"];

/// Removes the files of an earlier run, of a load path or of a sweep.
pub(super) fn remove_all(results: &Results<'_>) {
    remove_path(results);
    remove_sweep(results);
}

/// Removes the files of a load path.
fn remove_path(results: &Results<'_>) {
    results.remove([
        TEXT,
        DISPLACEMENTS,
        FORCES,
        REACTIONS,
        ELECTRODES,
        AIR,
        SERIES,
    ]);
    results.remove([DEFORMED, ALONG, AIR_PLOT, PATH].into_iter().flatten());
    results.remove_fields(FIELDS);
    SpanForces::remove_files(results, FIELDS);
}

/// Removes the files of a sweep.
fn remove_sweep(results: &Results<'_>) {
    results.remove([SWEEP_TABLE, SWEEP_TEXT].into_iter().chain(SWEEP_PLOT));
    let folder = results.path(SWEEP_FOLDER);
    let entries = std::fs::read_dir(&folder).into_iter().flatten().flatten();
    for entry in entries.map(|entry| entry.path()) {
        if entry.is_dir() {
            remove_known(&entry);
        }
    }
    remove_known(&folder);
}

/// Removes the files of a folder whose endings a run writes, and the folder if it is then empty.
fn remove_known(folder: &Path) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    for path in entries.map(|entry| entry.path()) {
        let ending = path.extension().and_then(OsStr::to_str);
        if ending.is_some_and(|ending| ENDINGS.contains(&ending)) {
            // A file that is used elsewhere stays.
            let _ = std::fs::remove_file(path);
        }
    }
    let _ = std::fs::remove_dir(folder);
}
