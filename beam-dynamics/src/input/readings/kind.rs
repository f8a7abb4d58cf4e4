//! The quantities of columns and sensors: their words, dimensions and units.

use shared_geom::units::{Dimension, Unit, UnitProblem, parse_as};

use crate::case::ElectrodeQuantity;
use crate::elements::{
    EnergyPart, JointMotion, NodeVector, RotorQuantity, SpringVector, StripQuantity,
};

/// The word under `quantity`, the source of its numbers, their dimension (of beams for the
/// first three components), and their default unit.
pub(in crate::input) type Kind = (&'static str, Source, Dimension, &'static str);

/// Source of the numbers of a quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::input) enum Source {
    /// A vector of a node.
    Node(NodeVector),
    /// A momentum of a node, or of the model if no node is named.
    Momentum {
        /// Whether it is the angular momentum.
        is_angular: bool,
    },
    /// Internal force or strain of a beam.
    Section {
        /// Whether it is the strain.
        is_strain: bool,
    },
    /// Reaction of a joint.
    Reaction {
        /// Whether it is the moment.
        is_moment: bool,
    },
    /// Motion of a joint.
    Joint(JointMotion),
    /// A vector of a rod or a spring.
    Spring(SpringVector),
    /// A quantity of the air at a strip.
    Strip(StripQuantity),
    /// A quantity of a rotor.
    Rotor(RotorQuantity),
    /// A quantity of an electrode.
    Electrode(ElectrodeQuantity),
    /// Value of a drive, with the dimension of its unit.
    Drive,
    /// A signal.
    Signal,
    /// Energy of the model.
    Energy(EnergyPart),
    /// Length of the step.
    StepLength,
    /// Iterations of the step.
    Iterations,
}

const fn dimension(length: i8, mass: i8, time: i8) -> Dimension {
    Dimension {
        length,
        mass,
        time,
        ..Dimension::NUMBER
    }
}

/// Velocity, in m/s.
const VELOCITY: Dimension = dimension(1, 0, -1);
/// Momentum, in kg m/s.
const MOMENTUM: Dimension = dimension(1, 1, -1);
/// Curvature and twist, in 1/m.
pub(in crate::input) const CURVATURE: Dimension = dimension(-1, 0, 0);

/// Words for the six components, in the order of [`COMPONENTS`].
pub(super) const SIX: [&str; 6] = [
    "axial",
    "shear_y",
    "shear_z",
    "torsion",
    "bending_y",
    "bending_z",
];

/// Units of energy, which inputs do not have: there they would be units of moments.
const JOULES: [(&str, f64); 3] = [("J", 1.0), ("kJ", 1e3), ("MJ", 1e6)];

/// A unit of a quantity of `dimension`.
pub(in crate::input) fn unit_of(unit: &str, dimension: Dimension) -> Result<Unit, UnitProblem> {
    let joules = JOULES.iter().find(|joules| joules.0 == unit);
    match joules.filter(|_| dimension == Dimension::MOMENT) {
        Some((_, factor)) => Ok(Unit {
            factor: *factor,
            dimension,
        }),
        None => parse_as(unit, dimension),
    }
}

/// The dimension of a component of a quantity: of beams the last three components are about
/// axes.
pub(in crate::input) fn dimension_of(kind: &Kind, component: Option<&str>) -> Dimension {
    let Source::Section { is_strain } = kind.1 else {
        return kind.2;
    };
    let index = SIX.iter().position(|word| Some(*word) == component);
    match (index, is_strain) {
        (Some(3..), true) => CURVATURE,
        (Some(3..), false) => Dimension::MOMENT,
        _ => kind.2,
    }
}

