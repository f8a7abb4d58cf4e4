//! Changes by initialization, to fulfill the constraints.

use std::fmt;

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
