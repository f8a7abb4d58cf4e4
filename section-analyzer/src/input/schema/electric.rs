//! The keys of electric laws and of electrodes.

use shared_geom::units::Dimension;

use super::{Family, KeySchema, Need, TableSchema, ValueKind, key};
use crate::input::electrodes::CIRCUIT_WORDS;

use Need::{Default, Optional, Required};

const NUMBER: Dimension = Dimension::NUMBER;
const NAMES: &[ValueKind] = &[ValueKind::Names];
const STRAIN: &[ValueKind] = &[ValueKind::Quantity(Dimension::STRAIN_PER_FIELD)];
const STRESS: &[ValueKind] = &[ValueKind::Quantity(Dimension::CHARGE_PER_AREA)];

/// The electric law of a material.
pub(super) const ELECTRIC: KeySchema = key(
    "electric",
    &[ValueKind::Table(&LAW)],
    Optional,
    "",
    "The electric law of a dielectric; without it the material is not part of the electric \
     problem.",
);

/// The electric law of a material without stiffness.
pub(super) const DIELECTRIC: KeySchema = key(
    "electric",
    &[ValueKind::Table(&PLAIN)],
    Required,
    "",
    "The electric law, without coupling.",
);

const PERMITTIVITY: KeySchema = key(
    "permittivity",
    &[
        ValueKind::Quantity(Dimension::PERMITTIVITY),
        ValueKind::Vector(3, Dimension::PERMITTIVITY),
        ValueKind::Rows(3, 3),
    ],
    Required,
    "[\"2.77e-8 F/m\", \"2.77e-8 F/m\", \"3.01e-8 F/m\"]",
    "Permittivity: one number, three along the axes of the constants, or a symmetric matrix; \
     plain numbers in the declared force per square of the voltage (F/m in SI).",
);

const RELATIVE: KeySchema = key(
    "relative_permittivity",
    &[
        ValueKind::Quantity(NUMBER),
        ValueKind::Vector(3, NUMBER),
        ValueKind::Rows(3, 3),
    ],
    Required,
    "[3130, 3130, 3400]",
    "Permittivity in units of the vacuum permittivity, 8.8541878128e-12 F/m: one number, three, \
     or a symmetric matrix.",
);

const D: KeySchema = key(
    "d",
    &[ValueKind::Table(&STRAINS), ValueKind::Rows(3, 6)],
    Required,
    "[[0, 0, 0, 0, 741e-12, 0], [0, 0, 0, 741e-12, 0, 0], [-274e-12, -274e-12, 593e-12, 0, 0, 0]]",
    "Strain per electric field without stress: constants by name, or 3 rows (field 1, 2, 3) of \
     6 (strain 11, 22, 33, 23, 13, 12, engineering shears); plain numbers in the declared length \
     per voltage.",
);

const E: KeySchema = key(
    "e",
    &[ValueKind::Table(&STRESSES), ValueKind::Rows(3, 6)],
    Required,
    "[[0, 0, 0, 0, 17, 0], [0, 0, 0, 17, 0, 0], [-6.6, -6.6, 23.2, 0, 0, 0]]",
    "Stress per electric field without strain, with the sign sigma = c eps - e' E: constants by \
     name, or 3 rows of 6; plain numbers in the declared force per length and voltage (C/m^2 in \
     SI).",
);

/// The default is also the example.
const fn at(default: &'static str) -> KeySchema {
    key(
        "at",
        &[ValueKind::Word(&["stress", "strain"])],
        Default(default),
        default,
        "Quantity that was constant when the permittivity was measured.",
    )
}

const POLING: KeySchema = key(
    "poling",
    &[ValueKind::Quantity(NUMBER), ValueKind::Vector(3, NUMBER)],
    Default("3"),
    "3",
    "Direction of axis 3 of all constants of the material, elastic ones and expansion too, in the \
     axes of the material: one of them (1 along the fiber, 2 across it in the ply, 3 through the \
     thickness; with a minus for the opposite direction), or its components.",
);

const ACROSS: KeySchema = key(
    "across",
    &[ValueKind::Quantity(NUMBER), ValueKind::Vector(3, NUMBER)],
    Default("the axis after the poling, of 1, 2, 3, 1"),
    "1",
    "Direction of axis 1 of the constants in the axes of the material, at a right angle to the \
     poling; required if the poling is along none of them.",
);

