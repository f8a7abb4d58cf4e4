//! Control: sensors, systems of states and actuators.
//!
//! Each card is read twice. First its names are declared, so that the cards of all elements
//! may read them; then, when nodes and elements are known, its element is added.

use shared_geom::document::{Document, Table};

use super::builder::ModelBuilder;
use super::drives::Catalog;

mod actuators;
mod sensors;
mod state_spaces;

#[cfg(test)]
mod tests;

pub(super) use actuators::CARD as ACTUATOR;
pub(super) use sensors::{CARD as SENSOR, attach, kind as sensed};
pub(super) use state_spaces::STATE_SPACE;
pub use state_spaces::StateSpaceProblem;

/// The cards whose names expressions may read.
pub(super) struct Declared<'a> {
    sensors: Vec<sensors::Declared<'a>>,
    state_spaces: Vec<state_spaces::Named<'a>>,
    actuators: Vec<actuators::Named<'a>>,
}

/// Makes the names of all cards readable by expressions.
pub(super) fn declare<'a>(root: &Table<'a>, drives: &mut Catalog) -> Declared<'a> {
    Declared {
        sensors: sensors::declare(root, drives),
        state_spaces: state_spaces::declare(root, drives),
        actuators: actuators::declare(root, drives),
    }
}

/// Adds the elements of all cards to the model.
pub(super) fn read(declared: Declared<'_>, builder: &mut ModelBuilder) {
    sensors::read(declared.sensors, builder);
    state_spaces::read(declared.state_spaces, builder);
    actuators::read(declared.actuators, builder);
}

/// Notes problems of the cards in a run from and to the given `times` \[s\].
pub(super) fn check_run(document: &Document, builder: &ModelBuilder, times: [f64; 2]) {
    state_spaces::check_run(document, builder, times);
}
