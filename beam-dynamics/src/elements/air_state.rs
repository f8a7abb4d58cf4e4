//! Reports of strips in the air.

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::Vector3;
use rotor_aero::strip::StripReport;

/// Name of the rotor of blades without an inflow.
pub const NO_INFLOW: &str = "rotor";

/// Location of a strip in the model.
#[derive(Debug, Clone, PartialEq)]
pub struct StripLocation {
    /// Name of the rotor: of its inflow, if it has one; `None` without a rotor.
    pub rotor: Option<String>,
    /// Name of the blade, or of the card of strips.
    pub blade: String,
    /// Number on the blade from the root, from one.
    pub number: usize,
    /// Arc length along the blade from its root, or along the line of the card \[m\].
    pub span: f64,
    /// Direction of azimuth zero in the frame of the model; its part across the shaft counts \[-\].
    pub zero: Vector3<f64>,
    /// Sense of a positive thrust along the shaft: -1 of a rotor that turns clockwise, whose shaft has the
    /// direction of the rotation \[-\].
    pub side: f64,
}

impl Default for StripLocation {
    /// The first strip of a blade without a name.
    fn default() -> Self {
        Self {
            rotor: Some(NO_INFLOW.to_owned()),
            blade: String::new(),
            number: 1,
            span: 0.0,
            zero: Vector3::x(),
            side: 1.0,
        }
    }
}

/// The rotor of a strip at a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RotorMotion {
    /// Direction of the shaft, model axes \[-\].
    pub axis: Vector3<f64>,
    /// Angular velocity about the shaft in space: of the hub, else of the section \[rad/s\].
    pub turning: f64,
    /// Velocity of the center of the shaft against the air without induction, model axes [m/s].
    pub velocity: Vector3<f64>,
    /// Radius of the tip of the blade \[m\].
    pub tip_radius: f64,
    /// Density of the air \[kg/m^3\].
    pub density: f64,
}

/// A strip in the air.
#[derive(Debug, Clone, PartialEq)]
pub struct AirState {
    /// Its location.
    pub location: Arc<StripLocation>,
    /// Distance of the quarter chord from the shaft; not a number without a rotor \[m\].
    pub radius: f64,
    /// Azimuth of the quarter chord about the shaft, from zero to a full turn; not a number without
    /// a rotor \[rad\].
    pub azimuth: f64,
    /// Quarter chord, model axes [m].
    pub position: Vector3<f64>,
    /// Flow, coefficients and loads per length.
    pub flow: StripReport,
    /// Part of the chord along which static flow at the angle of attack is attached [-].
    pub attached: f64,
    /// Force per length around the shaft, positive in the direction of rotation; without a rotor
    /// along the chord, toward the leading edge [N/m].
    pub tangential: f64,
    /// Force, model axes [N].
    pub force: Vector3<f64>,
    /// Moment about the center of the shaft, without a rotor about the origin; model axes [N m].
    pub moment: Vector3<f64>,
    /// Its rotor, if it has one.
    pub rotor: Option<RotorMotion>,
}

/// A quantity of a strip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StripQuantity {
    /// See [`StripReport::alpha`] \[rad\].
    AngleOfAttack,
    /// See [`StripReport::inflow_angle`] \[rad\].
    InflowAngle,
    /// Against the thrust [m/s].
    InducedVelocity,
    /// Around the shaft [m/s].
    InducedSwirl,
    /// See [`StripReport::speed`] [m/s].
    FlowSpeed,
    /// Of lift \[-\].
    LiftCoefficient,
    /// Of drag \[-\].
    DragCoefficient,
    /// Of the moment about the quarter chord \[-\].
    MomentCoefficient,
    /// \[-\].
    Mach,
    /// \[-\].
    Reynolds,
    /// Per length along the thrust, without a rotor normal to the chord [N/m].
    NormalLoad,
    /// Per length around the shaft, see [`AirState::tangential`] [N/m].
    TangentialLoad,
    /// Per length [N/m].
    LiftLoad,
    /// Per length [N/m].
    DragLoad,
    /// Per length, about the quarter chord [N].
    MomentLoad,
}

impl StripQuantity {
    /// Its value in SI units.
    pub fn of(self, state: &AirState) -> f64 {
        let side = state.location.side;
        let of_report = self.of_report(&state.flow);
        of_report.map_or(state.tangential, |value| self.on_side(side, value))
    }

    /// A value of the report in the axes of a rotor whose positive thrust has the sense `side` along its shaft, 1 or -1:
    /// the axes along the shaft and around it have the other direction.
    pub(crate) fn on_side(self, side: f64, value: f64) -> f64 {
        match self {
            Self::InflowAngle if side < 0.0 => value - PI.copysign(value),
            _ => self.sense(side) * value,
        }
    }

    /// The derivative of [`Self::on_side`] by the value.
    pub(crate) fn sense(self, side: f64) -> f64 {
        match self {
            Self::InducedVelocity | Self::InducedSwirl | Self::NormalLoad => side,
            _ => 1.0,
        }
    }

    /// Its value in SI units in the report of the section, which does not know the load around the
    /// shaft.
    pub fn of_report<T: Copy>(self, flow: &StripReport<T>) -> Option<T> {
        Some(match self {
            Self::AngleOfAttack => flow.alpha,
            Self::InflowAngle => flow.inflow_angle,
            Self::InducedVelocity => flow.induced[0],
            Self::InducedSwirl => flow.induced[1],
            Self::FlowSpeed => flow.speed,
            Self::LiftCoefficient => flow.coefficients[0],
            Self::DragCoefficient => flow.coefficients[1],
            Self::MomentCoefficient => flow.coefficients[2],
            Self::Mach => flow.mach,
            Self::Reynolds => flow.reynolds,
            Self::NormalLoad => flow.along_shaft,
            Self::TangentialLoad => return None,
            Self::LiftLoad => flow.lift_and_drag[0],
            Self::DragLoad => flow.lift_and_drag[1],
            Self::MomentLoad => flow.moment,
        })
    }
}

/// A sum over the strips of a rotor that sensors read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RotorSum {
    /// T [N].
    Thrust,
    /// Q [N m].
    Torque,
    /// P, each part of Q times the speed of rotation of its strip \[W\].
    Power,
}

impl RotorSum {
    /// The share of a strip, none without a rotor [N, N m, W].
    pub fn share(self, of: &AirState) -> f64 {
        let Some(rotor) = &of.rotor else { return 0.0 };
        match self {
            Self::Thrust => of.location.side * of.force.dot(&rotor.axis),
            Self::Torque => of.moment.dot(&rotor.axis),
            Self::Power => of.moment.dot(&rotor.axis) * rotor.turning,
        }
    }
}
