//! Problems of rotors.

use shared_geom::error::{Explain, counted, quoted};

use crate::input::rotor_speed::rpm;
use crate::input::short_number;

/// A problem of a `[[rotor]]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RotorProblem {
    /// A name that cannot be part of the names of signals.
    #[error("\"{name}\" is no name of a rotor, expected letters, digits and \"_\"")]
    Name {
        /// The name.
        name: String,
    },
    /// An azimuth of more than a turn.
    #[error("the azimuth of the first blade is {turns:.4} turns, expected at most one")]
    Azimuth {
        /// The azimuth in turns.
        turns: f64,
    },
    /// Two rotors of a name.
    #[error("rotor \"{name}\" is already defined, expected one of this name")]
    DoubledName {
        /// The name.
        name: String,
    },
    /// A shaft that nothing turns and nothing brakes.
    #[error("rotor \"{name}\" has no drive, expected \"speed\", \"angle\" or \"torque\"")]
    NoDrive {
        /// Name of the rotor.
        name: String,
    },
    /// Two drives of a shaft.
    #[error("rotor \"{name}\" has \"angle\" and \"torque\", expected one of them")]
    TwoDrives {
        /// Name of the rotor.
        name: String,
    },
    /// Azimuth zero along the shaft.
    #[error("\"aft\" is along the axis of the rotor, expected a direction across it")]
    AftAlongAxis,
    /// A hub with hinges that its kind does not have.
    #[error("a hub of the kind \"{hub}\" {found}, expected {expected}")]
    Hub {
        /// Kind of the hub.
        hub: &'static str,
        /// Its content, as text.
        found: String,
        /// The expected content, as text.
        expected: &'static str,
    },
    /// A key that belongs to another kind of hub.
    #[error("a hub of the kind \"{hub}\" has no \"{key}\"")]
    NotOfHub {
        /// Kind of the hub.
        hub: &'static str,
        /// The key.
        key: &'static str,
        /// Kinds of hubs that have it.
        kinds: &'static [&'static str],
    },
    /// A key of `[[blade]]` that follows from the rotor.
    #[error("[rotor.blade] has \"{key}\", which follows from the rotor")]
    OfBlade {
        /// The key.
        key: String,
    },
    /// Hinges that are not in order from the hub outward, or beyond the root.
    #[error(
        "{hinge} is at {} m from the center of the hub, expected from {} m to {} m",
        short_number(*.found, 6),
        short_number(*.from, 6),
        short_number(*.to, 6)
    )]
    HingeOrder {
        /// The hinge, as text.
        hinge: String,
        /// Its offset \[m\].
        found: f64,
        /// Offset of the hinge before \[m\].
        from: f64,
        /// Radius of the root \[m\].
        to: f64,
    },
    /// Two hinges of a kind at one place, neither with a spring.
    #[error(
        "two {kind} hinges are at {} m from the center of the hub, and neither has a stiffness, expected one there",
        short_number(*.offset, 6)
    )]
    HingesAlike {
        /// Their kind.
        kind: &'static str,
        /// Their offset \[m\].
        offset: f64,
    },
    /// A stop without an angle, or with angles in the wrong order.
    #[error("the stop has {found}, expected \"lower\" below \"upper\", or one of them")]
    Stop {
        /// Its angles, as text.
        found: &'static str,
    },
    /// A curve of a damper that is no function of the rate.
    #[error(
        "the damper has {} and {} under \"{key}\", expected as many of each, at least two, and \
         ascending rates",
        counted(*rates, "rate"),
        counted(*moments, "value")
    )]
    Curve {
        /// Number of rates.
        rates: usize,
        /// Number of moments or forces.
        moments: usize,
        /// Their key.
        key: &'static str,
    },
    /// A curve of a damper that feeds energy.
    #[error(
        "value {point} under \"{key}\" has the opposite sign of its rate: the damper would drive the \
         motion, expected values that resist it"
    )]
    DrivingDamper {
        /// Number of the value, from one.
        point: usize,
        /// Their key.
        key: &'static str,
    },
    /// A number of pitches that is not the number of blades.
    #[error("\"individual\" lists {found}, expected {expected}: one per blade")]
    Individual {
        /// Number of drives.
        found: usize,
        /// Number of blades.
        expected: usize,
    },
    /// A pitch over the azimuth, where the azimuth is no expression.
    #[error("the pitch depends on the azimuth, but {reason}")]
    NoAzimuth {
        /// The reason, as text.
        reason: &'static str,
    },
    /// A prescribed pitch that needs a link.
    #[error("the pitch of rotor \"{name}\" is prescribed at its bearing, but {reason}")]
    NeedsLink {
        /// Name of the rotor.
        name: String,
        /// The reason, as text.
        reason: &'static str,
    },
    /// A damper on a part that the rotor does not have.
    #[error("\"{key}\" of [rotor.lag_damper] is \"{word}\", but rotor \"{name}\" has {lacks}")]
    NoPartOfDamper {
        /// Name of the rotor.
        name: String,
        /// The key.
        key: &'static str,
        /// Its word.
        word: &'static str,
        /// The missing part, as text.
        lacks: &'static str,
    },
    /// A table without the one that uses it.
    #[error("{} has \"{key}\" without \"{needed}\", expected both", owner(name))]
    Idle {
        /// Name of the rotor, or the title of its table.
        name: String,
        /// The key.
        key: &'static str,
        /// The other key.
        needed: &'static str,
    },
    /// Two tables that exclude each other.
    #[error("{} has \"{key}\" and \"{other}\", expected one of them", owner(name))]
    Both {
        /// Name of the rotor, or the title of its table.
        name: String,
        /// A key.
        key: &'static str,
        /// Another key.
        other: &'static str,
    },
    /// A plate that is not below the ends of its links.
    #[error(
        "\"below\" is {} m, expected more than {} m: the ends of the links on the blades are there",
        short_number(*.found, 6),
        short_number(*.needed, 6)
    )]
    NoLength {
        /// Distance of the plate \[m\].
        found: f64,
        /// Distance of the ends of the links \[m\].
        needed: f64,
    },
    /// A snubber on a flexbeam that has no node there.
    #[error(
        "the snubber is at {} m, where the flexbeam has no node{}",
        short_number(*.offset, 6),
        nearest.map_or(String::new(), |at| format!(": the nearest is at {} m", short_number(at, 6)))
    )]
    NoHolder {
        /// Offset of the snubber \[m\].
        offset: f64,
        /// Offset of the nearest node \[m\]; `None` for a flexbeam from a file.
        nearest: Option<f64>,
    },
    /// A governor that holds no forward speed.
    #[error("the governor of rotor \"{name}\" holds {}, expected a speed above zero", rpm(*.speed))]
    Governed {
        /// Name of the rotor.
        name: String,
        /// The speed \[rad/s\].
        speed: f64,
    },
    /// Links without a lever about the pitch axis.
    #[error("\"horn\" is on the pitch axis, expected a distance ahead or behind")]
    NoLever,
    /// Not three actuators, or some at one azimuth.
    #[error(
        "\"azimuths\" lists {} actuators at {} different azimuths, expected three",
        .found[0], .found[1]
    )]
    Actuators {
        /// Their number, and the number of different azimuths.
        found: [usize; 2],
    },
    /// A coupling whose tangent is beyond all use.
    #[error("\"delta_3\" is {} deg, expected from -80 to 80 deg", short_number(*.degrees, 4))]
    Steep {
        /// The angle \[deg\].
        degrees: f64,
    },
    /// A pitch that no position of the plate gives.
    #[error("no position of the plate gives the pitch{}", from_nearest(*.off))]
    Unreachable {
        /// Remaining error of the iteration, as a height at the horn \[m\].
        off: f64,
    },
    /// A control that is no expression, for lengths of actuators, or beside sensed quantities.
    #[error("\"{key}\" is a drive by name or table, expected a number or an expression of t")]
    NotWritten {
        /// The key.
        key: &'static str,
    },
    /// A model that turns at another speed than the rotor.
    #[error(
        "rotor \"{name}\" turns at {} rpm, but the run starts at {} rpm",
        short_number(*.own, 6),
        short_number(*.start, 6)
    )]
    Speeds {
        /// Name of the rotor.
        name: String,
        /// Its speed \[rpm\].
        own: f64,
        /// Speed of the start \[rpm\].
        start: f64,
    },
    /// Airfoils that move backward.
    #[error(
        "rotor \"{name}\" turns at {}, so that its airfoils move backward, expected a speed above 0",
        rpm(*speed)
    )]
    Backward {
        /// Name of the rotor.
        name: String,
        /// Its speed \[rad/s\].
        speed: f64,
    },
    /// A free wheel that never holds.
    #[error(
        "rotor \"{name}\" turns at {}, but its free wheel drives in the sense of \"axis\" only",
        rpm(*speed)
    )]
    Overrun {
        /// Name of the rotor.
        name: String,
        /// Its speed \[rad/s\].
        speed: f64,
    },
    /// Two speeds of a shaft.
    #[error(
        "rotor \"{name}\" has the \"speed\" {}, but its \"angle\" begins with {}",
        rpm(speeds[0]),
        rpm(speeds[1])
    )]
    Angle {
        /// Name of the rotor.
        name: String,
        /// The given one, and the one of the angle at time zero \[rad/s\].
        speeds: [f64; 2],
    },
    /// A trim at rest of a rotor that turns.
    #[error(
        "rotor \"{name}\" turns at {}, but [trim] has no \"speed\": in its equilibrium the model \
         is at rest",
        rpm(*speed)
    )]
    Still {
        /// Name of the rotor.
        name: String,
        /// Its speed \[rad/s\].
        speed: f64,
    },
    /// A control of an equilibrium that acts over the azimuth.
    #[error(
        "\"{control}\" of [trim] is cyclic pitch of rotor \"{name}\", which changes over the azimuth: in \
         an equilibrium it would stay as at the time zero"
    )]
    HeldControl {
        /// Name of the rotor.
        name: String,
        /// Name of the control.
        control: String,
    },
    /// A model that turns about another axis than the rotor.
    #[error("the model turns about the axis of [hub], and rotor \"{name}\" has another")]
    Axes {
        /// Name of the rotor.
        name: String,
    },
    /// A model that turns with the support of the rotor.
    #[error(
        "rotor \"{name}\" turns on a part that does not, but a model with a speed of [modes], [static] or \
         start = \"rotating\" turns as a whole"
    )]
    Carried {
        /// Name of the rotor.
        name: String,
    },
    /// A tower or a wing without elasticity, or with two.
    #[error("the {part} needs \"properties\" or \"file\", and not both")]
    OneElasticity {
        /// The part, as text.
        part: &'static str,
    },
    /// Rotors in polar copies.
    #[error("[[repeat]] has a rotor, expected [[rotor]] outside of it")]
    Repeated,
    /// A damper between two points that are one.
    #[error(
        "\"hub\" and \"blade\" of [rotor.lag_damper] are the same point, [{}, {}, {}] m, expected the two \
         ends of the damper",
        short_number(.point[0], 6),
        short_number(.point[1], 6),
        short_number(.point[2], 6)
    )]
    DamperEnds {
        /// The point from the center of the hub \[m\].
        point: [f64; 3],
    },
}

