//! Problems of rotor files.

use shared_geom::error::{Explain, quoted};

use crate::input::short_number;

/// A number of a message.
fn shown(value: f64) -> String {
    short_number(value, 6)
}

/// A problem of `NAME.rotor.toml`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PerformanceProblem {
    /// Neither stations nor a file, or both.
    #[error("[rotor] has {found}, expected either \"stations\" or \"file\"")]
    StationSource {
        /// The keys found, as text.
        found: &'static str,
    },
    /// A property that neither the card nor the file has.
    #[error(
        "[rotor] has no \"{key}\", and neither has the file of the blade, expected one of them"
    )]
    Missing {
        /// The key.
        key: &'static str,
        /// An example.
        example: &'static str,
    },
    /// Too few stations.
    #[error("\"stations\" has {found}, expected at least two")]
    FewStations {
        /// Number of stations.
        found: usize,
    },
    /// Radii that do not increase.
    #[error(
        "station {number} is at the radius {} m, expected more than {} m, the radius of the station \
         before it",
        shown(*.found),
        shown(*.before)
    )]
    Order {
        /// Number of the station, from one.
        number: usize,
        /// Its radius [m].
        found: f64,
        /// The radius of the one before [m].
        before: f64,
    },
    /// The hub or the tip is inside the stations.
    #[error(
        "\"{key}\" is {} m, expected {} m or {side}, the radius of the {which} station",
        shown(*.found),
        shown(*.station)
    )]
    End {
        /// `hub_radius` or `tip_radius`.
        key: &'static str,
        /// Its value [m].
        found: f64,
        /// The radius of the station [m].
        station: f64,
        /// `less` or `more`.
        side: &'static str,
        /// `first` or `last`.
        which: &'static str,
    },
    /// No operating point.
    #[error(
        "the file has no operating points, expected [[sweep]], [[schedule]] or [[power_curve]]"
    )]
    NoPoints,
    /// Two names that are equal.
    #[error("the name \"{name}\" of operating points is used twice, expected different names")]
    SameName {
        /// The name.
        name: String,
    },
    /// An empty list.
    #[error("\"{key}\" is empty, expected at least one value")]
    Empty {
        /// The key.
        key: &'static str,
    },
    /// The speeds of a sweep do not determine its points.
    #[error(
        "[[sweep]] has {found}, expected two of \"speed\", \"rotor_speed\" and one of \
         \"tip_speed_ratio\" and \"advance_ratio\""
    )]
    Speeds {
        /// The keys found, as text.
        found: String,
    },
    /// A ratio of zero, or rotation at rest, by which a speed would be infinite.
    #[error("\"{key}\" has the value {}, expected a value above zero: \"{other}\" follows from it", shown(*.found))]
    NotPositive {
        /// The key.
        key: &'static str,
        /// The value [mixed].
        found: f64,
        /// The key of the quantity that follows.
        other: &'static str,
    },
    /// A negative speed of rotation.
    #[error("a point has a rotor speed of {} rpm, expected zero or more", shown(*.rpm))]
    Backward {
        /// The speed of rotation [rpm].
        rpm: f64,
    },
    /// Too many points.
    #[error("the sweep has {found} points, expected at most {most}")]
    TooMany {
        /// Number of points.
        found: usize,
        /// Largest number.
        most: usize,
    },
    /// Lists of different lengths.
    #[error("\"{key}\" has {found} values, expected 1 or {expected}, as many as \"{longest}\"")]
    Lengths {
        /// The key.
        key: &'static str,
        /// Number of its values.
        found: usize,
        /// Number of values of the longest list.
        expected: usize,
        /// The key of the longest list.
        longest: &'static str,
    },
    /// Loads requested at a value that no point has.
    #[error(
        "\"loads_at\" has {}, expected a value of {axis}; the nearest is {}",
        shown(*.found),
        shown(*.nearest)
    )]
    NoSuchPoint {
        /// The value [mixed].
        found: f64,
        /// The nearest value [mixed].
        nearest: f64,
        /// The quantity with its unit.
        axis: &'static str,
    },
    /// Neither or several laws of the speed of rotation.
    #[error(
        "[[power_curve]] has {found}, expected one of \"tip_speed_ratio\", \"torque_gain\" and \
         \"torque\""
    )]
    Law {
        /// The keys found, as text.
        found: String,
    },
    /// Values that do not increase.
    #[error("\"{key}\" has {} after {}, expected increasing values", shown(*.second), shown(*.first))]
    NotIncreasing {
        /// The key.
        key: &'static str,
        /// The value before [mixed].
        first: f64,
        /// The value [mixed].
        second: f64,
    },
    /// A power curve of a machine that is not driven by the wind.
    #[error("[[power_curve]] is for machine = \"turbine\", found machine = \"{machine}\"")]
    NotATurbine {
        /// The machine.
        machine: &'static str,
    },
    /// The tables of an airfoil end below the Mach numbers of the points.
    #[error(
        "airfoil \"{airfoil}\" has tables for Mach numbers up to {}, expected up to {}, the largest \
         at its stations in \"{part}\"",
        shown(*.largest),
        short_number(*.found, 3)
    )]
    Mach {
        /// Name of the airfoil.
        airfoil: String,
        /// Largest Mach number of its tables \[-\].
        largest: f64,
        /// Largest Mach number of the points \[-\].
        found: f64,
        /// Name of the points.
        part: String,
    },
    /// A cell of a schedule.
    #[error("column \"{column}\": \"{found}\" is not {expected}")]
    Cell {
        /// The title.
        column: String,
        /// The cell.
        found: String,
        /// The expected content.
        expected: &'static str,
    },
    /// A schedule without a column.
    #[error("the schedule has no column \"{column}\", found {found}")]
    NoColumn {
        /// The title.
        column: &'static str,
        /// The titles found, as text.
        found: String,
        /// Titles that are read, the usual one first.
        known: &'static [&'static str],
    },
    /// Two columns of one quantity.
    #[error("the columns \"{}\" and \"{}\" are both \"{column}\"", .titles[0], .titles[1])]
    Doubled {
        /// The quantity.
        column: &'static str,
        /// The titles.
        titles: [String; 2],
    },
    /// A schedule that begins with numbers.
    #[error("the first line has no titles, found {found}")]
    NoTitles {
        /// The line.
        found: String,
    },
    /// Another number of rows than the first line has.
    #[error("the first line announces {announced} rows, found {found}")]
    Announced {
        /// The number in the first line.
        announced: usize,
        /// Number of rows.
        found: usize,
    },
    /// Further problems of the rows of a file.
    #[error("{count} further rows have problems")]
    More {
        /// Their number.
        count: usize,
    },
}

