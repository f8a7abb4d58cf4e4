//! All that is asked of the solver for a section file, in one analysis.

use std::path::Path;

use shared_geom::error::{Diagnostics, Place};

use crate::analysis::{Analysis, analyze};
use crate::failure::Failure;
use crate::input::Input;
use crate::solution::{DistributedState, EndEffects, SectionSolution};

/// The solution of a section, and what its file asks for beside it.
#[derive(Debug)]
pub(super) struct Solved {
    /// Properties and central solutions.
    pub solution: SectionSolution,
    /// What loads along the beam add, parallel to the loads of the input.
    pub distributed: Vec<Option<DistributedState>>,
    /// The end effects, if asked for.
    pub end_effects: Option<EndEffects>,
}

impl Solved {
    /// What did not converge, in words; `file` is the section file.
    pub fn open_problem(&self, file: &Path) -> Option<String> {
        let found = self.end_effects.as_ref().filter(|f| !f.is_converged)?;
        let failure = Failure::EndEffects {
            change: found.change,
            vectors: found.vectors,
        };
        let place = Place::file(file.display().to_string());
        Some(Diagnostics::one(place, &failure).to_string())
    }
}

/// Solves the section of `input`, with its distributed loads; its end effects too if
/// `ends`.
///
/// # Errors
/// As [`Analysis::new`] and its questions.
pub(super) fn solve(input: &Input, ends: bool) -> Result<Solved, Failure> {
    let wanted = input.end_effects.filter(|_| ends);
    let loads: Vec<_> = input.distributed.iter().collect();
    if wanted.is_none() && loads.iter().all(|load| load.is_empty()) {
        return Ok(Solved {
            solution: analyze(&input.section)?,
            distributed: vec![None; loads.len()],
            end_effects: None,
        });
    }
    let analysis = Analysis::new(&input.section)?;
    let acting: Vec<_> = loads.iter().copied().filter(|l| !l.is_empty()).collect();
    let mut states = analysis.distributed(&acting)?.into_iter();
    let distributed = loads.iter().map(|load| match load.is_empty() {
        true => None,
        false => states.next(),
    });
    Ok(Solved {
        distributed: distributed.collect(),
        end_effects: wanted
            .map(|wanted| analysis.end_effects(wanted))
            .transpose()?,
        solution: analysis.solution().clone(),
    })
}
