//! Changes by initialization, to fulfill the constraints.

use std::fmt;

use nalgebra::Vector3;
use shared_geom::rotation::vector;

use crate::case::Model;
use crate::model::State;

/// Changes below this part of the size of the model, or of the fastest motion, are
/// round-off.
const VISIBLE: f64 = 1e-9;

/// Node quantity adjusted during initialization.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Changed {
    /// Position [m].
    Position,
    /// Orientation, by the components of the rotation vector of its change [rad].
    Orientation,
    /// Velocity [m/s].
    Velocity,
    /// Angular velocity [rad/s].
    AngularVelocity,
}

/// A change by initialization, to fulfill the constraints.
#[derive(Debug, Clone, PartialEq)]
pub struct StartChange {
    /// The node.
    pub node: String,
    /// The changed quantity.
    pub what: Changed,
    /// The component: 0 to 2 for x to z.
    pub component: usize,
    /// The given value [SI unit of the quantity].
    pub from: f64,
    /// The adjusted value [SI unit of the quantity].
    pub to: f64,
}

impl fmt::Display for StartChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let axis = ["x", "y", "z"][self.component];
        let (what, unit, scale) = match self.what {
            Changed::Position => ("position", "m", 1.0),
            Changed::Orientation => ("orientation", "deg", 180.0 / std::f64::consts::PI),
            Changed::Velocity => ("velocity", "m/s", 1.0),
            Changed::AngularVelocity => ("angular velocity", "rad/s", 1.0),
        };
        let number = |value: f64| {
            let text = format!("{:.9e}", scale * value);
            text.parse::<f64>().unwrap_or(value).to_string()
        };
        let about = match self.what {
            Changed::Position | Changed::Velocity => "along",
            Changed::Orientation | Changed::AngularVelocity => "about",
        };
        write!(
            f,
            "{what} of node \"{}\" {about} {axis}: from {} to {} {unit}",
            self.node,
            number(self.from),
            number(self.to)
        )
    }
}

/// Every component that initialization changed visibly.
pub(super) fn changes(model: &Model, given: &State, found: &State) -> Vec<StartChange> {
    let size = model.system.size();
    let fastest = |state: &State| {
        let of = state.nodes.iter().map(|node| {
            node.velocity
                .norm()
                .max(size * node.angular_velocity.norm())
        });
        of.fold(0.0, f64::max)
    };
    let fastest = fastest(given).max(fastest(found));
    let mut changes = Vec::new();
    let nodes = given.nodes.iter().zip(&found.nodes);
    for ((given, found), node) in nodes.zip(model.system.nodes()) {
        let turn = vector::from_rotation(&(found.rotation * given.rotation.transpose()));
        for (what, from, to, smallest) in [
            (
                Changed::Position,
                given.position,
                found.position,
                VISIBLE * size,
            ),
            (Changed::Orientation, Vector3::zeros(), turn, VISIBLE),
            (
                Changed::Velocity,
                given.velocity,
                found.velocity,
                VISIBLE * fastest,
            ),
            (
                Changed::AngularVelocity,
                given.angular_velocity,
                found.angular_velocity,
                VISIBLE * fastest / size,
            ),
        ] {
            for component in 0..3 {
                if (to[component] - from[component]).abs() > smallest {
                    changes.push(StartChange {
                        node: node.label.clone(),
                        what,
                        component,
                        from: from[component],
                        to: to[component],
                    });
                }
            }
        }
    }
    changes
}
