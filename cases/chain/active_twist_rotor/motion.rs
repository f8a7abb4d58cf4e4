//! Periodic motion of the rotor: its controls, and the columns over a period.

use std::path::Path;

use beam_dynamics::analysis::periodic::{periodic_from, record};
use beam_dynamics::input::{self, Input};
use beam_dynamics::model::State;
use beam_dynamics::result::{AcceptedStep, ColumnValues, Harmonics, Recorder};

use super::Result;

/// The file with a set of properties, and with other values of parameters.
///
/// # Errors
/// All problems of the file.
pub fn read(file: &Path, set: &str, given: &[(&str, f64)]) -> Result<Input> {
    let text =
        std::fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let text = text.replace("coupled.properties", &format!("{set}.properties"));
    let given: Vec<_> = given
        .iter()
        .map(|(name, value)| ((*name).to_owned(), *value))
        .collect();
    input::parse_with(&text, file, &given).map_err(|problems| problems.to_string())
}

/// A motion that repeats.
#[derive(Debug)]
pub struct Motion {
    /// Its first state.
    pub state: State,
    /// Controls of a trim \[deg\].
    pub controls: Vec<f64>,
    /// Largest error of the targets and of the state, relative to their sizes \[-\].
    pub residual: f64,
    names: Vec<String>,
    /// The columns at the steps, the end of the period left out \[unit of each\].
    rows: Vec<Vec<f64>>,
}

/// The motion of the file with a set of properties and with values of parameters, from a state of the
/// model if one is given.
///
/// # Errors
/// A file that cannot be read, or a motion that does not repeat.
pub fn motion(
    file: &Path,
    set: &str,
    given: &[(&str, f64)],
    from: Option<&State>,
) -> Result<Motion> {
    let input = read(file, set, given)?;
    let settings = input.periodic.as_ref().ok_or("[periodic] is absent")?;
    let outcome = periodic_from(&input.model, settings, from);
    if let Some(failure) = outcome.failure {
        return Err(format!("{given:?}: {failure}"));
    }
    let state = outcome.state.ok_or("no state of the motion")?;
    let mut columns = Columns {
        values: ColumnValues::new(&input.model, &input.output),
        rows: Vec::new(),
    };
    let recorded = record(&input.model, settings, &state, &mut columns);
    recorded.map_err(|failure| failure.to_string())?;
    let names = input
        .output
        .columns
        .iter()
        .map(|column| column.name.clone());
    columns.rows.pop();
    Ok(Motion {
        controls: outcome.result.controls.iter().map(|own| own.1).collect(),
        residual: outcome
            .result
            .passes
            .last()
            .map_or(f64::NAN, |pass| pass.residual),
        names: names.collect(),
        rows: columns.rows,
        state,
    })
}

impl Motion {
    /// Values of a column at the steps of a period; empty for an unknown name.
    pub fn column(&self, name: &str) -> Vec<f64> {
        let found = self.names.iter().position(|own| own == name);
        let rows = self.rows.iter();
        found.map_or_else(Vec::new, |index| rows.map(|row| row[index]).collect())
    }

    /// Mean and harmonics of a column, from the first instant of the period.
    pub fn harmonics(&self, name: &str, count: usize) -> Harmonics {
        Harmonics::of(&self.column(name), count)
    }

    /// Factors of cosine and sine of a harmonic of a column.
    pub fn wave(&self, name: &str, number: usize) -> [f64; 2] {
        let found = self.harmonics(name, number);
        found
            .parts
            .get(number - 1)
            .copied()
            .unwrap_or([f64::NAN; 2])
    }
}

/// Records the columns of a period.
struct Columns<'a> {
    values: ColumnValues<'a>,
    rows: Vec<Vec<f64>>,
}

impl Recorder for Columns<'_> {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        self.values.follow(accepted);
        let mut row = vec![0.0; self.values.columns().len()];
        self.values.evaluate(accepted, &mut row);
        self.rows.push(row);
        true
    }
}
