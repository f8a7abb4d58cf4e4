//! Problems of a reading.

use shared_geom::error::{Explain, quoted};

use crate::input::number::short_number;

/// Part of the radius of the tip beyond which a hub is too large \[-\].
const HUB: f64 = 0.5;

/// A problem of a column or a sensor.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ReadingProblem {
    /// Angles about axes that do not describe every orientation.
    #[error("\"sequence\" is \"{found}\", expected three axes, neighbors different, as in \"zxz\"")]
    Sequence {
        /// The text.
        found: String,
    },
    /// A node on which a joint does not act.
    #[error("\"{joint}\" does not act on node \"{node}\", expected one of its nodes")]
    NotOfJoint {
        /// The joint.
        joint: String,
        /// The node.
        node: String,
        /// Its nodes.
        known: Vec<String>,
    },
    /// A sensor that reads no number, or more than one.
    #[error("sensor \"{name}\" reads {found} numbers, expected one")]
    Several {
        /// The sensor.
        name: String,
        /// Count of numbers.
        found: usize,
    },
    /// A quantity that is not a number of the state, or whose derivatives are unknown.
    #[error("\"{quantity}\" cannot be sensed: {reason}")]
    NotSensed {
        /// The quantity.
        quantity: &'static str,
        /// The reason, as text.
        reason: &'static str,
    },
    /// An energy of elements, one of which does not provide its derivatives.
    #[error(
        "\"{quantity}\" cannot be sensed: the derivatives of the energy of \"{element}\" are not known"
    )]
    EnergyOf {
        /// The quantity.
        quantity: &'static str,
        /// The element.
        element: String,
    },
    /// A name of no blade or card with strips.
    #[error("\"{name}\" has no strips, expected a blade with [blade.aerodynamics] or a [[strip]]")]
    NoStrips {
        /// The name.
        name: String,
        /// The blades and cards with strips.
        known: Vec<String>,
    },
    /// Both or none of the positions.
    #[error("expected one of \"at\" and \"strip\", found {found}")]
    Position {
        /// `both` or `none`.
        found: &'static str,
    },
    /// A strip that the blade does not have.
    #[error("\"strip\" is {found}, expected 1 to {count}: \"{blade}\" has {count} strips")]
    StripNumber {
        /// The number found.
        found: usize,
        /// Number of strips.
        count: usize,
        /// The blade.
        blade: String,
    },
    /// A position beyond the first or the last strip.
    #[error(
        "\"at\" is {}, expected {} to {}, between the first and the last strip of \"{blade}\"",
        short_number(*.found, 6), short_number(.ends[0], 6), short_number(.ends[1], 6)
    )]
    OffStrips {
        /// The part of the radius found.
        found: f64,
        /// The parts at the first and the last strip.
        ends: [f64; 2],
        /// The blade.
        blade: String,
    },
    /// A rotor that does not exist, or none where there are several.
    #[error(
        "{found}, expected the name of the inflow of a rotor whose blades have [blade.aerodynamics]"
    )]
    Rotor {
        /// The unknown name, or the number of rotors, as text.
        found: String,
        /// The rotors.
        known: Vec<String>,
    },
    /// A definition without the quantity.
    #[error("the definition \"{found}\" has no \"{quantity}\"")]
    Definition {
        /// The definition.
        found: &'static str,
        /// The quantity.
        quantity: &'static str,
        /// The definitions that have it.
        known: Vec<&'static str>,
    },
    /// Axes that do not belong to a joint.
    #[error("a reaction is sensed in the axes of a node of the joint, a frame, or an end")]
    AxesOfOther,
}

impl Explain for ReadingProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Sequence { .. } => {
                Some("\"zyx\" is yaw, pitch, roll; \"zxz\" precession, nutation, spin".to_owned())
            }
            Self::NotOfJoint { known, .. } => {
                Some(format!("its nodes: {}", quoted(known)))
            }
            Self::Several { .. } => Some("choose one \"component\"".to_owned()),
            Self::NotSensed { .. } => {
                Some("columns of output can show it; docs: \"Signals\"".to_owned())
            }
            Self::EnergyOf { .. } => Some(
                "sense another energy, or one of a model without electrodes, elastic parts that are \
                 driven, finite-volume beams and laws by expressions; columns of output can show it"
                    .to_owned(),
            ),
            Self::NoStrips { known, .. } => Some(if known.is_empty() { "the model has no strips in the air".to_owned() } else { format!("with strips: {}", quoted(known)) }),
            Self::Position { .. } => Some(
                "\"at\" is a part of the radius or of the length, \"strip\" a number from the root"
                    .to_owned(),
            ),
            Self::StripNumber { .. } => None,
            Self::OffStrips { ends, .. } if ends[0] > HUB => Some(format!(
                "the hub has {} of the radius: check the unit of \"hub_radius\"",
                short_number(ends[0], 3)
            )),
            Self::OffStrips { .. } => Some(
                "strips are at Gauss points; \"strip\" selects the first or the last".to_owned(),
            ),
            Self::Rotor { known, .. } => Some(if known.is_empty() { "no blade of the model has [blade.aerodynamics]".to_owned() } else { format!("rotors: {}", quoted(known)) }),
            Self::Definition { known, .. } => {
                Some(format!("definitions with it: {}", quoted(known)))
            }
            Self::AxesOfOther => {
                Some("or sense three components, and turn them by an expression".to_owned())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hubs_that_are_too_large_are_the_cause() {
        for (first, expected) in [
            (0.2, "Gauss points"),
            (0.991, "the hub has 0.991 of the radius"),
        ] {
            let (found, ends, blade) = (0.1, [first, 1.0], "main 1".to_owned());
            let help = ReadingProblem::OffStrips { found, ends, blade }.help();
            assert!(help.unwrap_or_default().contains(expected), "{expected}");
        }
    }
}
