//! The keys of `[[rotor]]` and of its tables.

use nalgebra::Vector3;
use shared_geom::document::schema::TableSchema;
use shared_geom::document::schema::ValueKind::{
    Count, Drive, Drives, NotNegative, Positive, Quantities, Quantity, Table as OneTable, Tables,
    Text, Vector, Word,
};
use shared_geom::document::{ByHand, Nested, NestedList};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::damper_keys::{DAMPER, LAG_DAMPER};
use super::flexbeam_keys::{FLEXBEAM, SNUBBER, TORQUE_TUBE};
use super::hubs;
use super::mounts::keys::{FOOT, NACELLE, PYLON, TOWER};
use super::train_keys::TRAIN;
use crate::input::moments::INERTIA;
use crate::input::{aerodynamics, blades};

keys! {
    /// A rotor with its shaft, hub, blades and controls: it expands to frames, nodes, bodies, joints,
    /// springs and blades, which `beam-dynamics expand` prints.
    pub(in crate::input) CARD = "[[rotor]]";
    /// Its name, letters, digits and `_`: its hub is the node `NAME/hub`, its blades are `NAME 1` and
    /// so on.
    pub(super) NAME: String = "name", [Text], required, "\"main\"";
    /// Kind of the hub.
    pub(super) HUB: usize = "hub", [Word(&hubs::WORDS)], required, "\"articulated\"";
    /// Node that carries the shaft, or the tower, nacelle, wing or pylon.
    pub(super) NODE: Option<String> = "node", [Text], or "the frame of the model", "\"pylon\"";
    /// Center of the hub, on the shaft; with a nacelle or a pylon it follows from these.
    pub(super) CENTER: Vector3<f64> = "center", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, 2]";
    /// Axis of the shaft in the sense of rotation, of any length; with a nacelle or a pylon it
    /// chooses the sense only.
    pub(super) AXIS: Vector3<f64> = "axis", [Vector(3, Dimension::NUMBER)],
        or "[0, 0, 1]" = Vector3::z(), "[0.1, 0, 1]";
    /// Sense of rotation as seen against `axis`, from above on a helicopter: counterclockwise about `axis`,
    /// or its mirror image, clockwise; `axis` then is toward the thrust.
    pub(super) DIRECTION: usize = "direction", [Word(&DIRECTIONS)],
        or "\"counterclockwise\"" = 0, "\"clockwise\"";
    /// Direction of azimuth zero; its part across the axis counts.
    pub(super) AFT: Vector3<f64> = "aft", [Vector(3, Dimension::NUMBER)],
        or "[1, 0, 0]" = Vector3::x(), "[0, 1, 0]";
    /// Azimuth of the first blade in the undeformed model.
    pub(super) AZIMUTH: f64 = "azimuth", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "45";
    /// Number of blades.
    pub(super) BLADES: usize = "blades", [Count(100)], required, "4";
    /// Speed of the shaft; with `angle` or `torque` the speed at the start of a run.
    pub(super) SPEED: Option<f64> = "speed", [Quantity(Dimension::ROTATION_SPEED)], optional, "300";
    /// Angle of the shaft over time, in place of a constant speed.
    pub(super) ANGLE: ByHand = "angle", [Drive(Dimension::ANGLE)], optional, "\"= 900*t^2\"";
    /// Torque on the shaft, whose speed then follows; it acts against the node of the shaft.
    pub(super) TORQUE: ByHand = "torque", [Drive(Dimension::MOMENT)], optional, "\"8 kN*m\"";
    /// Mass of the hub.
    pub(super) MASS: f64 = "mass", [NotNegative(Dimension::MASS)], or "0" = 0.0, "80";
    /// Distance of the cone of the blades below the hinge of a teetering hub.
    pub(super) UNDERSLING: f64 = "undersling", [Quantity(Dimension::LENGTH)], or "0" = 0.0, "0.1";
    /// Distance of each universal joint of a gimballed hub from its center, along mast and hub.
    pub(super) LINK: Option<f64> = "link", [Positive(Dimension::LENGTH)], optional, "0.15";
    /// Tilt of a teetering or gimballed hub.
    pub(super) TILT: Nested = "tilt", [OneTable(&TILT_TABLE)], optional, "";
    /// Body of the part that tilts.
    pub(super) YOKE: Nested = "yoke", [OneTable(&YOKE_TABLE)], optional, "";
    /// The blade.
    pub(super) BLADE: ByHand = "blade", [OneTable(&blades::OF_ROTOR)], required, "";
    /// Hinges of each blade, from the hub outward.
    pub(super) HINGES: NestedList = "hinge", [Tables(&HINGE)], optional, "";
    /// Pitch of the blades.
    pub(super) SWASHPLATE: Nested = "swashplate", [OneTable(&SWASHPLATE_TABLE)], optional, "";
    /// Pitch links; without them the pitch bearing has the pitch of the swashplate.
    pub(super) PITCH_LINK: Nested = "pitch_link", [OneTable(&PITCH_LINK_TABLE)], optional, "";
    /// The velocity that the rotor induces: an `[[inflow]]` of its name about its shaft.
    pub(super) INFLOW: ByHand = "inflow", [OneTable(&aerodynamics::OF_ROTOR)], optional, "";
    with INERTIA.schema, FLEXBEAM.schema, TORQUE_TUBE.schema, SNUBBER.schema,
        LAG_DAMPER.schema, TRAIN.schema, FOOT.schema, TOWER.schema, NACELLE.schema, PYLON.schema;
}

