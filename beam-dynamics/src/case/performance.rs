//! A rigid rotor and its operating points, of which the performance is computed.

use std::f64::consts::PI;

use rotor_aero::airfoil::Section;
use rotor_aero::rotor::{OperatingPoint, RigidRotor};

/// Kind of a machine: the signs and the coefficients of its field.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MachineKind {
    /// Wind turbine.
    #[default]
    Turbine,
    /// Propeller.
    Propeller,
    /// Lifting rotor in hover and axial flight.
    Helicopter,
}

/// A steady operating point of a rotor in its air.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingSetting {
    /// Speed of the wind or of flight along the shaft [m/s].
    pub speed: f64,
    /// Speed of rotation [rad/s].
    pub omega: f64,
    /// Pitch, added to the twist [rad].
    pub pitch: f64,
}

/// The quantity over which performance is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Abscissa {
    /// Speed of the wind or of flight.
    Speed,
    /// Speed of rotation.
    RotorSpeed,
    /// Pitch.
    Pitch,
    /// Speed of the tip over the speed of the wind.
    TipSpeedRatio,
    /// Speed of flight over revolutions per second and diameter.
    AdvanceRatio,
}

impl Abscissa {
    /// Name and unit of its values.
    pub fn title(self) -> &'static str {
        match self {
            Self::Speed => "speed [m/s]",
            Self::RotorSpeed => "rotor speed [rpm]",
            Self::Pitch => "pitch [deg]",
            Self::TipSpeedRatio => "tip speed ratio [-]",
            Self::AdvanceRatio => "advance ratio [-]",
        }
    }

    /// Its value at an operating point of a rotor with this radius \[m\], in the unit of its
    /// title.
    pub fn of(self, at: &OperatingSetting, radius: f64) -> f64 {
        match self {
            Self::Speed => at.speed,
            Self::RotorSpeed => at.omega * 30.0 / PI,
            Self::Pitch => at.pitch.to_degrees(),
            Self::TipSpeedRatio => at.omega * radius / at.speed,
            Self::AdvanceRatio => PI * at.speed / (at.omega * radius),
        }
    }
}

/// The law by which the speed of rotation of a turbine follows the wind below rated power.
#[derive(Debug, Clone, PartialEq)]
pub enum RotorSpeedLaw {
    /// A constant tip speed ratio [-].
    TipSpeedRatio(f64),
    /// A torque of the load proportional to the square of the speed of rotation: the factor
    /// [N m s^2].
    TorqueGain(f64),
    /// A torque of the load by a table of the speed of rotation and the torque, linear between
    /// its rows and constant outside [rad/s, N m].
    Torque(Vec<[f64; 2]>),
}

/// Rated power of a turbine with pitch control.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RatedPower {
    /// Power of the rotor [W].
    pub power: f64,
    /// Largest pitch of the search [rad].
    pub largest_pitch: f64,
}

/// The operating curve of a turbine.
#[derive(Debug, Clone, PartialEq)]
pub struct PowerCurve {
    /// Speeds of the wind [m/s].
    pub speeds: Vec<f64>,
    /// Law of the speed of rotation.
    pub law: RotorSpeedLaw,
    /// Least and largest speed of rotation [rad/s].
    pub rotor_speeds: [f64; 2],
    /// Pitch below rated power [rad].
    pub pitch: f64,
    /// Rated power; absent without a limit.
    pub rated: Option<RatedPower>,
}

/// Operating points to compute.
#[derive(Debug, Clone, PartialEq)]
pub enum PerformanceRequest {
    /// Given points.
    Settings(Vec<OperatingSetting>),
    /// Points that follow from the control of a turbine.
    PowerCurve(PowerCurve),
}

impl PerformanceRequest {
    /// Number of points.
    pub fn count(&self) -> usize {
        match self {
            Self::Settings(settings) => settings.len(),
            Self::PowerCurve(curve) => curve.speeds.len(),
        }
    }
}

/// A set of operating points with a table and figures of its own.
#[derive(Debug, Clone, PartialEq)]
pub struct PerformancePart {
    /// Name.
    pub name: String,
    /// The points.
    pub request: PerformanceRequest,
    /// The quantity over which they are drawn.
    pub abscissa: Abscissa,
    /// Names of the curves; each has the same number of successive points.
    pub curves: Vec<String>,
    /// Whether the points are a grid of the tip speed ratio and the pitch, for maps.
    pub is_map: bool,
    /// Values of the abscissa at which loads along the blade are reported, in its unit [mixed].
    pub loads_at: Vec<f64>,
}

/// A rotor and the requested points.
#[derive(Debug, Clone)]
pub struct PerformanceCase {
    /// Name, for tables and figures.
    pub name: String,
    /// Kind of machine.
    pub machine: MachineKind,
    /// The rotor.
    pub rotor: RigidRotor<Section>,
    /// The air and its shear; speeds and pitch are zero.
    pub air: OperatingPoint,
    /// The requested points.
    pub parts: Vec<PerformancePart>,
    /// Remarks on the files for the user.
    pub remarks: Vec<String>,
}

/// The value of a table, linear between its rows and constant outside.
pub fn linear_between(rows: &[[f64; 2]], x: f64) -> f64 {
    let after = rows.partition_point(|row| row[0] <= x);
    let before = after.checked_sub(1).and_then(|index| rows.get(index));
    match (before, rows.get(after)) {
        (Some([a, low]), Some([b, high])) => low + (high - low) * (x - a) / (b - a),
        (Some(row), None) | (None, Some(row)) => row[1],
        (None, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_linear_between_rows_and_constant_outside() {
        let rows = [[1.0, 10.0], [2.0, 30.0], [2.5, 30.0]];
        let found = [0.0, 1.0, 1.5, 2.0, 2.2, 9.0].map(|x| linear_between(&rows, x));
        assert_eq!(found, [10.0, 10.0, 20.0, 30.0, 30.0, 30.0]);
        assert_eq!(linear_between(&[], 1.0), 0.0);
    }
}