/// The distance of a pitch from the nearest one that a plate gives \[m\], if there is one.
fn from_nearest(off: f64) -> String {
    if off.is_finite() {
        format!(": {} m from the nearest", short_number(off, 3))
    } else {
        ", and none is near".to_owned()
    }
}

impl Explain for RotorProblem {
    fn help(&self) -> Option<String> {
        let fixed = match self {
            Self::NoDrive { .. } => {
                "a constant \"speed\", an \"angle\" over time, or a \"torque\", which is 0 for a \
                 rotor that turns freely"
            }
            Self::Azimuth { .. } => "it is an angle in the unit of the file: degrees or radians?",
            Self::Steep { .. } => {
                "pitch falls by its tangent times the flap angle; is it in the unit of the file?"
            }
            Self::TwoDrives { .. } => "\"speed\" beside \"torque\" is the speed at the start",
            Self::NotOfHub { kinds, .. } => {
                return Some(format!("kinds that have it: {}", quoted(kinds)));
            }
            Self::Idle { key, needed, .. } => {
                return Some(format!("add \"{needed}\", or remove \"{key}\""));
            }
            Self::OfBlade { key } => return Some(blade_help(key).to_owned()),
            Self::HingeOrder { .. } => {
                "list hinges from the hub outward; \"hub_radius\" of [rotor.blade] is the radius of \
                 the root, to which flexbeam and torque tube reach"
            }
            Self::HingesAlike { .. } => {
                "remove one, or give it another \"offset\" or \"kind\": without \"offset\" a hinge is where the previous one is"
            }
            Self::NoHolder { .. } => {
                "end a piece of [rotor.flexbeam] there, or give the snubber the \"offset\" of a node"
            }
            Self::Governed { .. } => {
                "give [rotor.drive.governor] a \"speed\"; \"axis\" has the sense of rotation"
            }
            Self::NoAzimuth { .. } => {
                "give \"speed\", or \"angle\" as an expression, \"= 900*t^2\""
            }
            Self::NeedsLink { .. } => {
                "add [rotor.pitch_link] with the control stiffness, or [rotor.swashplate.plate]"
            }
            Self::NotWritten { .. } => {
                "the lengths of actuators, and a pitch with a sensed quantity or azimuth, are \
                 expressions: write the drive as one"
            }
            Self::DrivingDamper { .. } => {
                "a positive value resists a positive rate; [[spring]] and [[load]] have other laws"
            }
            Self::NoPartOfDamper { key: "on", .. } => {
                "add a lag hinge, or write on = \"root\", the part that also turns with the pitch"
            }
            Self::NoPartOfDamper { .. } => "write between = \"hub\", or more \"blades\"",
            Self::DamperEnds { .. } => {
                "both are positions from the center of the hub along the undeformed blade: \"hub\" moves \
                 with the hub and \"blade\" with the blade, and the damper acts along the line between \
                 them"
            }
            _ => return self.help_of_rotation().map(str::to_owned),
        };
        Some(fixed.to_owned())
    }
}

