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
        let material = name.to_owned();
        table.note(&key, &InputProblem::Inadmissible { material, problem });
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
        (Some(first), None) if ORTHOTROPIC.contains(&first) => orthotropic(table),
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

fn full(table: &Table<'_>) -> Option<ElasticLaw> {
    let rows = table.rows_of("stiffness", [6, 6], Dimension::STRESS)?;
    Some(ElasticLaw::Full(Matrix6::from_fn(|i, j| rows[i][j])))
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