const LAW: TableSchema = TableSchema {
    title: "[material.NAME.electric]",
    meaning: "Electric law of a material. The stiffness of the material is the stiffness at \
              constant electric field (short circuit).",
    keys: &[POLING, ACROSS],
    families: &[
        Family {
            name: "dielectric",
            meaning: "Not piezoelectric.",
            keys: &[PERMITTIVITY],
        },
        Family {
            name: "dielectric, relative",
            meaning: "The same in units of the permittivity of vacuum.",
            keys: &[RELATIVE],
        },
        Family {
            name: "d",
            meaning: "Piezoelectric, by strains per field.",
            keys: &[D, PERMITTIVITY, at("\"stress\"")],
        },
        Family {
            name: "d, relative",
            meaning: "The same in units of the permittivity of vacuum.",
            keys: &[D, RELATIVE, at("\"stress\"")],
        },
        Family {
            name: "e",
            meaning: "Piezoelectric, by stresses per field.",
            keys: &[E, PERMITTIVITY, at("\"strain\"")],
        },
        Family {
            name: "e, relative",
            meaning: "The same in units of the permittivity of vacuum.",
            keys: &[E, RELATIVE, at("\"strain\"")],
        },
    ],
};

const PLAIN: TableSchema = TableSchema {
    title: "[material.NAME.electric], no stiffness",
    meaning: "The permittivity of a material without stiffness.",
    keys: &[POLING, ACROSS],
    families: &[
        Family {
            name: "dielectric",
            meaning: "In F/m.",
            keys: &[PERMITTIVITY],
        },
        Family {
            name: "dielectric, relative",
            meaning: "In units of the permittivity of vacuum.",
            keys: &[RELATIVE],
        },
    ],
};

const fn strain(name: &'static str, example: &'static str, meaning: &'static str) -> KeySchema {
    key(name, STRAIN, Default("0"), example, meaning)
}

const fn stress(name: &'static str, example: &'static str, meaning: &'static str) -> KeySchema {
    key(name, STRESS, Default("0"), example, meaning)
}

const STRAINS: TableSchema = TableSchema {
    title: "d = { ... }",
    meaning: "Strains per electric field by name: first the component of the field, then of the \
              strain, 1 to 6 for 11, 22, 33, 23, 13, 12.",
    keys: &[
        strain("d11", "\"10 pC/N\"", "Strain 11 of field 1."),
        strain("d12", "\"10 pC/N\"", "Strain 22 of field 1."),
        strain("d13", "\"10 pC/N\"", "Strain 33 of field 1."),
        strain("d14", "\"10 pC/N\"", "Shear strain 23 of field 1."),
        strain("d15", "\"741 pC/N\"", "Shear strain 13 of field 1."),
        strain("d16", "\"10 pC/N\"", "Shear strain 12 of field 1."),
        strain("d21", "\"10 pC/N\"", "Strain 11 of field 2."),
        strain("d22", "\"10 pC/N\"", "Strain 22 of field 2."),
        strain("d23", "\"10 pC/N\"", "Strain 33 of field 2."),
        strain("d24", "\"741 pC/N\"", "Shear strain 23 of field 2."),
        strain("d25", "\"10 pC/N\"", "Shear strain 13 of field 2."),
        strain("d26", "\"10 pC/N\"", "Shear strain 12 of field 2."),
        strain("d31", "\"-274 pC/N\"", "Strain 11 of field 3."),
        strain("d32", "\"-274 pC/N\"", "Strain 22 of field 3."),
        strain("d33", "\"593 pC/N\"", "Strain 33 of field 3."),
        strain("d34", "\"10 pC/N\"", "Shear strain 23 of field 3."),
        strain("d35", "\"10 pC/N\"", "Shear strain 13 of field 3."),
        strain("d36", "\"10 pC/N\"", "Shear strain 12 of field 3."),
    ],
    families: &[],
};

