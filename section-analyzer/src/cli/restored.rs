//! Solutions of sections whose result files are up to date: they are not solved again.

use nalgebra::DMatrix;
use shared_geom::section::{self, SectionProperties};

use super::analyze::{Analyzed, Job, Run, made_from};
use super::solved::solve;
use crate::failure::Failure;
use crate::input::{Input, read_warping};
use crate::output::{AnalysisRecord, OutputFiles};
use crate::solution::SectionSolution;

/// The solution of a section of a blade, and whether it was there.
#[derive(Debug)]
pub(super) struct Restored {
    pub solution: SectionSolution,
    /// The properties of the result files from which it is made; without them the section has been
    /// solved.
    pub known: Option<SectionProperties>,
}

impl Restored {
    /// The solution from the files of `job`, if `section-analyzer blade` wrote them for this
    /// input; else by solving the section.
    ///
    /// # Errors
    /// As [`solve`].
    pub fn new(input: &Input, job: &Job) -> Result<Self, Failure> {
        Ok(match known(input, job) {
            Some((properties, solution)) => Self {
                solution,
                known: Some(properties),
            },
            None => Self {
                solution: solve(input, false)?.solution,
                known: None,
            },
        })
    }
}

/// The solution of an analyzed section with its `properties`: from the warping of this analysis,
/// or of the files of `job` if they have not changed. Both give the same numbers.
///
/// # Errors
/// As [`solve`].
pub(super) fn solution_of(
    analyzed: Analyzed,
    job: &Job,
    properties: &SectionProperties,
) -> (Input, Result<SectionSolution, Failure>) {
    let Analyzed { input, solution } = analyzed;
    let of_files = || warping(&input, &OutputFiles::new(&job.folder, &job.name).ok()?);
    let warping = solution.map(|solution| solution.warping).or_else(of_files);
    let known = warping.and_then(|warping| from_results(&input, properties, warping));
    let solution = match known {
        Some(solution) => Ok(solution),
        None => solve(&input, false).map(|solved| solved.solution),
    };
    (input, solution)
}

/// The solution from the result files; `None` if they are missing, changed or of other inputs.
fn known(input: &Input, job: &Job) -> Option<(SectionProperties, SectionSolution)> {
    let files = OutputFiles::new(&job.folder, &job.name).ok()?;
    let record = AnalysisRecord::read(&files)?;
    if !record.holds(&files, &made_from(input, &Run::plain(false))) {
        return None;
    }
    let properties = section::read(&files.properties()).ok()?;
    let solution = from_results(input, &properties, warping(input, &files)?)?;
    Some((properties, solution))
}

/// The warping in the result files of a section.
fn warping(input: &Input, files: &OutputFiles) -> Option<DMatrix<f64>> {
    let found = read_warping(&files.warping_field()).ok()?;
    (found.nrows() == 3 * input.section.mesh.nodes.len()).then_some(found)
}

/// The solution with these results; `None` with electrodes, whose effects are not among them.
fn from_results(
    input: &Input,
    properties: &SectionProperties,
    warping: DMatrix<f64>,
) -> Option<SectionSolution> {
    if !input.section.electrodes.is_empty() {
        return None;
    }
    SectionSolution::of_results(&properties.stiffness, &properties.mass, warping)
}
