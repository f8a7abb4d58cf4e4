//! Problems of the request of a linear model.

use shared_geom::error::{Explain, nearest_name};

use super::request::LinearChoice;

/// A problem of the request of a linear model.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum LinearProblem {
    /// An input that the file does not have.
    #[error("\"{name}\" of --input is not a drive of the file, nor a control of [trim]")]
    Input {
        /// The name.
        name: String,
        /// The names that may be inputs.
        known: Vec<String>,
    },
    /// An output that the file does not have.
    #[error("\"{name}\" of --output is not a sensor, an output or a column of the file")]
    Output {
        /// The name.
        name: String,
        /// The names that may be outputs.
        known: Vec<String>,
    },
    /// A name that is given twice.
    #[error("\"{name}\" of {option} is given twice, expected it once")]
    Doubled {
        /// The name.
        name: String,
        /// `--input` or `--output`.
        option: &'static str,
    },
    /// A control that is a parameter of the file.
    #[error("\"{name}\" of --input is a parameter of the file, expected a drive")]
    Parameter {
        /// The name.
        name: String,
    },
    /// A drive without a value at time zero.
    #[error("the drive \"{name}\" of --input is {value} at 0 s, expected a finite number")]
    NoValue {
        /// The name.
        name: String,
        /// The value [its unit].
        value: f64,
    },
    /// The analysis whose equilibrium is meant is missing.
    #[error("--about {} needs [{}]", .0.card(), .0.card())]
    Missing(LinearChoice),
    /// Several speeds.
    #[error("[modes] has {count} speeds, expected one")]
    Speeds {
        /// Their number.
        count: usize,
    },
    /// A speed beside a trim.
    #[error("--speed has no effect on the equilibrium of [trim], which has its own \"speed\"")]
    SpeedOfTrim,
    /// A speed beside the one of the period, or no speed in it.
    #[error("--about is periodic, which needs the \"speed\" of [periodic] and no --speed")]
    SpeedOfPeriod,
    /// An equilibrium beside a trim.
    #[error("the file has [trim], but --about is {}, expected trim", .0.card())]
    BesideTrim(LinearChoice),
    /// A trim of periodic motion.
    #[error("[trim] belongs to periodic motion, expected method = \"equilibrium\"")]
    PeriodicTrim,
}

impl LinearChoice {
    /// The card of the analysis.
    pub(super) fn card(self) -> &'static str {
        match self {
            Self::Modes => "modes",
            Self::Periodic => "periodic",
            Self::Static => "static",
            Self::Trim => "trim",
        }
    }
}

impl Explain for LinearProblem {
    fn help(&self) -> Option<String> {
        let fixed = match self {
            Self::Input { name, known } => {
                return Some(match nearest_name(name, known.iter().map(String::as_str)) {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None if known.is_empty() => {
                        "write [drives.NAME] with kind = \"constant\" and value = 0, and use NAME \
                         in the cards on which it acts"
                            .to_owned()
                    }
                    None => format!("drives and controls: {}", known.join(", ")),
                });
            }
            Self::Output { name, known } => {
                return Some(match nearest_name(name, known.iter().map(String::as_str)) {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None if known.is_empty() => {
                        "add [sensors.NAME] with quantity = \"position\" and of = \"tip\""
                            .to_owned()
                    }
                    None => format!("sensors, outputs and columns: {}", known.join(", ")),
                });
            }
            Self::Parameter { .. } => {
                "write [drives.NAME] with this value, and use NAME in place of the parameter"
            }
            Self::NoValue { .. } => "write it so that it is finite there",
            Self::Missing(_) => "add the card, or leave --about away",
            Self::Speeds { .. } => "choose one by --speed, as in --speed \"300 rpm\"",
            Self::SpeedOfPeriod => "write the \"speed\" of the rotor in [periodic]",
            Self::SpeedOfTrim => "leave it away, or change \"speed\" of [trim]",
            Self::BesideTrim(_) => "leave --about away, or remove [trim] in another file",
            Self::PeriodicTrim => {
                "change the method, or replace the controls by parameters in another file"
            }
            Self::Doubled { .. } => return None,
        };
        Some(fixed.to_owned())
    }
}