/// Words of the sense of rotation.
const DIRECTIONS: [&str; 2] = ["counterclockwise", "clockwise"];

/// Springs, dampers and stops of the tilt.
const TILT_TABLE: TableSchema = TableSchema {
    title: "[rotor.tilt]",
    meaning: "Spring, damper and stops of the tilt; a positive angle of a teetering hub is up for \
              the first blade.",
    keys: &[STIFFNESS.schema, DAMPING.schema, STOP.schema],
    families: &[],
};

keys! {
    /// A body in the axes of the hub, with its center in the hub's center.
    YOKE_TABLE = "[rotor.yoke]";
    /// Its mass.
    pub(super) YOKE_MASS: f64 = "mass", [Positive(Dimension::MASS)], required, "30";
    with INERTIA.schema;
}

keys! {
    /// A hinge of every blade.
    HINGE = "[[rotor.hinge]]";
    /// Motion: flap, positive up; lag, positive forward; pitch, positive nose up.
    pub(super) KIND: usize = "kind", [Word(&KINDS)], required, "\"flap\"";
    /// Distance from the center of the hub along the blade; without it the offset of the previous
    /// hinge, or of the root.
    pub(super) OFFSET: Option<f64> = "offset", [Quantity(Dimension::LENGTH)], optional, "0.2";
    with STIFFNESS.schema, DAMPING.schema, STOP.schema, DAMPER.schema;
}

/// Words of the kinds of hinges.
pub(super) const KINDS: [&str; 3] = ["flap", "lag", "pitch"];

keys! {
    /// Stiffness of the spring, moment per radian.
    pub(super) STIFFNESS: f64 = "stiffness", [NotNegative(Dimension::MOMENT)], or "0" = 0.0,
        "\"40 kN*m\"";
    /// Damper, moment per angular velocity in radians per time.
    pub(super) DAMPING: f64 = "damping", [NotNegative(Dimension::TURNING_DAMPER)], or "0" = 0.0,
        "\"900 N*m*s\"";
    /// Stops: one-sided smooth springs.
    pub(super) STOP: Nested = "stop", [OneTable(&STOP_TABLE)], optional, "";
}

keys! {
    /// Stops at angles, at least one.
    STOP_TABLE = "stop = { ... }";
    /// Least angle: the droop stop of a flap hinge.
    pub(super) LOWER: Option<f64> = "lower", [Quantity(Dimension::ANGLE)], optional, "-4";
    /// Largest angle.
    pub(super) UPPER: Option<f64> = "upper", [Quantity(Dimension::ANGLE)], optional, "25";
    /// Stiffness in contact, moment per radian.
    pub(super) STOP_STIFFNESS: f64 = "stiffness", [Positive(Dimension::MOMENT)], required,
        "\"200 kN*m\"";
    /// Damper in contact, moment per angular velocity in radians per time.
    pub(super) STOP_DAMPING: f64 = "damping", [NotNegative(Dimension::TURNING_DAMPER)],
        or "0" = 0.0, "\"2 kN*m*s\"";
    /// Angle over which the contact begins.
    pub(super) WIDTH: f64 = "width", [Positive(Dimension::ANGLE)],
        or "\"0.1 deg\"" = 0.1_f64.to_radians(), "0.2";
}

