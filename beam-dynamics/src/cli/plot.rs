//! `plot`: draws columns of runs in time.

use std::path::{Path, PathBuf};

use shared_geom::error::Explain;
use shared_geom::figure::{Drawing, Figure};
use shared_geom::files::OutputProblem;

use super::table_part::TablePart;
use super::terminal::Terminal;
use super::{DONE, NOT_REACHED, WRONG_INPUT};
use crate::output::{RunFileProblem, TimePlot, TimeTable};

/// Endings of the figures.
const ENDINGS: [&str; 2] = ["png", "svg"];

/// Selected columns and times, and the output file.
#[derive(Debug, Clone, clap::Args)]
pub(super) struct PlotOptions {
    #[command(flatten)]
    part: TablePart,
    /// Column over which the others are drawn
    #[arg(long = "x", value_name = "NAME", id = "x", default_value = "time")]
    across: String,
    /// Title of the figure; the names of the models if not given
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    /// Figure to write: PNG and SVG, or one of them by its ending; NAME.plot next to the
    /// first RESULT if not given
    #[arg(long, value_name = "FIGURE")]
    out: Option<PathBuf>,
}

/// `plot RESULT...`
pub(super) fn plot_files(
    results: &[PathBuf],
    options: &PlotOptions,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let out = options.out.as_deref();
    if let Some(problem) = out.and_then(other_kind) {
        terminal.report(&problem);
        return WRONG_INPUT;
    }
    let Some(tables) = options.part.read(results, terminal) else {
        return WRONG_INPUT;
    };
    let plot = match plot_of(&tables, options) {
        Ok(plot) => plot,
        Err(problems) => {
            for problem in &problems {
                terminal.report(problem);
            }
            return WRONG_INPUT;
        }
    };
    terminal.show("Written\n");
    let drawing = plot.drawing();
    for path in targets(&results[0], out) {
        if let Err(problem) = save(&drawing, &path) {
            terminal.report(&problem);
            return NOT_REACHED;
        }
        terminal.show(&format!("  {}\n", path.display()));
    }
    DONE
}

/// The figure, or all wrong names.
fn plot_of(tables: &[TimeTable], options: &PlotOptions) -> Result<TimePlot, Vec<RunFileProblem>> {
    let columns = options.part.columns();
    let across = options.across.as_str();
    let wanted = columns.iter().map(String::as_str).chain([across]);
    let checks = tables
        .iter()
        .flat_map(|table| wanted.clone().map(|name| table.find(name)));
    let wrong: Vec<_> = checks.filter_map(Result::err).collect();
    if !wrong.is_empty() {
        return Err(wrong);
    }
    let plot = TimePlot::new(tables, across, &columns).map_err(|problem| vec![problem])?;
    plot.check_size().map_err(|problem| vec![problem])?;
    Ok(match &options.title {
        Some(title) => plot.titled(title),
        None => plot,
    })
}

/// A figure of an unsupported kind.
#[derive(Debug, thiserror::Error)]
#[error("\"{file}\" ends in \"{ending}\", expected png, svg or a name without such an ending")]
struct OtherKind {
    file: String,
    ending: String,
}

impl Explain for OtherKind {
    fn help(&self) -> Option<String> {
        Some("write SVG, which other programs convert to other kinds".to_owned())
    }
}

/// Problem of the ending of a figure, if any.
fn other_kind(out: &Path) -> Option<OtherKind> {
    const OTHERS: [&str; 10] = [
        "pdf", "eps", "ps", "jpg", "jpeg", "gif", "tif", "tiff", "bmp", "webp",
    ];
    let ending = out.extension()?.to_str()?.to_owned();
    let is_other = OTHERS.contains(&ending.to_ascii_lowercase().as_str());
    let file = out.display().to_string();
    is_other.then_some(OtherKind { file, ending })
}

/// Writes the figure into a folder that is made.
fn save(drawing: &Drawing, path: &Path) -> Result<(), OutputProblem> {
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    if let Some(folder) = folder {
        shared_geom::files::make_folder(folder)?;
    }
    shared_geom::files::write_figure(path, drawing)
}

/// Files to write: one if its ending is given, else both kinds.
fn targets(result: &Path, out: Option<&Path>) -> Vec<PathBuf> {
    let Some(out) = out else {
        let stem = TimeTable::run_name(result);
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
