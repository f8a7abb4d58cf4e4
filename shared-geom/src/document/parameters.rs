//! Numbers with names, `[parameters]`, and the expressions of them that may stand in the
//! place of any number.

use std::collections::BTreeMap;

use super::table::Table;
use super::tree::{Kind, Value};
use super::{Document, DocumentProblem};
use crate::expression::{Expression, Jet, Names, is_name, written};
use crate::units::parse_any;

/// Parameters by name; those that are wrong are not a number.
pub(super) type Parameters = Vec<(String, f64)>;

/// A parameter that depends on others.
struct Open {
    name: String,
    line: usize,
    expression: Expression,
}

impl Document {
    /// Reads the table `[parameters]`, if there is one: numbers, quantities such as
    /// `"0.5 in"`, which count in the declared unit, and expressions of other parameters,
    /// in any order.
    pub fn declare_parameters(&self, root: &Table<'_>) {
        if !root.has("parameters") {
            return;
        }
        let Some(table) = root.table("parameters") else {
            return;
        };
        let names = table.keys();
        let names: Vec<_> = names.iter().map(String::as_str).collect();
        let mut known = Parameters::new();
        let mut open = Vec::new();
        for (name, value) in table.values() {
            if !is_name(name) {
                let name = name.to_owned();
                self.note_in(value, &DocumentProblem::ParameterName { name });
            }
            match self.parameter(name, value, &names) {
                Some(Parameter::Number(number)) => known.push((name.to_owned(), number)),
                Some(Parameter::Open(expression)) => open.push(Open {
                    name: name.to_owned(),
                    line: value.line,
                    expression,
                }),
                None => known.push((name.to_owned(), f64::NAN)),
            }
        }
        self.close(&names, &mut known, open);
        *self.parameters.borrow_mut() = known;
    }

    fn note_in(&self, value: &Value, problem: &DocumentProblem) {
        self.note(value.line, problem);
    }

    fn parameter(&self, name: &str, value: &Value, names: &[&str]) -> Option<Parameter> {
        let key = || name.to_owned();
        let found = match &value.kind {
            Kind::Integer(number) => Parameter::Number(*number as f64),
            Kind::Number(number) if number.is_finite() => Parameter::Number(*number),
            Kind::Text(text) => match written(text) {
                Some(text) => {
                    let names = Names {
                        variables: names,
                        constants: &[],
                    };
                    let found = Expression::parse(text, &names).map_err(|problem| {
                        let key = key();
                        self.note_in(value, &DocumentProblem::Expression { key, problem });
                    });
                    Parameter::Open(found.ok()?)
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
            other => {
                let problem = DocumentProblem::WrongValue {
                    key: key(),
                    found: other.describe(),
                    expected: "a number, a quantity or an expression".to_owned(),
                };
                self.note_in(value, &problem);
                return None;
            }
        };
        Some(found)
    }

    /// Finds the values of parameters that depend on others, and notes those that depend
    /// on themselves.
    fn close(&self, names: &[&str], known: &mut Parameters, mut open: Vec<Open>) {
        let index = |name: &str| names.iter().position(|own| *own == name);
        loop {
            let before = open.len();
            open.retain(|one| {
                let value = |i: usize| known.iter().find(|own| own.0 == names[i]);
                let ready = (0..names.len()).all(|i| !one.expression.uses(i) || value(i).is_some());
                if !ready {
                    return true;
                }
                let at = |i: usize| Jet::constant(value(i).map_or(f64::NAN, |own| own.1));
                let number = one.expression.at(at).value;
                let of_known = (0..names.len())
                    .filter(|&i| one.expression.uses(i))
                    .all(|i| !at(i).value.is_nan());
                if !number.is_finite() && of_known {
                    let problem = DocumentProblem::WrongValue {
                        key: one.name.clone(),
                        found: number.to_string(),
                        expected: "a finite number".to_owned(),
                    };
                    self.note(one.line, &problem);
                }
                let number = if number.is_finite() { number } else { f64::NAN };
                known.push((one.name.clone(), number));
                false
            });
            if open.len() == before {
                break;
            }
        }
        let next: BTreeMap<&str, &str> = open
            .iter()
            .filter_map(|one| {
                let waits =
                    |other: &&Open| index(&other.name).is_some_and(|i| one.expression.uses(i));
                let other = open.iter().find(waits)?;
                Some((one.name.as_str(), other.name.as_str()))
            })
            .collect();
        for one in &open {
            known.push((one.name.clone(), f64::NAN));
            if let Some(chain) = cycle(&one.name, &next) {
                let name = one.name.clone();
                self.note(one.line, &DocumentProblem::Cycle { name, chain });
            }
        }
    }

    /// The parameters that have been declared, in no order; those that are wrong are not
    /// a number.
    pub fn parameters(&self) -> Vec<(String, f64)> {
        self.parameters.borrow().clone()
    }

    /// The value of an expression of parameters under `key`; what is wrong with it is
    /// noted, unless it was with a parameter.
    pub(super) fn evaluate(&self, key: &str, line: usize, text: &str) -> Option<f64> {
        let constants = self.parameters.borrow();
        let names = Names {
            variables: &[],
            constants: &constants,
        };
        let found = self.expression(key, line, written(text)?, &names)?;
        let number = found.at(|_| Jet::default()).value;
        let is_told = number.is_nan() && constants.iter().any(|own| own.1.is_nan());
        (!is_told).then_some(number)
    }

    /// The value of an expression of parameters; `None` where it has none.
    pub(super) fn quietly(&self, text: &str) -> Option<f64> {
        let constants = self.parameters.borrow();
        let names = Names {
            variables: &[],
            constants: &constants,
        };
        let found = Expression::parse(written(text)?, &names).ok()?;
        let number = found.at(|_| Jet::default()).value;
        number.is_finite().then_some(number)
    }

    /// The expression `text` under `key`, on `line`; notes what is wrong with it.
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

/// What stands for a parameter.
enum Parameter {
    Number(f64),
    Open(Expression),
}

/// The way from a name back to it, when it comes back.
fn cycle(name: &str, next: &BTreeMap<&str, &str>) -> Option<Vec<String>> {
    let mut chain = vec![name.to_owned()];
    let mut at = name;
    while chain.len() <= next.len() {
        at = next.get(at)?;
        chain.push(at.to_owned());
        if at == name {
            return Some(chain);
        }
    }
    None
}
