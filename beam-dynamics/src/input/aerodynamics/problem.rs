//! Problems of airfoils, strips and inflows.

use shared_geom::error::{Explain, nearest_name};

use crate::elements::strips::LARGER_TABLES;
use crate::input::short_number;

/// A problem of `[airfoils]`, `[[strip]]`, `[blade.aerodynamics]` or `[[inflow]]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum StripProblem {
    /// An unknown airfoil or inflow.
    #[error("unknown {kind} \"{name}\" in {user}")]
    Unknown {
        /// `airfoil`, `built-in airfoil`, `inflow` or `node`.
        kind: &'static str,
        /// The name.
        name: String,
        /// The user of the name, as text.
        user: String,
        /// The names of this kind.
        known: Vec<String>,
    },
    /// Neither a file nor a formula, or both.
    #[error("airfoil \"{name}\" has {found}, expected one of \"file\", \"built_in\" and \"slope\"")]
    AirfoilSource {
        /// Name of the airfoil.
        name: String,
        /// The keys found, as text.
        found: &'static str,
    },
    /// A key that another one needs.
    #[error("airfoil \"{name}\" has \"{key}\" without \"{needed}\", which it belongs to")]
    Useless {
        /// Name of the airfoil.
        name: String,
        /// The key found.
        key: &'static str,
        /// The key that it belongs to.
        needed: &'static str,
    },
    /// A key of an inflow that another one needs.
    #[error("inflow \"{name}\" has \"{key}\", which belongs to {needed}")]
    InflowKey {
        /// Name of the inflow.
        name: String,
        /// The key found.
        key: &'static str,
        /// The key that it belongs to, as text.
        needed: String,
    },
    /// A delay of stall that changes no airfoil.
    #[error(
        "\"stall_delay\" has no effect on {names}: airfoils without a table of stall, or with a \"stall_delay\" \
         of their own"
    )]
    NoStallDelay {
        /// Names of the airfoils.
        names: String,
    },
    /// A delay of stall on a line that does not turn.
    #[error(
        "strip \"{user}\" has \"stall_delay\" without \"inflow\", which gives the shaft about which it turns"
    )]
    DelayWithoutRotor {
        /// Name of the card of strips.
        user: String,
    },
    /// A rotor in ground effect at or below the ground.
    #[error(
        "inflow \"{name}\" has its ground at {} m along the vertical, and the center of the rotor is at \
         {} m: expected the ground below it",
        short_number(*.ground, 6),
        short_number(*.center, 6)
    )]
    BelowGround {
        /// Name of the inflow.
        name: String,
        /// Coordinate of the ground along the vertical \[m\].
        ground: f64,
        /// Coordinate of the center of the rotor \[m\].
        center: f64,
    },
    /// Strips without a blade in an inflow that does not have the number of blades.
    #[error(
        "inflow \"{name}\" of strip \"{user}\" has no \"blades\", expected their number: the momentum of \
         an annulus is the one of all blades"
    )]
    Blades {
        /// Name of the inflow.
        name: String,
        /// Name of the card of strips.
        user: String,
    },
    /// An effective radius beyond the tip.
    #[error(
        "the effective radius is {} of the radius, expected at most 1",
        short_number(*.found, 6)
    )]
    EffectiveRadius {
        /// Part of the radius \[-\].
        found: f64,
    },
    /// A table that cannot be used as an airfoil.
    #[error("airfoil \"{name}\": {reason}")]
    Airfoil {
        /// Name of the airfoil.
        name: String,
        /// The reason, as text.
        reason: String,
        /// The remedy, if known.
        help: Option<String>,
    },
    /// Too few stations.
    #[error("\"stations\" has {found}, expected at least two: at the root and at the tip")]
    FewStations {
        /// Number of stations.
        found: usize,
    },
    /// A line that is neither on a node nor on beams.
    #[error("a [[strip]] has {found}, expected either \"node\", \"from\" and \"to\", or \"beams\"")]
    Carrier {
        /// The keys found, as text.
        found: &'static str,
    },
    /// A line of no length.
    #[error(
        "both ends of the line of the strip are the same point, expected a line of some length"
    )]
    NoSpan,
    /// A direction forward along the line.
    #[error("\"forward\" is along the line of the strip, expected a direction across it")]
    ForwardAlong,
    /// Positions that do not increase.
    #[error(
        "station {} is at {} m, expected more than {} m, the position of the station before it",
        .index + 1,
        short_number(*.found, 6),
        short_number(*.before, 6)
    )]
    Order {
        /// Index of the station, from zero.
        index: usize,
        /// Its position [m].
        found: f64,
        /// The position of the one before [m].
        before: f64,
    },
    /// Strips beyond the Mach numbers of the table of their airfoil.
    #[error(
        "strips of \"{blade}\" reach Mach {found:.3} at {} m, and the table of airfoil \"{airfoil}\" is \
         for Mach numbers from {} to {}",
        short_number(*.radius, 4),
        range[0],
        range[1]
    )]
    Mach {
        /// Name of the blade or card of strips.
        blade: String,
        /// Name of the airfoil.
        airfoil: String,
        /// Largest distance from the shaft with this airfoil \[m\].
        radius: f64,
        /// Mach number there, without induction \[-\].
        found: f64,
        /// Mach numbers of the table \[-\].
        range: [f64; 2],
    },
    /// Stations beyond the line.
    #[error(
        "station {} is at {} m, expected a position on the line, from 0 to {} m",
        .index + 1,
        short_number(*.found, 6),
        short_number(*.length, 6)
    )]
    OffLine {
        /// Index of the station, from zero.
        index: usize,
        /// Its position [m].
        found: f64,
        /// Length of the line [m].
        length: f64,
    },
}

