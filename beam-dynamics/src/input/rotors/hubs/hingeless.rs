//! Hingeless hub: blades that bend in flap and lag; hinges with springs may represent flexures.

use super::HubKind;
use crate::input::rotors::base::{Base, LAG, PITCH};
use crate::input::rotors::problem::RotorProblem;

/// The kind.
pub(super) const KIND: HubKind = HubKind {
    word: "hingeless",
    tilts: false,
    problem,
    yoke: |base| (base.hub(), Vec::new()),
};

fn problem(base: &Base) -> Option<RotorProblem> {
    let mut hinges = base.hinges.iter();
    let unstated = hinges.find(|hinge| hinge.kind != PITCH && !hinge.has_stiffness)?;
    let kind = if unstated.kind == LAG { "lag" } else { "flap" };
    Some(RotorProblem::Hub {
        hub: KIND.word,
        found: format!("has a {kind} hinge without \"stiffness\""),
        expected: "the stiffness of the flexure that it represents (0 if it turns freely), or the kind \
                   \"articulated\"",
    })
}
