//! Problems of drives.

use shared_geom::error::{Explain, nearest_name};

use crate::input::short_number;

/// A problem of a drive.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum DriveProblem {
    /// A drive with another dimension than the key.
    #[error("\"{name}\" measures {measures}, expected {expected}")]
    Measures {
        /// Name of the drive.
        name: String,
        /// Its dimension, as text.
        measures: String,
        /// The expected dimension, as text.
        expected: String,
    },
    /// Drives that use each other.
    #[error("the drive \"{}\" uses itself: {}", .chain[0], .chain.join(" -> "))]
    Cycle {
        /// The drives, from one back to itself.
        chain: Vec<String>,
    },
    /// A drive without values at some times of a run.
    #[error(
        "\"{key}\" has values from {} s to {} s, and the run goes from {} s to {} s",
        six(.domain[0]), six(.domain[1]), six(.run[0]), six(.run[1])
    )]
    Extrapolation {
        /// The key.
        key: String,
        /// First and last time of the drive \[s\].
        domain: [f64; 2],
        /// First and last time of the run \[s\].
        run: [f64; 2],
    },
    /// A drive without a finite value or slope at the first instant.
    #[error(
        "\"{key}\" has the {what} {found} at {} s, expected a finite number where it starts",
        six(*.start)
    )]
    NoStart {
        /// The key.
        key: String,
        /// Value or slope.
        what: &'static str,
        /// The value or slope [unit of the key].
        found: f64,
        /// The first instant \[s\].
        start: f64,
    },
    /// A length that reaches zero or less in a run.
    #[error(
        "\"{key}\" is {} m at {} s, expected a length greater than zero at all times of the run, \
         from {} s to {} s",
        six(*.value), six(*.time), six(.run[0]), six(.run[1])
    )]
    NoLength {
        /// The key.
        key: String,
        /// The value \[m\].
        value: f64,
        /// The time \[s\].
        time: f64,
        /// First and last time of the run \[s\].
        run: [f64; 2],
    },
    /// A drive with too many corners for a run.
    #[error(
        "\"{key}\" has more than {most} corners and jumps from {} s to {} s, and a step ends at each",
        six(.run[0]), six(.run[1])
    )]
    ManyCorners {
        /// The key.
        key: String,
        /// The largest number of corners.
        most: usize,
        /// First and last time of the run \[s\].
        run: [f64; 2],
    },
    /// An end that is not after the start.
    #[error("the drive ends at {} s, expected a time after its start at {} s", six(*.end), six(*.start))]
    Backward {
        /// Start \[s\].
        start: f64,
        /// End \[s\].
        end: f64,
    },
    /// Two keys of which one is needed.
    #[error("{drive} has {found} of \"{}\" and \"{}\", expected one", .keys[0], .keys[1])]
    OneOf {
        /// The table of the drive, as text.
        drive: String,
        /// The keys.
        keys: [&'static str; 2],
        /// `both` or `none`.
        found: &'static str,
    },
    /// A key that only named drives have.
    #[error("a drive in a card has no \"unit\": it is in the unit of its key")]
    InlineUnit,
    /// An invalid band of frequencies.
    #[error("\"band\" is {} Hz to {} Hz, expected two increasing frequencies from zero", six(.band[0]), six(.band[1]))]
    Band {
        /// The frequencies \[Hz\].
        band: [f64; 2],
    },
    /// An empty list.
    #[error("\"{key}\" is empty, expected drives")]
    Nothing {
        /// The key.
        key: &'static str,
    },
    /// A signal whose required derivative is unknown.
    #[error("\"{key}\" follows \"{name}\", whose {needed} is not known")]
    Rough {
        /// The key.
        key: String,
        /// The sensor or the system of the output.
        name: String,
        /// The derivative that is needed.
        needed: Needed,
    },
    /// A sensed quantity where only a function of time is allowed.
    #[error("\"{key}\" senses \"{name}\", expected a function of time only")]
    Senses {
        /// The key.
        key: String,
        /// The sensor.
        name: String,
    },
    /// An input of a linear model where only a function of time is allowed.
    #[error(
        "{user} uses \"{name}\", an input of the linear model, expected a function of time only"
    )]
    OfInput {
        /// The card or the key, as text.
        user: String,
        /// The input.
        name: String,
    },
    /// A name that a signal cannot have.
    #[error(
        "\"{name}\" is not a name of a signal, expected letters, digits and \"_\", and no name \
         that expressions already use"
    )]
    SignalName {
        /// The name.
        name: String,
    },
    /// A name of something else that expressions read.
    #[error("\"{name}\" is the name of {by} already")]
    SignalTaken {
        /// The name.
        name: String,
        /// The user of the name.
        by: &'static str,
    },
    /// A rotation in axes of a third node.
    #[error("a rotation is sensed in the axes of its reference node, or of the model")]
    AxesOfRotation,
    /// Fewer than two rows.
    #[error("the table has {found} rows, expected at least two")]
    FewRows {
        /// Number of rows.
        found: usize,
    },
    /// A time that is not after the previous one.
    #[error("the time {time} is not after {before}, expected increasing times")]
    NotRising {
        /// The time as written.
        time: f64,
        /// The previous time.
        before: f64,
    },
    /// The name of a parameter without an expression.
    #[error(
        "\"{name}\" under \"{key}\" is a parameter, expected an expression, or the name of a drive"
    )]
    Parameter {
        /// The name.
        name: String,
        /// The key.
        key: String,
    },
    /// A column that the file does not have.
    #[error("no column \"{name}\"")]
    NoColumn {
        /// The name.
        name: String,
        /// The columns of the file.
        known: Vec<String>,
    },
    /// A row that cannot be read.
    #[error("\"{found}\" in column \"{column}\" is not a number")]
    NoNumber {
        /// The text found.
        found: String,
        /// The column.
        column: String,
    },
    /// Further rows with problems.
    #[error("{count} more rows have problems")]
    MoreRows {
        /// Number of rows.
        count: usize,
    },
}

