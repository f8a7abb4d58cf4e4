//! Materials as written: the keys determine the law.

use nalgebra::Matrix6;
use shared_geom::document::schema::ValueKind::{
    NamedTables, Positive, Quantity, Rows, Vector, Word,
};
use shared_geom::document::schema::{Family, KeySchema, TableSchema};
use shared_geom::document::{Declared, NestedByName, Table, Value};
use shared_geom::keys;
use shared_geom::units::Dimension;

use super::electric::{self, DIELECTRIC, ELECTRIC, ElectricDataProblem, WrittenElectric};
use super::problem::InputProblem;
use super::strengths::{self, PLY_STRAIN, PLY_STRENGTH, UNIFORM_STRAIN, UNIFORM_STRENGTH};
use crate::material::{
    ElasticLaw, EngineeringConstants, Material, MaterialLimits, MaterialProblem,
};

keys! {
    /// The materials, by name.
    pub(super) MATERIALS: NestedByName = "material", [NamedTables(&MATERIAL)], required, "";
    /// Mass per volume; 0 for a material without mass.
    DENSITY: f64 = "density", [Quantity(Dimension::DENSITY)], required, "\"1600 kg/m^3\"";
    /// Mass per volume; 0 for a material without mass.
    DENSITY_OR_ZERO: f64 = "density", [Quantity(Dimension::DENSITY)], or "0" = 0.0,
        "\"1600 kg/m^3\"";
    /// Strain per rise of temperature, plain numbers per declared unit of it: one for all
    /// directions, or along the material axes 1, 2, 3; without it the material does not expand.
    EXPANSION: Option<Expansion> = "expansion",
        [Quantity(Dimension::EXPANSION), Vector(3, Dimension::EXPANSION)]
        as "an expansion coefficient, or an array of 3, one for each material axis", optional,
        "[1e-7, 2.8e-5, 2.8e-5]";
    /// Thickness of a ply, for layers of layup files that are given by `count` or `plies`.
    PLY_THICKNESS: Option<f64> = "ply_thickness", [Positive(Dimension::LENGTH)], optional,
        "\"0.25 mm\"";
    /// Young's modulus.
    YOUNG: f64 = "young", [Quantity(Dimension::STRESS)], required, "\"73.1 GPa\"";
    /// Poisson's ratio, between -1 and 0.5.
    POISSON: f64 = "poisson", [Quantity(Dimension::NUMBER)], required, "0.325";
    /// Modulus along the fiber.
    E1: f64 = "e1", [Quantity(Dimension::STRESS)], required, "\"142 GPa\"";
    /// Modulus across the fiber in the ply.
    E2: f64 = "e2", [Quantity(Dimension::STRESS)], required, "\"9.8 GPa\"";
    /// Modulus through the thickness.
    E3: f64 = "e3", [Quantity(Dimension::STRESS)], required, "\"9.8 GPa\"";
    /// Shear modulus in the ply.
    G12: f64 = "g12", [Quantity(Dimension::STRESS)], required, "\"6 GPa\"";
    /// Shear modulus of fiber and thickness.
    G13: f64 = "g13", [Quantity(Dimension::STRESS)], required, "\"6 GPa\"";
    /// Shear modulus across the fiber.
    G23: f64 = "g23", [Quantity(Dimension::STRESS)], required, "\"4.8 GPa\"";
    /// Contraction along 2 under tension along 1.
    NU12: f64 = "nu12", [Quantity(Dimension::NUMBER)], required, "0.3";
    /// Contraction along 3 under tension along 1.
    NU13: f64 = "nu13", [Quantity(Dimension::NUMBER)], required, "0.34";
    /// Contraction along 3 under tension along 2.
    NU23: f64 = "nu23", [Quantity(Dimension::NUMBER)], required, "0.42";
    /// Modulus across the fiber.
    E2_ACROSS: f64 = "e2", [Quantity(Dimension::STRESS)], required, "\"9.8 GPa\"";
    /// Shear modulus along the fiber.
    G12_ALONG: f64 = "g12", [Quantity(Dimension::STRESS)], required, "\"6 GPa\"";
    /// Contraction across the fiber under tension along it.
    NU12_ALONG: f64 = "nu12", [Quantity(Dimension::NUMBER)], required, "0.3";
    /// Contraction across the fiber under tension across it.
    NU23_ACROSS: f64 = "nu23", [Quantity(Dimension::NUMBER)], required, "0.42";
    /// Shear modulus across the fiber.
    G23_ACROSS: f64 = "g23", [Quantity(Dimension::STRESS)], required, "\"3.45 GPa\"";
    /// Stiffness in the declared unit of stress, symmetric and positive definite, order 11, 22,
    /// 33, 23, 13, 12 with engineering shear strains.
    STIFFNESS: Stiffness = "stiffness", [Rows(6, 6)], required,
        "[[4, 2, 2, 0, 0, 0], [2, 4, 2, 0, 0, 0], [2, 2, 4, 0, 0, 0], [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]";
    /// The word none.
    NO_STIFFNESS: usize = "stiffness", [Word(&["none"])], required, "\"none\"";
}

