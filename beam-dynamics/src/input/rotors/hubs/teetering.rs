//! Teetering hub: two blades on one yoke, whose hinge is on the shaft, across both blades.

use nalgebra::Vector3;
use shared_geom::document::Card;

use super::HubKind;
use crate::input::rotors::base::{Base, Hinge};
use crate::input::rotors::problem::RotorProblem;
use crate::input::rotors::stops;

/// The kind.
pub(super) const KIND: HubKind = HubKind {
    word: "teetering",
    tilts: true,
    problem,
    yoke,
};

fn problem(base: &Base) -> Option<RotorProblem> {
    (base.count != 2).then(|| RotorProblem::Hub {
        hub: KIND.word,
        found: format!("has {} blades", base.count),
        expected: "2, or the kind \"gimballed\"",
    })
}

fn yoke(base: &Base) -> (String, Vec<Card>) {
    let (hub, yoke, name) = (base.hub(), base.part("yoke"), base.part("teeter"));
    let arm = base.arm(0);
    let nodes = [hub.as_str(), &yoke];
    let mut cards = vec![
        base.node(&yoke, &base.local(), Vector3::zeros()),
        base.hinge(
            &name,
            nodes,
            (&arm, base.turned(&-Vector3::y())),
            &base.tilt,
        ),
    ];
    cards.extend(base.yoke.as_ref().map(|lump| base.body(&yoke, lump)));
    let hinge = Hinge {
        kind: 0,
        offset: 0.0,
        restraint: base.tilt,
        has_stiffness: false,
        damper: None,
    };
    cards.extend(stops::cards(
        base,
        (&name, nodes),
        (&arm, stops::across(base)),
        &hinge,
    ));
    (yoke, cards)
}
