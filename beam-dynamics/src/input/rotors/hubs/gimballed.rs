//! Gimballed hub: two universal joints and a link between mast and yoke, which turn at equal
//! speeds at every tilt.
//!
//! ```text
//!                 yoke  o======== blades
//!                       |
//!            upper [+]--'   at d along the hub axis      axes: link y, yoke x
//!                   #
//!                   #       link of two parts that slides, in phase
//!                   #
//!            lower [+]      at d along the mast          axes: mast x, link y
//!                   |
//!                 mast      spherical bearing of the yoke at the center
//! ```
//!
//! The link halves the tilt because both joints have the distance d from the center; their
//! distance is `2 d cos(tilt/2)`, so that the link must slide.

use nalgebra::Vector3;
use shared_geom::document::{Card, Content};

use super::HubKind;
use crate::input::rotors::base::{Base, angles, lengths};
use crate::input::rotors::problem::RotorProblem;
use crate::input::rotors::stops;

/// The kind.
pub(super) const KIND: HubKind = HubKind {
    word: "gimballed",
    tilts: true,
    problem,
    yoke,
};

fn problem(base: &Base) -> Option<RotorProblem> {
    (base.link.is_none()).then(|| RotorProblem::Hub {
        hub: KIND.word,
        found: "has no \"link\"".to_owned(),
        expected: "the distance of each universal joint from the center of the hub",
    })
}

fn yoke(base: &Base) -> (String, Vec<Card>) {
    let [hub, yoke] = [base.hub(), base.part("yoke")];
    let [lower, upper] = ["lower", "upper"].map(|end| base.part(&format!("{end} link")));
    let center = Vector3::zeros();
    let arm = base.placed(&(Vector3::z() * base.link.unwrap_or_default()));
    let local = base.local();
    let mut cards = vec![
        base.node(&lower, &local, -arm),
        base.node(&upper, &local, arm),
        base.node(&yoke, &local, center),
    ];
    cards.extend(base.yoke.as_ref().map(|lump| base.body(&yoke, lump)));
    let [x, y] = [Vector3::x(), Vector3::y()];
    let universal = |end: &str, nodes: [&str; 2], at: Vector3<f64>, axes: [Vector3<f64>; 2]| {
        let axes = axes.map(|axis| Content::numbers(axis.iter().copied()));
        base.joint(&base.part(&format!("{end} cross")), "universal", &nodes)
            .with("in", base.name.as_str())
            .with("at", lengths(&at))
            .with("axes", Content::list(axes))
    };
    cards.push(universal("lower", [&hub, &lower], -arm, [x, y]));
    cards.push(universal("upper", [&upper, &yoke], arm, [y, x]));
    cards.push(
        base.joint(&base.part("link"), "prismatic", &[&lower, &upper])
            .with("in", base.name.as_str())
            .with("at", lengths(&center))
            .with("axis", Content::numbers([0.0, 0.0, 1.0])),
    );
    cards.push(
        base.joint(&base.part("bearing"), "spherical", &[&hub, &yoke])
            .with("in", base.name.as_str())
            .with("at", lengths(&center)),
    );
    cards.extend(restraints(base, [&hub, &yoke]));
    (yoke, cards)
}

/// The spring, damper and stop of the gimbal, equal in all directions.
fn restraints(base: &Base, nodes: [&str; 2]) -> Vec<Card> {
    let spring = |what: &str| {
        base.listed("spring")
            .with("name", base.part(&format!("gimbal {what}")))
            .with("nodes", Content::texts(nodes))
            .with("in", base.name.as_str())
            .with("orientation", angles(&Vector3::zeros()))
    };
    let tilt = &base.tilt;
    let both = |value: f64, unit| Content::quantities([value, value, 0.0], unit);
    let mut cards = Vec::new();
    if tilt.stiffness != 0.0 || tilt.damping != 0.0 {
        cards.push(
            spring("spring")
                .with("rotational_stiffness", both(tilt.stiffness, "N*m"))
                .with("rotational_damping", both(tilt.damping, "N*m*s")),
        );
    }
    cards.extend(
        tilt.stop
            .map(|stop| spring("stop").with("rotational_law", stops::of_tilt(&stop, &base.units))),
    );
    cards
}
