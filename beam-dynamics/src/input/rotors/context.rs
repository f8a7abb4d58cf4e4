//! The names that expressions of rotors may use, from all cards of the input.
//!
//! An expression of a control becomes part of an expression of another card. Its problems are
//! therefore found before, where it is written, with the names that the other cards will find.

use std::cell::Cell;

use shared_geom::document::schema::KeySchema;
use shared_geom::document::{Document, Item, Table};
use shared_geom::units;

use super::keys::{COSINE, HARMONIC, NAME, PLATE, SINE, SWASHPLATE, TORQUE};
use super::train_keys::TRAIN;
use super::{KEY, shaft};
use crate::elements::{Input, Sensor, Smoothness};
use crate::input::drives::{self, Catalog, Measure, Read};
use crate::input::{control, linear, trim};
use crate::model::Quantity;

/// Names, first guesses and the start of runs.
#[derive(Debug)]
pub(super) struct Context {
    catalog: Catalog,
    /// Whether a rotor was refused for a problem that has been noted.
    wrong: Cell<bool>,
    /// Whether nodes have given velocities at the start of a run.
    pub moves: bool,
    /// First guesses of numbers that a trim finds, by their names.
    pub guesses: Vec<(String, f64)>,
}

impl Context {
    /// The context of the top table of a file, with the `inputs` of a linear model.
    pub fn of(root: &Table<'_>, inputs: &[String]) -> Self {
        let mut catalog = drives::read_named(root, inputs);
        declare(root, &mut catalog);
        let trim = trim::declare(root, &mut catalog);
        for name in inputs {
            // Problems of inputs are noted with the ones of the linear model.
            let _input = linear::input(name, &mut catalog, trim.as_ref(), &mut Vec::new());
        }
        for rotor in root.tables(KEY).iter().filter(|rotor| senses(rotor)) {
            if let Some(name) = rotor.get(&NAME) {
                let (name, read) = azimuth(&name);
                catalog.add_readable(name, read);
            }
        }
        let is_given = |card: &str| {
            let run = root.is_table(card).then(|| root.table(card)).flatten();
            run.is_some_and(|run| {
                !run.is_text("start") || run.text("start").as_deref() == Some("given")
            })
        };
        Self {
            catalog,
            wrong: Cell::new(false),
            moves: ["transient", "periodic"].into_iter().any(is_given),
            guesses: trim::guesses(root),
        }
    }

    /// Whether the value of a key, a drive or an expression, senses a quantity; `None` if it is wrong
    /// or not as smooth as it must be, which has been noted.
    pub fn senses(&self, item: &Item<'_>, key: &KeySchema, needed: Smoothness) -> Option<bool> {
        let signal = drives::signal_of(item, key.dimension(), &self.catalog);
        let signal = signal.filter(|signal| drives::is_smooth(item, signal, needed));
        if signal.is_none() {
            self.refuse();
        }
        signal.map(|signal| signal.drive().is_none())
    }

    /// The value of a key if it does not change, `Some(None)` if it does; `None` if it is wrong, which
    /// has been noted.
    pub fn constant(&self, item: &Item<'_>, key: &KeySchema) -> Option<Option<f64>> {
        let signal = drives::signal_of(item, key.dimension(), &self.catalog);
        if signal.is_none() {
            self.refuse();
        }
        signal.map(|signal| signal.constant())
    }

    /// Refuses the rotors for a problem that was noted; their cards are still read.
    pub fn refuse(&self) {
        self.wrong.set(true);
    }

    /// Whether all values so far were accepted.
    pub fn is_sound(&self) -> bool {
        !self.wrong.get()
    }

    /// The parameters, and the first guesses of numbers that a trim finds.
    pub fn constants(&self, document: &Document) -> Vec<(String, f64)> {
        let mut constants = document.parameters().clone();
        constants.extend(self.guesses.iter().cloned());
        constants
    }

    /// Whether there is a drive of the name.
    pub fn has_drive(&self, name: &str) -> bool {
        self.catalog.has(name)
    }
}

/// Makes the names of control cards readable, and of their copies in `[[repeat]]`.
fn declare(table: &Table<'_>, catalog: &mut Catalog) {
    control::declare(table, catalog);
    if table.is_list("repeat") {
        for repeat in table.tables("repeat") {
            declare(&repeat, catalog);
        }
    }
}

/// Whether a rotor has a sensor of its azimuth.
fn senses(rotor: &Table<'_>) -> bool {
    if !(rotor.has(&TORQUE) || rotor.has(&TRAIN)) || !rotor.is_table(&SWASHPLATE) {
        return false;
    }
    let swashplate = rotor.table(&SWASHPLATE);
    swashplate.is_some_and(|table| {
        let is_cyclic = table.has(&COSINE) || table.has(&SINE) || table.has(&HARMONIC);
        is_cyclic && !table.has(&PLATE)
    })
}

/// Name and scalar of the azimuth of a rotor.
fn azimuth(rotor: &str) -> (String, Option<Read>) {
    let name = shaft::sensor(rotor);
    let quantity = Quantity::new("joint angle", shaft::SENSOR_UNIT, 1.0);
    let scalar = Sensor::output(&name, quantity);
    let unit = units::parse(shaft::SENSOR_UNIT).ok();
    let read = unit.map(|unit| Read {
        input: Input {
            scalar,
            unit: unit.factor,
        },
        measure: Measure::Unit(unit),
    });
    (name, read)
}
