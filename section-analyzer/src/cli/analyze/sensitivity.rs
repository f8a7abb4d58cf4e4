//! Derivatives of the properties of one section: which are asked for, and their file.

use shared_geom::error::{Diagnostics, Place};
use shared_geom::files::OutputProblem;
use thiserror::Error;

use super::Run;
use crate::analysis::Analysis;
use crate::cli::solved::{Solved, solve};
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{ResultWriter, sensitivity_json, sensitivity_table};
use crate::section::Section;
use crate::sensitivity::{Axis, Derivative, Parameter, SensitivityProblem};
use crate::solution::SectionSolution;
use shared_geom::error::Explain;

/// A node that derivatives are asked for, and that is not there.
#[derive(Debug, Error)]
enum NodeProblem {
    #[error("--sensitivity-nodes {node}: the mesh \"{mesh}\" has no node {node}")]
    Missing {
        node: u64,
        mesh: String,
        nearest: Option<u64>,
    },
    #[error("--sensitivity-nodes {node}: no cell of the mesh \"{mesh}\" has node {node}")]
    Free { node: u64, mesh: String },
}

impl Explain for NodeProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Missing { nearest, .. } => {
                nearest.map(|node| format!("the nearest number in the file is {node}"))
            }
            Self::Free { .. } => Some("give a node at a corner or a side of a cell".to_owned()),
        }
    }
}

/// The derivatives of a section, if they are asked for.
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

    /// Writes the file, or removes that of an earlier run.
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

/// The parameters that the run asks for; what is wrong with its nodes, all at once.
pub(super) fn parameters(input: &Input, run: &Run) -> Result<Option<Vec<Parameter>>, String> {
    let Some(nodes) = &run.sensitivity else {
        return Ok(None);
    };
    let mut parameters = Parameter::of_section(&input.section);
    let mut problems = Diagnostics::new();
    for &tag in nodes {
        match index_of(input, tag) {
            Ok(node) => {
                parameters.extend([Axis::Y, Axis::Z].map(|axis| Parameter::Node { node, axis }))
            }
            Err(problem) => problems.push(Place::file(input.summary.file.clone()), &problem),
        }
    }
    match problems.is_empty() {
        true => Ok(Some(parameters)),
        false => Err(problems.to_string()),
    }
}

fn index_of(input: &Input, tag: u64) -> Result<usize, NodeProblem> {
    let mesh = &input.section.mesh;
    let name = || input.summary.mesh_file.clone();
    let Some(node) = mesh.node_tags.iter().position(|&known| known == tag) else {
        let tags = mesh.node_tags.iter().copied();
        return Err(NodeProblem::Missing {
            node: tag,
            mesh: name(),
            nearest: tags.min_by_key(|known| known.abs_diff(tag)),
        });
    };
    let mut cells = mesh.cells.iter();
    match cells.any(|cell| cell.nodes().contains(&(node as u32))) {
        true => Ok(node),
        false => Err(NodeProblem::Free {
            node: tag,
            mesh: name(),
        }),
    }
}

/// Solves the section with all that its file asks for, and the derivatives if they are
/// asked for.
pub(super) fn analyzed(
    input: &Input,
    parameters: Option<Vec<Parameter>>,
) -> Result<(Solved, Sensitivities), Failure> {
    let Some(parameters) = parameters else {
        return Ok((solve(input, true)?, Sensitivities::default()));
    };
    let analysis = Analysis::new(&input.section)?;
    let derivatives = analysis.sensitivities(&parameters).map_err(|problem| {
        // the parameters are those of the section
        let unknowns = match problem {
            SensitivityProblem::OutOfMemory { unknowns } => unknowns,
            _ => analysis.domain().unknowns(),
        };
        Failure::OutOfMemory { unknowns }
    })?;
    let solved = Solved::by(&analysis, input, true)?;
    Ok((solved, Sensitivities(Some((parameters, derivatives)))))
}
