//! Articulated hub: blades on flap and lag hinges.

use super::HubKind;
use crate::input::rotors::base::Base;
use crate::input::rotors::problem::RotorProblem;

/// The kind.
pub(super) const KIND: HubKind = HubKind {
    word: "articulated",
    tilts: false,
    problem,
    yoke: |base| (base.hub(), Vec::new()),
};

fn problem(base: &Base) -> Option<RotorProblem> {
    let flaps = base.hinges.iter().any(|hinge| hinge.kind == 0);
    (!flaps).then(|| RotorProblem::Hub {
        hub: KIND.word,
        found: "has no flap hinge".to_owned(),
        expected: "[[rotor.hinge]] with kind = \"flap\", or the kind \"hingeless\", whose blades may have \
                   lag hinges alone",
    })
}
