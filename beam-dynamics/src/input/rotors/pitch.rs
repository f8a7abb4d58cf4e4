//! The pitch bearing of a blade and its control.
//!
//! A link with the stiffness k and the coupling `K_p = tan(delta_3)` is a spring of the rotation
//! vector psi of the blade against the hub, in the axes of the blade, where the pitch is `psi_x` and
//! the flap angle `-psi_y`:
//!
//! ```text
//! M = k n (n . psi - theta)        n = (1, -K_p, 0)
//! ```
//!
//! so that the pitch is `theta - K_p beta` without a moment about the bearing, and the moment
//! acts on flapping too. The sign is the one of rotors whose pitch falls with flapping up for
//! positive `delta_3`. Of the mirror image n and theta have the opposite sign.

use nalgebra::Vector3;
use shared_geom::document::{Card, Content};

use super::base::{Base, Hinge, Local, Restraint, lengths};
use super::controls::Sum;

/// Control stiffness between swashplate and blade.
#[derive(Debug, Clone, Copy)]
pub(super) struct Link {
    /// About the pitch axis \[N m\].
    pub stiffness: f64,
    /// About the pitch axis \[N m s\].
    pub damping: f64,
    /// Pitch-flap coupling \[rad\].
    pub delta_3: f64,
}

/// Control of the pitch bearings.
#[derive(Debug, Clone, Copy)]
pub(super) enum Control {
    /// None at the bearing: it is free but for its spring, or has a link to a plate.
    Free,
    /// The bearing has the commanded angle.
    Prescribed,
    /// A spring at the bearing.
    Bearing(Link),
    /// A spring from the hub to the blade.
    Coupled(Link),
}

/// The cards of the pitch bearing of blade `k` between two nodes.
pub(super) fn cards(
    base: &Base,
    (k, nodes): (usize, [&str; 2]),
    hinge: &Hinge,
    (control, command): (&Control, &Sum),
) -> Vec<Card> {
    let arm = base.arm(k);
    let name = base.of_blade(k, "pitch");
    let axis = base.turned(&Vector3::x());
    let bearing = |restraint: &Restraint| base.hinge(&name, nodes, (&arm, axis), restraint);
    match control {
        Control::Free => vec![bearing(&hinge.restraint)],
        Control::Prescribed => vec![
            base.joint(&name, "revolute", &nodes)
                .with("in", arm.name.as_str())
                .with("at", lengths(&Vector3::new(hinge.offset, 0.0, 0.0)))
                .with("axis", Content::numbers(axis.iter().copied()))
                .with("angle", command.content()),
        ],
        Control::Bearing(link) => {
            let restraint = Restraint {
                stiffness: link.stiffness,
                damping: link.damping,
                stop: None,
            };
            let flexure = flexure(base, (k, nodes), &arm, &hinge.restraint);
            let link = bearing(&restraint).with("angle", command.content());
            [link].into_iter().chain(flexure).collect()
        }
        Control::Coupled(link) => vec![
            bearing(&hinge.restraint),
            coupled(base, (k, nodes[1]), &arm, (link, command)),
        ],
    }
}

/// The spring of a link from the hub to a node of blade `k`.
pub(super) fn coupled(
    base: &Base,
    (k, node): (usize, &str),
    arm: &Local,
    (link, command): (&Link, &Sum),
) -> Card {
    let hub = base.hub();
    base.listed("spring")
        .with("name", base.of_blade(k, "pitch link"))
        .with("nodes", Content::texts([hub.as_str(), node]))
        .with("in", arm.name.as_str())
        .with("rotational_law", law(base, link, command))
}

/// The spring of the bearing itself, beside the spring of the control.
fn flexure(
    base: &Base,
    (k, nodes): (usize, [&str; 2]),
    arm: &Local,
    restraint: &Restraint,
) -> Option<Card> {
    (restraint.stiffness != 0.0 || restraint.damping != 0.0).then(|| {
        base.listed("spring")
            .with("name", base.of_blade(k, "pitch flexure"))
            .with("nodes", Content::texts(nodes))
            .with("in", arm.name.as_str())
            .with(
                "rotational_stiffness",
                Content::quantities([restraint.stiffness, 0.0, 0.0], "N*m"),
            )
            .with(
                "rotational_damping",
                Content::quantities([restraint.damping, 0.0, 0.0], "N*m*s"),
            )
    })
}

fn law(base: &Base, link: &Link, command: &Sum) -> Content {
    let normal = Vector3::new(1.0, -link.delta_3.tan(), 0.0);
    let matrix = |value: f64| {
        let matrix = normal * normal.transpose() * value;
        Content::list(
            matrix
                .row_iter()
                .map(|row| Content::numbers(row.iter().copied())),
        )
    };
    let units = &base.units;
    let spring = Content::table([
        ("kind", "linear".into()),
        ("stiffness", matrix(link.stiffness / units.moment)),
        ("prestrain", Content::numbers([base.side(), 0.0, 0.0])),
        ("prestrain_drive", command.content()),
    ]);
    let damper = Content::table([
        ("kind", "viscous".into()),
        (
            "viscosity",
            matrix(link.damping / (units.moment * units.time)),
        ),
    ]);
    if link.damping == 0.0 {
        spring
    } else {
        Content::list([spring, damper])
    }
}
