//! The analysis of one section, with its files and its outcome as text.

use std::cell::LazyCell;

use shared_geom::error::{Diagnostics, SourceLocation};
use shared_geom::files::OutputProblem;
use shared_geom::section::{self, SectionProperties};

use super::electrodes::{fields_per_volt, require_known, write_electrodes};
use super::mesh_error::MeshError;
use super::open::open;
use super::outcome::{Outcome, Status};
use super::renewed::{made_from, renewed, without_strengths};
use super::sensitivity::{Sensitivities, analyzed, parameters};
use super::{Job, Run};
use crate::cli::figures::draw_section;
use crate::cli::solved::Solved;
use crate::cli::stress::Stresses;
use crate::cli::{warnings_of, words};
use crate::failure::Failure;
use crate::input::{self, Input};
use crate::output::{
    AnalysisRecord, Outline, OutputFiles, ResultWriter, WarpingPlot, add_prestress, areas_csv,
    constants_csv, end_effects, failure_report, imposed_report, piezo_report, prestress_report,
    properties, report, warping_vtu,
};
use crate::properties::{Centers, NoRestrainedWarping, RestrainedWarping};
use crate::recovery::Recovery;
use crate::sensitivity::Parameter;
use crate::solution::SectionSolution;

/// A section that has been analyzed, for further results without reading or solving it again.
#[derive(Debug)]
pub(in crate::cli) struct Analyzed {
    /// The section as read.
    pub input: Input,
    /// Its solution; `None` if nothing has changed since its files were written, or if it has
    /// none.
    pub solution: Option<SectionSolution>,
}

/// Reads, solves and writes one section, unless nothing has changed since it was
/// written; returns the section too if its input is sound.
pub(in crate::cli) fn analyze_one(job: &Job, run: &Run) -> (Outcome, Option<Analyzed>) {
    match checked(job, run) {
        Err(problems) => (Outcome::wrong_input(problems), None),
        Ok((input, parameters, files)) => {
            let (outcome, solution) = analyze_checked(job, run, (&input, parameters), files);
            (outcome, Some(Analyzed { input, solution }))
        }
    }
}

/// The input of a section, the parameters of its derivatives, and its files; or all problems of
/// the input.
fn checked(job: &Job, run: &Run) -> Result<(Input, Option<Vec<Parameter>>, OutputFiles), String> {
    let mut input = input::read(&job.file).map_err(|problems| problems.to_string())?;
    open(&mut input, &run.open)?;
    require_known(&input, run)?;
    let parameters = parameters(&input, run)?;
    let files = OutputFiles::new(&job.folder, &job.name).map_err(|problem| words(&problem))?;
    Ok((input, parameters, files))
}

fn analyze_checked(
    job: &Job,
    run: &Run,
    (input, parameters): (&Input, Option<Vec<Parameter>>),
    files: OutputFiles,
) -> (Outcome, Option<SectionSolution>) {
    let made_from = made_from(input, run);
    let unchanged = if run.force {
        None
    } else {
        let unchanged = unchanged(&files, &made_from);
        unchanged.or_else(|| renewed(&files, (input, run), &made_from))
    };
    let earlier = files.earlier();
    let solve = || {
        let _lock = match files.lock() {
            Ok(lock) => lock,
            Err(problem) => return (Outcome::wrong_input(words(&problem)), None),
        };
        let results = ResultWriter::new(files).with_figures(run.figures);
        let in_circuit = |found| InCircuit::new(input, found, run);
        match analyzed(input, parameters).and_then(in_circuit) {
            Ok(found) => (
                solved(job, (input, run), &found, results, &made_from),
                Some(found.found.solution),
            ),
            Err(failure) => (failed(job, input, &failure, results), None),
        }
    };
    let (outcome, solution) = unchanged.map_or_else(solve, |outcome| (outcome, None));
    let outcome = Outcome {
        removed: earlier.removed(),
        nodes: Some(input.section.mesh.nodes.len()),
        warnings: warnings_of(input),
        ..outcome
    };
    (outcome, solution)
}

/// The outcome of an earlier run, if this run would write the same files.
fn unchanged(files: &OutputFiles, made_from: &str) -> Option<Outcome> {
    let record = AnalysisRecord::read(files)?;
    if !record.holds(files, made_from) {
        return None;
    }
    let names = record.names(files).into_iter();
    Some(Outcome {
        report: std::fs::read_to_string(files.report()).ok()?,
        files: names.map(|name| files.folder().join(name)).collect(),
        properties: Some(section::read(&files.properties()).ok()?),
        ..Outcome::new(Status::Unchanged)
    })
}

/// The solution of a section, and the effect of its circuit.
#[derive(Debug)]
struct InCircuit {
    found: Solved,
    derivatives: Sensitivities,
    mesh_error: MeshError,
    /// With open electrodes at no charge.
    seen: SectionSolution,
    /// At one volt of each driven electrode, for its figures.
    fields: Vec<(String, Recovery)>,
}

impl InCircuit {
    /// # Errors
    /// Voltages that the circuit leaves undetermined, fields that do not add up.
    fn new(
        input: &Input,
        (found, derivatives): (Solved, Sensitivities),
        run: &Run,
    ) -> Result<Self, Failure> {
        Ok(Self {
            seen: found.solution.in_circuit()?,
            mesh_error: MeshError::new(input, &found.solution, run),
            fields: if run.figures {
                fields_per_volt(input, &found.solution)?
            } else {
                Vec::new()
            },
            found,
            derivatives,
        })
    }
}

