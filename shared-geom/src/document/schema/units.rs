//! The table of units, which input files share.

use super::{Need, TableSchema, ValueKind, key};
use crate::units::Dimension;

use Need::Default;

/// Units of plain numbers.
pub const UNITS: TableSchema = TableSchema {
    title: "[units]",
    meaning: "Units of plain numbers. Units that are not declared follow from the others: \
              quantities with a force in them use the unit of force, others the unit of mass; if \
              only one of force and mass is declared, the other is consistent with it.",
    keys: &[
        key(
            "length",
            &[ValueKind::Unit(Dimension::LENGTH)],
            Default("\"m\""),
            "\"in\"",
            "Unit of length; in a section file also the unit of the coordinates of the mesh.",
        ),
        key(
            "mass",
            &[ValueKind::Unit(Dimension::MASS)],
            Default("from the others"),
            "\"kg\"",
            "Unit of mass.",
        ),
        key(
            "force",
            &[ValueKind::Unit(Dimension::FORCE)],
            Default("from the others"),
            "\"lbf\"",
            "Unit of force.",
        ),
        key(
            "time",
            &[ValueKind::Unit(Dimension::TIME)],
            Default("\"s\""),
            "\"s\"",
            "Unit of time.",
        ),
        key(
            "angle",
            &[ValueKind::Unit(Dimension::ANGLE)],
            Default("\"deg\""),
            "\"deg\"",
            "Unit of angles.",
        ),
        key(
            "stress",
            &[ValueKind::Unit(Dimension::STRESS)],
            Default("from the others"),
            "\"GPa\"",
            "Unit of stress and of moduli.",
        ),
        key(
            "density",
            &[ValueKind::Unit(Dimension::DENSITY)],
            Default("from the others"),
            "\"kg/m^3\"",
            "Unit of density.",
        ),
        key(
            "mass_per_length",
            &[ValueKind::Unit(Dimension::MASS_PER_LENGTH)],
            Default("from the others"),
            "\"kg/m\"",
            "Unit of mass per length.",
        ),
        key(
            "rotation_speed",
            &[ValueKind::Unit(Dimension::ROTATION_SPEED)],
            Default("\"rpm\""),
            "\"rpm\"",
            "Unit of speeds of rotation.",
        ),
        key(
            "temperature",
            &[ValueKind::Unit(Dimension::TEMPERATURE)],
            Default("\"K\""),
            "\"degF\"",
            "Unit of rises of temperature, which are differences.",
        ),
        key(
            "voltage",
            &[ValueKind::Unit(Dimension::VOLTAGE)],
            Default("\"V\""),
            "\"kV\"",
            "Unit of voltage.",
        ),
    ],
    families: &[],
};