/// A material.
const MATERIAL: TableSchema = TableSchema {
    title: "[material.NAME]",
    meaning: "A material: its elastic law, which follows from the keys, and its density.",
    keys: &[PLY_THICKNESS.schema],
    families: &[
        Family {
            name: "isotropic",
            meaning: "Equal properties in all directions.",
            keys: &[
                YOUNG.schema,
                POISSON.schema,
                UNIFORM_STRENGTH.schema,
                UNIFORM_STRAIN.schema,
                DENSITY.schema,
                EXPANSION.schema,
                ELECTRIC.schema,
            ],
        },
        Family {
            name: "orthotropic",
            meaning: "Three planes of symmetry: axis 1 along the fiber, 2 across it in the ply, \
                      3 through the thickness.",
            keys: &[
                E1.schema,
                E2.schema,
                E3.schema,
                G12.schema,
                G13.schema,
                G23.schema,
                NU12.schema,
                NU13.schema,
                NU23.schema,
                PLY_STRENGTH.schema,
                PLY_STRAIN.schema,
                DENSITY.schema,
                EXPANSION.schema,
                ELECTRIC.schema,
            ],
        },
        Family {
            name: "transversely isotropic by nu23",
            meaning: "Equal properties in all directions across the fiber, axis 1: e3 = e2, \
                      g13 = g12, nu13 = nu12, and g23 = e2 / (2 (1 + nu23)).",
            keys: &across_fiber(NU23_ACROSS.schema),
        },
        Family {
            name: "transversely isotropic by g23",
            meaning: "Equal properties in all directions across the fiber, axis 1: e3 = e2, \
                      g13 = g12, nu13 = nu12, and nu23 = e2 / (2 g23) - 1.",
            keys: &across_fiber(G23_ACROSS.schema),
        },
        Family {
            name: "full",
            meaning: "Any anisotropic law.",
            keys: &[
                STIFFNESS.schema,
                PLY_STRENGTH.schema,
                PLY_STRAIN.schema,
                DENSITY.schema,
                EXPANSION.schema,
                ELECTRIC.schema,
            ],
        },
        Family {
            name: "no stiffness",
            meaning: "A dielectric with an electric field and a weight, but no stiffness: air, \
                      soft potting.",
            keys: &[
                NO_STIFFNESS.schema,
                DENSITY_OR_ZERO.schema,
                DIELECTRIC.schema,
            ],
        },
    ],
};

/// The keys of a transversely isotropic material; `last` is the constant across the fiber.
const fn across_fiber(last: KeySchema) -> [KeySchema; 10] {
    [
        E1.schema,
        E2_ACROSS.schema,
        G12_ALONG.schema,
        NU12_ALONG.schema,
        last,
        PLY_STRENGTH.schema,
        PLY_STRAIN.schema,
        DENSITY.schema,
        EXPANSION.schema,
        ELECTRIC.schema,
    ]
}

/// Largest expansion coefficient \[1/K\]: thirty times the coefficient of rubber.
const LARGEST_EXPANSION: f64 = 0.01;