impl RotorProblem {
    /// Remedies of problems of speeds, and of analyses that the rotation does not suit.
    fn help_of_rotation(&self) -> Option<&'static str> {
        Some(match self {
            Self::Speeds { .. } => "give both the same speed",
            Self::Backward { .. } | Self::Overrun { .. } => {
                "\"axis\" of [[rotor]] has the sense of rotation: reverse it, and write the positive \
                 speed"
            }
            Self::Angle { .. } => "remove \"speed\", which follows from \"angle\", or correct one",
            Self::Still { .. } => {
                "give [trim] the speed of the rotor, or write method = \"shooting\" and add [periodic]"
            }
            Self::HeldControl { .. } => "write method = \"shooting\" in [trim], and add [periodic]",
            Self::Carried { .. } => {
                "find the motion in [periodic] with the speed of the rotor, its modes in \
                 [periodic.floquet], and these over a parameter in [stability] with by = \"Floquet\", or by = \"averaged\" for three or \
                 more equal blades; \
                 runs in time begin with start = \"given\""
            }
            Self::Axes { .. } => {
                "steady rotation needs the axis and the center of the rotor in [hub], and one rotor; \
                 compute several in [transient] or [periodic] with start = \"given\""
            }
            _ => return None,
        })
    }
}

/// The name of a rotor, or the title of a table, in a message.
fn owner(name: &str) -> String {
    if name.starts_with('[') {
        name.to_owned()
    } else {
        format!("rotor \"{name}\"")
    }
}

fn blade_help(key: &str) -> &'static str {
    match key {
        "name" => "the blades are called by the name of the rotor and their number",
        "count" | "azimuth" | "azimuths" | "names" => "use \"blades\" and \"azimuth\" of [[rotor]]",
        "hinges" => "use [[rotor.hinge]]",
        "root" => "use \"hub_radius\"",
        _ => "remove it: the rotor holds and moves its blades",
    }
}