const STRESSES: TableSchema = TableSchema {
    title: "e = { ... }",
    meaning: "Stresses per electric field by name: first the component of the field, then of the \
              stress, 1 to 6 for 11, 22, 33, 23, 13, 12.",
    keys: &[
        stress("e11", "\"0.1 C/m^2\"", "Stress 11 of field 1."),
        stress("e12", "\"0.1 C/m^2\"", "Stress 22 of field 1."),
        stress("e13", "\"0.1 C/m^2\"", "Stress 33 of field 1."),
        stress("e14", "\"0.1 C/m^2\"", "Shear stress 23 of field 1."),
        stress("e15", "\"17 C/m^2\"", "Shear stress 13 of field 1."),
        stress("e16", "\"0.1 C/m^2\"", "Shear stress 12 of field 1."),
        stress("e21", "\"0.1 C/m^2\"", "Stress 11 of field 2."),
        stress("e22", "\"0.1 C/m^2\"", "Stress 22 of field 2."),
        stress("e23", "\"0.1 C/m^2\"", "Stress 33 of field 2."),
        stress("e24", "\"17 C/m^2\"", "Shear stress 23 of field 2."),
        stress("e25", "\"0.1 C/m^2\"", "Shear stress 13 of field 2."),
        stress("e26", "\"0.1 C/m^2\"", "Shear stress 12 of field 2."),
        stress("e31", "\"-6.6 C/m^2\"", "Stress 11 of field 3."),
        stress("e32", "\"-6.6 C/m^2\"", "Stress 22 of field 3."),
        stress("e33", "\"23.2 C/m^2\"", "Stress 33 of field 3."),
        stress("e34", "\"0.1 C/m^2\"", "Shear stress 23 of field 3."),
        stress("e35", "\"0.1 C/m^2\"", "Shear stress 13 of field 3."),
        stress("e36", "\"0.1 C/m^2\"", "Shear stress 12 of field 3."),
    ],
    families: &[],
};

/// An electrode.
pub(super) const ELECTRODE: TableSchema = TableSchema {
    title: "[[electrode]]",
    meaning: "A part with one voltage: a conductor on curves, in regions or at points of the \
              mesh, or fingers across the beam.",
    keys: &[
        key(
            "name",
            &[ValueKind::Text],
            Required,
            "\"top\"",
            "Its name in loads and results.",
        ),
        key(
            "circuit",
            &[ValueKind::Word(&CIRCUIT_WORDS)],
            Default("\"driven\""),
            "\"driven\"",
            "Its connection: a prescribed voltage, the ground (0 V), or none, so that its charge \
             stays zero.",
        ),
    ],
    families: &[
        Family {
            name: "curve",
            meaning: "A conductor along curves.",
            keys: &[key(
                "curve",
                NAMES,
                Required,
                "\"upper\"",
                "The physical curve or curves, by name or tag; NAME/outer is the face of a lamina.",
            )],
        },
        Family {
            name: "region",
            meaning: "A conductor that fills regions, such as a metal sheet.",
            keys: &[key(
                "region",
                NAMES,
                Required,
                "\"shim\"",
                "The physical surface or surfaces, or a lamina by its name, for all its plies.",
            )],
        },
        Family {
            name: "point",
            meaning: "A conductor at points.",
            keys: &[key(
                "point",
                NAMES,
                Required,
                "\"wire\"",
                "The physical point or points, by name or tag.",
            )],
        },
        Family {
            name: "interdigitated",
            meaning: "Fingers of alternate sign across the beam, whose field is along the fibers.",
            keys: &[key(
                "interdigitated",
                &[ValueKind::Table(&FINGERS)],
                Required,
                "",
                "Regions of the fingers, and their spacing.",
            )],
        },
    ],
};

const FINGERS: TableSchema = TableSchema {
    title: "interdigitated = { ... }",
    meaning: "Cells between fingers: their field is the voltage over an effective spacing, equal \
              in all cells, and they have no unknown potential.",
    keys: &[
        key(
            "regions",
            NAMES,
            Required,
            "[\"skin/2\", \"skin/4\"]",
            "The regions, or a lamina by its name, for all its plies.",
        ),
        key(
            "spacing",
            &[ValueKind::Quantity(Dimension::LENGTH)],
            Required,
            "\"0.31 mm\"",
            "Effective spacing of the fingers: voltage over mean field.",
        ),
        key(
            "reversed",
            NAMES,
            Optional,
            "\"skin/4\"",
            "Those regions whose field has the opposite direction.",
        ),
        key(
            "axis",
            &[ValueKind::Count(3)],
            Default("1"),
            "1",
            "Material axis of the field.",
        ),
    ],
    families: &[],
};
