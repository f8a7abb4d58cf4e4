//! The files of a blade.

use std::path::PathBuf;

use shared_geom::blade::{self, Blade};
use shared_geom::error::Explain;
use shared_geom::exchange::{self, Format};
use shared_geom::figure::Figure;
use shared_geom::files::{OutputProblem, make_folder, write_figure, write_whole};

use crate::cli::arguments::WholeBladeArguments;
use crate::cli::{NOT_REACHED, Stop, Terminal, list, list_removed};
use crate::output::{
    SolvedSpan, SpanFiles, comparison_csv, comparison_text, layers_csv, span_csv, span_plots,
    span_text,
};

/// A blade whose sections do not make one.
#[derive(Debug, thiserror::Error)]
#[error("the blade is not written: {0}")]
struct Unsound(String);

impl Explain for Unsound {
    fn help(&self) -> Option<String> {
        None
    }
}

/// The results of a run.
pub(super) struct Results<'a> {
    pub span: &'a SolvedSpan<'a>,
    /// The report.
    pub page: Option<String>,
    /// Whether the blade is complete.
    pub is_written: bool,
    /// The blade with which it is compared.
    pub other: Option<Blade>,
}

/// Writes the tables and figures of the solved sections, their report, and the blade in all
/// formats if it is complete; otherwise blades of an earlier run are removed.
pub(super) fn write(
    results: &Results<'_>,
    files: &SpanFiles,
    arguments: &WholeBladeArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let Results {
        span, is_written, ..
    } = *results;
    let figures = !arguments.no_figures;
    let blade = span.blade();
    let problems = if is_written {
        blade.problems()
    } else {
        Vec::new()
    };
    let is_written = is_written && problems.is_empty();
    if is_written {
        write!(terminal.out, "\n{}", span_text(&blade))?;
    }
    if let Some(other) = &results.other {
        write!(terminal.out, "\n{}", comparison_text(span, other))?;
    }
    let old = match is_written {
        true => Vec::new(),
        false => old_blades(&blade, files.name(), files),
    };
    let earlier = files.earlier().with(old.iter().cloned());
    let (mut written, mut lost) = (Vec::new(), Vec::new());
    let done = write_tables(results, files, figures, &mut written)
        .and_then(|()| write_requested(results, files, &mut written))
        .and_then(|()| {
            if is_written {
                write_blade(
                    &blade,
                    files.name(),
                    files,
                    arguments,
                    (&mut written, &mut lost),
                )
            } else {
                // A missing file is ignored.
                old.iter().for_each(|file| drop(std::fs::remove_file(file)));
                Ok(())
            }
        });
    for text in &lost {
        writeln!(terminal.out, "  {text}")?;
    }
    list("Written", &written, terminal)?;
    list_removed(&earlier.removed(), terminal)?;
    let mut end = Ok(());
    for problem in problems {
        end = Err(terminal.report(&Unsound(problem.to_string()), NOT_REACHED));
    }
    done.map_err(|problem| terminal.report(&problem, NOT_REACHED))?;
    end
}

fn write_tables(
    results: &Results<'_>,
    files: &SpanFiles,
    figures: bool,
    written: &mut Vec<PathBuf>,
) -> Result<(), OutputProblem> {
    let span = results.span;
    for (file, text) in [
        (files.span(), span_csv(span)),
        (files.layers(), layers_csv(span)),
    ] {
        write_whole(&file, &text)?;
        written.push(file);
    }
    let is_drawn = figures && !span.stations.is_empty();
    for (name, plot) in span_plots(span, results.other.as_ref()) {
        let file = files.figure(name);
        let vector = file.with_extension("svg");
        let drawing = is_drawn.then(|| plot.drawing());
        for file in [file, vector] {
            match &drawing {
                Some(drawing) => {
                    write_figure(&file, drawing)?;
                    written.push(file);
                }
                // A missing file is ignored.
                None => drop(std::fs::remove_file(file)),
            }
        }
    }
    Ok(())
}

/// Writes the results on request, or removes the ones of an earlier run.
fn write_requested(
    results: &Results<'_>,
    files: &SpanFiles,
    written: &mut Vec<PathBuf>,
) -> Result<(), OutputProblem> {
    let other = results.other.as_ref();
    let table = other.map(|other| comparison_csv(results.span, other));
    for (text, file) in [
        (table.as_deref(), files.comparison()),
        (results.page.as_deref(), files.report()),
    ] {
        write_or_remove(text, file, written)?;
    }
    Ok(())
}

/// Writes a file, or removes the one of an earlier run.
fn write_or_remove(
    text: Option<&str>,
    file: PathBuf,
    written: &mut Vec<PathBuf>,
) -> Result<(), OutputProblem> {
    match text {
        Some(text) => {
            write_whole(&file, text)?;
            written.push(file);
        }
        // A missing file is ignored.
        None => drop(std::fs::remove_file(&file)),
    }
    Ok(())
}

/// Writes the blade file and the formats; notes properties that formats cannot hold.
fn write_blade(
    blade: &Blade,
    name: &str,
    files: &SpanFiles,
    arguments: &WholeBladeArguments,
    (written, lost): (&mut Vec<PathBuf>, &mut Vec<String>),
) -> Result<(), OutputProblem> {
    write_whole(&files.blade(), &blade::write(blade))?;
    written.push(files.blade());
    let wanted = arguments.format.iter().flat_map(|formats| &formats.0);
    for format in wanted {
        let Ok(writing) = exchange::write(blade, *format, name) else {
            continue;
        };
        let folder = files.format(format.name());
        make_folder(&folder)?;
        for (file, text) in &writing.files {
            let file = folder.join(file);
            write_whole(&file, text)?;
            written.push(file);
        }
        lost.extend(
            writing
                .lost
                .iter()
                .map(|one| format!("{} cannot hold: {one}", format.name())),
        );
    }
    Ok(())
}

/// The files of a blade, which an earlier run may have written for other sections.
fn old_blades(blade: &Blade, name: &str, files: &SpanFiles) -> Vec<PathBuf> {
    let mut old = vec![files.blade()];
    for format in Format::ALL
        .into_iter()
        .filter(|_| blade.problems().is_empty())
    {
        let names = exchange::write(blade, format, name).map_or_else(|_| Vec::new(), |it| it.files);
        old.extend(
            names
                .iter()
                .map(|(file, _)| files.format(format.name()).join(file)),
        );
    }
    old
}
