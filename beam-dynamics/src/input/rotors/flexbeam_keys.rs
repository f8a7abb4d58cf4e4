//! The keys of bearingless blades: flexbeam, torque tube and snubber.

use nalgebra::Vector3;
use shared_geom::document::schema::ValueKind::{
    NotNegative, Positive, Quantity, Table as OneTable, Vector, Word,
};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::document::{ByHand, Nested};
use shared_geom::keys;
use shared_geom::units::Dimension;

use crate::input::blades::{FLEXBEAM as FLEXBEAM_TABLE, PIECES, STATIONS};
use crate::input::moments::INERTIA;

keys! {
    /// Flexbeam of a bearingless hub.
    pub(super) FLEXBEAM: ByHand = "flexbeam", [OneTable(&FLEXBEAM_TABLE)], optional, "";
    /// Torque tube around the flexbeam, on the root of the blade at its outer end; without this table
    /// a rigid tube without mass.
    pub(super) TORQUE_TUBE: ByHand = "torque_tube", [OneTable(&TUBE_TABLE)], optional, "";
    /// Snubber between the hub and the torque tube.
    pub(super) SNUBBER: Nested = "snubber", [OneTable(&SNUBBER_TABLE)], optional, "";
}

/// A torque tube.
const TUBE_TABLE: TableSchema = TableSchema {
    title: "[rotor.torque_tube]",
    meaning: "The torque tube: rigid, or of beams by keys of `[[blade]]`.",
    keys: &[TUBE_OFFSET.schema],
    families: &[
        Family {
            name: "rigid",
            meaning: "A rigid body.",
            keys: &[TUBE_MASS.schema, TUBE_CENTER.schema, INERTIA.schema],
        },
        PIECES,
        STATIONS,
    ],
};

keys! {
    /// Distance of its inner end, which has horn and snubber, from the center of the hub along the
    /// blade.
    pub(super) TUBE_OFFSET: Option<f64> = "offset", [NotNegative(Dimension::LENGTH)],
        or "the offset of the flexbeam", "0.15";
    /// Its mass.
    pub(super) TUBE_MASS: Option<f64> = "mass", [Positive(Dimension::MASS)], or "none", "4";
    /// Distance of its center of mass from the center of the hub along the blade.
    pub(super) TUBE_CENTER: Option<f64> = "center", [Quantity(Dimension::LENGTH)],
        or "midway between its ends", "0.5";
}

keys! {
    /// Pin or springs that hold the torque tube, along the blade, forward and up; they do not resist
    /// its rotation. Without stiffness and damping a pin that slides along the blade.
    SNUBBER_TABLE = "[rotor.snubber]";
    /// Distance from the center of the hub along the blade.
    pub(super) SNUBBER_OFFSET: Option<f64> = "offset", [NotNegative(Dimension::LENGTH)],
        or "the inner end of the torque tube", "0.15";
    /// Part that holds it: the hub, or the flexbeam by its node at the offset.
    pub(super) SNUBBER_TO: usize = "to", [Word(&["hub", "flexbeam"])], or "\"hub\"" = 0,
        "\"flexbeam\"";
    /// Stiffnesses, zero or more.
    pub(super) SNUBBER_STIFFNESS: Option<Vector3<f64>> = "stiffness",
        [Vector(3, Dimension::SPRING_STIFFNESS)], or "rigid, or zero with `damping`",
        "[0, \"300 kN/m\", \"9 MN/m\"]";
    /// Ratio of the loss to the stiffness of an elastomer at the frequency, in place of `damping`.
    pub(super) SNUBBER_LOSS: Option<f64> = "loss_factor", [Positive(Dimension::NUMBER)], optional,
        "0.4";
    /// The frequency of the stiffness of an elastomer.
    pub(super) SNUBBER_FREQUENCY: Option<f64> = "frequency", [Positive(Dimension::FREQUENCY)],
        optional, "4.2";
    /// Stiffnesses of an elastomer at rest, below those at the frequency or both zero: it then
    /// relaxes; without them the loss grows with the frequency.
    pub(super) SNUBBER_REST: Option<Vector3<f64>> = "static_stiffness",
        [Vector(3, Dimension::SPRING_STIFFNESS)], optional, "[0, \"200 kN/m\", \"7 MN/m\"]";
    /// Dampers, zero or more.
    pub(super) SNUBBER_DAMPING: Option<Vector3<f64>> = "damping", [Vector(3, Dimension::DAMPER)], or "zero",
        "[0, 900, 0]";
}

/// The keys of a torque tube that is a line of beams.
pub(super) const TUBE_LINE: TableSchema = TableSchema {
    title: TUBE_TABLE.title,
    meaning: TUBE_TABLE.meaning,
    keys: &[],
    families: &[PIECES, STATIONS],
};
