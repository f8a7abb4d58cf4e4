//! What can be wrong with the card of a blade.

use shared_geom::error::Explain;

use crate::input::short_number;

/// A problem of a `[[blade]]`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BladeProblem {
    /// Stations and pieces at once.
    #[error("blade \"{blade}\" has \"file\" and \"{key}\", expected a blade file or pieces")]
    FileAndPieces {
        /// Name of the blade.
        blade: String,
        /// The key of a blade of pieces.
        key: &'static str,
    },
    /// Two keys of which one is meant.
    #[error("{blade} has \"{first}\" and \"{second}\", expected one of them")]
    Both {
        /// The blade, in words.
        blade: String,
        /// A key.
        first: &'static str,
        /// Another that says the same.
        second: &'static str,
    },
    /// Names of another number than the blades.
    #[error("\"names\" lists {found}, expected {expected}: one a blade")]
    Names {
        /// Number of names.
        found: usize,
        /// Number of blades.
        expected: usize,
    },
    /// Two blades of a card at the same azimuth.
    #[error("\"azimuths\" has {} deg twice, expected each once", short_number(*.degrees, 6))]
    AzimuthTwice {
        /// The angle \[deg\].
        degrees: f64,
    },
    /// Fewer elements than parts between places that must be element ends.
    #[error(
        "\"elements\" is {found}, expected at least {needed}: one in each interval between \
         jumps, kinks and masses"
    )]
    TooFew {
        /// The number found.
        found: usize,
        /// The number needed.
        needed: usize,
    },
    /// A mass off the blade.
    #[error(
        "\"at\" is {} m, expected a place on the line, from 0 to {} m, or \"tip\"",
        short_number(*.found, 6),
        short_number(*.length, 6)
    )]
    OffLine {
        /// The place \[m\].
        found: f64,
        /// Length of the line \[m\].
        length: f64,
    },
    /// Hinges that do not go outward.
    #[error(
        "{hinge} is at {} m from the center of rotation, inboard of the one before it at {} m",
        short_number(*.found, 6),
        short_number(*.before, 6)
    )]
    HingesInward {
        /// The hinge, in words.
        hinge: String,
        /// Its offset \[m\].
        found: f64,
        /// Offset of the hinge before \[m\].
        before: f64,
    },
    /// A hinge outboard of the root.
    #[error(
        "{hinge} is at {} m from the center of rotation, outboard of the root of the blade at {} m",
        short_number(*.found, 6),
        short_number(*.root, 6)
    )]
    HingeBeyondRoot {
        /// The hinge, in words.
        hinge: String,
        /// Its offset \[m\].
        found: f64,
        /// Radius of the root \[m\].
        root: f64,
    },
    /// A hinge that lets the blade do what one before it does.
    #[error("{hinge} turns about the axis of a hinge before it, and neither has a stiffness")]
    HingesAlike {
        /// The hinge, in words.
        hinge: String,
    },
    /// A root with hinges that is free or clamped as well.
    #[error("blade \"{blade}\" has \"hinges\" and \"clamp_root\", expected one of them")]
    HingesAndClamp {
        /// Name of the blade.
        blade: String,
    },
}

impl Explain for BladeProblem {
    fn help(&self) -> Option<String> {
        let fixed = match self {
            Self::FileAndPieces { .. } => {
                "a file has line, twist and properties of the whole blade; \"elements\" says how many"
            }
            Self::Both { first: "root", .. } => {
                "\"root\" is a place at azimuth 0, \"hub_radius\" the distance from the center along the blade"
            }
            Self::Both { .. } => {
                "\"azimuths\" gives each angle; \"count\" divides the circle, from \"azimuth\" on"
            }
            Self::TooFew { .. } => "leave \"elements\" out to have element ends at the stations",
            Self::HingesInward { .. } => {
                "list the hinges from the hub outward; \"offset\" counts from the center of rotation along the blade, and hinges at one offset coincide"
            }
            Self::HingeBeyondRoot { .. } => {
                "offsets count from the center of rotation along the blade: a larger \"hub_radius\" moves the root outward"
            }
            Self::HingesAlike { .. } => {
                "what lies between the two turns without resistance: remove one, or give it another offset or a \"stiffness\""
            }
            Self::HingesAndClamp { .. } => "hinges hold the root; remove \"clamp_root\"",
            _ => return None,
        };
        Some(fixed.to_owned())
    }
}
