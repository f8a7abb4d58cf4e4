//! The main file of OpenFAST, `NAME.fst`, which names the files of the blade: of BeamDyn
//! or of ElastoDyn, as `CompElast` selects.

use std::path::Path;

use crate::document::read_text;
use crate::error::Diagnostics;

use super::named::{companion, missing, named};
use super::problem::{ExchangeProblem, Problems};
use super::{Options, Reading, beamdyn, elastodyn};

/// Names of BeamDyn's primary file of each blade.
const BEAMDYN: [&str; 3] = ["BDBldFile(1)", "BDBldFile(2)", "BDBldFile(3)"];

/// Whether `text` is a main file.
pub(super) fn recognize(text: &str) -> bool {
    named(text, &["CompElast"]).is_some() || named(text, &["EDFile"]).is_some()
}

/// Reads the blade that the file leads to: of several, the first.
///
/// # Errors
/// All errors of the file, or of the files that it leads to.
pub(super) fn read(text: &str, file: &Path, options: &Options) -> Result<Reading, Diagnostics> {
    let mut problems = Problems::new(&file.display().to_string());
    let is_beamdyn = is_beamdyn(text, &mut problems);
    let names = match is_beamdyn {
        Some(true) => &BEAMDYN[..1],
        _ => &["EDFile"],
    };
    let path = companion(text, names, file, &mut problems);
    let (is_beamdyn, path) = problems.finish(is_beamdyn.zip(path))?;
    let inner = read_text(&path)?;
    let (module, mut reading) = if is_beamdyn {
        ("BeamDyn", beamdyn::read(&inner, &path, options)?)
    } else {
        ("ElastoDyn", elastodyn::read(&inner, &path, options)?)
    };
    reading.remarks.insert(
        0,
        format!(
            "the blade is read from the file of {module}, as CompElast selects: {}",
            path.display()
        ),
    );
    let files = BEAMDYN.map(|name| named(text, &[name]).map(|found| found.value));
    if is_beamdyn && files.iter().flatten().any(|file| Some(*file) != files[0]) {
        reading
            .remarks
            .push("the blades have different files: blade 1 is read".to_owned());
    }
    Ok(reading)
}

/// Whether the blade is of BeamDyn, by the value of `CompElast`.
fn is_beamdyn(text: &str, problems: &mut Problems) -> Option<bool> {
    let Some(found) = named(text, &["CompElast"]) else {
        problems.push(0, &missing("CompElast"));
        return None;
    };
    match found.value {
        "1" | "3" => Some(false),
        "2" => Some(true),
        other => {
            problems.push(
                found.line,
                &ExchangeProblem::Other {
                    what: "CompElast".to_owned(),
                    found: format!("\"{other}\""),
                    expected: "1 or 3 (ElastoDyn), or 2 (BeamDyn)".to_owned(),
                    help: "correct the switch".to_owned(),
                },
            );
            None
        }
    }
}

#[cfg(test)]
mod tests;
