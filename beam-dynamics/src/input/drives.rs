//! Numbers that change with time: `[drives.NAME]`, and their forms in cards.
//!
//! A plain number is in the declared unit of its key. So are the numbers of a named drive,
//! for every key that uses it, unless it has a `unit`.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use shared_geom::document::schema::KeySchema;
use shared_geom::document::{Document, Item, Table};
use shared_geom::expression::{Names, words, written};
use shared_geom::units::Dimension;

mod columns;
mod keys;
mod kinds;
mod measure;
mod positive;
mod problem;
mod signals;
#[cfg(test)]
mod tests;

pub(super) use columns::from_file;
pub(super) use keys::DRIVE;
pub(super) use measure::Measure;
pub use problem::DriveProblem;
pub(super) use signals::{
    Read, is_smooth, read_distance, read_factor, read_length, read_position, read_signal,
    read_speed, signal_of,
};

use super::problem::InputProblem;
use crate::model::{Drive, Formula};
use signals::Readable;

/// Largest number of corners of a drive in a run: a step ends at each of them.
const MOST_CORNERS: usize = 500_000;
/// The key of the angle of a joint.
const ANGLE: &str = "angle";

/// A drive with a name.
#[derive(Debug, Clone)]
struct Named {
    drive: Drive,
    measure: Measure,
}

/// A use of a drive.
#[derive(Debug)]
struct Used {
    line: usize,
    key: String,
    drive: Drive,
    counts: Counts,
}

/// The required properties of a drive.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Counts {
    Value,
    /// Its slope as well.
    Slope,
    /// Its slope as well, and it must be above zero at all times.
    Positive,
}

/// The drives of an input by name; wrong drives are `None`.
#[derive(Debug, Default)]
pub(super) struct Catalog {
    named: BTreeMap<String, Option<Named>>,
    /// Uses of drives that do not have a value at all times: line, key and the times
    /// between which there is a value.
    bounded: RefCell<Vec<(usize, String, [f64; 2])>>,
    /// All uses of drives in the model.
    used: RefCell<Vec<Used>>,
    /// Scalars that expressions read by name.
    readable: Readable,
    /// Names of the inputs of a linear model.
    inputs: BTreeSet<String>,
}

/// Reads the drive under a declared key of a card, in SI units: a number or a
/// quantity, an expression of time `"= ..."`, the name of a `[drives.NAME]`, or a table.
/// `None` if it is absent or wrong; problems have been noted.
pub(super) fn read(table: &Table<'_>, key: &KeySchema, catalog: &Catalog) -> Option<Drive> {
    read_value(&table.item(key)?, key.dimension(), catalog)
}

/// Like [`read`], for a value in any position.
pub(super) fn read_value(
    item: &Item<'_>,
    dimension: Dimension,
    catalog: &Catalog,
) -> Option<Drive> {
    used(item, dimension, catalog, Counts::Value)
}

/// A drive that must have a value at the start of a run.
fn used(item: &Item<'_>, dimension: Dimension, catalog: &Catalog, counts: Counts) -> Option<Drive> {
    let drive = read_item(item, dimension, catalog)?;
    catalog.used.borrow_mut().push(Used {
        line: item.line(),
        key: item.key().to_owned(),
        drive: drive.clone(),
        counts,
    });
    Some(drive)
}

/// Like [`read`], for a value in any position, which is only written to tables and may have
/// gaps.
pub(super) fn read_item(item: &Item<'_>, dimension: Dimension, catalog: &Catalog) -> Option<Drive> {
    let find = |name: &str| catalog.find(name, item);
    if let Some(name) = catalog.sensed(item) {
        let key = item.key().to_owned();
        item.note(&DriveProblem::Senses { key, name });
        return None;
    }
    let drive = drive(item, Measure::Declared(dimension), &find)?;
    let domain = drive.domain();
    if domain.iter().any(|end| end.is_finite()) {
        let location = (item.line(), item.key().to_owned(), domain);
        catalog.bounded.borrow_mut().push(location);
    }
    Some(drive)
}

/// A function that finds a drive by its name and notes an unknown name.
type Find<'a> = dyn Fn(&str) -> Option<Named> + 'a;

/// A drive in `measure`.
fn drive(item: &Item<'_>, measure: Measure, find: &Find<'_>) -> Option<Drive> {
    let title = format!("the drive under \"{}\" of {}", item.key(), item.owner());
    if let Some(table) = item.table(&title) {
        let table = table.described(&DRIVE);
        let drive = kinds::read(&table, measure, find);
        if kinds::is_known(&table) {
            table.finish();
        }
        return drive;
    }
    let Some(text) = item.text() else {
        return measure.number(item).map(Drive::Constant);
    };
    if let Some(text) = written(text) {
        return formula(item, text, measure);
    }
    let begins = text.trim_start().chars().next();
    if begins.is_some_and(|letter| letter.is_ascii_digit() || "+-.".contains(letter)) {
        return measure.number(item).map(Drive::Constant);
    }
    let named = find(text.trim())?;
    match measure.factor_from(named.measure, item.document()) {
        Some(factor) => Some(named.drive.scaled(factor)),
        None => {
            let name = text.trim().to_owned();
            item.note(&DriveProblem::Measures {
                name,
                measures: named.measure.words(),
                expected: measure.words(),
            });
            None
        }
    }
}

