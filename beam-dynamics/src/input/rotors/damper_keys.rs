//! The keys of dampers: of hinges, and between hub and blade.

use nalgebra::Vector3;
use shared_geom::document::Nested;
use shared_geom::document::schema::ValueKind::{
    NotNegative, Positive, Quantities, Table as OneTable, Vector, Word,
};
use shared_geom::document::schema::{Family, TableSchema};
use shared_geom::keys;
use shared_geom::units::Dimension;

keys! {
    /// Damper of the hinge: a curve of moment over angular velocity, or an elastomer.
    pub(super) DAMPER: Nested = "damper", [OneTable(&DAMPER_TABLE)], optional, "";
    /// Damper along a line between hub and blade, or between neighboring blades.
    pub(super) LAG_DAMPER: Nested = "lag_damper", [OneTable(&LAG_DAMPER_TABLE)], optional, "";
}

/// A damper of a hinge.
const DAMPER_TABLE: TableSchema = TableSchema {
    title: "damper = { ... }",
    meaning: "A damper of the angle of a hinge.",
    keys: &[],
    families: &[
        Family {
            name: "curve",
            meaning: "Moment against the motion for each angular velocity, linear between them and \
                      beyond.",
            keys: &[RATES.schema, MOMENTS.schema],
        },
        Family {
            name: "elastomer",
            meaning: "Stiffness and loss factor at a frequency.",
            keys: &[
                TURNING_STIFFNESS.schema,
                LOSS_FACTOR.schema,
                FREQUENCY.schema,
                TURNING_REST.schema,
            ],
        },
    ],
};

keys! {
    /// Ascending angular velocities, at least two.
    pub(super) RATES: Vec<f64> = "rates", [Quantities(Dimension::ROTATION_SPEED)], required,
        "[\"-1 rad/s\", 0, \"1 rad/s\"]";
    /// The moment at each.
    pub(super) MOMENTS: Vec<f64> = "moments", [Quantities(Dimension::MOMENT)], required,
        "[-900, 0, 900]";
    /// Stiffness at the frequency, moment per radian.
    pub(super) TURNING_STIFFNESS: f64 = "stiffness", [Positive(Dimension::MOMENT)], required,
        "\"9 kN*m\"";
    /// Ratio of the loss to the stiffness at the frequency.
    pub(super) LOSS_FACTOR: f64 = "loss_factor", [Positive(Dimension::NUMBER)], required, "0.5";
    /// The frequency.
    pub(super) FREQUENCY: f64 = "frequency", [Positive(Dimension::FREQUENCY)], required, "4.2";
    /// Stiffness at rest, less than the one at the frequency: the elastomer then relaxes; without it
    /// the loss grows with the frequency.
    pub(super) TURNING_REST: Option<f64> = "static_stiffness", [NotNegative(Dimension::MOMENT)],
        optional, "\"6 kN*m\"";
}

/// A damper between hub and blade.
const LAG_DAMPER_TABLE: TableSchema = TableSchema {
    title: "[rotor.lag_damper]",
    meaning: "A damper along the line between a point of the hub and a point of each blade, or \
              between points of each blade and the next one; a positive force resists its \
              elongation.",
    keys: &[
        BETWEEN.schema,
        HUB_END.schema,
        NEXT_END.schema,
        BLADE_END.schema,
        ON.schema,
    ],
    families: &[
        Family {
            name: "linear",
            meaning: "A spring and a damper.",
            keys: &[STIFFNESS.schema, DAMPING.schema],
        },
        Family {
            name: "curve",
            meaning: "Force against the motion for each velocity of the elongation, linear between \
                      them and beyond.",
            keys: &[VELOCITIES.schema, FORCES.schema],
        },
        Family {
            name: "elastomer",
            meaning: "Stiffness and loss factor at a frequency.",
            keys: &[
                LINE_STIFFNESS.schema,
                LOSS_FACTOR.schema,
                FREQUENCY.schema,
                LINE_REST.schema,
            ],
        },
    ],
};

/// Parts of a blade that carry a damper.
pub(super) const PARTS: [&str; 2] = ["lag", "root"];

/// Words of what a damper connects with each blade.
const ENDS: [&str; 2] = ["hub", "blades"];

keys! {
    /// Its other end than on the blade: on the hub, or on the next blade in the direction of azimuth.
    pub(super) BETWEEN: usize = "between", [Word(&ENDS)], or "\"hub\"" = 0, "\"blades\"";
    /// End on the hub, or on the yoke of a hub that tilts: along the undeformed blade from the center
    /// of the hub, forward, and up; needed between hub and blade.
    pub(super) HUB_END: Option<Vector3<f64>> = "hub", [Vector(3, Dimension::LENGTH)], optional,
        "[0.1, -0.15, 0]";
    /// End on the next blade, in the axes of that blade; needed between blades.
    pub(super) NEXT_END: Option<Vector3<f64>> = "next", [Vector(3, Dimension::LENGTH)], optional,
        "[0.5, -0.1, 0]";
    /// End on the blade, in the same axes.
    pub(super) BLADE_END: Vector3<f64> = "blade", [Vector(3, Dimension::LENGTH)], required,
        "[0.5, -0.1, 0]";
    /// Part of the blade that carries this end: the one outboard of the first lag hinge, or the root,
    /// which turns with the pitch.
    pub(super) ON: Option<usize> = "on", [Word(&PARTS)], or "`\"lag\"` if there is a lag hinge",
        "\"root\"";
    /// Stiffness, force per displacement.
    pub(super) STIFFNESS: f64 = "stiffness", [NotNegative(Dimension::SPRING_STIFFNESS)], or "0" = 0.0,
        "\"200 kN/m\"";
    /// Damper, force per velocity.
    pub(super) DAMPING: f64 = "damping", [NotNegative(Dimension::DAMPER)], or "0" = 0.0, "8000";
    /// Ascending velocities of the elongation, at least two.
    pub(super) VELOCITIES: Vec<f64> = "rates", [Quantities(Dimension::VELOCITY)], required,
        "[-0.1, 0, 0.1]";
    /// The force at each.
    pub(super) FORCES: Vec<f64> = "forces", [Quantities(Dimension::FORCE)], required,
        "[-900, 0, 900]";
    /// Stiffness at the frequency, force per displacement.
    pub(super) LINE_STIFFNESS: f64 = "stiffness", [Positive(Dimension::SPRING_STIFFNESS)], required,
        "\"400 kN/m\"";
    /// Stiffness at rest, less than the one at the frequency: the elastomer then relaxes; without it
    /// the loss grows with the frequency.
    pub(super) LINE_REST: Option<f64> = "static_stiffness",
        [NotNegative(Dimension::SPRING_STIFFNESS)], optional, "\"300 kN/m\"";
}
