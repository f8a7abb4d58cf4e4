//! Constitutive laws in cards: `law = { kind = "linear", ... }`, or a list of tables
//! whose forces add up.

use nalgebra::{SMatrix, SVector};
use shared_geom::document::{ByHand, Key, Table};
use shared_geom::section::least_eigenvalue;
use shared_geom::units::Dimension;

use super::beam_section::Properties;
use super::drives::{self, Catalog};
use crate::elements::laws::{Driven, Law, Term};
use crate::elements::{Instant, Signal, Smoothness};

mod keys;
mod kinds;
mod numbers;
mod problem;

#[cfg(test)]
mod tests;

pub(super) use keys::{BOTH, DISPLACEMENT, ROD, SECTION};
use keys::{PRESTRAIN, PRESTRAIN_DRIVE, PRESTRESS, PRESTRESS_DRIVE};
pub use problem::LawProblem;

/// Least eigenvalue of the stiffness of a law, scaled to a unit diagonal, that is treated
/// as positive: more than its round-off.
const SOFT: f64 = 1e-12;

/// The components of a law.
#[derive(Debug, Clone, Copy)]
pub(super) struct Components<const N: usize> {
    /// Their names in tables and expressions.
    pub names: [&'static str; N],
    /// Dimensions of the strains.
    pub strain: [Dimension; N],
    /// Dimensions of the forces.
    pub force: [Dimension; N],
    /// Stiffness of the section, for the kind `"section"` [N, N m, N m^2].
    pub section: Option<SMatrix<f64, N, N>>,
}

/// Curvature.
const PER_LENGTH: Dimension = Dimension {
    length: -1,
    ..Dimension::NUMBER
};

impl Components<1> {
    /// For a rod, by its strain.
    pub const STRAIN: Self = Self {
        names: ["e"],
        strain: [Dimension::NUMBER],
        force: [Dimension::FORCE],
        section: None,
    };
    /// For a rod, by its elongation.
    pub const ELONGATION: Self = Self {
        strain: [Dimension::LENGTH],
        ..Self::STRAIN
    };
}

impl Components<3> {
    /// For a displacement.
    pub const DISPLACEMENT: Self = Self {
        names: ["x", "y", "z"],
        strain: [Dimension::LENGTH; 3],
        force: [Dimension::FORCE; 3],
        section: None,
    };
    /// For a rotation.
    pub const ROTATION: Self = Self {
        strain: [Dimension::ANGLE; 3],
        force: [Dimension::MOMENT; 3],
        ..Self::DISPLACEMENT
    };
}

/// Three of one kind and three of another.
const fn three_and_three(first: Dimension, last: Dimension) -> [Dimension; 6] {
    [first, first, first, last, last, last]
}

impl Components<6> {
    /// For displacement and rotation together.
    pub const BOTH: Self = Self {
        names: ["x", "y", "z", "turn_x", "turn_y", "turn_z"],
        strain: three_and_three(Dimension::LENGTH, Dimension::ANGLE),
        force: three_and_three(Dimension::FORCE, Dimension::MOMENT),
        section: None,
    };

