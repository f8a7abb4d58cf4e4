//! `section-analyzer analyze`: computes the results of section files.

use std::path::{Path, PathBuf};

use super::arguments::AnalyzeArguments;
use super::{DONE, Stop, Terminal, WRONG_INPUT, list, list_removed};
use crate::input;

mod alike;
mod electrodes;
mod lines;
mod many;
mod mesh_error;
mod one;
mod open;
mod outcome;
mod overlap;
mod progress;
mod renewed;
mod sensitivity;

pub(super) use many::solve_all;
pub(super) use one::{Analyzed, analyze_one};
pub(super) use outcome::{Outcome, Status};
pub(super) use renewed::made_from;

/// Identifies this program by its version and the id of its build, since two builds of
/// one version may differ.
const PROGRAM: &str = concat!(
    env!("CARGO_PKG_VERSION"),
    " ",
    env!("SECTION_ANALYZER_BUILD")
);

/// A section to analyze, and the folder of its results.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Job {
    /// The section file.
    pub file: PathBuf,
    /// The folder of its results.
    pub folder: PathBuf,
    /// The name of the section.
    pub name: String,
    /// The section as the table of sections shows it.
    pub label: String,
}

impl Job {
    /// The results of `file` go to the folder `out`, or else to the folder `results` next
    /// to the file.
    pub fn new(file: &Path, out: Option<&Path>) -> Self {
        let beside = || file.parent().unwrap_or(Path::new("")).join("results");
        Self {
            file: file.to_owned(),
            folder: out.map_or_else(beside, Path::to_owned),
            name: input::name_of(file),
            label: file.display().to_string(),
        }
    }
}

/// Settings shared by all sections of a run.
#[derive(Debug, Clone)]
pub(super) struct Run {
    /// Whether sections are solved even if nothing has changed.
    force: bool,
    /// Which figures are drawn.
    figures: bool,
    /// Numbers of the nodes whose coordinates are parameters of the derivatives; `None`
    /// if no derivatives are requested.
    sensitivity: Option<Vec<u64>>,
    /// Whether the discretization error is estimated.
    mesh_error: bool,
    /// Driven electrodes that are open.
    open: Vec<String>,
}

impl Run {
    /// Properties alone, without figures.
    pub fn plain(force: bool) -> Self {
        Self {
            force,
            figures: false,
            sensitivity: None,
            mesh_error: false,
            open: Vec::new(),
        }
    }
}

/// Analyzes sections and writes their results.
pub(super) fn analyze_files(
    arguments: &AnalyzeArguments,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let out = arguments.out.as_deref();
    let jobs: Vec<_> = arguments
        .files
        .iter()
        .map(|file| Job::new(file, out))
        .collect();
    let overlaps = overlap::overlaps(&jobs);
    for problem in &overlaps {
        terminal.report(problem, WRONG_INPUT);
    }
    if !overlaps.is_empty() {
        return Err(Stop::Reported(WRONG_INPUT));
    }
    let run = Run {
        force: arguments.force,
        figures: !arguments.no_figures,
        sensitivity: arguments
            .sensitivity
            .then(|| arguments.sensitivity_nodes.clone()),
        mesh_error: arguments.mesh_error,
        open: arguments.open.clone(),
    };
    match &jobs[..] {
        [job] => show(job, analyze_one(job, &run).0, terminal),
        jobs => solve_all(
            jobs,
            arguments.threads,
            &|_, job| analyze_one(job, &run).0,
            terminal,
        )?
        .result(),
    }
}

/// Shows the outcome of a run with a single section.
fn show(job: &Job, outcome: Outcome, terminal: &mut Terminal<'_>) -> Result<(), Stop> {
    write!(terminal.out, "{}", outcome.report)?;
    if let Some(messages) = outcome.messages(&job.label, terminal.is_quiet) {
        // Reported first; the written files are listed all the same.
        terminal.report_text(&messages, outcome.status.code());
    }
    list(outcome.status.heading(), &outcome.files, terminal)?;
    list_removed(&outcome.removed, terminal)?;
    match outcome.status.code() {
        DONE => Ok(()),
        code => Err(Stop::Reported(code)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The id of the build is a SHA-256, made by the build script.
    #[test]
    fn the_program_is_reported_by_version_and_build() {
        let (version, build) = PROGRAM.split_once(' ').unwrap();
        assert_eq!(version, env!("CARGO_PKG_VERSION"));
        assert_eq!(build.len(), 64);
        assert!(build.bytes().all(|digit| digit.is_ascii_hexdigit()));
    }
}