/// A material as far as it could be read; its name is known even if its constants are
/// wrong, so that regions can refer to it.
#[derive(Debug, Clone)]
pub(super) struct WrittenMaterial {
    pub name: String,
    pub line: usize,
    /// In the axes of the material.
    pub material: Option<Material>,
    pub limits: MaterialLimits,
    pub electric: Option<WrittenElectric>,
    /// Thickness of a ply \[m\].
    pub ply_thickness: Option<f64>,
}

/// Reads `[material.NAME]` for every name, and checks that each can exist.
pub(super) fn read(root: &Table<'_>) -> Vec<WrittenMaterial> {
    let tables = root.named_tables(&MATERIALS);
    tables
        .into_iter()
        .map(|(name, table)| {
            let law = law(&name, &table);
            let limits = strengths::read(&name, &table, law.as_ref());
            let electric = electric::read(&name, &table, law.as_ref());
            electric::check_limits(&name, &table, &limits, electric.as_ref());
            if law == Some(ElasticLaw::Absent) {
                electric::check_absent(&name, &table);
            }
            let material = read_one(&name, &table, law, electric.as_ref());
            // a wrong one has been noted, and is not reported as absent too
            let ply_thickness = table.get(&PLY_THICKNESS).unwrap_or(Some(1.0));
            table.finish();
            WrittenMaterial {
                name,
                line: table.line(),
                material,
                limits,
                electric,
                ply_thickness,
            }
        })
        .collect()
}

fn read_one(
    name: &str,
    table: &Table<'_>,
    law: Option<ElasticLaw>,
    electric: Option<&WrittenElectric>,
) -> Option<Material> {
    let density = table.get(match law {
        Some(ElasticLaw::Absent) => &DENSITY_OR_ZERO,
        _ => &DENSITY,
    });
    let expansion = table.get(&EXPANSION);
    let material = Material {
        name: name.to_owned(),
        law: law?,
        density: density?,
        expansion: expansion?.map(|expansion| expansion.0),
        electric: electric.map(|electric| electric.law),
    };
    for problem in material.check() {
        let key = key_of(&problem, &material.law);
        let Some(key) = written_key(&key, table) else {
            continue;
        };
        let material = name.to_owned();
        table.note(key, &InputProblem::Inadmissible { material, problem });
    }
    let Some(electric) = electric else {
        return Some(material);
    };
    let turned = material.turned(&electric.axes);
    let note = |problem| {
        let material = name.to_owned();
        table.note(&EXPANSION, &ElectricDataProblem::Axes { material, problem });
    };
    turned.map_err(note).ok()
}

/// Expansion along the material axes \[1/K\].
#[derive(Debug)]
struct Expansion([f64; 3]);

impl Declared for Expansion {}

/// One coefficient for all directions, or one for each material axis.
impl Value for Expansion {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let found = table.quantities(key.name, key.dimension())?;
        let coefficients = match found[..] {
            [all] if !table.is_list(key) => [all; 3],
            [a1, a2, a3] => [a1, a2, a3],
            _ => {
                table.wrong(key, &key.expected());
                return None;
            }
        };
        if coefficients.iter().any(|a| a.abs() > LARGEST_EXPANSION) {
            table.wrong(key, "coefficients of at most 0.01 1/K");
            return None;
        }
        Some(Self(coefficients))
    }
}

