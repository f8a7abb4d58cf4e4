//! The keys of loads.

use shared_geom::units::Dimension;

use super::distributed::{TRACTIONS, VOLUMES};
use super::{Need, TableSchema, ValueKind, key};

use Need::{Default, Optional};

const GROUP: &[ValueKind] = &[ValueKind::Name];
const FORCE: &[ValueKind] = &[ValueKind::Quantity(Dimension::FORCE)];
const MOMENT: &[ValueKind] = &[ValueKind::Quantity(Dimension::MOMENT)];

/// A load case.
pub(super) const LOAD: TableSchema = TableSchema {
    title: "[load.NAME]",
    meaning: "An internal force with at least one nonzero component, imposed states, a \
              distributed load, voltages, or several of these. NAME is made of letters, digits, - \
              and _.",
    keys: &[
        key("axial", FORCE, Default("0"), "\"10 kN\"", "Axial force."),
        key(
            "shear_y",
            FORCE,
            Default("0"),
            "\"1 kN\"",
            "Shear force along y.",
        ),
        key(
            "shear_z",
            FORCE,
            Default("0"),
            "\"2 kN\"",
            "Shear force along z.",
        ),
        key(
            "torsion",
            MOMENT,
            Default("0"),
            "\"120 N m\"",
            "Torque about x.",
        ),
        key(
            "bending_y",
            MOMENT,
            Default("0"),
            "\"-3 kN m\"",
            "Bending moment about y.",
        ),
        key(
            "bending_z",
            MOMENT,
            Default("0"),
            "\"500 N m\"",
            "Bending moment about z.",
        ),
        key(
            "point",
            &[ValueKind::Vector(2, Dimension::LENGTH)],
            Default("the origin of the mesh"),
            "[12.5, 0]",
            "Point of application of the force, y and z.",
        ),
        key(
            "temperature",
            GROUP,
            Optional,
            "\"hot\"",
            "The temperature that acts with it, by its name.",
        ),
        key(
            "initial_strain",
            GROUP,
            Optional,
            "\"cure\"",
            "The initial strain that acts with it, by its name.",
        ),
        key(
            "voltages",
            &[ValueKind::Named(Dimension::VOLTAGE)],
            Optional,
            "{ top = \"100 V\" }",
            "Voltages of driven electrodes by their names; all others are zero.",
        ),
        TRACTIONS,
        VOLUMES,
    ],
    families: &[],
};
