//! All analyses requested by a section file, with one solver.

use std::path::Path;

use shared_geom::error::{Diagnostics, SourceLocation};

use crate::analysis::{Analysis, analyze};
use crate::failure::Failure;
use crate::input::Input;
use crate::solution::{DistributedState, EndEffects, ImposedSolutions, SectionSolution};

/// The solution of a section, and the further results that its file requests.
#[derive(Debug)]
pub(super) struct Solved {
    /// Properties and central solutions.
    pub solution: SectionSolution,
    /// Effects of temperature and of the imposed states of the input.
    pub imposed: ImposedSolutions,
    /// Contributions of distributed loads, parallel to the loads of the input.
    pub distributed: Vec<Option<DistributedState>>,
    /// The end effects, if requested.
    pub end_effects: Option<EndEffects>,
}

impl Solved {
    /// All analyses of the section that `input` requests; its end effects too if `ends`.
    ///
    /// # Errors
    /// The errors of these analyses.
    pub fn by(analysis: &Analysis<'_>, input: &Input, ends: bool) -> Result<Self, Failure> {
        let loads = &input.distributed;
        let acting: Vec<_> = loads.iter().filter(|load| !load.is_empty()).collect();
        let mut states = analysis.distributed(&acting)?.into_iter();
        let distributed = loads
            .iter()
            .map(|load| if load.is_empty() { None } else { states.next() });
        let wanted = input.end_effects.filter(|_| ends);
        let found = wanted.map(|wanted| analysis.end_effects(wanted));
        Ok(Self {
            imposed: analysis.all_imposed(&input.imposed)?,
            distributed: distributed.collect(),
            end_effects: found.transpose()?,
            solution: analysis.solution().clone(),
        })
    }

    /// Searches that did not converge, as text; `file` is the section file.
    pub fn open_problem(&self, file: &Path) -> Option<String> {
        let failure = open_end_effects(self.end_effects.as_ref()?)?;
        let location = SourceLocation::file(file.display().to_string());
        Some(Diagnostics::one(location, &failure).to_string())
    }
}

/// End effects that did not converge.
pub(super) fn open_end_effects(found: &EndEffects) -> Option<Failure> {
    let failure = Failure::EndEffects {
        change: found.change,
        vectors: found.vectors,
    };
    (!found.is_converged).then_some(failure)
}

/// Solves the section of `input`, with its imposed states and distributed loads; its end
/// effects too if `ends`.
///
/// # Errors
/// As [`Analysis::new`] and its methods.
pub(super) fn solve(input: &Input, ends: bool) -> Result<Solved, Failure> {
    let section = &input.section;
    let requests = input.end_effects.filter(|_| ends).is_some()
        || input.distributed.iter().any(|load| !load.is_empty())
        || !input.imposed.is_empty()
        || section.expands();
    if requests {
        return Solved::by(&Analysis::new(section)?, input, ends);
    }
    Ok(Solved {
        solution: analyze(section)?,
        imposed: ImposedSolutions::default(),
        distributed: vec![None; input.distributed.len()],
        end_effects: None,
    })
}