/// All quantities.
pub(in crate::input) const KINDS: [Kind; 61] = [
    (
        "position",
        Source::Node(NodeVector::Position),
        Dimension::LENGTH,
        "m",
    ),
    (
        "displacement",
        Source::Node(NodeVector::Displacement),
        Dimension::LENGTH,
        "m",
    ),
    (
        "velocity",
        Source::Node(NodeVector::Velocity),
        VELOCITY,
        "m/s",
    ),
    (
        "velocity_in_space",
        Source::Node(NodeVector::VelocityInSpace),
        VELOCITY,
        "m/s",
    ),
    (
        "rotation",
        Source::Node(NodeVector::Rotation),
        Dimension::ANGLE,
        "deg",
    ),
    (
        "attitude",
        Source::Node(NodeVector::Attitude),
        Dimension::ANGLE,
        "deg",
    ),
    (
        "euler_angles",
        Source::Node(NodeVector::Euler([2, 1, 0])),
        Dimension::ANGLE,
        "deg",
    ),
    (
        "angular_velocity",
        Source::Node(NodeVector::AngularVelocity),
        Dimension::ROTATION_SPEED,
        "rad/s",
    ),
    (
        "angular_velocity_in_space",
        Source::Node(NodeVector::AngularVelocityInSpace),
        Dimension::ROTATION_SPEED,
        "rad/s",
    ),
    (
        "momentum",
        Source::Momentum { is_angular: false },
        MOMENTUM,
        "kg m/s",
    ),
    (
        "angular_momentum",
        Source::Momentum { is_angular: true },
        Dimension::TURNING_DAMPER,
        "kg m^2/s",
    ),
    (
        "internal_force",
        Source::Section { is_strain: false },
        Dimension::FORCE,
        "N",
    ),
    (
        "strain",
        Source::Section { is_strain: true },
        Dimension::NUMBER,
        "1",
    ),
    (
        "reaction_force",
        Source::Reaction { is_moment: false },
        Dimension::FORCE,
        "N",
    ),
    (
        "reaction_moment",
        Source::Reaction { is_moment: true },
        Dimension::MOMENT,
        "N m",
    ),
    (
        "joint_displacement",
        Source::Joint(JointMotion::Displacement),
        Dimension::LENGTH,
        "m",
    ),
    (
        "joint_rotation",
        Source::Joint(JointMotion::Rotation),
        Dimension::ANGLE,
        "deg",
    ),
    (
        "joint_angle",
        Source::Joint(JointMotion::Angle),
        Dimension::ANGLE,
        "deg",
    ),
    (
        "joint_velocity",
        Source::Joint(JointMotion::Velocity),
        VELOCITY,
        "m/s",
    ),
    (
        "joint_angular_velocity",
        Source::Joint(JointMotion::AngularVelocity),
        Dimension::ROTATION_SPEED,
        "rad/s",
    ),
    (
        "spring_displacement",
        Source::Spring(SpringVector::Displacement),
        Dimension::LENGTH,
        "m",
    ),
    (
        "spring_rotation",
        Source::Spring(SpringVector::Rotation),
        Dimension::ANGLE,
        "deg",
    ),
    (
        "spring_force",
        Source::Spring(SpringVector::Force),
        Dimension::FORCE,
        "N",
    ),
    (
        "spring_moment",
        Source::Spring(SpringVector::Moment),
        Dimension::MOMENT,
        "N m",
    ),
    (
        "voltage",
        Source::Electrode(ElectrodeQuantity::Voltage),
        Dimension::VOLTAGE,
        "V",
    ),
    (
        "charge",
        Source::Electrode(ElectrodeQuantity::Charge),
        Dimension::CHARGE,
        "C",
    ),
    (
        "current",
        Source::Electrode(ElectrodeQuantity::Current),
        Dimension::CURRENT,
        "A",
    ),
    (
        "angle_of_attack",
        Source::Strip(StripQuantity::AngleOfAttack),
        Dimension::ANGLE,
        "deg",
    ),
    (
        "inflow_angle",
        Source::Strip(StripQuantity::InflowAngle),
        Dimension::ANGLE,
        "deg",
    ),
    (
        "induced_velocity",
        Source::Strip(StripQuantity::InducedVelocity),
        VELOCITY,
        "m/s",
    ),
    (
        "induced_swirl",
        Source::Strip(StripQuantity::InducedSwirl),
        VELOCITY,
        "m/s",
    ),
    (
        "flow_speed",
        Source::Strip(StripQuantity::FlowSpeed),
        VELOCITY,
        "m/s",
    ),
    (
        "lift_coefficient",
        Source::Strip(StripQuantity::LiftCoefficient),
        Dimension::NUMBER,
        "1",
    ),
    (
        "drag_coefficient",
        Source::Strip(StripQuantity::DragCoefficient),
        Dimension::NUMBER,
        "1",
    ),
    (
        "moment_coefficient",
        Source::Strip(StripQuantity::MomentCoefficient),
        Dimension::NUMBER,
        "1",
    ),
    (
        "mach",
        Source::Strip(StripQuantity::Mach),
        Dimension::NUMBER,
        "1",
    ),
    (
        "reynolds",
        Source::Strip(StripQuantity::Reynolds),
        Dimension::NUMBER,
        "1",
    ),
    (
        "normal_load",
        Source::Strip(StripQuantity::NormalLoad),
        Dimension::FORCE_PER_LENGTH,
        "N/m",
    ),
    (
        "tangential_load",
        Source::Strip(StripQuantity::TangentialLoad),
        Dimension::FORCE_PER_LENGTH,
        "N/m",
    ),
    (
        "lift_load",
        Source::Strip(StripQuantity::LiftLoad),
        Dimension::FORCE_PER_LENGTH,
        "N/m",
    ),
    (
        "drag_load",
        Source::Strip(StripQuantity::DragLoad),
        Dimension::FORCE_PER_LENGTH,
        "N/m",
    ),
    (
        "moment_load",
        Source::Strip(StripQuantity::MomentLoad),
        Dimension::FORCE,
        "N",
    ),
    (
        "thrust",
        Source::Rotor(RotorQuantity::Thrust),
        Dimension::FORCE,
        "N",
    ),
    (
        "torque",
        Source::Rotor(RotorQuantity::Torque),
        Dimension::MOMENT,
        "N m",
    ),
    (
        "power",
        Source::Rotor(RotorQuantity::Power),
        Dimension::POWER,
        "W",
    ),
    (
        "thrust_coefficient",
        Source::Rotor(RotorQuantity::ThrustCoefficient),
        Dimension::NUMBER,
        "1",
    ),
    (
        "torque_coefficient",
        Source::Rotor(RotorQuantity::TorqueCoefficient),
        Dimension::NUMBER,
        "1",
    ),
    (
        "power_coefficient",
        Source::Rotor(RotorQuantity::PowerCoefficient),
        Dimension::NUMBER,
        "1",
    ),
    (
        "efficiency",
        Source::Rotor(RotorQuantity::Efficiency),
        Dimension::NUMBER,
        "1",
    ),
    (
        "advance_ratio",
        Source::Rotor(RotorQuantity::AdvanceRatio),
        Dimension::NUMBER,
        "1",
    ),
    (
        "tip_speed_ratio",
        Source::Rotor(RotorQuantity::TipSpeedRatio),
        Dimension::NUMBER,
        "1",
    ),
    (
        "figure_of_merit",
        Source::Rotor(RotorQuantity::FigureOfMerit),
        Dimension::NUMBER,
        "1",
    ),
    ("drive", Source::Drive, Dimension::NUMBER, "1"),
    ("signal", Source::Signal, Dimension::NUMBER, "1"),
    (
        "kinetic_energy",
        Source::Energy(EnergyPart::Kinetic),
        Dimension::MOMENT,
        "J",
    ),
    (
        "elastic_energy",
        Source::Energy(EnergyPart::Elastic),
        Dimension::MOMENT,
        "J",
    ),
    (
        "gravity_energy",
        Source::Energy(EnergyPart::Gravity),
        Dimension::MOMENT,
        "J",
    ),
    (
        "electric_energy",
        Source::Energy(EnergyPart::Electric),
        Dimension::MOMENT,
        "J",
    ),
    (
        "energy",
        Source::Energy(EnergyPart::Total),
        Dimension::MOMENT,
        "J",
    ),
    ("step_length", Source::StepLength, Dimension::TIME, "s"),
    ("iterations", Source::Iterations, Dimension::NUMBER, "1"),
];
