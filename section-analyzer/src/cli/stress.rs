//! `section-analyzer stress`, and the stresses written by `analyze`: a set of files for
//! each load case.

use std::path::{Path, PathBuf};

use nalgebra::Vector6;
use shared_geom::error::{Diagnostics, Explain, SourceLocation};
use shared_geom::files::OutputProblem;

use super::arguments::LoadArguments;
use super::solved::{Solved, solve};
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list, list_removed, words};
use crate::failure::Failure;
use crate::input::{self, Input, InputProblem};
use crate::output::{
    OutputFiles, ResultWriter, distributed_load, failure_indices_of_cells, stress_cells_csv,
    stress_nodes_csv, stress_plots, stress_points_csv, stress_report, stress_vtu,
};
use crate::recovery::{LoadCase, Recoverer, Recovery};
use crate::section::DistributedLoad;
use crate::solution::{DistributedState, SectionSolution};

/// No load to recover stresses for.
#[derive(Debug, thiserror::Error)]
#[error("the section file has no load case, and the command line has no load")]
struct NoLoad;

impl Explain for NoLoad {
    fn help(&self) -> Option<String> {
        let text = "add [load.NAME] to the section file, or give some of --axial, --shear-y, \
                    --shear-z, --torsion, --bending-y, --bending-z";
        Some(text.to_owned())
    }
}

/// Analyzes a section and writes its stresses under the loads of the command line, or
/// else under the loads of its file, into the folder `out`, with these figures.
pub(super) fn recover_file(
    file: &Path,
    load: &LoadArguments,
    (out, figures): (Option<PathBuf>, bool),
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let mut input = terminal.read(file)?;
    if let Some(load) = written_load(load, terminal)? {
        input.loads = vec![load];
        input.distributed = vec![DistributedLoad::default()];
        input.distributed_words = vec![Vec::new()];
    }
    let location = SourceLocation::file(file.display().to_string());
    if input.loads.is_empty() {
        return Err(terminal.report_all(&Diagnostics::one(location, &NoLoad)));
    }
    let folder = out.unwrap_or_else(|| file.parent().unwrap_or(Path::new("")).join("results"));
    let files = OutputFiles::new(&folder, &input::name_of(file))
        .map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    let earlier = files.earlier();
    let _lock = files
        .lock()
        .map_err(|problem| terminal.report(&problem, WRONG_INPUT))?;
    let solved = solve(&input, false).map_err(|failure| {
        for load in &input.loads {
            files.remove_stresses(&load.name);
        }
        let problem = Diagnostics::one(location, &failure);
        terminal.report_text(&problem.to_string(), NOT_REACHED)
    })?;

    let mut results = ResultWriter::beside(files).with_figures(figures);
    let mut stresses = Stresses::default();
    let written = stresses.write(&input, &solved, &mut results);
    write!(terminal.out, "{}", stresses.reports.join("\n"))?;
    let problems = [
        written.err().map(|problem| words(&problem)),
        stresses.problems(file),
    ];
    let problems: Vec<_> = problems.into_iter().flatten().collect();
    let reported =
        (!problems.is_empty()).then(|| terminal.report_text(&problems.join("\n"), NOT_REACHED));
    list("Written", &results.abandon(), terminal)?;
    list_removed(&earlier.removed(), terminal)?;
    reported.map_or(Ok(()), Err)
}

/// The load of the command line, if given.
fn written_load(
    arguments: &LoadArguments,
    terminal: &mut Terminal<'_>,
) -> Result<Option<LoadCase>, Stop> {
    let given = arguments.components();
    if given.iter().all(Option::is_none) {
        return Ok(None);
    }
    let force = Vector6::from_fn(|i, _| given[i].unwrap_or(0.0));
    let name = arguments.name.clone();
    if force == Vector6::zeros() {
        let problem = InputProblem::ZeroLoad { load: name };
        return Err(terminal.report(&problem, WRONG_INPUT));
    }
    let point = match arguments.point[..] {
        [y, z] => [y, z],
        _ => [0.0; 2],
    };
    let load = input::checked_load(LoadCase::at_point(name, &force, point));
    load.map(Some)
        .map_err(|problem| terminal.report(&problem, WRONG_INPUT))
}

