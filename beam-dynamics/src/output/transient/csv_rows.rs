//! The table of a run as text, written row by row.

use std::fmt::Write as _;
use std::fs::{File, OpenOptions};
use std::io::{BufRead, BufReader, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::problem::RunFileProblem;
use super::writer::{Heading, RowWriter, cannot_read, cannot_write};

/// A table of comma-separated values. Rows that belong together are written by one call of the system,
/// so that no row is lost if the run is killed.
#[derive(Debug)]
pub(in crate::output) struct CsvRows {
    path: PathBuf,
    file: File,
    /// Rows that are not yet written.
    added: String,
}

impl CsvRows {
    /// A new file with its header line.
    pub fn create(path: &Path, headings: &[Heading]) -> Result<Self, RunFileProblem> {
        let mut file = File::create(path).map_err(|error| cannot_write(path, &error))?;
        let header = header(headings);
        file.write_all(header.as_bytes())
            .map_err(|error| cannot_write(path, &error))?;
        Ok(Self {
            path: path.to_owned(),
            file,
            added: String::new(),
        })
    }

    /// The file of an earlier part of the run, without its rows after `time` \[s\]; a new one if it
    /// does not exist.
    pub fn resume(path: &Path, headings: &[Heading], time: f64) -> Result<Self, RunFileProblem> {
        if !path.exists() {
            return Self::create(path, headings);
        }
        let text = std::fs::read_to_string(path).map_err(|error| cannot_read(path, &error))?;
        let header = header(headings);
        let Some(rows) = text.strip_prefix(&header) else {
            let file = path.display().to_string();
            return Err(RunFileProblem::OtherColumns { file });
        };
        let is_before = |row: &&str| {
            let first = row.split(',').next().unwrap_or_default();
            row.ends_with('\n') && first.parse::<f64>().is_ok_and(|found| found <= time)
        };
        let kept = rows.split_inclusive('\n').take_while(is_before);
        let length = header.len() + kept.map(str::len).sum::<usize>();
        let open = || {
            let mut file = OpenOptions::new().write(true).open(path)?;
            file.set_len(length as u64)?;
            file.seek(SeekFrom::End(0))?;
            Ok(file)
        };
        Ok(Self {
            path: path.to_owned(),
            file: open().map_err(|error| cannot_write(path, &error))?,
            added: String::new(),
        })
    }
}

impl CsvRows {
    /// Path of the table.
    pub fn file(&self) -> &Path {
        &self.path
    }

    /// The present content of the file.
    ///
    /// # Errors
    /// [`RunFileProblem::Unreadable`].
    pub fn content(&self) -> Result<String, RunFileProblem> {
        std::fs::read_to_string(&self.path).map_err(|error| cannot_read(&self.path, &error))
    }

    /// Shows the lines of the present content to `visit`, one at a time.
    ///
    /// # Errors
    /// [`RunFileProblem::Unreadable`].
    pub fn each_line(&self, visit: &mut dyn FnMut(&str)) -> Result<(), RunFileProblem> {
        let unreadable = |error: std::io::Error| cannot_read(&self.path, &error);
        let file = File::open(&self.path).map_err(unreadable)?;
        for line in BufReader::new(file).lines() {
            visit(&line.map_err(unreadable)?);
        }
        Ok(())
    }

    /// Adds a row, without writing it yet.
    pub fn add(&mut self, row: &[f64]) {
        for (k, value) in row.iter().enumerate() {
            let comma = if k > 0 { "," } else { "" };
            // The shortest text that is read as the same number. Writing to a text cannot fail.
            let _ = write!(self.added, "{comma}{value:?}");
        }
        self.added.push('\n');
    }

    /// Writes the rows added since the last call.
    ///
    /// # Errors
    /// [`RunFileProblem::Output`].
    pub fn write_added(&mut self) -> Result<(), RunFileProblem> {
        let written = self.file.write_all(self.added.as_bytes());
        self.added.clear();
        written.map_err(|error| cannot_write(&self.path, &error))
    }
}

impl RowWriter for CsvRows {
    fn path(&self) -> &Path {
        &self.path
    }

    fn write(&mut self, row: &[f64]) -> Result<(), RunFileProblem> {
        self.add(row);
        self.write_added()
    }
}

/// Names with their units in brackets.
fn header(headings: &[Heading]) -> String {
    let column = |heading: &Heading| format!("{} [{}]", heading.name, heading.shown_unit());
    let columns: Vec<_> = headings.iter().map(column).collect();
    columns.join(",") + "\n"
}
