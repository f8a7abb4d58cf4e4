//! Rigid hub: blades on the hub, with pitch bearings at most. Propellers, wind turbines.

use super::HubKind;
use crate::input::rotors::base::Base;
use crate::input::rotors::problem::RotorProblem;

/// The kind.
pub(super) const KIND: HubKind = HubKind {
    word: "rigid",
    tilts: false,
    problem,
    yoke: |base| (base.hub(), Vec::new()),
};

fn problem(base: &Base) -> Option<RotorProblem> {
    base.hinges
        .iter()
        .any(|hinge| hinge.kind != 2)
        .then(|| RotorProblem::Hub {
            hub: KIND.word,
            found: "has a flap or lag hinge".to_owned(),
            expected: "none, or the kind \"hingeless\" or \"articulated\"",
        })
}
