//! The keys of the limits of materials: strengths and strain limits.

use shared_geom::units::Dimension;

use super::{Family, KeySchema, Need, TableSchema, ValueKind, key};

use Need::{Default, Required};

const NUMBER: &[ValueKind] = &[ValueKind::Quantity(Dimension::NUMBER)];
const STRESS: &[ValueKind] = &[ValueKind::Quantity(Dimension::STRESS)];

/// Strengths of an isotropic material.
pub(super) const STRENGTH: TableSchema = TableSchema {
    title: "[material.NAME.strength], isotropic",
    meaning: "Largest stresses of an isotropic material, all positive.",
    keys: &[],
    families: &[
        Family {
            name: "yield",
            meaning: "For the index of von Mises.",
            keys: &[key(
                "yield",
                STRESS,
                Required,
                "\"350 MPa\"",
                "Yield stress.",
            )],
        },
        Family {
            name: "principal",
            meaning: "For the principal stresses.",
            keys: &[
                key("tension", STRESS, Required, "\"400 MPa\"", "In tension."),
                key(
                    "compression",
                    STRESS,
                    Required,
                    "\"380 MPa\"",
                    "In compression.",
                ),
                key("shear", STRESS, Required, "\"220 MPa\"", "In shear."),
            ],
        },
    ],
};

/// Strain limits of an isotropic material.
pub(super) const STRAIN_LIMIT: TableSchema = TableSchema {
    title: "[material.NAME.strain_limit], isotropic",
    meaning: "Largest principal strains of an isotropic material, all positive.",
    keys: &[
        key("tension", NUMBER, Required, "0.012", "In tension."),
        key("compression", NUMBER, Required, "0.012", "In compression."),
        key(
            "shear",
            NUMBER,
            Required,
            "0.018",
            "In shear, an engineering strain.",
        ),
    ],
    families: &[],
};

/// Strengths of an orthotropic or fully anisotropic material.
pub(super) const PLY_STRENGTH: TableSchema = TableSchema {
    title: "[material.NAME.strength]",
    meaning: "Largest stresses in the axes of the material, all positive, also in compression.",
    keys: &[
        key("xt", STRESS, Required, "\"1100 MPa\"", "Tension along 1."),
        key(
            "xc",
            STRESS,
            Required,
            "\"700 MPa\"",
            "Compression along 1.",
        ),
        key("yt", STRESS, Required, "\"40 MPa\"", "Tension along 2."),
        key(
            "yc",
            STRESS,
            Required,
            "\"140 MPa\"",
            "Compression along 2.",
        ),
        key(
            "s12",
            STRESS,
            Required,
            "\"70 MPa\"",
            "Shear in the plane of 1 and 2.",
        ),
        key(
            "zt",
            STRESS,
            Default("yt"),
            "\"40 MPa\"",
            "Tension along 3.",
        ),
        key(
            "zc",
            STRESS,
            Default("yc"),
            "\"140 MPa\"",
            "Compression along 3.",
        ),
        key(
            "s13",
            STRESS,
            Default("s12"),
            "\"70 MPa\"",
            "Shear in the plane of 1 and 3.",
        ),
        key(
            "s23",
            STRESS,
            Default("half of yc"),
            "\"70 MPa\"",
            "Shear in the plane of 2 and 3.",
        ),
        interaction(
            "f12",
            "-0.5",
            "Interaction of 1 and 2 in Tsai-Wu, F12 / sqrt(F11 F22).",
        ),
        interaction("f13", "f12", "Interaction of 1 and 3 in Tsai-Wu."),
        interaction("f23", "f12", "Interaction of 2 and 3 in Tsai-Wu."),
    ],
    families: &[],
};

const fn interaction(
    name: &'static str,
    default: &'static str,
    meaning: &'static str,
) -> KeySchema {
    key(name, NUMBER, Default(default), "-0.4", meaning)
}

/// Strain limits of an orthotropic or fully anisotropic material.
pub(super) const PLY_STRAIN_LIMIT: TableSchema = TableSchema {
    title: "[material.NAME.strain_limit]",
    meaning: "Largest strains in the axes of the material, all positive, also in compression; \
              shear strains are engineering strains.",
    keys: &[
        key("xt", NUMBER, Required, "0.018", "Tension along 1."),
        key("xc", NUMBER, Required, "0.012", "Compression along 1."),
        key("yt", NUMBER, Required, "0.005", "Tension along 2."),
        key("yc", NUMBER, Required, "0.02", "Compression along 2."),
        key(
            "s12",
            NUMBER,
            Required,
            "0.02",
            "Shear in the plane of 1 and 2.",
        ),
        key("zt", NUMBER, Default("yt"), "0.005", "Tension along 3."),
        key("zc", NUMBER, Default("yc"), "0.02", "Compression along 3."),
        key(
            "s13",
            NUMBER,
            Default("s12"),
            "0.02",
            "Shear in the plane of 1 and 3.",
        ),
        key(
            "s23",
            NUMBER,
            Default("yc"),
            "0.02",
            "Shear in the plane of 2 and 3.",
        ),
    ],
    families: &[],
};
