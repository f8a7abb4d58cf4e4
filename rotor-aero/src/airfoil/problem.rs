//! Problems of airfoil tables, and peculiarities that are accepted.

use shared_geom::error::Explain;

/// Largest angle of tables that seem to be in radians, as it is read \[deg\].
pub const RADIANS: f64 = 3.2;

/// A reason for which a table is refused. A `curve` is named by coefficient, airfoil and
/// conditions; angles in messages are in degrees.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum AirfoilProblem {
    /// A coefficient has no curve.
    #[error("airfoil \"{airfoil}\" has no {coefficient} curve")]
    Absent {
        /// Name.
        airfoil: String,
        /// Name of the coefficient.
        coefficient: &'static str,
    },
    /// Angles and values differ in number.
    #[error("{curve}: {angles} angles and {values} values, expected equal numbers")]
    Lengths {
        /// Curve.
        curve: String,
        /// Number of angles.
        angles: usize,
        /// Number of values.
        values: usize,
    },
    /// A curve of fewer than two points.
    #[error("{curve}: {points} points, expected two or more")]
    Few {
        /// Curve.
        curve: String,
        /// Number of points.
        points: usize,
    },
    /// A number is infinite or not a number.
    #[error("{curve}: {quantity} of point {point} is {value}, expected a finite number")]
    NotFinite {
        /// Curve.
        curve: String,
        /// Angle or value.
        quantity: &'static str,
        /// Point, counted from one.
        point: usize,
        /// Value found \[-\].
        value: f64,
    },
    /// An angle is less than the one before.
    #[error(
        "{curve}: {second_deg} deg (point {point}) follows {first_deg} deg, expected ascending angles"
    )]
    NotAscending {
        /// Curve.
        curve: String,
        /// Angle before \[deg\].
        first_deg: f64,
        /// Angle \[deg\].
        second_deg: f64,
        /// Point of the second angle, counted from one.
        point: usize,
    },
    /// More than one angle is repeated.
    #[error(
        "{curve}: {count} angles are repeated, the first two are {first_deg} and {second_deg} deg"
    )]
    Repeated {
        /// Curve.
        curve: String,
        /// Number of repeated angles.
        count: usize,
        /// First of them \[deg\].
        first_deg: f64,
        /// Second of them \[deg\].
        second_deg: f64,
    },
    /// A gap at small angles of attack.
    #[error(
        "{curve}: no values between {from_deg} and {to_deg} deg, expected steps of at most 25 deg there"
    )]
    Gap {
        /// Curve.
        curve: String,
        /// Start of the gap \[deg\].
        from_deg: f64,
        /// End of the gap \[deg\].
        to_deg: f64,
    },
    /// A curve does not cover the full circle.
    #[error("{curve}: {from_deg} to {to_deg} deg, expected -180 to 180 deg")]
    Incomplete {
        /// Curve.
        curve: String,
        /// First angle \[deg\].
        from_deg: f64,
        /// Last angle \[deg\].
        to_deg: f64,
    },
    /// A curve exceeds the full circle.
    #[error("{curve}: {from_deg} to {to_deg} deg exceed -180 to 180 deg")]
    Beyond {
        /// Curve.
        curve: String,
        /// First angle \[deg\].
        from_deg: f64,
        /// Last angle \[deg\].
        to_deg: f64,
    },
    /// Values at -180 and 180 deg differ.
    #[error("{curve}: {low} at -180 deg and {high} at 180 deg, expected equal values")]
    EndsDiffer {
        /// Curve.
        curve: String,
        /// Value at -180 deg \[-\].
        low: f64,
        /// Value at 180 deg \[-\].
        high: f64,
    },
    /// Some curves of a coefficient state a condition, and others do not.
    #[error("{curve}: {given} curves state a {variable}, and {absent} do not")]
    Mixed {
        /// Coefficient and airfoil.
        curve: String,
        /// Name of the condition.
        variable: &'static str,
        /// Number of curves with it.
        given: usize,
        /// Number of curves without it.
        absent: usize,
    },
    /// Two curves have the same conditions.
    #[error("{curve}: curves {first} and {second} of the table have the same conditions")]
    Shared {
        /// Curve.
        curve: String,
        /// First curve, counted from one.
        first: usize,
        /// Second curve, counted from one.
        second: usize,
    },
    /// A condition is impossible.
    #[error("{curve}: {variable} {value}, expected {expected}")]
    Condition {
        /// Curve.
        curve: String,
        /// Name of the condition.
        variable: &'static str,
        /// Value found \[-\].
        value: f64,
        /// Range expected.
        expected: &'static str,
    },
    /// A coefficient is too large for any airfoil.
    #[error("{curve}: {value} at {angle_deg} deg, expected {from} to {to}")]
    Absurd {
        /// Curve.
        curve: String,
        /// Value found \[-\].
        value: f64,
        /// Its angle \[deg\].
        angle_deg: f64,
        /// Smallest value accepted \[-\].
        from: f64,
        /// Largest value accepted \[-\].
        to: f64,
    },
    /// Compressibility is requested for a table over Mach numbers.
    #[error("airfoil \"{airfoil}\" has curves over the Mach number, which contain compressibility")]
    HasMach {
        /// Name.
        airfoil: String,
    },
    /// A table cannot be transformed.
    #[error("{curve}: {reason}")]
    Transformation {
        /// Curve.
        curve: String,
        /// Reason.
        reason: &'static str,
    },
}

