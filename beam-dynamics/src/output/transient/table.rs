//! Tables of runs, read back: the data of plots.

use std::path::Path;

use shared_geom::files::read_bytes;
use shared_geom::units::{Dimension, parse_as};

use super::netcdf_table::{self, Content};
use super::writer::cannot_read;
use super::{Heading, RunFileProblem};

/// Endings of results that are not part of the names of runs.
const ENDINGS: [&str; 4] = [".transient.csv", ".transient.nc", ".csv", ".nc"];
/// Remedy for a file that is not a table.
const REMEDY: &str = "name a table that transient wrote, NAME.transient.csv or NAME.transient.nc";

/// The table of a run: columns of numbers, time first.
#[derive(Debug, Clone, PartialEq)]
pub struct TimeTable {
    /// Path of the file.
    pub file: String,
    /// Name of the model: from the file, for text from the NetCDF file next to it; else the name of
    /// the file.
    pub title: String,
    /// Names, units and, of NetCDF files, meanings of the columns.
    pub headings: Vec<Heading>,
    /// The numbers of each column [its unit].
    pub columns: Vec<Vec<f64>>,
}

impl TimeTable {
    /// Reads a table as text (`.csv`) or in binary (`.nc`).
    ///
    /// # Errors
    /// [`RunFileProblem::Unreadable`].
    pub fn read(path: &Path) -> Result<Self, RunFileProblem> {
        let is_table = ["csv", "nc"]
            .iter()
            .any(|ending| path.extension() == Some(ending.as_ref()));
        let bytes = if is_table {
            read_bytes(path).map_err(|error| cannot_read(path, &error))?
        } else {
            Vec::new()
        };
        Self::parse(&bytes, path)
    }

    /// The table in the content of the file at `path`.
    ///
    /// # Errors
    /// As [`TimeTable::read`].
    pub fn parse(bytes: &[u8], path: &Path) -> Result<Self, RunFileProblem> {
        let ending = path.extension().and_then(|ending| ending.to_str());
        let mut table = match ending {
            Some("csv") => parse_csv(bytes, path),
            Some("nc") => parse_netcdf(bytes, path),
            _ => Err(unreadable(path, "its ending is neither .csv nor .nc")),
        }?;
        table.in_seconds(path)?;
        Ok(table)
    }

    /// Converts the times of other units than seconds.
    fn in_seconds(&mut self, path: &Path) -> Result<(), RunFileProblem> {
        let mut all = self.headings.iter_mut().zip(&mut self.columns);
        let Some((heading, times)) = all.find(|(heading, _)| heading.name == "time") else {
            return Ok(());
        };
        if ["", "s"].contains(&heading.unit.as_str()) {
            return Ok(());
        }
        let Ok(unit) = parse_as(&heading.unit, Dimension::TIME) else {
            let reason = format!("the unit of \"time\" is \"{}\"", heading.unit);
            return Err(unreadable(path, reason));
        };
        times.iter_mut().for_each(|time| *time *= unit.factor);
        heading.unit = "s".to_owned();
        Ok(())
    }

    /// The name of the run whose table is at `path`: of the file, without the endings of results.
    pub fn run_name(path: &Path) -> String {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let stem = ENDINGS.iter().find_map(|ending| name.strip_suffix(ending));
        stem.unwrap_or(&name).to_owned()
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, Vec::len)
    }

    /// Leaves the rows between two times \[s\].
    pub fn between(&mut self, from: f64, to: f64) {
        let Some(index) = self.headings.iter().position(|h| h.name == "time") else {
            return;
        };
        let is_in: Vec<_> = self.columns[index]
            .iter()
            .map(|time| (from..=to).contains(time))
            .collect();
        for column in &mut self.columns {
            let mut rows = is_in.iter();
            column.retain(|_| rows.next().copied().unwrap_or(false));
        }
    }

    /// Indices of the columns called `name`; with `*` at its end of all that begin with it.
    ///
    /// # Errors
    /// [`RunFileProblem::NoColumn`].
    pub fn find(&self, name: &str) -> Result<Vec<usize>, RunFileProblem> {
        let fits = |heading: &Heading| match name.strip_suffix('*') {
            Some(first) => heading.name.starts_with(first),
            None => heading.name == name,
        };
        let columns = self.headings.iter().enumerate();
        let found: Vec<_> = columns.filter(|(_, h)| fits(h)).map(|(k, _)| k).collect();
        if !found.is_empty() {
            return Ok(found);
        }
        let file = self.file.clone();
        if name == "time" {
            return Err(RunFileProblem::NoTime { file });
        }
        Err(RunFileProblem::NoColumn {
            name: name.to_owned(),
            file,
            known: self.headings.iter().map(|h| h.name.clone()).collect(),
        })
    }
}

fn unreadable(path: &Path, reason: impl Into<String>) -> RunFileProblem {
    RunFileProblem::Unreadable {
        file: path.display().to_string(),
        reason: reason.into(),
        remedy: REMEDY,
    }
}

fn parse_csv(bytes: &[u8], path: &Path) -> Result<TimeTable, RunFileProblem> {
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(bytes);
    let failed = |error: csv::Error| unreadable(path, error.to_string());
    let headings: Vec<_> = reader
        .headers()
        .map_err(failed)?
        .iter()
        .map(heading)
        .collect();
    let mut columns = vec![Vec::new(); headings.len()];
    let is_torn = bytes.last() != Some(&b'\n');
    let records: Result<Vec<_>, _> = reader.records().collect();
    let mut records = records.map_err(failed)?;
    if is_torn {
        // The run is just writing its last line, or was killed there.
        records.pop();
    }
    for (row, record) in records.iter().enumerate() {
        if record.len() != headings.len() {
            let reason = format!("line {} has {} values", row + 2, record.len());
            return Err(unreadable(path, reason));
        }
        for (column, value) in columns.iter_mut().zip(record) {
            let value = value.trim();
            let number = if value.is_empty() {
                Ok(f64::NAN)
            } else {
                value.parse()
            };
            column.push(number.map_err(|_| {
                unreadable(
                    path,
                    format!("line {} has \"{value}\", expected a number", row + 2),
                )
            })?);
        }
    }
    let title = netcdf_table::title(&path.with_extension("nc"));
    Ok(TimeTable {
        file: path.display().to_string(),
        title: title.unwrap_or_else(|| TimeTable::run_name(path)),
        headings,
        columns,
    })
}

/// A heading such as `tip_z [mm]`.
fn heading(text: &str) -> Heading {
    let inner = text.trim().strip_suffix(']');
    let (name, unit) = match inner.and_then(|text| text.split_once('[')) {
        Some((name, unit)) => (name.trim(), unit.trim()),
        None => (text.trim(), ""),
    };
    Heading {
        name: name.to_owned(),
        unit: match unit {
            "-" => "1".to_owned(),
            unit => unit.to_owned(),
        },
        words: String::new(),
    }
}

fn parse_netcdf(bytes: &[u8], path: &Path) -> Result<TimeTable, RunFileProblem> {
    let foreign = "it is not a complete NetCDF-3 file of a run";
    let content = Content::parse(bytes).ok_or_else(|| unreadable(path, foreign))?;
    Ok(TimeTable {
        file: path.display().to_string(),
        title: if content.title.is_empty() {
            TimeTable::run_name(path)
        } else {
            content.title
        },
        headings: content.headings,
        columns: content.columns,
    })
}
