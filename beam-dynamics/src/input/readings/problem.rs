//! Problems of a reading.

use shared_geom::error::Explain;

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
                let quoted: Vec<_> = known.iter().map(|name| format!("\"{name}\"")).collect();
                Some(format!("its nodes: {}", quoted.join(", ")))
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
            Self::AxesOfOther => {
                Some("or sense three components, and turn them by an expression".to_owned())
            }
        }
    }
}
