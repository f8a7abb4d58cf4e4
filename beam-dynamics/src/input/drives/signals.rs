//! Signals: numbers that depend on time and on the names that expressions may read.

use std::collections::BTreeMap;

use shared_geom::document::schema::KeySchema;
use shared_geom::document::{Item, Table};
use shared_geom::expression::{Names, is_name, written};
use shared_geom::units::Dimension;

use super::measure::Measure;
use super::problem::Needed;
use super::{Catalog, Counts, DriveProblem};
use crate::elements::{Input, Signal, Smoothness};
use crate::input::problem::InputProblem;
use crate::model::Scalar;

/// Scalars that expressions read by name; wrong ones are `None`.
pub(super) type Readable = BTreeMap<String, Option<Read>>;

/// A scalar that expressions read by name.
#[derive(Debug, Clone)]
pub(in crate::input) struct Read {
    /// The scalar.
    pub input: Input,
    /// The unit of its numbers: if it has one, the name alone under a key is in this unit,
    /// and not in the unit of the key.
    pub measure: Measure,
}

/// Reads the signal under a declared key of a card, in SI units: any drive (see
/// [`super::read`]), an expression of time and of names that expressions may read, or one
/// of these names. `None` if it is absent or wrong; problems have been noted.
pub(in crate::input) fn read_signal(
    table: &Table<'_>,
    key: &KeySchema,
    catalog: &Catalog,
) -> Option<Signal> {
    signal_of(&table.item(key)?, key.dimension(), catalog)
}

/// Like [`read_signal`], for a pure number that is one without the key.
pub(in crate::input) fn read_factor(
    table: &Table<'_>,
    key: &KeySchema,
    catalog: &Catalog,
) -> Option<Signal> {
    if table.has(key) {
        read_signal(table, key, catalog)
    } else {
        Some(Signal::default())
    }
}

/// Like [`read_signal`], for the angular velocity of an imposed motion, or for a force that
/// opposes a rate: the rate of the signal must be known.
pub(in crate::input) fn read_speed(
    table: &Table<'_>,
    key: &KeySchema,
    catalog: &Catalog,
) -> Option<Signal> {
    let counts = (Counts::Slope, Smoothness::Rate);
    read_smooth(&table.item(key)?, key.dimension(), catalog, counts)
}

/// Like [`read_signal`], for a prescribed position or angle: the second derivative of the
/// signal must be known.
pub(in crate::input) fn read_position(
    table: &Table<'_>,
    key: &KeySchema,
    catalog: &Catalog,
) -> Option<Signal> {
    let counts = (Counts::Slope, Smoothness::Acceleration);
    read_smooth(&table.item(key)?, key.dimension(), catalog, counts)
}

fn read_smooth(
    item: &Item<'_>,
    dimension: Dimension,
    catalog: &Catalog,
    (counts, needed): (Counts, Smoothness),
) -> Option<Signal> {
    let signal = find(item, dimension, catalog, counts)?;
    is_smooth(item, &signal, needed).then_some(signal)
}

/// Like [`read_position`], for a length above zero at all times.
pub(in crate::input) fn read_distance(
    table: &Table<'_>,
    key: &KeySchema,
    catalog: &Catalog,
) -> Option<Signal> {
    let signal = read_length(table, key, catalog)?;
    is_smooth(&table.item(key)?, &signal, Smoothness::Acceleration).then_some(signal)
}

/// Like [`read_signal`], for a length above zero at all times.
pub(in crate::input) fn read_length(
    table: &Table<'_>,
    key: &KeySchema,
    catalog: &Catalog,
) -> Option<Signal> {
    let item = table.item(key)?;
    let signal = find(&item, key.dimension(), catalog, Counts::Positive)?;
    if signal
        .drive()
        .is_some_and(|drive| drive.at(0.0).value <= 0.0)
    {
        table.wrong(key, "a length greater than zero at all times");
        return None;
    }
    Some(signal)
}

/// Like [`read_signal`], for a value in any position.
pub(in crate::input) fn signal_of(
    item: &Item<'_>,
    dimension: Dimension,
    catalog: &Catalog,
) -> Option<Signal> {
    find(item, dimension, catalog, Counts::Value)
}

/// Whether the required derivatives of a signal are known; notes the first name whose
/// derivative is unknown.
pub(in crate::input) fn is_smooth(item: &Item<'_>, signal: &Signal, needed: Smoothness) -> bool {
    let Some(rough) = signal.rougher_than(needed) else {
        return true;
    };
    item.note(&DriveProblem::Rough {
        key: item.key().to_owned(),
        name: rough.owner.clone(),
        needed: match needed {
            Smoothness::Acceleration => Needed::Acceleration,
            Smoothness::Rate | Smoothness::Value => Needed::Rate,
        },
    });
    false
}

