//! Derivatives of the properties of one section: the requested parameters, and their
//! file.

use shared_geom::error::{Diagnostics, Explain, SourceLocation};
use shared_geom::files::OutputProblem;
use thiserror::Error;

use super::Run;
use crate::analysis::Analysis;
use crate::cli::solved::{Solved, solve};
use crate::failure::Failure;
use crate::input::{Input, NodeProblem};
use crate::output::{ResultWriter, sensitivity_json, sensitivity_table};
use crate::section::Section;
use crate::sensitivity::{Axis, Derivative, Parameter, SensitivityProblem};
use crate::solution::SectionSolution;

/// A node for which derivatives are requested but do not exist.
#[derive(Debug, Error)]
#[error("--sensitivity-nodes {node}: {problem}")]
struct WrongNode {
    node: u64,
    problem: NodeProblem,
}

impl Explain for WrongNode {
    fn help(&self) -> Option<String> {
        self.problem.help()
    }
}

/// The derivatives of a section, if requested.
#[derive(Debug, Default)]
pub(super) struct Sensitivities(Option<(Vec<Parameter>, Vec<Derivative>)>);

impl Sensitivities {
    /// The part of the report.
    pub fn table(&self, section: &Section, solution: &SectionSolution) -> String {
        self.0
            .as_ref()
            .map_or_else(String::new, |(of, derivatives)| {
                sensitivity_table(section, solution, of, derivatives)
            })
    }

    /// Writes the file, or removes the file of an earlier run.
    pub fn write(&self, input: &Input, results: &mut ResultWriter) -> Result<(), OutputProblem> {
        let files = results.files().clone();
        let Some((parameters, derivatives)) = &self.0 else {
            files.remove_sensitivity();
            return Ok(());
        };
        let hash = &input.summary.input_hash;
        let text = sensitivity_json(&input.section, parameters, derivatives, hash);
        results.text(files.sensitivity(), &text)
    }
}

/// The requested parameters, or all problems of the requested nodes.
pub(super) fn parameters(input: &Input, run: &Run) -> Result<Option<Vec<Parameter>>, String> {
    let Some(nodes) = &run.sensitivity else {
        return Ok(None);
    };
    let mut parameters = Parameter::of_section(&input.section);
    let mut problems = Diagnostics::new();
    let mesh = &input.summary.mesh_file;
    for &node in nodes {
        let of_axis = |axis| input.source.coordinate(&input.section, mesh, node, axis);
        match of_axis(Axis::Y).and_then(|y| Ok([y, of_axis(Axis::Z)?])) {
            Ok(both) => parameters.extend(both.map(Parameter::MeshNode)),
            Err(problem) => {
                let location = SourceLocation::file(input.summary.file.clone());
                problems.push(location, &WrongNode { node, problem });
            }
        }
    }
    if problems.is_empty() {
        Ok(Some(parameters))
    } else {
        Err(problems.to_string())
    }
}

/// Solves the section with all analyses requested in its file, and the derivatives if
/// requested.
pub(super) fn analyzed(
    input: &Input,
    parameters: Option<Vec<Parameter>>,
) -> Result<(Solved, Sensitivities), Failure> {
    let Some(parameters) = parameters else {
        return Ok((solve(input, true)?, Sensitivities::default()));
    };
    let analysis = Analysis::new(&input.section)?;
    let derivatives = analysis.sensitivities(&parameters).map_err(|problem| {
        // the parameters belong to the section
        let unknowns = match problem {
            SensitivityProblem::OutOfMemory { unknowns } => unknowns,
            _ => analysis.domain().unknowns(),
        };
        Failure::OutOfMemory { unknowns }
    })?;
    let solved = Solved::by(&analysis, input, true)?;
    Ok((solved, Sensitivities(Some((parameters, derivatives)))))
}