/// The recovered stresses.
#[derive(Debug, Default)]
pub(super) struct Stresses {
    /// The reports, one for each load that could be recovered.
    reports: Vec<String>,
    failures: Vec<Failure>,
}

impl Stresses {
    /// Recovers and writes the stresses under every load of `input`.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(
        &mut self,
        input: &Input,
        solved: &Solved,
        results: &mut ResultWriter,
    ) -> Result<(), OutputProblem> {
        if input.loads.is_empty() {
            return Ok(());
        }
        let recoverer =
            Recoverer::new(&input.section, &solved.solution).with_imposed(&solved.imposed.states);
        let added = solved.distributed.iter().zip(&input.distributed_words);
        for (load, (added, words)) in input.loads.iter().zip(added) {
            let recovered = match added {
                Some(added) => recoverer.recover_with(load, added),
                None => recoverer.recover(load),
            };
            match recovered {
                Ok(recovery) => {
                    let added = added.as_ref().map(|state| (state, &words[..]));
                    let state = (&solved.solution, added);
                    self.write_one(input, state, &recovery, results)?;
                }
                Err(failure) => {
                    results.files().remove_stresses(&load.name);
                    self.failures.push(failure);
                }
            }
        }
        Ok(())
    }

    /// All files of one recovery: a new one needs one more line.
    fn write_one(
        &mut self,
        input: &Input,
        (solution, added): (&SectionSolution, Option<(&DistributedState, &[String])>),
        recovery: &Recovery,
        results: &mut ResultWriter,
    ) -> Result<(), OutputProblem> {
        let Input {
            section, limits, ..
        } = input;
        let load = &recovery.load.name;
        let files = results.files().clone();
        // of an earlier run, whose materials may have had strengths
        files.remove_stresses(load);
        let mut report = stress_report(section, limits, recovery);
        if let Some((added, words)) = added {
            let words = (words, recovery.strain_scale);
            report = report + "\n" + &distributed_load(section, added, words);
        }
        results.text(files.stress_report(load), &report)?;
        self.reports.push(report);
        let points = stress_points_csv(section, limits, recovery);
        results.text(files.stress_points(load), &points)?;
        results.text(
            files.stress_cells(load),
            &stress_cells_csv(section, recovery),
        )?;
        results.text(
            files.stress_nodes(load),
            &stress_nodes_csv(section, recovery),
        )?;
        write_fields(input, solution, recovery, results)
    }

    /// The loads of the section file `file` that could not be recovered, as text.
    pub fn problems(&self, file: &Path) -> Option<String> {
        let mut problems = Diagnostics::new();
        for failure in &self.failures {
            problems.push(SourceLocation::file(file.display().to_string()), failure);
        }
        (!problems.is_empty()).then(|| problems.to_string())
    }
}

/// The field file and the figures of one recovery.
fn write_fields(
    input: &Input,
    solution: &SectionSolution,
    recovery: &Recovery,
    results: &mut ResultWriter,
) -> Result<(), OutputProblem> {
    let Input {
        section,
        summary,
        limits,
        ..
    } = input;
    let load = &recovery.load.name;
    let files = results.files().clone();
    let failure = failure_indices_of_cells(section, limits, recovery);
    let fields = stress_vtu(section, solution, recovery, &failure);
    results.add(files.stress_field(load), |file| fields.write(file))?;
    if !results.draws() {
        // figures of an earlier run were removed with its reports
        return Ok(());
    }
    for (word, plot) in stress_plots(section, summary, recovery, &failure) {
        results.figure(files.stress_figure(load, word), || plot)?;
    }
    Ok(())
}