/// A derivative with respect to time that a signal must provide.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Needed {
    /// The first.
    Rate,
    /// The second.
    Acceleration,
}

impl std::fmt::Display for Needed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Rate => "rate",
            Self::Acceleration => "second derivative",
        })
    }
}

impl Explain for DriveProblem {
    fn help(&self) -> Option<String> {
        let fixed = match self {
            Self::NoColumn { name, known } => {
                return Some(match nearest_name(name, known.iter().map(String::as_str)) {
                    Some(near) => format!("did you mean \"{near}\"?"),
                    None => format!("columns: {}", known.join(", ")),
                });
            }
            Self::Parameter { name, .. } => return Some(format!("write \"= {name}\"")),
            Self::Extrapolation { .. } => {
                "give more values, or outside = \"hold\" to continue with the first and the last"
            }
            Self::NoStart { .. } => {
                "write it so that it is finite there, such as 1/(t + 0.1) for 1/t, or give \
                 [transient] another \"from\""
            }
            Self::NoLength { .. } => {
                "let the drive stay at a length above zero, bound it by max() as in \
                 max(0.01, 1 - 2*t), or end the run earlier"
            }
            Self::ManyCorners { .. } => {
                "make its intervals longer, or the run shorter; a random drive with a \"band\" \
                 has no corners"
            }
            Self::Measures { .. } => {
                "give it another \"unit\"; a drive or an actuator without one is in the unit of each key"
            }
            Self::Senses { .. } => {
                "gravity, and a drive that other drives use, must be known before a run"
            }
            Self::OfInput { .. } => {
                "gravity, the wind, and drives that are made of other drives cannot follow an input: \
                 use the other drive as the input, or another name here"
            }
            Self::Rough { .. } => {
                "its value, or its rate, may jump, which would be an impulse: add an [[actuator]] \
                 with this signal as its \"command\", and use the actuator's name here"
            }
            Self::SignalName { name } if name.contains(' ') => {
                "expressions read the names of sensors, state spaces and actuators: these cards cannot \
                 be copied by [[repeat]], write one for each copy outside of it"
            }
            Self::InlineUnit => {
                "give it a name, [drives.NAME], or write the values with their unit"
            }
            _ => return None,
        };
        Some(fixed.to_owned())
    }
}

fn six(value: f64) -> String {
    short_number(value, 6)
}
