//! Readings: the quantities of a state by their words, as in columns and sensors.

use shared_geom::document::{DocumentProblem, Table};
use shared_geom::units::{Dimension, Unit};

mod air;
mod keys;
mod kind;
mod problem;
mod reading;

pub(super) use keys::{
    ANGLES, ELECTRODES, ENERGIES, JOINTS, MOMENTA, NODES, OF_COLUMNS, REACTIONS, ROTORS, SECTIONS,
    SPRINGS, STRIPS,
};
use kind::KINDS;
pub(super) use kind::{Kind, Source, dimension_of, unit_of};
pub use problem::ReadingProblem;
pub(super) use reading::{Found, Reading};

/// The quantity of a card.
pub(super) fn kind(table: &Table<'_>) -> Option<&'static Kind> {
    let words = KINDS.map(|kind| kind.0);
    table.require_text("quantity", "a quantity, for example \"position\"")?;
    Some(&KINDS[table.word("quantity", &words)?])
}

/// Whether the quantity of a card is known; otherwise its keys are not checked.
pub(super) fn is_known(table: &Table<'_>) -> bool {
    let is_one = |word: String| KINDS.iter().any(|kind| kind.0 == word);
    table.is_text("quantity") && table.text("quantity").is_some_and(is_one)
}

/// The `unit` of a card, of a quantity of `dimension`.
pub(super) fn unit(table: &Table<'_>, unit: &str, dimension: Dimension) -> Option<Unit> {
    match unit_of(unit, dimension) {
        Ok(unit) => Some(unit),
        Err(problem) => {
            let key = "unit".to_owned();
            table.note("unit", &DocumentProblem::Unit { key, problem });
            None
        }
    }
}