fn more_steps(others: usize) -> String {
    match others {
        0 => String::new(),
        1 => ", and one more step above 30 deg".to_owned(),
        _ => format!(", and {others} more steps above 30 deg"),
    }
}

impl Explain for AirfoilProblem {
    fn help(&self) -> Option<String> {
        let text = match self {
            Self::Absent { .. } => "add the curve; a lift without drag needs a drag curve of zeros",
            Self::Lengths { .. } => "each angle needs one value",
            Self::Few { .. } => "give the values at -180 and 180 deg at least",
            Self::NotFinite { .. } => "remove the point, or repair its number in the file",
            Self::NotAscending { .. } => "sort the rows of the table by angle",
            Self::Repeated { .. } => {
                "remove the repeated rows; if all angles are rounded, write more digits"
            }
            Self::Gap { .. } => {
                "add rows up to and beyond stall, or remove the far rows and use viterna = true, which \
                 extends a table from its stall to all angles"
            }
            Self::Incomplete {
                from_deg, to_deg, ..
            } if from_deg.abs().max(to_deg.abs()) <= RADIANS => {
                "the angles seem to be in radians, but are read as degrees: convert them, or state their \
                 unit"
            }
            Self::Incomplete { .. } => "extend the table to the full circle, as Viterna does",
            Self::Beyond { .. } => {
                "shift angles above 180 deg by -360 deg, or correct the unit of the angles"
            }
            Self::EndsDiffer { .. } => "-180 and 180 deg are the same flow: make the values equal",
            Self::Mixed { .. } => "state it for all curves of the coefficient, or for none",
            Self::Shared { .. } => "remove one of them, or correct its conditions",
            Self::Condition { .. } => "correct the number, or its unit",
            Self::Absurd { .. } => "correct the value, the order of the columns, or its unit",
            Self::HasMach { .. } => {
                "use the table as it is, or its curves of the lowest Mach number"
            }
            Self::Transformation { .. } => return None,
        };
        Some(text.to_owned())
    }
}

/// A peculiarity of a table that is accepted.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum AirfoilRemark {
    /// One angle is given twice.
    #[error(
        "{curve}: {angle_deg} deg is repeated, the first value {kept} is kept, {dropped} is dropped"
    )]
    Repeated {
        /// Curve.
        curve: String,
        /// Angle \[deg\].
        angle_deg: f64,
        /// Value kept \[-\].
        kept: f64,
        /// Value dropped \[-\].
        dropped: f64,
    },
    /// An end is near 180 deg, and moved there.
    #[error("{curve}: the end at {angle_deg} deg is moved to {to_deg} deg")]
    Closed {
        /// Curve.
        curve: String,
        /// Angle found \[deg\].
        angle_deg: f64,
        /// Angle used \[deg\].
        to_deg: f64,
    },
    /// Values at -180 and 180 deg differ a little.
    #[error("{curve}: {low} at -180 deg and {high} at 180 deg, the mean is used")]
    EndsDiffer {
        /// Curve.
        curve: String,
        /// Value at -180 deg \[-\].
        low: f64,
        /// Value at 180 deg \[-\].
        high: f64,
    },
    /// A table at a single Mach number.
    #[error("{curve}: the only Mach number of the table, its values are used at all Mach numbers")]
    SingleMach {
        /// Curve.
        curve: String,
    },
    /// A wide step of the angle of attack.
    #[error(
        "{curve}: no values between {from_deg} and {to_deg} deg{}{}",
        more_steps(*.others),
        if *.at_stall {
            "; lift rises and falls there, expected steps of at most 25 deg from -20 to 20 deg: add \
             rows, or remove the far ones and use viterna = true, which extends a table beyond stall"
        } else {
            ""
        }
    )]
    WideStep {
        /// Curve.
        curve: String,
        /// Start of the step \[deg\].
        from_deg: f64,
        /// End of the step \[deg\].
        to_deg: f64,
        /// Number of other steps above 30 deg.
        others: usize,
        /// Whether it includes angles at which the flow is attached or stalls.
        at_stall: bool,
    },
    /// Rows that are missing among others at small angles.
    #[error(
        "{curve}: no values between {from_deg} and {to_deg} deg, where steps are {usual_deg} deg: rows seem \
         to be missing, and the curve between them is a guess: add them"
    )]
    Skipped {
        /// Curve.
        curve: String,
        /// Start of the step \[deg\].
        from_deg: f64,
        /// End of the step \[deg\].
        to_deg: f64,
        /// Median step there \[deg\].
        usual_deg: f64,
    },
    /// Drag below zero.
    #[error("{curve}: the drag coefficient is {value} at {angle_deg} deg")]
    NegativeDrag {
        /// Curve.
        curve: String,
        /// Value \[-\].
        value: f64,
        /// Angle \[deg\].
        angle_deg: f64,
    },
    /// No moment curve.
    #[error("airfoil \"{airfoil}\" has no moment curve: the moment is zero")]
    NoMoment {
        /// Name.
        airfoil: String,
    },
}
