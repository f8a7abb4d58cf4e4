//! Names of runs in a figure: its title, and the names in the legend.

use std::path::Path;

use crate::output::TimeTable;

/// Largest number of models in a title.
const MOST_TITLES: usize = 3;

/// The models of `tables`, each once.
pub(super) fn title(tables: &[TimeTable]) -> String {
    let mut titles: Vec<&str> = Vec::new();
    for table in tables {
        if !titles.contains(&table.title.as_str()) {
            titles.push(&table.title);
        }
    }
    let more = titles.len().saturating_sub(MOST_TITLES);
    titles.truncate(MOST_TITLES);
    match more {
        0 => titles.join(" / "),
        more => format!("{} and {more} more", titles.join(" / ")),
    }
}

/// A name for each run: the name of the file, with its ending or with as many folders as distinguish
/// the runs.
pub(super) fn runs(tables: &[TimeTable]) -> Vec<String> {
    let paths: Vec<_> = tables.iter().map(|table| Path::new(&table.file)).collect();
    let depth = paths.iter().map(|path| path.components().count()).max();
    let mut names: Vec<_> = paths.iter().map(|path| TimeTable::run_name(path)).collect();
    for folders in 0..depth.unwrap_or(0) {
        if is_distinct(&names) {
            return names;
        }
        let of_folders = |path: &Path| match folders {
            0 => path.file_name().unwrap_or_default().into(),
            _ => last_folders(path, folders).join(TimeTable::run_name(path)),
        };
        let found = paths.iter().map(|path| of_folders(path));
        names = found.map(|path| path.display().to_string()).collect();
    }
    if !is_distinct(&names) {
        names = paths.iter().map(|path| TimeTable::run_name(path)).collect();
    }
    names
}

fn is_distinct(names: &[String]) -> bool {
    let is_first = |k: usize| !names[..k].contains(&names[k]);
    (0..names.len()).all(is_first)
}

/// The last folders above the file at `path`, without the common folder of results.
fn last_folders(path: &Path, count: usize) -> std::path::PathBuf {
    let parent = path.parent().unwrap_or(Path::new(""));
    let folders: Vec<_> = parent.components().collect();
    folders[folders.len().saturating_sub(count)..]
        .iter()
        .filter(|folder| folder.as_os_str() != "results")
        .collect()
}
