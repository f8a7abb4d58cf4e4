//! Hingeless hub: blades that bend in flap and lag; hinges with springs may represent flexures.

use super::HubKind;
use crate::input::rotors::base::Base;
use crate::input::rotors::problem::RotorProblem;

/// The kind.
pub(super) const KIND: HubKind = HubKind {
    word: "hingeless",
    tilts: false,
    problem,
    yoke: |base| (base.hub(), Vec::new()),
};

fn problem(base: &Base) -> Option<RotorProblem> {
    let is_free = base
        .hinges
        .iter()
        .any(|hinge| hinge.kind != 2 && hinge.restraint.stiffness == 0.0);
    is_free.then(|| RotorProblem::Hub {
        hub: KIND.word,
        found: "has a flap or lag hinge without \"stiffness\"".to_owned(),
        expected: "the stiffness of the flexure that it represents, or the kind \"articulated\"",
    })
}