/// An expression of time in declared units.
fn formula(item: &Item<'_>, text: &str, measure: Measure) -> Option<Drive> {
    let document = item.document();
    let constants = document.parameters();
    let names = Names {
        variables: &["t"],
        constants: &constants,
    };
    let expression = document.expression(item.key(), item.line(), text, &names)?;
    let factor = measure.factor(document);
    if expression.uses(0) {
        let formula = Formula::new(expression, document.factor(Dimension::TIME));
        return Some(Drive::Formula(Arc::new(formula)).scaled(factor));
    }
    let value = expression.at(|_| Default::default()).value;
    if value.is_nan() && constants.iter().any(|own| own.1.is_nan()) {
        // The problem of the parameter has been reported.
        return None;
    }
    if value.is_finite() {
        Some(Drive::Constant(factor * value))
    } else {
        item.wrong("an expression with a finite value")
    }
}

/// Reads every `[drives.NAME]`, each of which may use others, except `inputs` of a linear model.
pub(super) fn read_named(root: &Table<'_>, inputs: &[String]) -> Catalog {
    let tables = root.named_tables("drives");
    let reader = Reader {
        tables: &tables,
        inputs,
        done: RefCell::default(),
        open: RefCell::default(),
    };
    for (name, _) in &tables {
        reader.find(name);
    }
    Catalog {
        named: reader.done.into_inner(),
        bounded: RefCell::default(),
        used: RefCell::default(),
        readable: Readable::new(),
        inputs: BTreeSet::new(),
    }
}

/// Named drives during reading.
struct Reader<'a, 'd> {
    tables: &'a [(String, Table<'d>)],
    inputs: &'a [String],
    done: RefCell<BTreeMap<String, Option<Named>>>,
    /// Names that are being read, each used by the previous one.
    open: RefCell<Vec<String>>,
}

impl Reader<'_, '_> {
    /// The drive called `name`; `None` if it is wrong, which has been noted.
    fn find(&self, name: &str) -> Option<Named> {
        if let Some(found) = self.done.borrow().get(name) {
            return found.clone();
        }
        let table = &self.tables.iter().find(|own| own.0 == name)?.1;
        self.open.borrow_mut().push(name.to_owned());
        let measure = table.get(&keys::UNIT);
        let drive = measure.and_then(|measure| {
            let find = |other: &str| self.other(other, table);
            let drive = kinds::read(table, measure, &find)?;
            Some(Named { drive, measure })
        });
        if measure.is_some() && kinds::is_known(table) {
            table.finish();
        }
        self.open.borrow_mut().pop();
        self.done
            .borrow_mut()
            .insert(name.to_owned(), drive.clone());
        drive
    }

    /// A drive that is used by another one.
    fn other(&self, name: &str, user: &Table<'_>) -> Option<Named> {
        let open = self.open.borrow().clone();
        if let Some(first) = open.iter().position(|own| own == name) {
            let chain = open[first..].iter().cloned();
            let chain = chain.chain([name.to_owned()]).collect();
            user.note("", &DriveProblem::Cycle { chain });
            return None;
        }
        if self.inputs.iter().any(|input| input == name) {
            let (user_of, name) = (user.title().to_owned(), name.to_owned());
            user.note(
                "",
                &DriveProblem::OfInput {
                    user: user_of,
                    name,
                },
            );
            return None;
        }
        if !self.tables.iter().any(|own| own.0 == name) {
            let known = self.tables.iter().map(|own| own.0.clone());
            user.note("", &unknown(name, user.title(), known.collect()));
            return None;
        }
        self.find(name)
    }
}

/// Whether a drive has one rate at some instants.
fn is_straight(drive: &Drive) -> bool {
    const INSTANTS: [f64; 3] = [0.37, 1.9, 23.0];
    let rate = drive.at(0.0).rate;
    let mut others = INSTANTS.into_iter().map(|time| drive.at(time).rate);
    others.all(|other| (other - rate).abs() <= 1e-9 * rate.abs())
}

/// Whether a drive has more corners in a run than are allowed.
fn has_many_corners(drive: &Drive, [from, to]: [f64; 2]) -> bool {
    let mut time = from;
    for _ in 0..=MOST_CORNERS {
        let next = drive.next_corner(time);
        // Beyond the end, or absent.
        if next.is_nan() || next > to {
            return false;
        }
        time = next.max(time);
    }
    true
}

