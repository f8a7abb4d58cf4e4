//! The keys of distributed loads, and of end effects.

use shared_geom::units::Dimension;

use super::{Family, KeySchema, Need, TableSchema, ValueKind, key};

use Need::{Default, Optional, Required};

const GROUP: &[ValueKind] = &[ValueKind::Name];
const STRESS: &[ValueKind] = &[ValueKind::Quantity(Dimension::STRESS)];

const ALONG: KeySchema = key(
    "along",
    &[ValueKind::Numbers(
        crate::input::distributed::MOST_COEFFICIENTS,
    )],
    Default("[1]"),
    "[1, 0.5]",
    "Coefficients c0, c1, c2, ... of the polynomial c0 + c1 x + c2 x^2 + ... that multiplies the \
     force, x along the beam from this section in the declared unit of length.",
);

/// Key for the number of end effects to find.
pub(super) const END_EFFECTS: KeySchema = key(
    "end_effects",
    &[ValueKind::Count(crate::input::MOST_END_EFFECTS)],
    Optional,
    "3",
    "Number of decaying solutions to find, beginning with the slowest decay from an end or a \
     jump; this takes several times as long as the analysis.",
);

/// Tractions of a load.
pub(super) const TRACTIONS: KeySchema = key(
    "traction",
    &[ValueKind::Tables(&TRACTION)],
    Optional,
    "",
    "Forces on surfaces of the beam, which act along it.",
);

/// Volume forces of a load.
pub(super) const VOLUMES: KeySchema = key(
    "volume",
    &[ValueKind::Tables(&VOLUME)],
    Optional,
    "",
    "Forces in the volume of the beam, which act along it.",
);

const TRACTION: TableSchema = TableSchema {
    title: "[[load.NAME.traction]]",
    meaning: "A force per area on the surface that a curve of the mesh makes along the beam, \
              constant along the curve.",
    keys: &[
        key(
            "curve",
            GROUP,
            Required,
            "\"top\"",
            "The physical curve, by its name or its tag, along sides of cells; a face of a lamina \
             is \"NAME/outer\", or \"NAME/left\" and \"NAME/right\" if it is centered.",
        ),
        ALONG,
    ],
    families: &[
        Family {
            name: "pressure",
            meaning: "Normal to the surface; not on a curve with cells on both sides.",
            keys: &[key(
                "pressure",
                STRESS,
                Required,
                "\"2 kPa\"",
                "Pressure on the surface; suction is negative.",
            )],
        },
        Family {
            name: "tangential",
            meaning: "Along the curve, in the plane of the section.",
            keys: &[key(
                "tangential",
                STRESS,
                Required,
                "\"300 Pa\"",
                "Force per area in the direction of the lines of the curve.",
            )],
        },
        Family {
            name: "force",
            meaning: "In section axes.",
            keys: &[key(
                "force",
                &[ValueKind::Vector(3, Dimension::STRESS)],
                Required,
                "[0, 0, \"-2 kPa\"]",
                "Force per area along x, y and z.",
            )],
        },
    ],
};

const VOLUME: TableSchema = TableSchema {
    title: "[[load.NAME.volume]]",
    meaning: "A force per volume, constant in its regions or proportional to the density.",
    keys: &[
        key(
            "region",
            GROUP,
            Default("the whole section"),
            "\"skin\"",
            "The loaded physical surface, by its name or its tag, or a lamina by its name, for \
             all its plies.",
        ),
        ALONG,
    ],
    families: &[
        Family {
            name: "force",
            meaning: "Given as it is.",
            keys: &[key(
                "force",
                &[ValueKind::Vector(3, Dimension::FORCE_PER_VOLUME)],
                Required,
                "[0, 0, \"-12 kN/m^3\"]",
                "Force per volume along x, y and z.",
            )],
        },
        Family {
            name: "acceleration",
            meaning: "Density times acceleration: weight, or the centrifugal force outward.",
            keys: &[key(
                "acceleration",
                &[ValueKind::Vector(3, Dimension::ACCELERATION)],
                Required,
                "[0, 0, -9.81]",
                "Acceleration along x, y and z.",
            )],
        },
    ],
};