impl Explain for PerformanceProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::StationSource { .. } => {
                "give stations = [{ r, chord, twist, airfoil }, ...], or the file of a blade"
            }
            Self::Missing { example, .. } => return Some(format!("add {example} to [rotor]")),
            Self::FewStations { .. } => "give stations from the hub to the tip",
            Self::Order { .. } => "order the stations from the hub to the tip",
            Self::End { .. } => "correct it, or remove the stations outside the blade",
            Self::NoPoints => {
                "add [[sweep]] with speed = [8] and rotor_speed = { from = 5, to = 12, steps = 8 }"
            }
            Self::SameName { .. } => "give each its own \"name\"",
            Self::Empty { .. } => "give a number, a list, or { from, to, steps }",
            Self::Speeds { .. } => {
                "give speed and rotor_speed, or one of them and a ratio, from which the other \
                 follows"
            }
            Self::NotPositive { .. } => "begin above zero, or give \"speed\" and \"rotor_speed\"",
            Self::Backward { .. } => {
                "the airfoils are for a rotor that turns forward; descent has a negative \"speed\""
            }
            Self::TooMany { .. } => "use fewer steps, or several sweeps",
            Self::Lengths { .. } => "give one value for all points, or one for each",
            Self::NoSuchPoint { .. } => "loads are reported at computed points: use one of them",
            Self::Law { .. } => {
                "tip_speed_ratio = 7.5, or torque_gain = 2.1e6, or torque = { rotor_speed = [...], \
                 torque = [...] }"
            }
            Self::NotIncreasing { .. } => "order the values, each once",
            Self::NotATurbine { .. } => "use [[sweep]] or [[schedule]]",
            Self::Mach { .. } => {
                "add tables of larger Mach numbers to its file, or outside_mach = \"hold\" to \
                 [rotor], which uses the last table beyond its Mach number"
            }
            Self::Cell { .. } => "write a number with a decimal point, in the unit of the title",
            Self::NoColumn { known: [], .. } => "give the list, or the \"file\" of a table",
            Self::NoColumn { known, .. } => {
                return Some(format!(
                    "the first line has the titles, such as wind [m/s],rotor_speed [rpm],pitch [deg]; \
                     for this column {} are known",
                    quoted(known)
                ));
            }
            Self::Doubled { .. } => "rename the column that is not meant",
            Self::NoTitles { .. } => {
                "write a line of titles above, such as wind [m/s],rotor_speed [rpm],pitch [deg]; a \
                 file of HAWC2, with wind, pitch and rotor speed, ends in .opt"
            }
            Self::Announced { .. } => "correct the number, or complete the rows",
            Self::More { .. } => return None,
        };
        Some(text.to_owned())
    }
}
