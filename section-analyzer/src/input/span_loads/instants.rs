//! Instants of a table of loads: its load cases, times and steps, compared as numbers.

use std::collections::HashMap;

use shared_geom::error::Diagnostics;
use shared_geom::units::{Dimension, rounded};

use super::super::column_table::Row;
use super::{INSTANTS, LoadInstant, LoadTable, NAMELESS};

/// The cells that distinguish instants: the case, the time and the step.
type Key = [Option<String>; 3];

/// The instants of a table, in the order of their first rows.
pub(super) struct Instants<'a> {
    table: &'a LoadTable,
    columns: [Option<usize>; 3],
    /// Seconds in a number of the column of times.
    second: f64,
    numbers: HashMap<Key, usize>,
    pub found: Vec<LoadInstant>,
}

impl<'a> Instants<'a> {
    /// # Errors
    /// A column that is there twice, a unit that is none of time.
    pub fn new(table: &'a LoadTable) -> Result<Self, Diagnostics> {
        let mut columns = [None; 3];
        for (column, name) in columns.iter_mut().zip(INSTANTS) {
            *column = table.0.find(name)?;
        }
        let second = columns[1].map_or(Ok(1.0), |time| table.0.factor(time, Dimension::TIME))?;
        Ok(Self {
            table,
            columns,
            second,
            numbers: HashMap::new(),
            found: Vec::new(),
        })
    }

    /// The instant of a row, and whether it is the first row of it.
    ///
    /// # Errors
    /// A time that is no number.
    pub fn of(&mut self, row: &Row) -> Result<(&mut LoadInstant, bool), Diagnostics> {
        let [case, time, step] = self.columns;
        let case = case.map(|column| row.cells[column].clone());
        let time = time.map(|column| self.table.0.number(row, column));
        // a sum with zero is never -0
        let time = time.transpose()?.map(|time| self.second * time + 0.0);
        let step = step.map(|column| step_of(&row.cells[column]));
        let exact = time.map(|time| time.to_string());
        let count = self.found.len();
        let key = [case.clone(), exact, step.clone()];
        let number = *self.numbers.entry(key).or_insert(count);
        if number == count {
            let written = [
                case.clone(),
                time.map(|time| rounded(time).to_string()),
                step,
            ];
            let words = INSTANTS.iter().zip(written);
            let words = words.filter_map(|(word, value)| Some(format!("{word} {}", value?)));
            let words: Vec<String> = words.collect();
            self.found.push(LoadInstant {
                name: match words.is_empty() {
                    true => NAMELESS.to_owned(),
                    false => words.join(" "),
                },
                case,
                time,
                points: Vec::new(),
            });
        }
        Ok((&mut self.found[number], number == count))
    }
}

/// A step as it is compared: a number, or else the text.
fn step_of(cell: &str) -> String {
    let number = cell.parse::<f64>();
    number.map_or_else(|_| cell.to_owned(), |number| (number + 0.0).to_string())
}