/// The law that the keys of the table determine.
fn law(name: &str, table: &Table<'_>) -> Option<ElasticLaw> {
    let isotropic_ones = [&YOUNG, &POISSON].map(|key| key.name());
    let orthotropic_ones = [&E1, &E2, &E3, &G12, &G13, &G23, &NU12, &NU13, &NU23];
    let orthotropic_ones = orthotropic_ones.map(|key| key.name());
    // All keys are read, so that none of them is reported as unknown.
    let present = |keys: &[&'static str]| -> Vec<&'static str> {
        keys.iter().copied().filter(|key| table.has(key)).collect()
    };
    let families = [
        present(&isotropic_ones),
        present(&orthotropic_ones),
        present(&[STIFFNESS.name()]),
    ];
    let mut found = families.iter().filter_map(|keys| keys.first().copied());
    let material = name.to_owned();
    match (found.next(), found.next()) {
        (None, _) => {
            table.note("", &InputProblem::NoLaw { material });
            None
        }
        (Some(first), Some(second)) => {
            let problem = InputProblem::MixedLaw {
                material,
                first,
                second,
            };
            table.note(second, &problem);
            None
        }
        (Some(first), None) if isotropic_ones.contains(&first) => isotropic(table),
        (Some(first), None) if orthotropic_ones.contains(&first) => {
            if [&E3, &G13, &NU13].iter().any(|key| table.has(key)) {
                orthotropic(table)
            } else {
                transversely_isotropic(material, table)
            }
        }
        (Some(_), None) if table.is_text(&STIFFNESS) => {
            table.get(&NO_STIFFNESS).map(|_| ElasticLaw::Absent)
        }
        (Some(_), None) => table
            .get(&STIFFNESS)
            .map(|stiffness| ElasticLaw::Full(stiffness.0)),
    }
}

fn isotropic(table: &Table<'_>) -> Option<ElasticLaw> {
    let (young, poisson) = (table.get(&YOUNG), table.get(&POISSON));
    Some(ElasticLaw::Isotropic {
        young: young?,
        poisson: poisson?,
    })
}

fn orthotropic(table: &Table<'_>) -> Option<ElasticLaw> {
    // All constants are read before the first missing one ends the reading.
    let read = [&E1, &E2, &E3, &G12, &G13, &G23, &NU12, &NU13, &NU23];
    let read = read.map(|key| table.get(key));
    let [e1, e2, e3, g12, g13, g23, nu12, nu13, nu23] = read;
    Some(ElasticLaw::Orthotropic(EngineeringConstants {
        e1: e1?,
        e2: e2?,
        e3: e3?,
        g12: g12?,
        g13: g13?,
        g23: g23?,
        nu12: nu12?,
        nu13: nu13?,
        nu23: nu23?,
    }))
}

/// A material with equal properties in all directions across the fiber:
/// `G23 = E2 / (2 (1 + nu23))`.
fn transversely_isotropic(material: String, table: &Table<'_>) -> Option<ElasticLaw> {
    // All constants are read before the first missing one ends the reading.
    let read = [&E1, &E2_ACROSS, &G12_ALONG, &NU12_ALONG];
    let [e1, e2, g12, nu12] = read.map(|key| table.get(key));
    let (nu23, g23) = match (table.has(&NU23_ACROSS), table.has(&G23_ACROSS)) {
        (true, false) => {
            let nu23 = table.get(&NU23_ACROSS)?;
            (nu23, e2? / (2.0 * (1.0 + nu23)))
        }
        (false, true) => {
            let g23 = table.get(&G23_ACROSS)?;
            (e2? / (2.0 * g23) - 1.0, g23)
        }
        (has_both, _) => {
            let key = if has_both { G23.name() } else { "" };
            table.note(key, &InputProblem::AcrossFiber { material, has_both });
            return None;
        }
    };
    let (e1, e2, g12, nu12) = (e1?, e2?, g12?, nu12?);
    Some(ElasticLaw::Orthotropic(EngineeringConstants {
        e1,
        e2,
        e3: e2,
        g12,
        g13: g12,
        g23,
        nu12,
        nu13: nu12,
        nu23,
    }))
}

/// Any stiffness \[Pa\].
#[derive(Debug)]
struct Stiffness(Matrix6<f64>);

impl Declared for Stiffness {}

impl Value for Stiffness {
    fn read(table: &Table<'_>, key: &KeySchema) -> Option<Self> {
        let rows = table.rows_of(key.name, [6, 6], Dimension::STRESS)?;
        Some(Self(Matrix6::from_fn(|i, j| rows[i][j])))
    }
}

/// The key of the table from which the constant `key` follows; `None` for constants of
/// transversely isotropic materials that equal another one, whose problem is reported.
fn written_key<'a>(key: &'a str, table: &Table<'_>) -> Option<&'a str> {
    match key {
        "e3" | "g13" | "nu13" if !table.has(key) => None,
        "nu23" if !table.has(key) => Some("g23"),
        "g23" if !table.has(key) => Some("nu23"),
        _ => Some(key),
    }
}

/// The key of the wrong constant; the key of the table if several constants are wrong
/// together.
fn key_of(problem: &MaterialProblem, law: &ElasticLaw) -> String {
    let constant = match problem {
        MaterialProblem::NotFinite { constant, .. }
        | MaterialProblem::ModulusNotPositive { constant, .. }
        | MaterialProblem::PoissonTooLarge { constant, .. } => *constant,
        MaterialProblem::DensityNegative { .. } => "density",
        MaterialProblem::PoissonOutOfRange { .. } => "poisson",
        MaterialProblem::NotSymmetric { .. } | MaterialProblem::NotPositiveDefinite { .. } => {
            "stiffness"
        }
        MaterialProblem::PoissonTogetherTooLarge { .. } => "",
    };
    match (constant, law) {
        ("E", _) => "young".to_owned(),
        ("nu", ElasticLaw::Isotropic { .. }) => "poisson".to_owned(),
        (constant, _) => constant.to_lowercase(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use shared_geom::document::Document;

    /// The law of a material with these keys.
    fn read_law(keys: &str) -> ElasticLaw {
        let text = format!("units = \"SI\"\n[material.ply]\n{keys}\ndensity = 1600\n");
        let document = Document::parse(&text, "a.section.toml").expect("TOML");
        let root = document.root();
        document.declare_units(&root);
        let material = read(&root).pop().and_then(|known| known.material);
        document.finish(material).expect("admissible").law
    }

    fn problems(keys: &str) -> String {
        let text = format!("units = \"SI\"\n[material.ply]\n{keys}\ndensity = 1600\n");
        let document = Document::parse(&text, "a.section.toml").expect("TOML");
        let root = document.root();
        document.declare_units(&root);
        let material = read(&root).pop().and_then(|known| known.material);
        document.finish(material).expect_err("wrong").to_string()
    }

    /// Both short forms equal the nine constants written out, with G23 = 9.8 GPa / 2.8 by
    /// hand, and their stiffness does not change as the ply turns about the fiber: C22 -
    /// C23 = 2 C44. A few units of round-off.
    #[test]
    fn transverse_isotropy_is_a_short_form_of_nine_constants() {
        let short = "e1 = 142e9\ne2 = 9.8e9\ng12 = 6e9\nnu12 = 0.3\n";
        let whole = read_law(&format!(
            "{short}e3 = 9.8e9\ng13 = 6e9\nnu13 = 0.3\nnu23 = 0.4\ng23 = 3.5e9\n"
        ))
        .stiffness();
        for last in ["nu23 = 0.4", "g23 = 3.5e9"] {
            let found = read_law(&format!("{short}{last}\n")).stiffness();
            assert!((found - whole).amax() < 1e-14 * whole.amax(), "{last}");
            let difference = found[(1, 1)] - found[(1, 2)] - 2.0 * found[(3, 3)];
            assert!(difference.abs() < 1e-14 * whole.amax(), "{difference:e}");
        }
    }

    #[test]
    fn wrong_short_forms_are_reported() {
        let short = "e1 = 142e9\ne2 = 9.8e9\ng12 = 6e9\nnu12 = 0.3\n";
        for (last, expected) in [
            (
                "",
                "a.section.toml:2: material \"ply\" has neither \"nu23\" nor \"g23\"",
            ),
            (
                "nu23 = 0.4\ng23 = 3.5e9",
                "a.section.toml:8: material \"ply\" has \"nu23\" and \"g23\" without \"e3\"",
            ),
            (
                "nu23 = 1.2",
                "a.section.toml:7: material \"ply\": |nu23| is 1.2",
            ),
            (
                "g23 = 2e9",
                "a.section.toml:7: material \"ply\": |nu23| is 1.45",
            ),
            ("g23 = 3.5e9\ng13 = 6e9", "has no \"e3\""),
        ] {
            let shown = problems(&format!("{short}{last}\n"));
            assert!(shown.contains(expected), "{expected}\n{shown}");
        }
        // e3 equals e2: its problem is not reported again
        let wrong = short.replace("e2 = 9.8e9", "e2 = -9.8e9");
        let shown = problems(&format!("{wrong}nu23 = 0.4\n"));
        assert!(shown.contains("a.section.toml:4: "), "{shown}");
        assert!(!shown.contains("E3"), "{shown}");
    }
}
