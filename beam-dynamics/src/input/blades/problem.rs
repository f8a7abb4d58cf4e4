//! Problems of the card of a blade.

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
    /// Two keys that exclude each other.
    #[error("{blade} has \"{first}\" and \"{second}\", expected one of them")]
    Both {
        /// The blade, as text.
        blade: String,
        /// A key.
        first: &'static str,
        /// Another key for the same quantity.
        second: &'static str,
    },
    /// A number of names that differs from the number of blades.
    #[error("\"names\" lists {found}, expected {expected}: one per blade")]
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
    /// Fewer elements than parts between positions that must be element ends.
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
        "\"at\" is {} m, expected a position on the line, from 0 to {} m, or \"tip\"",
        short_number(*.found, 6),
        short_number(*.length, 6)
    )]
    OffLine {
        /// The position \[m\].
        found: f64,
        /// Length of the line \[m\].
        length: f64,
    },
    /// Hinges that are not in order from the hub outward.
    #[error(
        "{hinge} is at {} m from the center of rotation, inboard of the previous hinge at {} m",
        short_number(*.found, 6),
        short_number(*.before, 6)
    )]
    HingesInward {
        /// The hinge, as text.
        hinge: String,
        /// Its offset \[m\].
        found: f64,
        /// Offset of the previous hinge \[m\].
        before: f64,
    },
    /// A hinge outboard of the root.
    #[error(
        "{hinge} is at {} m from the center of rotation, outboard of the root of the blade at {} m",
        short_number(*.found, 6),
        short_number(*.root, 6)
    )]
    HingeBeyondRoot {
        /// The hinge, as text.
        hinge: String,
        /// Its offset \[m\].
        found: f64,
        /// Radius of the root \[m\].
        root: f64,
    },
    /// A hinge that allows the same motion as a previous hinge.
    #[error("{hinge} turns about the axis of a previous hinge, and neither has a stiffness")]
    HingesAlike {
        /// The hinge, as text.
        hinge: String,
    },
    /// A file of a tower or a wing that has another length.
    #[error(
        "the line of \"{file}\" is {} m long, expected the length of the part, {} m",
        short_number(*found, 6),
        short_number(*expected, 6)
    )]
    LengthOfPart {
        /// The file.
        file: String,
        /// Its length \[m\].
        found: f64,
        /// Length of the part \[m\].
        expected: f64,
    },
    /// A mirror image of a section that has none.
    #[error("blade \"{blade}\" is a mirror image, and its sections have {found}")]
    NoMirror {
        /// Name of the blade.
        blade: String,
        /// A part of a section, as text.
        found: &'static str,
    },
    /// A root with hinges and with a clamp option.
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
                "a file has line, twist and properties of the whole blade; \"elements\" is the \
                 number of elements"
            }
            Self::Both { first: "root", .. } => {
                "\"root\" is a position at azimuth 0, \"hub_radius\" the distance from the center \
                 along the blade"
            }
            Self::LengthOfPart { .. } => {
                "of an htc file of HAWC2 the blade is read without body = \"NAME\", the main_body of the \
                 part; correct the length, or give a file of the part alone"
            }
            Self::Both {
                first: "mirror", ..
            } => {
                "hold the root by joints of its own, as a [[rotor]] with direction = \"clockwise\" does"
            }
            Self::NoMirror { .. } => "give the sections stiffness, mass and damping only",
            Self::Both { first: "part", .. } => "the blade of which it is a part has the strips",
            Self::Both { .. } => {
                "\"azimuths\" gives each angle; \"count\" divides the circle, from \"azimuth\""
            }
            Self::TooFew { .. } => "leave \"elements\" out to have element ends at the stations",
            Self::HingesInward { .. } => {
                "list the hinges from the hub outward; \"offset\" is measured from the center of rotation along the blade, and hinges at one offset coincide"
            }
            Self::HingeBeyondRoot { .. } => {
                "offsets are measured from the center of rotation along the blade: a larger \"hub_radius\" moves the root outward"
            }
            Self::HingesAlike { .. } => {
                "the parts between the two turn without resistance: remove one, or give it another offset or a \"stiffness\""
            }
            Self::HingesAndClamp { .. } => "hinges hold the root; remove \"clamp_root\"",
            _ => return None,
        };
        Some(fixed.to_owned())
    }
}