fn find(
    item: &Item<'_>,
    dimension: Dimension,
    catalog: &Catalog,
    counts: Counts,
) -> Option<Signal> {
    let drive = || super::used(item, dimension, catalog, counts).map(Signal::Drive);
    let Some(text) = item.text() else {
        return drive();
    };
    let readable = &catalog.readable;
    let text = match written(text) {
        Some(text) => text,
        None if readable.contains_key(text.trim()) => text.trim(),
        None => {
            let name = text.trim();
            if readable.is_empty() || !is_name(name) || catalog.has(name) {
                return drive();
            }
            if super::is_parameter(name, item) {
                return None;
            }
            let known = readable.keys().cloned().chain(catalog.names());
            item.note(&InputProblem::UnknownName {
                kind: "signal",
                name: name.to_owned(),
                user: format!("\"{}\"", item.key()),
                known: known.collect(),
            });
            return None;
        }
    };
    match sensing(item, (text, dimension), readable)? {
        Some(signal) => Some(signal),
        None => drive(),
    }
}

/// The signal of an expression; `Some(None)` if it reads no scalar.
fn sensing(
    item: &Item<'_>,
    (text, dimension): (&str, Dimension),
    readable: &Readable,
) -> Option<Option<Signal>> {
    let document = item.document();
    let constants = document.parameters();
    let parse = |variables: &[&str]| {
        let names = Names {
            variables,
            constants: &constants,
        };
        document.expression(item.key(), item.line(), text, &names)
    };
    let variables = ["t"].into_iter();
    let variables: Vec<_> = variables
        .chain(readable.keys().map(String::as_str))
        .collect();
    let expression = parse(&variables)?;
    if !(1..variables.len()).any(|index| expression.uses(index)) {
        return Some(None);
    }
    if constants.iter().any(|own| own.1.is_nan()) {
        // The wrong parameter has been noted.
        return None;
    }
    // Names that are not used may be wrong: only the used names are kept.
    let mut used = Vec::new();
    let mut kept = vec!["t"];
    for (index, (name, read)) in readable.iter().enumerate() {
        if expression.uses(index + 1) {
            used.push(read.clone()?.input);
            kept.push(name);
        }
    }
    let expression = parse(&kept)?;
    let factor = match readable.get(text).and_then(Option::as_ref) {
        Some(read) => factor_of_name(item, (text, read.measure), dimension)?,
        None => Measure::Declared(dimension).factor(document),
    };
    let units = [document.factor(Dimension::TIME), factor];
    Some(Some(Signal::sensing(expression, used, units)))
}

/// SI units in one number of a single name under a key of `dimension`. A name with another
/// unit is allowed only for a pure number; other dimensions are noted.
fn factor_of_name(
    item: &Item<'_>,
    (name, measure): (&str, Measure),
    dimension: Dimension,
) -> Option<f64> {
    let wanted = Measure::Declared(dimension);
    if dimension == Dimension::NUMBER || measure == Measure::Plain {
        return Some(wanted.factor(item.document()));
    }
    if wanted.factor_from(measure, item.document()).is_some() {
        return Some(measure.factor(item.document()));
    }
    item.note(&DriveProblem::Measures {
        name: name.to_owned(),
        measures: measure.words(),
        expected: wanted.words(),
    });
    None
}

impl Catalog {
    /// The scalar that expressions read by a name.
    pub fn read_by(&self, name: &str) -> Option<&Read> {
        self.readable.get(name)?.as_ref()
    }

    /// All names of such scalars.
    pub fn readable_names(&self) -> impl Iterator<Item = String> {
        self.readable.keys().cloned()
    }

    /// The value at time zero and the unit of a named drive; `None` if it is wrong.
    pub fn at_start(&self, name: &str) -> Option<(f64, Measure)> {
        let named = self.named.get(name)?.as_ref()?;
        Some((named.drive.at(0.0).value, named.measure))
    }

    /// Replaces a drive by a scalar, an input of a linear model.
    pub fn add_input(&mut self, name: &str, (scalar, measure): (Scalar, Measure)) {
        let unit = match measure {
            Measure::Unit(unit) => unit.factor,
            _ => 1.0,
        };
        let input = Input { scalar, unit };
        self.named.remove(name);
        self.inputs.insert(name.to_owned());
        self.readable
            .insert(name.to_owned(), Some(Read { input, measure }));
    }

    /// Makes a scalar readable by `name` in expressions; `None` for a wrong one.
    pub fn add_readable(&mut self, name: String, read: Option<Read>) {
        self.readable.insert(name, read);
    }

    /// Whether `name` under `key` can be read by expressions and is free; otherwise notes
    /// the reason.
    pub fn is_free(&self, name: &str, table: &Table<'_>, key: &str) -> bool {
        let parameters = table.document().parameters();
        let taken = [
            (
                "a sensor, an output or a control",
                self.readable.contains_key(name),
            ),
            ("a parameter", parameters.iter().any(|own| own.0 == name)),
            ("a drive", self.has(name)),
        ];
        let by = taken.iter().find(|taken| taken.1).map(|taken| taken.0);
        let own = name.to_owned();
        let problem = match by {
            _ if !is_name(name) || name == "t" => DriveProblem::SignalName { name: own },
            Some(by) => DriveProblem::SignalTaken { name: own, by },
            None => return true,
        };
        table.note(key, &problem);
        false
    }
}