keys! {
    /// Pitch of the blades over azimuth: collective, cyclic and more.
    SWASHPLATE_TABLE = "[rotor.swashplate]";
    /// Mean pitch.
    pub(super) COLLECTIVE: ByHand = "collective", [Drive(Dimension::ANGLE)], or "0", "8";
    /// Factor of the cosine of the azimuth.
    pub(super) COSINE: ByHand = "cosine", [Drive(Dimension::ANGLE)], or "0", "2";
    /// Factor of the sine of the azimuth.
    pub(super) SINE: ByHand = "sine", [Drive(Dimension::ANGLE)], or "0", "\"= -4*t\"";
    /// Higher harmonics of the pitch.
    pub(super) HARMONIC: NestedList = "harmonic", [Tables(&HARMONIC_TABLE)], optional, "";
    /// Pitch of each blade, added to the others.
    pub(super) INDIVIDUAL: ByHand = "individual", [Drives(Dimension::ANGLE)], optional,
        "[0, 0, \"= sin(t)\", 0]";
    /// Plates and pitch links as bodies and rods; without it the pitch follows the formula.
    pub(super) PLATE: Nested = "plate", [OneTable(&PLATE_TABLE)], optional, "";
}

keys! {
    /// A harmonic of the pitch.
    HARMONIC_TABLE = "[[rotor.swashplate.harmonic]]";
    /// Its number: 2 is twice per revolution.
    pub(super) ORDER: usize = "order", [Count(100)], required, "2";
    with COSINE.schema, SINE.schema;
}

keys! {
    /// A plate that does not turn, held on the mast, one that turns on it, and a link to each blade.
    PLATE_TABLE = "[rotor.swashplate.plate]";
    /// Distance of the plates below the center of the hub, without pitch.
    pub(super) BELOW: f64 = "below", [Positive(Dimension::LENGTH)], required, "0.15";
    /// End of the link on the blade, along the span from the center of the hub, and ahead of the
    /// pitch axis; without pitch the link is parallel to the mast.
    pub(super) HORN: [f64; 2] = "horn", [Vector(2, Dimension::LENGTH)], required, "[0.05, 0.19]";
    /// Stiffness of a link, force per displacement; without it links are rigid.
    pub(super) LINK_STIFFNESS: Option<f64> = "stiffness",
        [Positive(Dimension::SPRING_STIFFNESS)], or "rigid", "\"2 MN/m\"";
    /// Damper of a link with stiffness.
    pub(super) LINK_DAMPING: f64 = "damping", [NotNegative(Dimension::DAMPER)], or "0" = 0.0, "500";
    /// Three actuators that move the plate, in place of a prescribed plate.
    pub(super) ACTUATORS: Nested = "actuators", [OneTable(&ACTUATOR_TABLE)], optional, "";
}

keys! {
    /// Actuators of variable length from the mast to the plate.
    ACTUATOR_TABLE = "actuators = { ... }";
    /// Radius of their ends on the plate.
    pub(super) RADIUS: f64 = "radius", [Positive(Dimension::LENGTH)], required, "0.2";
    /// Radius of their bases.
    pub(super) BASE_RADIUS: f64 = "base_radius", [Positive(Dimension::LENGTH)], required, "0.2";
    /// Distance of their bases below the plate, without pitch.
    pub(super) BASE_BELOW: f64 = "base_below", [Positive(Dimension::LENGTH)], required, "0.3";
    /// Azimuths of the three.
    pub(super) AZIMUTHS: Vec<f64> = "azimuths", [Quantities(Dimension::ANGLE)],
        or "[90, 210, 330]" = [90.0_f64, 210.0, 330.0].map(f64::to_radians).to_vec(),
        "[0, 120, 240]";
}

keys! {
    /// Control stiffness between swashplate and blade.
    PITCH_LINK_TABLE = "[rotor.pitch_link]";
    /// Stiffness about the pitch axis, moment per radian.
    pub(super) CONTROL_STIFFNESS: f64 = "stiffness", [Positive(Dimension::MOMENT)], required,
        "\"20 kN*m\"";
    /// Pitch-flap coupling: pitch falls by its tangent times the flap angle.
    pub(super) DELTA_3: f64 = "delta_3", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "-15";
    with DAMPING.schema;
}
