//! Solutions of sections whose result files are up to date: they are not solved again.

use shared_geom::section;

use super::analyze::{Job, Run, made_from};
use super::solved::solve;
use crate::failure::Failure;
use crate::input::{Input, read_warping};
use crate::output::{AnalysisRecord, OutputFiles};
use crate::solution::SectionSolution;

/// The solution of a section of a blade, and whether it was there.
#[derive(Debug)]
pub(super) struct Restored {
    pub solution: SectionSolution,
    /// Whether it is made from the result files; else the section has been solved.
    pub is_known: bool,
}

impl Restored {
    /// The solution from the files of `job`, if `section-analyzer blade` wrote them for this
    /// input; else by solving the section.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn new(input: &Input, job: &Job) -> Result<Self, Failure> {
        let known = known(input, job);
        let is_known = known.is_some();
        let solution = match known {
            Some(solution) => solution,
            None => solve(input, false)?.solution,
        };
        Ok(Self { solution, is_known })
    }
}

/// The solution from the result files; `None` if they are missing, changed or of other inputs.
fn known(input: &Input, job: &Job) -> Option<SectionSolution> {
    let section = &input.section;
    if !section.electrodes.is_empty() {
        return None;
    }
    let files = OutputFiles::new(&job.folder, &job.name).ok()?;
    let record = AnalysisRecord::read(&files)?;
    if !record.holds(&files, &made_from(input, &Run::plain(false))) {
        return None;
    }
    let properties = section::read(&files.properties()).ok()?;
    let warping = read_warping(&files.warping_field()).ok()?;
    if warping.nrows() != 3 * section.mesh.nodes.len() {
        return None;
    }
    SectionSolution::of_results(&properties.stiffness, &properties.mass, warping)
}
