//! Discretization error of the stiffness of one section, if requested.

use shared_geom::files::OutputProblem;

use super::Run;
use crate::analysis::discretization_error;
use crate::failure::Failure;
use crate::input::Input;
use crate::output::{ResultWriter, mesh_error_json, mesh_error_table};
use crate::solution::{DiscretizationError, SectionSolution};

/// The estimate, if requested, or the reason for which it does not exist.
#[derive(Debug)]
pub(super) struct MeshError(Option<Result<DiscretizationError, Failure>>);

impl MeshError {
    /// Solves the section of `input`, of which `solution` is the result, with richer cells,
    /// if requested.
    pub fn new(input: &Input, solution: &SectionSolution, run: &Run) -> Self {
        let estimate = || discretization_error(&input.section, &solution.stiffness);
        Self(run.mesh_error.then(estimate))
    }

    /// The part of the report.
    pub fn table(&self, solution: &SectionSolution) -> String {
        match &self.0 {
            None => String::new(),
            Some(Ok(error)) => mesh_error_table(solution, error),
            Some(Err(failure)) => {
                format!("Discretization error\n  none: in the second analysis {failure}\n")
            }
        }
    }

    /// Writes the file, or removes the file of an earlier run.
    pub fn write(
        &self,
        input: &Input,
        solution: &SectionSolution,
        results: &mut ResultWriter,
    ) -> Result<(), OutputProblem> {
        let files = results.files().clone();
        let Some(Ok(error)) = &self.0 else {
            files.remove_mesh_error();
            return Ok(());
        };
        let (name, hash) = (&input.section.name, &input.summary.input_hash);
        let text = mesh_error_json(name, solution, error, hash);
        results.text(files.mesh_error(), &text)
    }
}
