//! Tables and figures of the electrodes of a section, and options that do not exist with
//! electrodes.

use shared_geom::error::{Diagnostics, Explain, SourceLocation};
use shared_geom::files::OutputProblem;
use thiserror::Error;

use super::Run;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{ResultWriter, electric_plots, electrodes_csv};
use crate::recovery::{LoadCase, Recoverer, Recovery};
use crate::section::Circuit;
use crate::solution::SectionSolution;
use nalgebra::Vector6;

/// An option for a section with electrodes, for which it does not exist.
#[derive(Debug, Error)]
#[error("{0} is not known for sections with electrodes")]
struct WithElectrodes(&'static str);

impl Explain for WithElectrodes {
    fn help(&self) -> Option<String> {
        let Self(option) = self;
        Some(format!("remove {option}, or the electrodes from the file"))
    }
}

/// Requires that the section has no electrodes if the run has options that do not exist for
/// them.
pub(super) fn require_known(input: &Input, run: &Run) -> Result<(), String> {
    let options = [
        (run.sensitivity.is_some(), "--sensitivity"),
        (run.mesh_error, "--mesh-error"),
    ];
    let mut problems = Diagnostics::new();
    for (is_requested, option) in options {
        if is_requested && !input.section.electrodes.is_empty() {
            let location = SourceLocation::file(input.summary.file.clone());
            problems.push(location, &WithElectrodes(option));
        }
    }
    if problems.is_empty() {
        Ok(())
    } else {
        Err(problems.to_string())
    }
}

/// Fields at one volt of each driven electrode, with its name.
///
/// # Errors
/// As [`Recoverer::recover`].
pub(super) fn fields_per_volt(
    input: &Input,
    solution: &SectionSolution,
) -> Result<Vec<(String, Recovery)>, Failure> {
    let driven = input.section.electrodes.iter();
    let driven: Vec<_> = driven
        .filter(|known| known.circuit == Circuit::Driven)
        .collect();
    if driven.is_empty() {
        return Ok(Vec::new());
    }
    let recoverer = Recoverer::new(&input.section, solution);
    let fields = driven.into_iter().map(|electrode| {
        let load = LoadCase {
            voltages: vec![(electrode.name.clone(), 1.0)],
            ..LoadCase::at_point(electrode.name.clone(), &Vector6::zeros(), [0.0; 2])
        };
        Ok((electrode.name.clone(), recoverer.recover(&load)?))
    });
    fields.collect()
}

/// Writes the table of the electrodes, and the figures of `fields` at one volt of each.
///
/// # Errors
/// A file that cannot be written.
pub(super) fn write_electrodes(
    input: &Input,
    solution: &SectionSolution,
    fields: &[(String, Recovery)],
    results: &mut ResultWriter,
) -> Result<(), OutputProblem> {
    let Some(piezo) = &solution.piezo else {
        return Ok(());
    };
    let files = results.files().clone();
    // figures of an earlier run
    files.remove_electrodes(piezo.electrodes.iter().map(|known| known.name.as_str()));
    results.text(files.electrodes(), &electrodes_csv(piezo))?;
    for (name, recovery) in fields {
        let Some(plots) = electric_plots(&input.section, &input.summary, recovery) else {
            continue;
        };
        results.figure_where(files.potential(name), || plots.potential)?;
        results.figure(files.field(name), || plots.field)?;
    }
    Ok(())
}