    /// For a beam section, whose stiffness may be unknown.
    pub fn section(stiffness: Option<SMatrix<f64, 6, 6>>) -> Self {
        Self {
            names: [
                "axial",
                "shear_y",
                "shear_z",
                "torsion",
                "bending_y",
                "bending_z",
            ],
            strain: three_and_three(Dimension::NUMBER, PER_LENGTH),
            force: three_and_three(Dimension::FORCE, Dimension::MOMENT),
            section: stiffness,
        }
    }
}

/// The law under `key` of a card; `None` if it is absent or wrong; problems have been
/// noted.
pub(super) fn read<const N: usize>(
    table: &Table<'_>,
    key: &str,
    of: &Components<N>,
    drives: &Catalog,
) -> Option<Law<N>> {
    let tables = if table.is_list(key) {
        table.tables(key)
    } else {
        vec![table.require_table(key, "the table of a law, or a list of them")?]
    };
    if tables.is_empty() {
        table.note(key, &LawProblem::Empty);
        return None;
    }
    // All terms are read, so that each problem is reported.
    let terms: Vec<_> = tables.iter().map(|table| term(table, of, drives)).collect();
    let terms: Option<Vec<_>> = terms.into_iter().collect();
    Some(Law::sum(terms?))
}

fn term<const N: usize>(
    table: &Table<'_>,
    of: &Components<N>,
    drives: &Catalog,
) -> Option<Term<N>> {
    let kind = kinds::read(table, of);
    let prestrain = driven(table, [&PRESTRAIN, &PRESTRAIN_DRIVE], &of.strain, drives);
    let prestress = driven(table, [&PRESTRESS, &PRESTRESS_DRIVE], &of.force, drives);
    if kinds::is_known(table) {
        table.finish();
    }
    let (kind, prestrain) = (kind?, prestrain?);
    if let (Some(driven), Some(item)) = (&prestrain, table.item(&PRESTRAIN_DRIVE))
        && kind.is_viscous()
        && !drives::is_smooth(&item, &driven.signal, Smoothness::Rate)
    {
        return None;
    }
    let term = Term {
        kind,
        prestrain,
        prestress: prestress?,
    };
    if let Some(found) = not_finite_at_rest(&term) {
        let has_reported = table
            .document()
            .parameters()
            .iter()
            .any(|own| own.1.is_nan());
        if !has_reported {
            table.note(keys::KIND[0], &LawProblem::NotFinite { found });
        }
        return None;
    }
    Some(term)
}

/// A force or a slope at zero strain and time zero that is not finite. The values of drives
/// at that time are not checked here.
fn not_finite_at_rest<const N: usize>(term: &Term<N>) -> Option<f64> {
    let mut term = Term {
        prestress: None,
        ..term.clone()
    };
    let has_value = |driven: &Driven<N>| driven.signal.value(&Instant::START).is_finite();
    term.prestrain = term.prestrain.filter(has_value);
    let zero = SVector::zeros();
    let found = Law::sum(vec![term]).at(&zero, &zero, &Instant::START);
    let slopes = found.by_strain.iter().chain(&found.by_rate);
    let mut all = found.force.iter().chain(slopes);
    all.find(|value| !value.is_finite()).copied()
}

/// A vector times a drive, if the first of the keys is present; the drive is one without
/// the second.
fn driven<const N: usize>(
    table: &Table<'_>,
    [key, drive_key]: [&Key<ByHand>; 2],
    dimensions: &[Dimension; N],
    drives: &Catalog,
) -> Option<Option<Driven<N>>> {
    if !table.has(key) {
        if table.has(drive_key) {
            let (key, drive_key) = (key.name(), drive_key.name());
            table.note(drive_key, &LawProblem::NothingDriven { key, drive_key });
            return None;
        }
        return Some(None);
    }
    let vector = numbers::vector(table, key.name(), dimensions);
    let signal = if table.has(drive_key) {
        drives::read_signal(table, &drive_key.schema, drives)
    } else {
        Some(Signal::default())
    };
    let vector: SVector<f64, N> = vector?;
    Some(Some(Driven {
        vector,
        signal: signal?,
    }))
}

/// The law of a beam, or of properties; all later stages need a positive definite
/// stiffness.
pub(super) fn of_section(
    table: &Table<'_>,
    drives: &Catalog,
    words: &str,
    properties: Option<&Properties>,
) -> Option<Law<6>> {
    let of = Components::section(properties.map(|found| found.stiffness));
    let law = read(table, "law", &of, drives)?;
    let stiffness = law.stiffness_at_rest();
    let least = least_eigenvalue(&stiffness);
    if least.is_nan() || least <= SOFT {
        let beam = words.to_owned();
        table.note("law", &LawProblem::SoftBeam { beam, least });
        return None;
    }
    Some(law)
}
