//! The keys of materials.

use shared_geom::units::Dimension;

use super::electric::{DIELECTRIC, ELECTRIC};
use super::imposed::EXPANSION;
use super::limits::{PLY_STRAIN_LIMIT, PLY_STRENGTH, STRAIN_LIMIT, STRENGTH};
use super::{Family, KeySchema, Need, TableSchema, ValueKind, key};

use Need::{Default, Optional, Required};

const NUMBER: &[ValueKind] = &[ValueKind::Quantity(Dimension::NUMBER)];
const STRESS: &[ValueKind] = &[ValueKind::Quantity(Dimension::STRESS)];
const DENSITY: &[ValueKind] = &[ValueKind::Quantity(Dimension::DENSITY)];

/// A table of limits of a material.
const fn limit(name: &'static str, kinds: &'static [ValueKind]) -> KeySchema {
    key(name, kinds, Optional, "", "Limits for the failure indices.")
}

const fn density(need: Need) -> KeySchema {
    key(
        "density",
        DENSITY,
        need,
        "\"1600 kg/m^3\"",
        "Mass per volume; 0 for a material without mass.",
    )
}

/// A material.
pub(super) const MATERIAL: TableSchema = TableSchema {
    title: "[material.NAME]",
    meaning: "A material: its elastic law, which follows from the keys, and its density.",
    keys: &[],
    families: &[
        Family {
            name: "isotropic",
            meaning: "Equal properties in all directions.",
            keys: &[
                key(
                    "young",
                    STRESS,
                    Required,
                    "\"73.1 GPa\"",
                    "Young's modulus.",
                ),
                key(
                    "poisson",
                    NUMBER,
                    Required,
                    "0.325",
                    "Poisson's ratio, between -1 and 0.5.",
                ),
                limit("strength", &[ValueKind::Table(&STRENGTH)]),
                limit("strain_limit", &[ValueKind::Table(&STRAIN_LIMIT)]),
                density(Required),
                EXPANSION,
                ELECTRIC,
            ],
        },
        Family {
            name: "orthotropic",
            meaning: "Three planes of symmetry: axis 1 along the fiber, 2 across it in the ply, \
                      3 through the thickness.",
            keys: &[
                key(
                    "e1",
                    STRESS,
                    Required,
                    "\"142 GPa\"",
                    "Modulus along the fiber.",
                ),
                key(
                    "e2",
                    STRESS,
                    Required,
                    "\"9.8 GPa\"",
                    "Modulus across the fiber in the ply.",
                ),
                key(
                    "e3",
                    STRESS,
                    Required,
                    "\"9.8 GPa\"",
                    "Modulus through the thickness.",
                ),
                key(
                    "g12",
                    STRESS,
                    Required,
                    "\"6 GPa\"",
                    "Shear modulus in the ply.",
                ),
                key(
                    "g13",
                    STRESS,
                    Required,
                    "\"6 GPa\"",
                    "Shear modulus of fiber and thickness.",
                ),
                key(
                    "g23",
                    STRESS,
                    Required,
                    "\"4.8 GPa\"",
                    "Shear modulus across the fiber.",
                ),
                key(
                    "nu12",
                    NUMBER,
                    Required,
                    "0.3",
                    "Contraction along 2 under tension along 1.",
                ),
                key(
                    "nu13",
                    NUMBER,
                    Required,
                    "0.34",
                    "Contraction along 3 under tension along 1.",
                ),
                key(
                    "nu23",
                    NUMBER,
                    Required,
                    "0.42",
                    "Contraction along 3 under tension along 2.",
                ),
                limit("strength", &[ValueKind::Table(&PLY_STRENGTH)]),
                limit("strain_limit", &[ValueKind::Table(&PLY_STRAIN_LIMIT)]),
                density(Required),
                EXPANSION,
                ELECTRIC,
            ],
        },
        Family {
            name: "transversely isotropic by nu23",
            meaning: "Equal properties in all directions across the fiber, axis 1: e3 = e2, \
                      g13 = g12, nu13 = nu12, and g23 = e2 / (2 (1 + nu23)).",
            keys: &[
                key(
                    "e1",
                    STRESS,
                    Required,
                    "\"142 GPa\"",
                    "Modulus along the fiber.",
                ),
                key(
                    "e2",
                    STRESS,
                    Required,
                    "\"9.8 GPa\"",
                    "Modulus across the fiber.",
                ),
                key(
                    "g12",
                    STRESS,
                    Required,
                    "\"6 GPa\"",
                    "Shear modulus along the fiber.",
                ),
                key(
                    "nu12",
                    NUMBER,
                    Required,
                    "0.3",
                    "Contraction across the fiber under tension along it.",
                ),
                key(
                    "nu23",
                    NUMBER,
                    Required,
                    "0.42",
                    "Contraction across the fiber under tension across it.",
                ),
                limit("strength", &[ValueKind::Table(&PLY_STRENGTH)]),
                limit("strain_limit", &[ValueKind::Table(&PLY_STRAIN_LIMIT)]),
                density(Required),
                EXPANSION,
                ELECTRIC,
            ],
        },
        Family {
            name: "transversely isotropic by g23",
            meaning: "Equal properties in all directions across the fiber, axis 1: e3 = e2, \
                      g13 = g12, nu13 = nu12, and nu23 = e2 / (2 g23) - 1.",
            keys: &[
                key(
                    "e1",
                    STRESS,
                    Required,
                    "\"142 GPa\"",
                    "Modulus along the fiber.",
                ),
                key(
                    "e2",
                    STRESS,
                    Required,
                    "\"9.8 GPa\"",
                    "Modulus across the fiber.",
                ),
                key(
                    "g12",
                    STRESS,
                    Required,
                    "\"6 GPa\"",
                    "Shear modulus along the fiber.",
                ),
                key(
                    "nu12",
                    NUMBER,
                    Required,
                    "0.3",
                    "Contraction across the fiber under tension along it.",
                ),
                key(
                    "g23",
                    STRESS,
                    Required,
                    "\"3.45 GPa\"",
                    "Shear modulus across the fiber.",
                ),
                limit("strength", &[ValueKind::Table(&PLY_STRENGTH)]),
                limit("strain_limit", &[ValueKind::Table(&PLY_STRAIN_LIMIT)]),
                density(Required),
                EXPANSION,
                ELECTRIC,
            ],
        },
        Family {
            name: "full",
            meaning: "Any anisotropic law.",
            keys: &[
                key(
                    "stiffness",
                    &[ValueKind::Rows(6, 6)],
                    Required,
                    "[[4, 2, 2, 0, 0, 0], [2, 4, 2, 0, 0, 0], [2, 2, 4, 0, 0, 0], \
                 [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]",
                    "Stiffness in the declared unit of stress, symmetric and positive definite, \
                 order 11, 22, 33, 23, 13, 12 with engineering shear strains.",
                ),
                limit("strength", &[ValueKind::Table(&PLY_STRENGTH)]),
                limit("strain_limit", &[ValueKind::Table(&PLY_STRAIN_LIMIT)]),
                density(Required),
                EXPANSION,
                ELECTRIC,
            ],
        },
        Family {
            name: "no stiffness",
            meaning: "A dielectric with an electric field and a weight, but no stiffness: air, \
                      soft potting.",
            keys: &[
                key(
                    "stiffness",
                    &[ValueKind::Word(&["none"])],
                    Required,
                    "\"none\"",
                    "The word none.",
                ),
                density(Default("0")),
                DIELECTRIC,
            ],
        },
    ],
};
