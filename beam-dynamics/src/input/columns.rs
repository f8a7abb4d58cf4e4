//! `[output]`: what a run in time writes, and the columns of its tables.

use shared_geom::document::Table;
use shared_geom::units::Dimension;

use super::draft::Draft;
use crate::case::{Every, OutputQuestion};

mod column;
mod kind;
mod preset;
mod problem;
mod reading;

#[cfg(test)]
mod tests;

pub use problem::ColumnProblem;

/// Reads `[output]`; without it, and without columns in it, there are those that most
/// look for first.
pub(super) fn read(root: &Table<'_>, draft: &Draft) -> Option<OutputQuestion> {
    let mut question = match root.has("output") {
        true => card(&root.table("output")?, draft)?,
        false => OutputQuestion::default(),
    };
    if question.columns.is_empty() {
        question.columns = preset::columns(draft);
    }
    Some(question)
}

fn card(table: &Table<'_>, draft: &Draft) -> Option<OutputQuestion> {
    let default = OutputQuestion::default();
    let rows = match table.has("every") {
        true => every(table, "every"),
        false => Some(default.every),
    };
    let restart = match table.has("restart_every") {
        true => every(table, "restart_every").map(Some),
        false => Some(None),
    };
    let switch = |key: &str| match table.has(key) {
        true => table.boolean(key),
        false => Some(true),
    };
    let (csv, netcdf) = (switch("csv"), switch("netcdf"));
    let vtu = match table.has("vtu") {
        true => table.count("vtu").map(Some),
        false => Some(None),
    };
    let columns = column::read(table, draft);
    table.finish();
    Some(OutputQuestion {
        columns: columns?,
        every: rows?,
        csv: csv?,
        netcdf: netcdf?,
        vtu: vtu?,
        restart: restart?,
    })
}

/// Steps as a whole number, or a time with its unit.
fn every(table: &Table<'_>, key: &str) -> Option<Every> {
    if !table.is_text(key) {
        return table.count(key).map(Every::Steps);
    }
    let time = table.quantity(key, Dimension::TIME)?;
    if time > 0.0 {
        return Some(Every::Time(time));
    }
    table.wrong(key, "a time above zero, or a number of steps");
    None
}
