//! The files of a periodic motion.

use super::plot::MultiplierPlot;
use super::tables::{floquet_csv, harmonics_csv};
use crate::case::{Column, Model, OutputSettings};
use crate::output::folder::{ResultLocation, Results, Written};
use crate::output::transient::{RunFileProblem, RunFiles};
use crate::result::{AcceptedStep, ColumnValues, Harmonics, PeriodicResult, Recorder};

const HARMONICS: &str = "harmonics.csv";
const FLOQUET: &str = "floquet.csv";
const PLOT: [&str; 2] = ["floquet.png", "floquet.svg"];

/// Writes the period as a run in time, `NAME.periodic.csv` and so on, the harmonics of its columns
/// as `NAME.harmonics.csv`, the multipliers as `NAME.floquet.csv`, and their figure
/// `NAME.floquet.png` and `.svg`.
#[derive(Debug)]
pub struct PeriodicFiles<'a> {
    run: RunFiles<'a>,
    location: &'a ResultLocation,
    columns: &'a [Column],
    values: ColumnValues<'a>,
    /// Values of each column at the steps, the start of the period left out.
    rows: Vec<Vec<f64>>,
}

impl<'a> PeriodicFiles<'a> {
    /// The files of `model` at `location`; files of an earlier analysis are removed.
    ///
    /// # Errors
    /// [`RunFileProblem`]: the folder or a file cannot be made, or is in use.
    pub fn new(
        model: &'a Model,
        settings: &'a OutputSettings,
        location: &'a ResultLocation,
    ) -> Result<Self, RunFileProblem> {
        let run = RunFiles::of_period(model, settings, location)?;
        let results = Results::new(location);
        results.remove([HARMONICS, FLOQUET].into_iter().chain(PLOT));
        Ok(Self {
            run,
            location,
            columns: &settings.columns,
            values: ColumnValues::new(model, settings),
            rows: Vec::new(),
        })
    }

    /// The problem that ended the recording.
    pub fn problem(&self) -> Option<&RunFileProblem> {
        self.run.problem()
    }

    /// A number of harmonics of each column; empty without a period.
    pub fn harmonics(&self, count: usize) -> Vec<Harmonics> {
        // The state at the end of the period is its start: the last row comes first.
        let Some((last, before)) = self.rows.split_last() else {
            return Vec::new();
        };
        let of_column = |index: usize| {
            let rows = std::iter::once(last).chain(before);
            let values: Vec<_> = rows.map(|row| row[index]).collect();
            Harmonics::of(&values, count)
        };
        (0..self.columns.len()).map(of_column).collect()
    }

    /// Writes everything else, with `text` as the report and the harmonics of each column, and lists all
    /// files.
    ///
    /// # Errors
    /// [`RunFileProblem`]: the one that ended the recording, or a file that cannot be written.
    pub fn finish(
        self,
        result: &PeriodicResult,
        (text, found): (&str, &[Harmonics]),
    ) -> Result<Written, RunFileProblem> {
        let mut written = self.run.finish(&result.name, text)?;
        let mut results = Results::new(self.location);
        if !found.is_empty() {
            results.text(HARMONICS, &harmonics_csv(self.columns, found))?;
        }
        if let Some(table) = &result.floquet {
            results.text(FLOQUET, &floquet_csv(table, result.period))?;
            results.figures(PLOT, || MultiplierPlot::new(result))?;
        }
        written.files.extend(results.written.files);
        Ok(written)
    }
}

impl Recorder for PeriodicFiles<'_> {
    fn record(&mut self, accepted: &AcceptedStep<'_>) -> bool {
        self.values.follow(accepted);
        if accepted.step > 0 {
            let mut row = vec![0.0; self.columns.len()];
            self.values.evaluate(accepted, &mut row);
            self.rows.push(row);
        }
        self.run.record(accepted)
    }
}
