//! Folders and names of the results of each file.

use std::path::{Path, PathBuf};

use shared_geom::error::Explain;
use shared_geom::files::{Earlier, make_folder, removed_remarks, removed_text, true_path};
use shared_geom::run_lock::RunLock;

use super::WRONG_INPUT;
use super::arguments::Results;
use super::terminal::{Message, Terminal};
use crate::input;
use crate::output::ResultLocation;

/// Two files whose results would have the same names.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
pub(super) enum SameResults {
    /// One file.
    #[error("\"{0}\" is given twice, expected it once")]
    SameFile(String),
    /// Two files.
    #[error("results of \"{first}\" and \"{second}\" would both be \"{target}\"")]
    SameName {
        first: String,
        second: String,
        target: String,
    },
}

impl Explain for SameResults {
    fn help(&self) -> Option<String> {
        match self {
            Self::SameFile(_) => None,
            Self::SameName { .. } => {
                Some("give the files different names, or run them one by one".to_owned())
            }
        }
    }
}

/// Folders and names of the results of all files, all different: two files that run at the
/// same time must not overwrite each other, however their folder is written.
///
/// # Errors
/// [`SameResults`]: the first two files with the same results.
pub(super) fn result_locations(
    files: &[PathBuf],
    results: &Results,
) -> Result<Vec<ResultLocation>, SameResults> {
    let locations: Vec<_> = files.iter().map(|file| location(file, results)).collect();
    let keys = locations
        .iter()
        .map(|location| (true_path(&location.folder), location.name.as_str()));
    let keys: Vec<_> = keys.collect();
    for (second, key) in keys.iter().enumerate() {
        if let Some(first) = keys[..second].iter().position(|other| other == key) {
            let ResultLocation { folder, name, .. } = &locations[second];
            let [first, second] = [&files[first], &files[second]];
            if true_path(first) == true_path(second) {
                return Err(SameResults::SameFile(second.display().to_string()));
            }
            return Err(SameResults::SameName {
                first: first.display().to_string(),
                second: second.display().to_string(),
                target: folder.join(format!("{name}.*")).display().to_string(),
            });
        }
    }
    Ok(locations)
}

fn location(file: &Path, results: &Results) -> ResultLocation {
    let beside = || file.parent().unwrap_or(Path::new("")).join("results");
    let folder = results.out.clone().unwrap_or_else(beside);
    ResultLocation::new(folder, input::name_of(file)).with_figures(!results.no_figures)
}

/// Does the work of a command that writes results to `location`, in its folder, which is made, and as
/// the only run of the command there; returns the exit code. Results of an earlier run that are then
/// removed are listed. A folder that is then still empty does not stay.
pub(super) fn in_folder(
    location: &ResultLocation,
    command: &str,
    terminal: &mut Terminal<'_>,
    work: impl FnOnce(&mut Terminal<'_>) -> u8,
) -> u8 {
    let ResultLocation { folder, name, .. } = location;
    let is_new = !folder.exists();
    let lock = make_folder(folder)
        .and_then(|()| RunLock::new(&folder.join(format!("{name}.{command}.lock"))));
    let code = match lock {
        Ok(_lock) => {
            let earlier = Earlier::new(folder, name);
            let code = work(terminal);
            let removed = earlier.removed();
            terminal.show(&removed_text(&removed));
            removed_remarks(&removed).for_each(|text| terminal.take(Message::Remark(text)));
            code
        }
        Err(problem) => {
            terminal.report(&problem);
            WRONG_INPUT
        }
    };
    if is_new {
        // Fails if it has files.
        let _ = std::fs::remove_dir(folder);
    }
    code
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_folder_in_two_ways_is_one_location() {
        let same = |files: [&str; 2], out: Option<&str>| {
            let results = Results {
                out: out.map(PathBuf::from),
                no_figures: false,
            };
            let reported = result_locations(&files.map(PathBuf::from), &results);
            reported.err().map(|problem| problem.to_string())
        };
        let expected = "\"./x.dynamics.toml\" is given twice, expected it once";
        let files = ["x.dynamics.toml", "./x.dynamics.toml"];
        assert_eq!(same(files, None).as_deref(), Some(expected));
        let expected = "results of \"x.dynamics.toml\" and \"./x.toml\" would both be \
                        \"./results/x.*\"";
        let files = ["x.dynamics.toml", "./x.toml"];
        assert_eq!(same(files, None).as_deref(), Some(expected));
        let files = ["a/x.dynamics.toml", "b/x.dynamics.toml"];
        assert_eq!(same(files, None), None);
        assert!(same(files, Some("c")).is_some());
        assert_eq!(same(["a/x.toml", "a/y.toml"], Some("c")), None);
    }
}