/// Whether a name without an expression is a parameter, which is noted.
fn is_parameter(name: &str, item: &Item<'_>) -> bool {
    let parameters = item.document().parameters();
    let is_one = parameters.iter().any(|own| own.0 == name);
    if is_one {
        let (name, key) = (name.to_owned(), item.key().to_owned());
        item.note(&DriveProblem::Parameter { name, key });
    }
    is_one
}

fn unknown(name: &str, user: &str, known: Vec<String>) -> InputProblem {
    InputProblem::UnknownName {
        kind: "drive",
        name: name.to_owned(),
        user: user.to_owned(),
        known,
    }
}

impl Catalog {
    /// Notes problems of drives in a run from and to the given `times` \[s\]: tables that
    /// end too early, too many corners, lengths that reach zero.
    pub fn check_run(&self, document: &Document, times: [f64; 2]) {
        self.check(document, times);
        self.check_corners(document, times);
        self.check_lengths(document, times);
    }

    /// Whether a drive has the name.
    pub fn has(&self, name: &str) -> bool {
        self.named.contains_key(name)
    }

    /// The names.
    pub fn names(&self) -> impl Iterator<Item = String> {
        self.named.keys().cloned()
    }

    fn find(&self, name: &str, item: &Item<'_>) -> Option<Named> {
        let found = self.named.get(name);
        let user = format!("\"{}\"", item.key());
        if self.inputs.contains(name) {
            let name = name.to_owned();
            item.note(&DriveProblem::OfInput { user, name });
            return None;
        }
        if found.is_none() && !is_parameter(name, item) {
            item.note(&unknown(name, &user, self.named.keys().cloned().collect()));
        }
        found?.clone()
    }

    /// The first sensed scalar in an expression.
    fn sensed(&self, item: &Item<'_>) -> Option<String> {
        let text = item.text().and_then(written)?;
        let mut sensed = words(text).filter(|word| self.readable.contains_key(*word));
        sensed.next().map(str::to_owned)
    }

    /// Notes every drive of the model without a finite value at the time `start` \[s\], or
    /// without a finite slope if it prescribes a motion.
    pub fn check_start(&self, document: &Document, start: f64) {
        for used in self.used.borrow().iter() {
            let [first, last] = used.drive.domain();
            if start < first || start > last {
                continue;
            }
            let now = used.drive.at(start);
            let (what, found) = match now.value.is_finite() {
                false => ("value", now.value),
                true if used.counts != Counts::Value => ("slope", now.rate),
                true => continue,
            };
            if !found.is_finite() {
                let key = used.key.clone();
                let problem = DriveProblem::NoStart {
                    key,
                    what,
                    found,
                    start,
                };
                document.note(used.line, &problem);
            }
        }
    }

    /// Keys and lines of the drives of the model that change with time, with their value at time zero
    /// [SI units]; not of an angle that grows at a constant rate, which is a steady rotation.
    pub fn changing(&self) -> Vec<(String, usize, f64)> {
        let used = self.used.borrow();
        let changing = used.iter().filter(|one| {
            let is_constant = one.drive.constant().is_some();
            !(is_constant || one.key == ANGLE && is_straight(&one.drive))
        });
        let found = changing.map(|one| (one.key.clone(), one.line, one.drive.at(0.0).value));
        found.collect()
    }

    /// Notes every drive of the model with too many corners in a run.
    pub fn check_corners(&self, document: &Document, run: [f64; 2]) {
        for used in self.used.borrow().iter() {
            if has_many_corners(&used.drive, run) {
                let (key, most) = (used.key.clone(), MOST_CORNERS);
                document.note(used.line, &DriveProblem::ManyCorners { key, most, run });
            }
        }
    }

    /// Notes every length of the model that is not above zero at all times of a run, as
    /// found at its corners and at many instants between.
    pub fn check_lengths(&self, document: &Document, run: [f64; 2]) {
        let used = self.used.borrow();
        for length in used.iter().filter(|one| one.counts == Counts::Positive) {
            if let Some((time, value)) = positive::first_below(&length.drive, run) {
                let key = length.key.clone();
                let problem = DriveProblem::NoLength {
                    key,
                    value,
                    time,
                    run,
                };
                document.note(length.line, &problem);
            }
        }
    }

    /// Notes every drive of a card that has no value at some time of a run.
    pub fn check(&self, document: &Document, [from, to]: [f64; 2]) {
        for (line, key, [first, last]) in self.bounded.borrow().iter() {
            if from < *first || to > *last {
                let problem = DriveProblem::Extrapolation {
                    key: key.clone(),
                    domain: [*first, *last],
                    run: [from, to],
                };
                document.note(*line, &problem);
            }
        }
    }
}
