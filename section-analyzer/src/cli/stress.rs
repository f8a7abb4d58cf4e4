//! `section-analyzer stress`, and the stresses that `analyze` writes: a set of files
//! for each load case.

use std::path::{Path, PathBuf};

use nalgebra::Vector6;
use shared_geom::error::{Diagnostics, Explain, Place};
use shared_geom::files::{OutputProblem, write_figure, write_text};

use super::arguments::LoadArguments;
use super::{NOT_REACHED, Stop, Terminal, WRONG_INPUT, list};
use crate::analysis::analyze;
use crate::failure::Failure;
use crate::input::{self, Input, InputProblem};
use crate::output::{
    OutputFiles, failure_indices_of_cells, stress_cells_csv, stress_nodes_csv, stress_plots,
    stress_points_csv, stress_report, stress_vtu,
};
use crate::recovery::{LoadCase, Recoverer, Recovery};
use crate::solution::SectionSolution;

/// Nothing to recover stresses for.
#[derive(Debug, thiserror::Error)]
#[error("the section file has no load case, and the command line gives no load")]
struct NoLoad;

impl Explain for NoLoad {
    fn help(&self) -> Option<String> {
        let text = "add [load.NAME] to the section file, or give some of --axial, --shear-y, \
                    --shear-z, --torsion, --bending-y, --bending-z";
        Some(text.to_owned())
    }
}

/// Analyzes a section and writes its stresses under the loads of the command line, or
/// else under those of its file.
pub(super) fn recover_file(
    file: &Path,
    load: &LoadArguments,
    out: Option<PathBuf>,
    terminal: &mut Terminal<'_>,
) -> Result<(), Stop> {
    let mut input = terminal.read(file)?;
    if let Some(load) = written_load(load, terminal)? {
        input.loads = vec![load];
    }
    let place = Place::file(file.display().to_string());
    if input.loads.is_empty() {
        return Err(terminal.tell_all(&Diagnostics::one(place, &NoLoad)));
    }
    let folder = out.unwrap_or_else(|| file.parent().unwrap_or(Path::new("")).join("results"));
    let files = OutputFiles::new(&folder, &input::name_of(file))
        .map_err(|problem| terminal.tell(&problem, WRONG_INPUT))?;
    let solution = analyze(&input.section).map_err(|failure| {
        for load in &input.loads {
            files.remove_stresses(&load.name);
        }
        let problem = Diagnostics::one(place, &failure);
        terminal.tell_text(&problem.to_string(), NOT_REACHED)
    })?;

    let stresses = Stresses::write(&input, &solution, &files);
    write!(terminal.out, "{}", stresses.reports.join("\n"))?;
    stresses.end(file, Vec::new(), Ok(()), terminal)
}

/// The load of the command line, where it gives one.
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
        return Err(terminal.tell(&problem, WRONG_INPUT));
    }
    let point = match arguments.point[..] {
        [y, z] => [y, z],
        _ => [0.0; 2],
    };
    Ok(Some(LoadCase::at_point(name, &force, point)))
}

/// What was recovered and written.
#[derive(Debug)]
pub(super) struct Stresses {
    /// The reports, one for each load that could be recovered.
    reports: Vec<String>,
    files: Vec<PathBuf>,
    written: Result<(), OutputProblem>,
    failures: Vec<Failure>,
}

impl Stresses {
    /// Recovers and writes the stresses under every load of `input`.
    pub fn write(input: &Input, solution: &SectionSolution, files: &OutputFiles) -> Self {
        let mut stresses = Self {
            reports: Vec::new(),
            files: Vec::new(),
            written: Ok(()),
            failures: Vec::new(),
        };
        if input.loads.is_empty() {
            return stresses;
        }
        let recoverer = Recoverer::new(&input.section, solution);
        for load in &input.loads {
            match recoverer.recover(load) {
                Ok(recovery) => stresses.write_one(input, solution, &recovery, files),
                Err(failure) => {
                    files.remove_stresses(&load.name);
                    stresses.failures.push(failure);
                }
            }
        }
        stresses
    }

    /// All files of one recovery: the place for further tables and figures.
    fn write_one(
        &mut self,
        input: &Input,
        solution: &SectionSolution,
        recovery: &Recovery,
        files: &OutputFiles,
    ) {
        let Input {
            section, limits, ..
        } = input;
        let load = &recovery.load.name;
        // of an earlier run, which may have had strengths
        files.remove_stresses(load);
        let report = stress_report(section, limits, recovery);
        let written = write_text(&files.stress_report(load), &report)
            .and_then(|()| {
                let points = stress_points_csv(section, limits, recovery);
                write_text(&files.stress_points(load), &points)
            })
            .and_then(|()| {
                let cells = stress_cells_csv(section, recovery);
                write_text(&files.stress_cells(load), &cells)
            })
            .and_then(|()| {
                let nodes = stress_nodes_csv(section, recovery);
                write_text(&files.stress_nodes(load), &nodes)
            });
        self.reports.push(report);
        self.files.extend([
            files.stress_report(load),
            files.stress_points(load),
            files.stress_cells(load),
            files.stress_nodes(load),
        ]);
        let written = written.and_then(|()| self.write_fields(input, solution, recovery, files));
        if self.written.is_ok() {
            self.written = written;
        }
    }

    /// The field file and the figures of one recovery.
    fn write_fields(
        &mut self,
        input: &Input,
        solution: &SectionSolution,
        recovery: &Recovery,
        files: &OutputFiles,
    ) -> Result<(), OutputProblem> {
        let Input {
            section,
            summary,
            limits,
            ..
        } = input;
        let load = &recovery.load.name;
        let failure = failure_indices_of_cells(section, limits, recovery);
        let field = files.stress_field(load);
        stress_vtu(section, solution, recovery, &failure).write(&field)?;
        self.files.push(field);
        for (word, plot) in stress_plots(section, summary, recovery, &failure) {
            let figure = files.stress_figure(load, word);
            write_figure(&figure, plot.size(), &plot)?;
            self.files.push(figure);
        }
        Ok(())
    }

    /// Lists these files behind `others`, which were `written` before, and tells the
    /// loads that could not be recovered.
    pub fn end(
        self,
        file: &Path,
        mut others: Vec<PathBuf>,
        written: Result<(), OutputProblem>,
        terminal: &mut Terminal<'_>,
    ) -> Result<(), Stop> {
        let mut problems = Diagnostics::new();
        for failure in &self.failures {
            problems.push(Place::file(file.display().to_string()), failure);
        }
        others.extend(self.files);
        let written = written.and(self.written);
        if problems.is_empty() {
            return list(&others, written, terminal);
        }
        let stop = terminal.tell_text(&problems.to_string(), NOT_REACHED);
        list(&others, written, terminal)?;
        Err(stop)
    }
}
