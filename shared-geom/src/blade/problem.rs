//! Conditions that a blade must satisfy before a computation.

use crate::error::Explain;
use crate::figure::tick_label;
use crate::line::LineProblem;
use crate::section::{CurvatureMismatch, PropertyProblem};
use crate::units::rounded;

/// Errors of a blade.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BladeProblem {
    /// The text is not the JSON of a blade file.
    #[error("not a blade file: {reason}")]
    Malformed {
        /// The parser's message.
        reason: String,
    },
    /// The file is of a later version of the format.
    #[error("written in version {found} of the blade-file format, expected at most {known}")]
    Newer {
        /// The version of the file.
        found: u64,
        /// The version that this program writes.
        known: u64,
    },
    /// The file declares other units.
    #[error("units are \"{found}\", expected \"SI\"")]
    Units {
        /// The word found.
        found: String,
    },
    /// The line is invalid.
    #[error(transparent)]
    Line(#[from] LineProblem),
    /// A blade without properties.
    #[error("the blade has no station, expected one or more")]
    NoStations,
    /// A number that is not finite.
    #[error("{field} holds a number that is not finite")]
    NotFinite {
        /// The field.
        field: &'static str,
    },
    /// Stations that are not in order of arc length.
    #[error(
        "station {station} lies at {} m, and the station before at {} m: stations lead from the root to the tip", rounded(*.found), rounded(*.before)
    )]
    Order {
        /// Number of the station, from one.
        station: usize,
        /// Its arc length [m].
        found: f64,
        /// The arc length before [m].
        before: f64,
    },
    /// Three stations at one arc length.
    #[error("station {station} is the third at {} m: a jump has two", rounded(*.position))]
    Third {
        /// Number of the station, from one.
        station: usize,
        /// Its arc length [m].
        position: f64,
    },
    /// Two stations at one arc length, with constant interpolation.
    #[error(
        "station {station} lies at {} m as the one before, and with constant interpolation every station is a jump", rounded(*.position)
    )]
    Doubled {
        /// Number of the station, from one.
        station: usize,
        /// Its arc length [m].
        position: f64,
    },
    /// A station that is not on the line.
    #[error("station {station} lies at {} m, and the line is {} m long", rounded(*.found), rounded(*.length))]
    OffLine {
        /// Number of the station, from one.
        station: usize,
        /// Its arc length [m].
        found: f64,
        /// Length of the line [m].
        length: f64,
    },
    /// Invalid properties of a station.
    #[error("station {station} at {} m: {problem}", rounded(*.position))]
    Station {
        /// Number of the station, from one.
        station: usize,
        /// Its arc length [m].
        position: f64,
        /// The problem.
        problem: PropertyProblem,
    },
    /// Problems of one kind at several stations.
    #[error("{stations}: {problem}{differ}")]
    Stations {
        /// The stations, as text.
        stations: String,
        /// The station with the numbers of the message, as text; empty if all are alike.
        differ: String,
        /// The problem of the first of them.
        problem: PropertyProblem,
    },
    /// A station with a stiffness that is not positive definite, and its range.
    #[error(
        "stiffness is not positive definite from {} m to {} m, about station {station} at {} m: there its smallest scaled eigenvalue is {value:.3e}", rounded(*.from), rounded(*.to), rounded(*.position)
    )]
    IndefiniteStation {
        /// Number of the station, from one.
        station: usize,
        /// Its arc length [m].
        position: f64,
        /// Its beginning, between this station and the previous one [m].
        from: f64,
        /// Its end, between this station and the next [m].
        to: f64,
        /// Smallest eigenvalue of the matrix scaled to a unit diagonal [-].
        value: f64,
    },
    /// Stiffness that is not positive definite at an arc length at which it is evaluated.
    #[error(
        "stiffness is not positive definite at {} m, between the stations at {} m and {} m: its smallest scaled eigenvalue is {value:.3e}", rounded(*.position), rounded(*.inner), rounded(*.outer)
    )]
    Indefinite {
        /// Arc length [m].
        position: f64,
        /// Arc length of the station on the inner side [m].
        inner: f64,
        /// Arc length of the station on the outer side [m].
        outer: f64,
        /// Smallest eigenvalue of the matrix scaled to a unit diagonal [-].
        value: f64,
    },
    /// A section that was solved for another curvature than the line's.
    #[error(
        "station {station} at {} m, \"{file}\": {mismatch}; {}",
        tick_label(*.position, 0.0), .mismatch.size()
    )]
    Curvature {
        /// Number of the station, from one.
        station: usize,
        /// Its arc length [m].
        position: f64,
        /// The property file, as it is named.
        file: String,
        /// Both curvatures.
        mismatch: CurvatureMismatch,
    },
    /// A damping time below zero.
    #[error("damping is {found} s, expected zero or more")]
    NegativeDamping {
        /// The time [s].
        found: f64,
    },
    /// Damping matrices for another number of stations.
    #[error("damping has {found} matrices, expected one for each of the {stations} stations")]
    DampingCount {
        /// Matrices found.
        found: usize,
        /// Stations.
        stations: usize,
    },
}

/// Help for matrices that are not positive definite.
const SIGNS: &str =
    "check the signs of the couplings, and that frame and order agree with the matrices";

impl Explain for BladeProblem {
    fn help(&self) -> Option<String> {
        match self {
            Self::Newer { .. } => Some("use a newer version of this program".to_owned()),
            Self::Units { .. } => Some("blade files in JSON are always SI".to_owned()),
            Self::Line(problem) => problem.help(),
            Self::Station { problem, .. } | Self::Stations { problem, .. } => match problem {
                PropertyProblem::NoShear
                | PropertyProblem::Diagonal {
                    index: 2 | 3,
                    field: "stiffness",
                    value: 0.0,
                    ..
                } => Some(
                    "a section without shear stiffness: --rigid-shear, or rigid_shear = true in \
                     [[blade]], makes the blade rigid in shear; it changes only stations whose \
                     shear rows are zero throughout, and whose bending stiffness is not"
                        .to_owned(),
                ),
                PropertyProblem::Indefinite { .. } => Some(SIGNS.to_owned()),
                problem => problem.help(),
            },
            Self::Curvature { mismatch, .. } => mismatch.help(),
            Self::Order { .. } => Some(
                "put the stations in order of arc length; two at one arc length are a jump"
                    .to_owned(),
            ),
            Self::IndefiniteStation { .. } | Self::Indefinite { .. } => Some(SIGNS.to_owned()),
            Self::Third { .. } => Some(
                "at one arc length the first station is the inner, the second the outer side of a jump"
                    .to_owned(),
            ),
            Self::OffLine { .. } => {
                Some("arc lengths count from the root along the line".to_owned())
            }
            _ => None,
        }
    }
}