fn solved(
    job: &Job,
    (input, run): (&Input, &Run),
    in_circuit: &InCircuit,
    mut results: ResultWriter,
    made_from: &str,
) -> Outcome {
    let Input {
        section, summary, ..
    } = input;
    let InCircuit {
        found,
        derivatives,
        mesh_error,
        seen,
        fields,
    } = in_circuit;
    let solution = &found.solution;
    let mut properties = properties(section, solution, &found.imposed, &summary.input_hash);
    let restrained = RestrainedWarping::new(section, &solution.warping, &solution.strain);
    let report = reported(input, in_circuit, &restrained, &mut properties);
    let mut stresses = Stresses::default();
    let written = results
        .text(results.files().properties(), &section::write(&properties))
        .and_then(|()| results.text(results.files().report(), &report))
        .and_then(|()| write_tables(input, restrained.as_ref().ok(), &mut results))
        .and_then(|()| derivatives.write(input, &mut results))
        .and_then(|()| mesh_error.write(input, solution, &mut results))
        .and_then(|()| write_figures(input, (solution, &seen.centers), &mut results))
        .and_then(|()| write_electrodes(input, solution, fields, &mut results))
        .and_then(|()| stresses.write(input, found, &mut results));

    let failed = stresses.problems(&job.file);
    let open = found.open_problem(&job.file);
    let (files, problem) = match written {
        Ok(()) if failed.is_none() && open.is_none() => {
            results.finish(made_from, without_strengths(input, run))
        }
        Ok(()) => (results.abandon(), None),
        Err(problem) => (results.abandon(), Some(problem)),
    };
    let problems: Vec<_> = [problem.map(|problem| words(&problem)), failed, open]
        .into_iter()
        .flatten()
        .collect();
    let status = if problems.is_empty() {
        Status::Solved
    } else {
        Status::NotReached
    };
    Outcome {
        report,
        files,
        problems: (!problems.is_empty()).then(|| problems.join("\n")),
        properties: Some(properties),
        ..Outcome::new(status)
    }
}

/// The report; its prestress is added to the `properties`.
fn reported(
    input: &Input,
    in_circuit: &InCircuit,
    restrained: &Result<RestrainedWarping, NoRestrainedWarping>,
    properties: &mut SectionProperties,
) -> String {
    let (section, found) = (&input.section, &in_circuit.found);
    let prestress_part = prestressed(input, found, properties);
    let on_request = [
        in_circuit.mesh_error.table(&found.solution),
        piezo_report(&found.solution, properties),
        imposed_report(properties),
        prestress_part,
        in_circuit.derivatives.table(section, &found.solution),
    ];
    let seen = &in_circuit.seen;
    let mut report = report(section, &input.summary, seen, restrained, &on_request);
    let ends = found.end_effects.as_ref().map(end_effects);
    report.extend(ends.map(|ends| format!("\n{ends}")));
    report
}

/// Adds the effect of prestress to the properties, if requested; returns its part of the
/// report.
fn prestressed(input: &Input, solved: &Solved, properties: &mut SectionProperties) -> String {
    let Some(measure) = input.prestress else {
        return String::new();
    };
    let (solution, imposed) = (&solved.solution, &solved.imposed);
    if let Err(reason) = add_prestress(properties, &input.section, solution, imposed, measure) {
        return format!("Prestress\n  none: {reason}\n");
    }
    let along = input.distributed.iter().map(|load| !load.is_empty());
    let loads: Vec<_> = input.loads.iter().zip(along).collect();
    prestress_report(properties, &loads)
}

/// Writes the tables of the section: a new one needs one more line.
fn write_tables(
    input: &Input,
    restrained: Option<&RestrainedWarping>,
    results: &mut ResultWriter,
) -> Result<(), OutputProblem> {
    let files = results.files().clone();
    results.text(files.areas(), &areas_csv(&input.summary.areas))?;
    match restrained {
        Some(constants) => results.text(files.constants(), &constants_csv(constants)),
        None => {
            files.remove_constants();
            Ok(())
        }
    }
}

/// Writes the figures and field files of the section: a new one needs one more line.
fn write_figures(
    input: &Input,
    (solution, centers): (&SectionSolution, &Centers),
    results: &mut ResultWriter,
) -> Result<(), OutputProblem> {
    let files = results.files().clone();
    let outline = LazyCell::new(|| Outline::new(&input.section));
    draw_section(input, &outline, Some(centers), results)?;
    let warping = || WarpingPlot::new(&input.section, &outline, solution);
    results.figure(files.warping(), warping)?;
    let fields = warping_vtu(&input.section, solution);
    results.add(files.warping_field(), |file| fields.write(file))
}

/// Writes the output that needs no solution; removes results of an earlier run.
fn failed(job: &Job, input: &Input, failure: &Failure, mut results: ResultWriter) -> Outcome {
    let written = write_failure(input, failure, &mut results);
    results.files().remove_results();
    let electrodes = input.section.electrodes.iter();
    let names = electrodes.map(|known| known.name.as_str());
    results.files().remove_electrodes(names);
    for load in &input.loads {
        results.files().remove_stresses(&load.name);
    }
    let location = SourceLocation::file(job.file.display().to_string());
    let mut problems = Diagnostics::one(location, failure).to_string();
    if let Err(problem) = written {
        problems = problems + "\n" + &words(&problem);
    }
    Outcome {
        files: results.abandon(),
        problems: Some(problems),
        ..Outcome::new(Status::NotReached)
    }
}

fn write_failure(
    input: &Input,
    failure: &Failure,
    results: &mut ResultWriter,
) -> Result<(), OutputProblem> {
    let Input {
        section, summary, ..
    } = input;
    let files = results.files().clone();
    results.text(files.report(), &failure_report(section, summary, failure))?;
    let outline = LazyCell::new(|| Outline::new(section));
    draw_section(input, &outline, None, results)
}
