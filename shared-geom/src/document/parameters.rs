//! Numbers with names, `[parameters]`, and their expressions, which may replace any
//! number.

use std::cell::Ref;

use super::lookup::{self, Lookup};
use super::table::Table;
use super::tree::{Kind, Value};
use super::{Document, DocumentProblem};
use crate::expression::{Expression, Jet, Names, is_name, words, written};
use crate::units::parse_any;

/// Parameters in the order of their names; wrong ones are NaN.
pub(super) type Parameters = Vec<(String, f64)>;

/// Names of a cycle that a message lists: it may contain all of them.
const MOST_SHOWN: usize = 8;

/// A parameter that depends on others.
struct Open<'a> {
    /// Its index among the parameters.
    index: usize,
    line: usize,
    source: Source<'a>,
    /// Indices of the parameters that it depends on.
    uses: Vec<usize>,
}

/// The rule of a parameter that depends on others.
enum Source<'a> {
    /// An expression, as text.
    Text(&'a str),
    /// A table over the only parameter that it depends on.
    Table(Lookup),
}

impl Document {
    /// Reads the table `[parameters]`, if it exists: numbers, quantities such as
    /// `"0.5 in"`, which are converted to the declared unit, expressions of other parameters,
    /// in any order, and tables over another one.
    pub fn declare_parameters(&self, root: &Table<'_>) {
        self.declare_parameters_as(root, &[]);
    }

    /// The same with other values of the parameters that are `given`, each in the declared unit.
    pub fn declare_parameters_as(&self, root: &Table<'_>, given: &[(String, f64)]) {
        if !root.has("parameters") {
            return;
        }
        let Some(table) = root.table("parameters") else {
            return;
        };
        let mut values: Vec<_> = table.values().collect();
        values.sort_by_key(|pair| pair.0);
        let names = values.iter().map(|pair| (pair.0.to_owned(), f64::NAN));
        let mut known: Parameters = names.collect();
        let (mut open, mut rows) = (Vec::new(), Vec::new());
        for (index, (name, value)) in values.into_iter().enumerate() {
            if !is_name(name) {
                let name = name.to_owned();
                self.note_in(value, &DocumentProblem::ParameterName { name });
            }
            if let Some((_, number)) = given.iter().find(|own| own.0 == name) {
                known[index].1 = *number;
                // The rows of its table are known all the same.
                if let Kind::Table(entries) = &value.kind {
                    let table = lookup::read(self, (name, value.line), entries);
                    rows.extend(table.map(|(of, table)| (of, table.values())));
                }
                continue;
            }
            match self.parameter(name, value, &known) {
                Some(Parameter::Number(number)) => known[index].1 = number,
                Some(Parameter::Open(source, uses)) => open.push(Open {
                    index,
                    line: value.line,
                    source,
                    uses,
                }),
                None => {}
            }
        }
        self.close(&mut known, &open);
        let tables = open.iter().filter_map(|one| match &one.source {
            Source::Table(table) => Some((known[one.uses[0]].0.clone(), table.values())),
            Source::Text(_) => None,
        });
        rows.extend(tables);
        *self.rows.borrow_mut() = rows;
        *self.parameters.borrow_mut() = known;
    }

    fn note_in(&self, value: &Value, problem: &DocumentProblem) {
        self.note(value.line, problem);
    }

