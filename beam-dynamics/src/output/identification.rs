//! Identified modes as text and as CSV.

use std::f64::consts::TAU;

use super::rows::csv_text;
use super::text::aligned;
use crate::input::short_number;
use crate::result::{Identification, IdentifiedMode};

/// Digits of frequencies and growth.
const DIGITS: usize = 8;
/// Columns of the table.
const HEADING: &str = "table,column,unit,method,frequency [Hz],growth [1/s],damping ratio [-],\
                       amplitude [unit],share [-],scatter [-],rest [-]";

/// A table for each column, with the part of Prony's sum that is left.
pub fn identification_text(all: &[Identification]) -> String {
    let mut text = String::new();
    for one in all {
        if !text.is_empty() {
            text.push('\n');
        }
        let [from, to] = one.times.map(|time| short_number(time, 6));
        text.push_str(&format!(
            "{}: \"{}\" from {from} s to {to} s, {} samples\n",
            one.file, one.column, one.samples
        ));
        let unit = if one.unit.is_empty() { "-" } else { &one.unit };
        let amplitude = format!("amplitude [{unit}]");
        let heading = [
            "method",
            "frequency [Hz]",
            "growth [1/s]",
            "damping ratio [-]",
            &amplitude,
            "share [-]",
            "scatter [-]",
        ];
        let mut rows = vec![heading.map(str::to_owned).to_vec()];
        rows.extend(one.modes.iter().map(|mode| cells(mode, 5).to_vec()));
        text.push_str(&aligned(&rows));
        text.push_str(&format!(
            "rest of Prony's sum: {} of the motion\n",
            short_number(one.residual, 3)
        ));
    }
    text
}

/// Rows with table, column, method, frequency, growth, damping ratio, amplitude, share and scatter, below
/// a heading `name [unit]`; the amplitude is in the unit of the column. Missing values are empty.
pub fn identification_csv(all: &[Identification]) -> String {
    let mut rows = Vec::new();
    for one in all {
        for mode in &one.modes {
            let mut row = vec![one.file.clone(), one.column.clone(), one.unit.clone()];
            row.extend(cells(mode, DIGITS));
            row.push(short_number(one.residual, DIGITS));
            rows.push(row);
        }
    }
    csv_text(HEADING, rows)
}

/// The cells of a mode, from its method on.
fn cells(mode: &IdentifiedMode, digits: usize) -> [String; 7] {
    let number = |value: f64| short_number(value, digits);
    let optional = |value: Option<f64>| value.map_or_else(String::new, number);
    [
        mode.method.name().to_owned(),
        number(mode.frequency / TAU),
        number(mode.growth),
        number(mode.damping()),
        optional(mode.amplitude),
        optional(mode.share),
        optional(mode.scatter),
    ]
}
