//! The pitch bearing of a blade and its control.
//!
//! A link with the stiffness k and the coupling `K_p = tan(delta_3)` has, by the angle p of the bearing and the
//! angle beta of the flap hinges inboard of it, the moments
//!
//! ```text
//! M = k (p + K_p beta - theta)     on the blade -M, on the flap hinges -K_p M
//! ```
//!
//! a spring of the bearing, whose moment is sensed, and moments between the parts of the hinges. On hubs that
//! tilt, and on flexbeams, it is a spring of the rotation vector psi of the blade against the hub, in the axes of
//! the blade, where the pitch is `psi_x` and the flap angle `-psi_y`:
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

use super::base::{Base, FLAP, Hinge, Local, PITCH, Restraint, lengths, signed};
use super::controls::Sum;
use super::damper::signal;

/// The quantities of the sensors of a coupling.
const MOMENT: &str = "spring_moment";
const ANGLE: &str = "joint_angle";
const RATE: &str = "joint_angular_velocity";

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

/// The cards of the pitch bearing of blade `k` between two nodes, outboard of flap hinges between others.
pub(super) fn cards(
    base: &Base,
    (k, nodes): (usize, [&str; 2]),
    (hinge, flaps): (&Hinge, &[[String; 2]]),
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
        Control::Bearing(link) if link.delta_3 != 0.0 => {
            let coupling = Coupling {
                base,
                k,
                link,
                flaps,
            };
            let bearing = bearing(&hinge.restraint);
            [bearing]
                .into_iter()
                .chain(coupling.cards(nodes, command))
                .collect()
        }
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

/// The coupling of a pitch bearing with the flap hinges inboard of it, of blade `k`.
struct Coupling<'a> {
    base: &'a Base,
    k: usize,
    link: &'a Link,
    /// The nodes of each flap hinge.
    flaps: &'a [[String; 2]],
}

impl Coupling<'_> {
    /// The spring of the bearing, the part of the flap angle in its moment, and the moments on the flap hinges.
    fn cards(&self, nodes: [&str; 2], command: &Sum) -> Vec<Card> {
        let Self {
            base,
            k,
            link,
            flaps,
        } = self;
        let (arm, name) = (base.arm(*k), base.of_blade(*k, "pitch link"));
        let spring = Link {
            delta_3: 0.0,
            ..**link
        };
        let sensor = |of: &str, quantity: &str, unit: &str| {
            Card::single(["sensors", &signal(&format!("{of} {quantity}"))], base.line)
                .with("quantity", quantity)
                .with("of", of)
                .with("unit", unit)
        };
        let mut cards = vec![
            base.listed("spring")
                .with("name", name.as_str())
                .with("nodes", Content::texts(nodes))
                .with("in", arm.name.as_str())
                .with("rotational_law", law(base, &spring, command)),
            sensor(&name, MOMENT, "N*m").with("component", "x"),
        ];
        for [_, flap] in *flaps {
            cards.push(sensor(flap, ANGLE, "rad"));
            if link.damping != 0.0 {
                cards.push(sensor(flap, RATE, "rad/s").with("component", "x"));
            }
        }
        let added = self.added();
        let ratio = signed(link.delta_3.tan());
        let moment = |part: &str, nodes: [&str; 2], axis: Vector3<f64>, drive: String| {
            base.listed("internal_force")
                .with("name", format!("{name} {part}"))
                .with("nodes", Content::texts(nodes))
                .with("in", arm.name.as_str())
                .with("moment", Content::quantities(axis.iter().copied(), "N*m"))
                .with("drive", format!("= {drive}"))
        };
        let sign = signed(base.side());
        let total = format!(
            "{ratio}*({sign}*{} + {added})",
            signal(&format!("{name} {MOMENT}"))
        );
        cards.push(moment(
            "coupling",
            nodes,
            base.axis(PITCH),
            format!("-({added})"),
        ));
        for (number, [inner, flap]) in flaps.iter().enumerate() {
            let part = format!("on flap {}", number + 1);
            let axis = base.axis(FLAP);
            cards.push(moment(&part, [inner, flap], axis, format!("-{total}")));
        }
        cards
    }

    /// The moment about the bearing by the flap angles, as an expression.
    fn added(&self) -> String {
        let link = self.link;
        let ratio = link.delta_3.tan();
        let terms = self.flaps.iter().flat_map(|[_, flap]| {
            let term = |factor: f64, quantity: &str| {
                let name = signal(&format!("{flap} {quantity}"));
                (factor != 0.0).then(|| format!("{}*{name}", signed(ratio * factor)))
            };
            [term(link.stiffness, ANGLE), term(link.damping, RATE)]
        });
        terms.flatten().collect::<Vec<_>>().join(" + ")
    }
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