    /// Definition of a parameter among the parameters `known`, whose numbers are not
    /// used.
    fn parameter<'a>(
        &self,
        name: &str,
        value: &'a Value,
        known: &Parameters,
    ) -> Option<Parameter<'a>> {
        let key = || name.to_owned();
        let found = match &value.kind {
            Kind::Integer(number) => Parameter::Number(*number as f64),
            Kind::Number(number) if number.is_finite() => Parameter::Number(*number),
            Kind::Text(text) => match written(text) {
                Some(text) => {
                    let found = self.expression(name, value.line, text, &of(known))?;
                    Parameter::Open(Source::Text(text), numbers(&found, known))
                }
                None => {
                    let found = parse_any(text).map_err(|problem| {
                        let key = key();
                        self.note_in(value, &DocumentProblem::Unit { key, problem });
                    });
                    let (number, dimension) = found.ok()?;
                    Parameter::Number(number / self.factor(dimension))
                }
            },
            Kind::Table(entries) => {
                let (of, table) = lookup::read(self, (name, value.line), entries)?;
                let index = known.binary_search_by(|own| own.0.cmp(&of));
                let Ok(index) = index else {
                    let known = known.iter().map(|own| own.0.clone()).collect();
                    let (key, meant) = ("of".to_owned(), None);
                    let problem = DocumentProblem::WrongWord {
                        key,
                        found: of,
                        known,
                        meant,
                    };
                    self.note_in(value, &problem);
                    return None;
                };
                Parameter::Open(Source::Table(table), vec![index])
            }
            other => {
                let problem = DocumentProblem::WrongValue {
                    key: key(),
                    found: other.describe(),
                    expected: "a number, a quantity, an expression or a table".to_owned(),
                };
                self.note_in(value, &problem);
                return None;
            }
        };
        Some(found)
    }

    /// Computes the values of parameters that depend on others, each once and after the
    /// parameters that it uses; notes parameters that depend on themselves.
    fn close(&self, known: &mut Parameters, open: &[Open<'_>]) {
        let mut location = vec![None; known.len()];
        for (at, one) in open.iter().enumerate() {
            location[one.index] = Some(at);
        }
        // For each open one: the number of parameters it waits for, and those waiting for
        // it.
        let mut waits = vec![0; open.len()];
        let mut users = vec![Vec::new(); open.len()];
        for (at, one) in open.iter().enumerate() {
            for other in one.uses.iter().filter_map(|&index| location[index]) {
                waits[at] += 1;
                users[other].push(at);
            }
        }
        let mut ready: Vec<_> = (0..open.len()).filter(|&at| waits[at] == 0).collect();
        while let Some(at) = ready.pop() {
            known[open[at].index].1 = self.value(&open[at], known);
            for &user in &users[at] {
                waits[user] -= 1;
                if waits[user] == 0 {
                    ready.push(user);
                }
            }
        }
        // Each of the rest waits for another one of the rest.
        let left = |&at: &usize| waits[at] > 0;
        let next = open.iter().map(|one| {
            let others = one.uses.iter().filter_map(|&index| location[index]);
            others.clone().find(left)
        });
        for cycle in cycles(&next.collect::<Vec<_>>()) {
            let name = |at: usize| known[open[at].index].0.clone();
            let mut chain: Vec<_> = cycle.iter().take(MOST_SHOWN).map(|&at| name(at)).collect();
            if cycle.len() > MOST_SHOWN {
                chain.push(format!("({} more)", cycle.len() - MOST_SHOWN));
            }
            chain.push(name(cycle[0]));
            let name = name(cycle[0]);
            self.note(open[cycle[0]].line, &DocumentProblem::Cycle { name, chain });
        }
    }

    /// The value of a parameter that depends on known ones; NaN if it has none.
    fn value(&self, one: &Open<'_>, known: &Parameters) -> f64 {
        let number = match &one.source {
            Source::Text(text) => {
                // It was parsed before.
                let found = Expression::parse(text, &of(known)).ok();
                found.map_or(f64::NAN, |found| found.at(|_| Jet::default()).value)
            }
            Source::Table(table) => {
                let (name, x) = &known[one.uses[0]];
                return table.at(*x).unwrap_or_else(|| {
                    if !x.is_nan() {
                        let ([first, last], own) = (table.range(), &known[one.index].0);
                        let problem = DocumentProblem::WrongValue {
                            key: name.clone(),
                            found: x.to_string(),
                            expected: format!(
                                "a value from {first} to {last}, the range of the table of \"{own}\""
                            ),
                        };
                        self.note(one.line, &problem);
                    }
                    f64::NAN
                });
            }
        };
        if number.is_finite() {
            return number;
        }
        if one.uses.iter().all(|&index| !known[index].1.is_nan()) {
            let problem = DocumentProblem::WrongValue {
                key: known[one.index].0.clone(),
                found: number.to_string(),
                expected: "a finite number".to_owned(),
            };
            self.note(one.line, &problem);
        }
        f64::NAN
    }

    /// The parameters that have been declared, in the order of their names; wrong ones
    /// are NaN.
    pub fn parameters(&self) -> Ref<'_, Vec<(String, f64)>> {
        self.parameters.borrow()
    }

    /// Values of the parameter `name` at the rows of tables over it that are inside all of them,
    /// in their order; empty without tables.
    pub fn rows_over(&self, name: &str) -> Vec<f64> {
        let tables = self.rows.borrow();
        let own = tables.iter().filter(|table| table.0 == name);
        let own: Vec<&[f64]> = own.map(|table| table.1.as_slice()).collect();
        let is_inside = |value: &f64| {
            own.iter()
                .all(|rows| rows.first() <= Some(value) && Some(value) <= rows.last())
        };
        let mut values: Vec<f64> = own
            .iter()
            .copied()
            .flatten()
            .copied()
            .filter(is_inside)
            .collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    }

    /// Whether an expression, or a table over a parameter, names the parameter.
    pub fn uses_parameter(&self, name: &str) -> bool {
        let mut entries = self.root.iter();
        entries.any(|entry| uses(&entry.value, &entry.key, name))
    }

    /// The value of an expression of parameters under `key`; notes problems, unless they
    /// were caused by a parameter.
    pub(super) fn evaluate(&self, key: &str, line: usize, text: &str) -> Option<f64> {
        let constants = self.parameters.borrow();
        let found = self.expression(key, line, written(text)?, &of(&constants))?;
        let number = found.at(|_| Jet::default()).value;
        let is_reported = number.is_nan() && constants.iter().any(|own| own.1.is_nan());
        (!is_reported).then_some(number)
    }

    /// The value of an expression of parameters; `None` if it has none.
    pub(super) fn quietly(&self, text: &str) -> Option<f64> {
        let constants = self.parameters.borrow();
        let found = Expression::parse(written(text)?, &of(&constants)).ok()?;
        let number = found.at(|_| Jet::default()).value;
        number.is_finite().then_some(number)
    }

    /// The expression `text` under `key`, on `line`; notes problems.
    pub fn expression(
        &self,
        key: &str,
        line: usize,
        text: &str,
        names: &Names<'_>,
    ) -> Option<Expression> {
        let found = Expression::parse(text, names).map_err(|problem| {
            let key = key.to_owned();
            self.note(line, &DocumentProblem::Expression { key, problem });
        });
        found.ok()
    }
}

