//! The two files of a blade, structural table and geometry, that belong together.

use std::fs;
use std::path::{Path, PathBuf};

use super::Source;
use crate::document::read_text;
use crate::exchange::problem::ExchangeProblem;

/// The file of the folder of `file` with an ending and a content: the one with the same stem, or
/// the only one. `None` if there is none, or if there are several.
pub(super) fn beside(file: &Path, ending: &str, is_it: fn(&str) -> bool) -> Option<Source> {
    let source = |path: PathBuf| {
        let text = read_text(&path).ok().filter(|text| is_it(text))?;
        Some(Source { path, text })
    };
    if let Some(same) = source(file.with_extension(ending)) {
        return Some(same);
    }
    let mut all = candidates(file, ending).into_iter().filter_map(source);
    let only = all.next()?;
    all.next().is_none().then_some(only)
}

/// Other files of the folder of `file` with an ending.
fn candidates(file: &Path, ending: &str) -> Vec<PathBuf> {
    let folder = match file.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let has_ending = |path: &PathBuf| {
        let found = path.extension().and_then(|found| found.to_str());
        found.is_some_and(|found| found.eq_ignore_ascii_case(ending)) && path != file
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut all: Vec<_> = entries
        .map(|entry| entry.path())
        .filter(has_ending)
        .collect();
    all.sort();
    all
}

/// The files that could belong to `file`, as text.
fn found(file: &Path, ending: &str) -> String {
    let names = candidates(file, ending);
    let names = names.iter().filter_map(|path| path.file_name()?.to_str());
    let names: Vec<_> = names.map(|name| format!("\"{name}\"")).collect();
    if names.is_empty() {
        format!("no .{ending} file")
    } else {
        format!("several .{ending} files: {}", names.join(", "))
    }
}

/// Description of the way from one file to the other.
const TOGETHER: &str = "give the turbine file (.trb), which names both files, or put both into \
                        one folder with the same name, as in blade.bld and blade.str";

/// The problem that a table of parts of the chord has no chord.
pub(super) fn without_chord(file: &Path) -> ExchangeProblem {
    ExchangeProblem::Other {
        what: "the chord, of which centers and radii of gyration of the table are parts".to_owned(),
        found: format!("{} next to this file", found(file, "bld")),
        expected: "the geometry of the blade in a .bld file".to_owned(),
        help: TOGETHER.to_owned(),
    }
}

/// The problem that a table of matrices has no length.
pub(super) fn without_line(file: &Path) -> ExchangeProblem {
    ExchangeProblem::Other {
        what: "the length of the blade (a structural file of QBlade has parts of it only)"
            .to_owned(),
        found: format!("{} next to this file", found(file, "bld")),
        expected: "the geometry of the blade in a .bld file".to_owned(),
        help: format!("{TOGETHER}; or give --length METERS for a straight blade without twist"),
    }
}

/// The problem that a geometry has no properties.
pub(super) fn without_structure(file: &Path) -> ExchangeProblem {
    ExchangeProblem::Other {
        what: "the properties of the sections (a .bld file has chord, twist and airfoils only)"
            .to_owned(),
        found: format!("{} with a blade next to this file", found(file, "str")),
        expected: "the structural table of the blade in a .str file".to_owned(),
        help: TOGETHER.to_owned(),
    }
}

/// The problem that a rotor turns the other way.
pub(super) fn reversed(value: &str) -> ExchangeProblem {
    ExchangeProblem::Other {
        what: "ROTATIONALDIR".to_owned(),
        found: format!("\"{value}\""),
        expected: "0, the standard direction of rotation".to_owned(),
        help: "the axes of a reversed blade are mirrored: export the turbine with the standard \
               direction"
            .to_owned(),
    }
}
