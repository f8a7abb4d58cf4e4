//! `identify`: frequencies and damping of the motions in tables of runs.

use std::path::{Path, PathBuf};

use shared_geom::error::Explain;
use shared_geom::files::write_text;

use super::table_part::TablePart;
use super::terminal::Terminal;
use super::{DONE, NOT_REACHED, WRONG_INPUT};
use crate::analysis::identification::{IdentificationSettings, Record, RecordProblem, identify};
use crate::output::{RunFileProblem, TimeTable, identification_csv, identification_text};
use crate::result::Identification;

/// Selected columns and times, and the settings of the methods.
#[derive(Debug, Clone, clap::Args)]
pub(super) struct IdentifyOptions {
    #[command(flatten)]
    part: TablePart,
    /// Largest number of modes of a column
    #[arg(long, value_name = "COUNT", default_value = "3", value_parser = clap::value_parser!(u8).range(1..=30))]
    count: u8,
    /// Part of a record that is noise: singular values below this part of the largest belong to
    /// no motion
    #[arg(long, value_name = "NUMBER", default_value = "1e-6", value_parser = part_of_one, allow_negative_numbers = true)]
    noise: f64,
    /// Table to write; NAME.identified.csv next to the first RESULT if not given
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

/// A number between zero and one.
fn part_of_one(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok();
    let number = number.filter(|number| (0.0..1.0).contains(number));
    number.ok_or_else(|| "expected a number from 0 up to 1".to_owned())
}

/// A record without a result.
#[derive(Debug, thiserror::Error)]
#[error("column \"{column}\" of \"{file}\": {problem}")]
struct OfColumn {
    column: String,
    file: String,
    problem: RecordProblem,
}

impl Explain for OfColumn {
    fn help(&self) -> Option<String> {
        self.problem.help()
    }
}

/// `identify RESULT...`
pub(super) fn identify_files(
    results: &[PathBuf],
    options: &IdentifyOptions,
    terminal: &mut Terminal<'_>,
) -> u8 {
    let Some(tables) = options.part.read(results, terminal) else {
        return WRONG_INPUT;
    };
    let names = options.part.columns();
    let chosen: Vec<_> = tables.iter().map(|table| columns(table, &names)).collect();
    let mut is_wrong = false;
    for problem in chosen
        .iter()
        .filter_map(|found| found.as_ref().err())
        .flatten()
    {
        terminal.report(problem);
        is_wrong = true;
    }
    if is_wrong {
        return WRONG_INPUT;
    }
    let (mut found, mut failed) = (Vec::new(), Vec::new());
    for (table, (time, columns)) in tables.iter().zip(chosen.into_iter().flatten()) {
        for column in columns {
            match of_column(table, (time, column), options) {
                Ok(modes) => found.push(modes),
                // Of all columns many are at rest.
                Err(of) if names.is_empty() && of.problem == RecordProblem::NoOscillation => {}
                Err(problem) => failed.push(problem),
            }
        }
    }
    let mut code = DONE;
    for of in &failed {
        terminal.report(of);
        code = code.max(match of.problem {
            RecordProblem::NoOscillation | RecordProblem::NoSum => NOT_REACHED,
            _ => WRONG_INPUT,
        });
    }
    if found.is_empty() {
        if failed.is_empty() {
            terminal.report_text("error: no column has an oscillation");
        }
        return code.max(NOT_REACHED);
    }
    terminal.show(&identification_text(&found));
    let out = options.out.clone().unwrap_or_else(|| target(&results[0]));
    if let Err(problem) = write_text(&out, &identification_csv(&found)) {
        terminal.report(&problem);
        return code.max(NOT_REACHED);
    }
    terminal.show(&format!("\nWritten\n  {}\n", out.display()));
    code
}

/// The index of the time and the indices of the columns, or all wrong names.
fn columns(
    table: &TimeTable,
    names: &[String],
) -> Result<(usize, Vec<usize>), Vec<RunFileProblem>> {
    let time = table.find("time").map_err(|problem| vec![problem])?[0];
    if names.is_empty() {
        let all = (0..table.headings.len()).filter(|column| *column != time);
        return Ok((time, all.collect()));
    }
    let (mut columns, mut problems) = (Vec::new(), Vec::new());
    for name in names {
        match table.find(name) {
            Ok(found) => columns.extend(found.into_iter().filter(|column| *column != time)),
            Err(problem) => problems.push(problem),
        }
    }
    if problems.is_empty() {
        Ok((time, columns))
    } else {
        Err(problems)
    }
}

/// The modes of a column.
fn of_column(
    table: &TimeTable,
    (time, column): (usize, usize),
    options: &IdentifyOptions,
) -> Result<Identification, OfColumn> {
    let heading = &table.headings[column];
    let problem = |problem| OfColumn {
        column: heading.name.clone(),
        file: table.file.clone(),
        problem,
    };
    let record = Record::new(&table.columns[time], &table.columns[column]).map_err(problem)?;
    let settings = IdentificationSettings {
        count: usize::from(options.count),
        noise: options.noise,
    };
    let (modes, residual) = identify(&record, &settings).map_err(problem)?;
    Ok(Identification {
        file: table.file.clone(),
        column: heading.name.clone(),
        unit: heading.unit.clone(),
        times: [record.start, record.start + record.length()],
        samples: record.values.len(),
        modes,
        residual,
    })
}

/// The table next to a result.
fn target(result: &Path) -> PathBuf {
    let stem = TimeTable::run_name(result);
    result.with_file_name(format!("{stem}.identified.csv"))
}
