//! The matrices of a linear model as one table.

use crate::output::rows::{csv_as_named, heading};
use crate::result::{LinearModel, LinearVariable};

/// `[A B; C D]`: a row for the rate of each state and for each output, a column for each state and
/// input, with names and units.
pub fn linear_csv(model: &LinearModel) -> String {
    let named = |own: &LinearVariable| format!("{} [{}]", own.name, own.unit);
    let rate = |own: &LinearVariable| match own.unit.as_str() {
        "-" => format!("rate of {} [1/s]", own.name),
        unit => format!("rate of {} [{unit}/s]", own.name),
    };
    let columns = model.states.iter().chain(&model.inputs).map(named);
    let columns: Vec<_> = std::iter::once("row".to_owned()).chain(columns).collect();
    let rates = model.states.iter().map(rate);
    let names = rates.chain(model.outputs.iter().map(named));
    let left = model.a.row_iter().chain(model.c.row_iter());
    let right = model.b.row_iter().chain(model.d.row_iter());
    let rows = names.zip(left.zip(right)).map(|(name, (left, right))| {
        let numbers = left.iter().chain(right.iter());
        // All digits: a model is computed with.
        let numbers = numbers.map(|value| format!("{value:?}"));
        std::iter::once(name).chain(numbers).collect()
    });
    csv_as_named(
        &heading(columns.iter().map(String::as_str)),
        rows.collect::<Vec<Vec<_>>>(),
    )
}
