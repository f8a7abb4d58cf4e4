//! `plot`: draws columns of runs in time.

use std::path::{Path, PathBuf};

use shared_geom::error::Explain;
use shared_geom::files::OutputProblem;

use super::terminal::Terminal;
use super::{DONE, NOT_REACHED, WRONG_INPUT};
use crate::output::{RunFileProblem, TimePlot, TimeTable};

/// Endings of the figures.
const ENDINGS: [&str; 2] = ["png", "svg"];

/// `plot RESULT...`
pub(super) fn plot_files(
    results: &[PathBuf],
    columns: &[String],
    across: &str,
    out: Option<&Path>,
    terminal: &mut Terminal<'_>,
) -> u8 {
    if let Some(problem) = out.and_then(other_kind) {
        terminal.tell(&problem);
        return WRONG_INPUT;
    }
    let columns: Vec<_> = columns.iter().map(|name| name.trim().to_owned()).collect();
    let columns = &columns[..];
    let Some(tables) = read(results, terminal) else {
        return WRONG_INPUT;
    };
    // Every wrong name is told, and not only the first.
    let wanted = columns.iter().map(String::as_str).chain([across]);
    let checks = tables
        .iter()
        .flat_map(|table| wanted.clone().map(|name| table.find(name)));
    let wrong: Vec<_> = checks.filter_map(Result::err).collect();
    for problem in &wrong {
        terminal.tell(problem);
    }
    if !wrong.is_empty() {
        return WRONG_INPUT;
    }
    let title = title(&tables);
    let plot = TimePlot::new(&title, &tables, across, columns);
    let plot = match plot.and_then(|plot| plot.check_size().map(|()| plot)) {
        Ok(plot) => plot,
        Err(problem) => {
            terminal.tell(&problem);
            return WRONG_INPUT;
        }
    };
    terminal.show("Written\n");
    for path in targets(&results[0], out) {
        if let Err(problem) = save(&plot, &path) {
            terminal.tell(&problem);
            return NOT_REACHED;
        }
        terminal.show(&format!("  {}\n", path.display()));
    }
    DONE
}

/// A figure of a kind that is not written.
#[derive(Debug, thiserror::Error)]
#[error("\"{file}\" ends in \"{ending}\", expected png, svg or a name without such an ending")]
struct OtherKind {
    file: String,
    ending: String,
}

impl Explain for OtherKind {
    fn help(&self) -> Option<String> {
        Some("write SVG, which other programs turn into further kinds".to_owned())
    }
}

/// What is wrong with the ending of a figure.
fn other_kind(out: &Path) -> Option<OtherKind> {
    const OTHERS: [&str; 10] = [
        "pdf", "eps", "ps", "jpg", "jpeg", "gif", "tif", "tiff", "bmp", "webp",
    ];
    let ending = out.extension()?.to_str()?.to_owned();
    let is_other = OTHERS.contains(&ending.to_ascii_lowercase().as_str());
    let file = out.display().to_string();
    is_other.then_some(OtherKind { file, ending })
}

/// Reads all tables; tells what is wrong with any.
fn read(results: &[PathBuf], terminal: &mut Terminal<'_>) -> Option<Vec<TimeTable>> {
    let tables = results.iter().map(|path| {
        let table: Result<TimeTable, RunFileProblem> = TimeTable::read(path);
        table.map_err(|problem| terminal.tell(&problem)).ok()
    });
    let tables: Vec<_> = tables.collect();
    tables.into_iter().collect()
}

fn save(plot: &TimePlot, path: &Path) -> Result<(), OutputProblem> {
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    if let Some(folder) = folder {
        shared_geom::files::make_folder(folder)?;
    }
    plot.save(path)
}

/// Files to write: one where its ending is given, else both kinds.
fn targets(result: &Path, out: Option<&Path>) -> Vec<PathBuf> {
    let Some(out) = out else {
        let name = result.file_name().unwrap_or_default().to_string_lossy();
        let stem = [".transient.csv", ".transient.nc", ".csv", ".nc"]
            .iter()
            .find_map(|ending| name.strip_suffix(ending))
            .unwrap_or(&name);
        return ENDINGS
            .map(|ending| result.with_file_name(format!("{stem}.plot.{ending}")))
            .to_vec();
    };
    let ending = out.extension().and_then(|ending| ending.to_str());
    if ending.is_some_and(|ending| ENDINGS.contains(&ending)) {
        return vec![out.to_owned()];
    }
    let name = out.file_name().unwrap_or_default().to_string_lossy();
    ENDINGS
        .map(|ending| out.with_file_name(format!("{name}.{ending}")))
        .to_vec()
}

fn title(tables: &[TimeTable]) -> String {
    let names: Vec<_> = tables
        .iter()
        .map(|table| {
            let name = Path::new(&table.file).file_name().unwrap_or_default();
            name.to_string_lossy().into_owned()
        })
        .collect();
    names.join(", ")
}
