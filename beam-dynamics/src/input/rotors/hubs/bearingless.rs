//! Bearingless hub: blades on flexbeams, whose twist is the pitch.

use super::HubKind;
use crate::input::rotors::base::Base;
use crate::input::rotors::problem::RotorProblem;

/// The kind.
pub(super) const KIND: HubKind = HubKind {
    word: "bearingless",
    tilts: false,
    problem,
    yoke: |base| (base.hub(), Vec::new()),
};

fn problem(base: &Base) -> Option<RotorProblem> {
    (!base.has_flexbeam).then(|| RotorProblem::Hub {
        hub: KIND.word,
        found: "has no \"flexbeam\"".to_owned(),
        expected: "[rotor.flexbeam], the beam between hub and blade",
    })
}