impl Explain for StripProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Unknown {
                kind, name, known, ..
            } => Some(match nearest_name(name, known.iter().map(String::as_str)) {
                Some(near) => format!("did you mean \"{near}\"?"),
                None if known.is_empty() => match *kind {
                    "airfoil" => "add a table [airfoils.NAME], or name a built-in airfoil".into(),
                    "node" => "add [[node]] with this name".into(),
                    _ => "add [[inflow]] with this name".into(),
                },
                None => format!("known: {}", known.join(", ")),
            }),
            Self::AirfoilSource { .. } => {
                Some("file = \"NAME.c81\", or built_in = \"NACA 0012\"".to_owned())
            }
            Self::Airfoil { help, .. } => help.clone(),
            Self::Order { .. } => Some("order the stations from the root to the tip".to_owned()),
            Self::OffLine { .. } => {
                Some("positions are arc lengths from the root of the blade".to_owned())
            }
            Self::Useless { needed, key, .. } => {
                Some(format!("add \"{needed}\", or remove \"{key}\""))
            }
            Self::Blades { .. } => Some(
                "add \"blades\" to the inflow, or use a model of the disk as its \"kind\"".into(),
            ),
            Self::BelowGround { .. } => Some(
                "\"ground\" is a coordinate, not a height: below a hub at 0 m it is negative"
                    .to_owned(),
            ),
            Self::InflowKey { key, .. } => Some(format!("remove \"{key}\", or change that")),
            Self::EffectiveRadius { .. } => {
                Some("usual are 0.95 to 0.98; 1 has no loss at the tips".to_owned())
            }
            Self::Carrier { .. } => {
                Some("node = \"wing\", from = [0, 1, 0], to = [0, -1, 0]".to_owned())
            }
            Self::NoSpan => Some("give both ends of the span, or beams of an open line".to_owned()),
            Self::ForwardAlong => Some("\"forward\" points toward the leading edge".to_owned()),
            Self::Mach { .. } => Some(LARGER_TABLES.to_owned()),
            Self::NoStallDelay { .. } => {
                Some("remove it, or give tables of two-dimensional flow".into())
            }
            Self::DelayWithoutRotor { .. } => Some("add \"inflow\", or remove it".to_owned()),
            Self::FewStations { .. } => None,
        }
    }
}