/// Definition of a parameter.
enum Parameter<'a> {
    Number(f64),
    /// A rule, and indices of the parameters that it depends on.
    Open(Source<'a>, Vec<usize>),
}

/// The names of parameters, and no variable.
fn of(known: &Parameters) -> Names<'_> {
    Names {
        variables: &[],
        constants: known,
    }
}

/// Whether a value under a key, or one inside of it, names a parameter.
fn uses(value: &Value, key: &str, name: &str) -> bool {
    match &value.kind {
        Kind::Text(text) => match written(text) {
            Some(text) => words(text).any(|word| word == name),
            None => key == lookup::OF.name() && text == name,
        },
        Kind::Array(items) => items.iter().any(|item| uses(item, key, name)),
        Kind::Table(entries) => {
            let mut entries = entries.iter();
            entries.any(|entry| uses(&entry.value, &entry.key, name))
        }
        _ => false,
    }
}

/// Indices of the parameters that an expression contains, each once.
fn numbers(expression: &Expression, known: &Parameters) -> Vec<usize> {
    let names = expression.known().iter();
    let mut found: Vec<_> = names
        .filter_map(|name| known.binary_search_by(|own| own.0.cmp(name)).ok())
        .collect();
    found.sort_unstable();
    found.dedup();
    found
}

/// The cycles of a graph in which each point has at most one successor, in the order in
/// which they are found; each starts at its first point found.
fn cycles(next: &[Option<usize>]) -> Vec<Vec<usize>> {
    const NEVER: usize = usize::MAX;
    let mut walk_of = vec![NEVER; next.len()];
    let mut found = Vec::new();
    for start in 0..next.len() {
        let mut at = Some(start);
        while let Some(here) = at.filter(|&here| walk_of[here] == NEVER) {
            walk_of[here] = start;
            at = next[here];
        }
        // This walk returned to its own points, not to earlier ones.
        let Some(first) = at.filter(|&here| walk_of[here] == start) else {
            continue;
        };
        let mut cycle = vec![first];
        while let Some(here) = next[*cycle.last().unwrap_or(&first)].filter(|&here| here != first) {
            cycle.push(here);
        }
        let least = (0..cycle.len()).min_by_key(|&i| cycle[i]).unwrap_or(0);
        cycle.rotate_left(least);
        found.push(cycle);
    }
    found
}
