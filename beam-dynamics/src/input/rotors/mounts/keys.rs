//! The keys of what carries the shaft of a rotor: tower and nacelle, wing and pylon.

use nalgebra::Vector3;
use shared_geom::document::schema::ValueKind::{
    Count, Drive, NotNegative, Positive, Quantity, Table as OneTable, Text, Vector,
};
use shared_geom::document::schema::{KeySchema, TableSchema};
use shared_geom::document::{ByHand, Nested};
use shared_geom::keys;
use shared_geom::units::Dimension;

use crate::input::blades::BODY;
use crate::input::damping;
use crate::input::moments::INERTIA;

keys! {
    /// Foot of the tower, or root of the wing; without these, the place of the nacelle or of the
    /// axis about which the pylon turns.
    pub(in crate::input::rotors) FOOT: Vector3<f64> = "base", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[0, 0, -90]";
}

keys! {
    /// The name of its properties.
    pub(super) PROPERTIES: Option<String> = "properties", [Text], or "`file`", "\"tower\"";
    /// A file of its sections, as of a tower of ElastoDyn, or with a straight line of the same length.
    pub(super) FILE: Option<String> = "file", [Text], or "`properties`", "\"tower.blade.json\"";
    /// Number of beams of three nodes.
    pub(super) ELEMENTS: usize = "elements", [Count(1000)], or "5" = 5, "10";
}

/// The keys of its elasticity.
const COLUMN: [KeySchema; 5] = [
    PROPERTIES.schema,
    FILE.schema,
    BODY.schema,
    damping::KEY_OF_FILE.schema,
    ELEMENTS.schema,
];

keys! {
    /// Tower from `base` upward, along z of the model.
    pub(in crate::input::rotors) TOWER: Nested = "tower", [OneTable(&TOWER_TABLE)], optional, "";
    /// Nacelle of a wind turbine; it has the shaft, which points downwind, along x without yaw.
    pub(in crate::input::rotors) NACELLE: Nested = "nacelle",
        [OneTable(&NACELLE_TABLE)], optional, "";
}

/// A tower.
const TOWER_TABLE: TableSchema = TableSchema {
    title: "[rotor.tower]",
    meaning: "A straight tower of beams, clamped to the ground or on `node`.",
    keys: &[
        HEIGHT.schema,
        COLUMN[0],
        COLUMN[1],
        COLUMN[2],
        COLUMN[3],
        COLUMN[4],
    ],
    families: &[],
};

keys! {
    /// Height of its top above `base`.
    pub(super) HEIGHT: f64 = "height", [Positive(Dimension::LENGTH)], required, "87.6";
}

keys! {
    /// The nacelle, a rigid body on the top of the tower; without a tower on `node` or the ground.
    NACELLE_TABLE = "[rotor.nacelle]";
    /// Angle of the shaft about z, from x.
    pub(super) YAW: ByHand = "yaw", [Drive(Dimension::ANGLE)], or "0", "\"= 10*min(1, t/20)\"";
    /// Angle by which the shaft is raised at its upwind end.
    pub(super) TILT: f64 = "tilt", [Quantity(Dimension::ANGLE)], or "0" = 0.0, "5";
    /// Distance of the center of the hub from the axis of the tower, along the shaft and upwind;
    /// negative for a rotor downwind.
    pub(super) OVERHANG: f64 = "overhang", [Quantity(Dimension::LENGTH)], or "0" = 0.0, "5";
    /// Height of the shaft above the top of the tower, at its axis.
    pub(super) ABOVE: f64 = "above", [Quantity(Dimension::LENGTH)], or "0" = 0.0, "1.9";
    /// Its mass.
    pub(super) NACELLE_MASS: f64 = "mass", [NotNegative(Dimension::MASS)], or "0" = 0.0, "240000";
    /// Its center of mass from the top of the tower: along x turned by the yaw, across, and up.
    pub(super) NACELLE_CENTER: Vector3<f64> = "mass_center", [Vector(3, Dimension::LENGTH)],
        or "[0, 0, 0]" = Vector3::zeros(), "[1.9, 0, 1.75]";
    with INERTIA.schema;
}

keys! {
    /// Pylon of a tiltrotor, with a wing or on `node`; it has the shaft.
    pub(in crate::input::rotors) PYLON: Nested = "pylon", [OneTable(&PYLON_TABLE)], optional, "";
}

keys! {
    /// A rigid pylon that turns about -y of the model, at the tip of its wing or at `base`.
    PYLON_TABLE = "[rotor.pylon]";
    /// Distance of the center of the hub from the axis about which it turns.
    pub(super) PYLON_LENGTH: f64 = "length", [Positive(Dimension::LENGTH)], required, "1.4";
    /// Conversion angle: zero with the shaft up, 90 degrees with the shaft forward, along -x.
    pub(super) CONVERSION: ByHand = "angle",
        [Drive(Dimension::ANGLE)], or "0", "\"= 90*min(1, t/20)\"";
    /// Its mass.
    pub(super) PYLON_MASS: f64 = "mass", [NotNegative(Dimension::MASS)], or "0" = 0.0, "850";
    /// Distance of its center of mass from the axis, along the shaft.
    pub(super) PYLON_CENTER: f64 = "mass_center",
        [Quantity(Dimension::LENGTH)], or "0" = 0.0, "0.6";
    /// The wing that carries it.
    pub(super) WING: Nested = "wing", [OneTable(&WING_TABLE)], optional, "";
    with INERTIA.schema;
}

/// A wing.
const WING_TABLE: TableSchema = TableSchema {
    title: "wing = { ... }",
    meaning: "A straight wing of beams from `base`, clamped or on `node`; y of its sections is \
              forward.",
    keys: &[
        SPAN.schema,
        COLUMN[0],
        COLUMN[1],
        COLUMN[2],
        COLUMN[3],
        COLUMN[4],
    ],
    families: &[],
};

keys! {
    /// Its tip from its root.
    pub(super) SPAN: Vector3<f64> = "span", [Vector(3, Dimension::LENGTH)], required, "[0, 4.9, 0]";
}
