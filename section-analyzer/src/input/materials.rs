//! Materials as written: the keys determine the law.

use nalgebra::Matrix6;
use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::electric::{self, ElectricDataProblem, WrittenElectric};
use super::problem::InputProblem;
use super::strengths;
use crate::material::{
    ElasticLaw, EngineeringConstants, Material, MaterialLimits, MaterialProblem,
};

const ISOTROPIC: [&str; 2] = ["young", "poisson"];
const ORTHOTROPIC: [&str; 9] = [
    "e1", "e2", "e3", "g12", "g13", "g23", "nu12", "nu13", "nu23",
];
/// Constants that a transversely isotropic material does not have: those along 3.
const ALONG_THICKNESS: [&str; 3] = ["e3", "g13", "nu13"];
const FULL: [&str; 1] = ["stiffness"];

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
}

/// Reads `[material.NAME]` for every name, and checks that each can exist.
pub(super) fn read(root: &Table<'_>) -> Vec<WrittenMaterial> {
    let tables = root.named_tables("material");
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
            table.finish();
            WrittenMaterial {
                name,
                line: table.line(),
                material,
                limits,
                electric,
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
    let needs_none = law == Some(ElasticLaw::Absent) && !table.has("density");
    let density = match needs_none {
        true => Some(0.0),
        false => table.require_quantity("density", Dimension::DENSITY),
    };
    let expansion = match table.has("expansion") {
        true => expansion(table).map(Some),
        false => Some(None),
    };
    let material = Material {
        name: name.to_owned(),
        law: law?,
        density: density?,
        expansion: expansion?,
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
        table.note(
            "expansion",
            &ElectricDataProblem::Axes { material, problem },
        );
    };
    turned.map_err(note).ok()
}

/// One coefficient for all directions, or one for each material axis \[1/K\].
fn expansion(table: &Table<'_>) -> Option<[f64; 3]> {
    let found = table.quantities("expansion", Dimension::EXPANSION)?;
    let coefficients = match found[..] {
        [all] if !table.is_list("expansion") => [all; 3],
        [a1, a2, a3] => [a1, a2, a3],
        _ => {
            let expected = "an expansion coefficient, or an array of 3, one for each material axis";
            table.wrong("expansion", expected);
            return None;
        }
    };
    if coefficients.iter().any(|a| a.abs() > LARGEST_EXPANSION) {
        table.wrong("expansion", "coefficients of at most 0.01 1/K");
        return None;
    }
    Some(coefficients)
}

/// The law that the keys of the table determine.
fn law(name: &str, table: &Table<'_>) -> Option<ElasticLaw> {
    // All keys are read, so that none of them is reported as unknown.
    let present = |keys: &[&'static str]| -> Vec<&'static str> {
        keys.iter().copied().filter(|key| table.has(key)).collect()
    };
    let families = [present(&ISOTROPIC), present(&ORTHOTROPIC), present(&FULL)];
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
        (Some(first), None) if ISOTROPIC.contains(&first) => isotropic(table),
        (Some(first), None) if ORTHOTROPIC.contains(&first) => {
            match ALONG_THICKNESS.iter().any(|key| table.has(key)) {
                true => orthotropic(table),
                false => transversely_isotropic(material, table),
            }
        }
        (Some(_), None) if table.is_text("stiffness") => {
            let word = table.word("stiffness", &["none"])?;
            (word == 0).then_some(ElasticLaw::Absent)
        }
        (Some(_), None) => full(table),
    }
}

fn isotropic(table: &Table<'_>) -> Option<ElasticLaw> {
    let young = table.require_quantity("young", Dimension::STRESS);
    let poisson = table.require_quantity("poisson", Dimension::NUMBER);
    Some(ElasticLaw::Isotropic {
        young: young?,
        poisson: poisson?,
    })
}

fn orthotropic(table: &Table<'_>) -> Option<ElasticLaw> {
    // All constants are read before the first missing one ends the reading.
    let read = ORTHOTROPIC.map(|key| {
        let dimension = match key.starts_with("nu") {
            true => Dimension::NUMBER,
            false => Dimension::STRESS,
        };
        table.require_quantity(key, dimension)
    });
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
    let stress = |key| table.require_quantity(key, Dimension::STRESS);
    let [e1, e2, g12] = ["e1", "e2", "g12"].map(stress);
    let nu12 = table.require_quantity("nu12", Dimension::NUMBER);
    let (nu23, g23) = match (table.has("nu23"), table.has("g23")) {
        (true, false) => {
            let nu23 = table.require_quantity("nu23", Dimension::NUMBER)?;
            (nu23, e2? / (2.0 * (1.0 + nu23)))
        }
        (false, true) => {
            let g23 = stress("g23")?;
            (e2? / (2.0 * g23) - 1.0, g23)
        }
        (has_both, _) => {
            let key = if has_both { "g23" } else { "" };
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

fn full(table: &Table<'_>) -> Option<ElasticLaw> {
    let rows = table.rows_of("stiffness", [6, 6], Dimension::STRESS)?;
    Some(ElasticLaw::Full(Matrix6::from_fn(|i, j| rows[i][j])))
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
