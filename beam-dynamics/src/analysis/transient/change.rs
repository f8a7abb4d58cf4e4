//! The changes that start-up makes, for the constraints to be fulfilled.

use std::fmt;

/// What of a node start-up changed.
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

/// A change that start-up made, for the constraints to be fulfilled.
#[derive(Debug, Clone, PartialEq)]
pub struct StartChange {
    /// The node.
    pub node: String,
    /// What was changed.
    pub what: Changed,
    /// The component: 0 to 2 for x to z.
    pub component: usize,
    /// As it was given [SI unit of it].
    pub from: f64,
    /// As it is [SI unit of it].
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
