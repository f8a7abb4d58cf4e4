//! `compare`: the differences of two blade files.

use std::path::{Path, PathBuf};

use clap::Args;
use shared_geom::blade::BladeDifference;
use shared_geom::exchange::Reading;

use crate::analysis::modes::modes;
use crate::input::{self, BladeSettings};
use crate::output::blade_comparison;

use super::reading_options::ReadingOptions;
use super::{DONE, NOT_REACHED, Terminal, WRONG_INPUT};

/// Number of frequencies that are compared.
const MODES: usize = 6;

/// The files, and the differences that are treated as equal.
#[derive(Debug, Args)]
pub(super) struct CompareArguments {
    /// Blade file to compare with
    a: PathBuf,
    /// Blade file to compare
    b: PathBuf,
    /// Largest relative difference that is treated as equal
    #[arg(long, value_name = "NUMBER", default_value = "1e-6", value_parser = tolerance, allow_hyphen_values = true)]
    tolerance: f64,
    #[command(flatten)]
    reading: ReadingOptions,
}

/// A tolerance, zero or more.
fn tolerance(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok();
    let good = number.filter(|number| number.is_finite() && *number >= 0.0);
    good.ok_or_else(|| "expected a number, 0 or more".to_owned())
}

/// Compares two blade files; the exit code shows whether they are equal.
pub(super) fn compare_files(arguments: &CompareArguments, terminal: &mut Terminal<'_>) -> u8 {
    let files = [&arguments.a, &arguments.b];
    let read = files.map(|file| match arguments.reading.read(file, None) {
        Ok((_, reading)) => Some(reading),
        Err(problems) => {
            terminal.report_text(&problems.to_string());
            None
        }
    });
    let [Some(a), Some(b)] = &read else {
        return WRONG_INPUT;
    };
    let mut all = a.blade.compare(&b.blade);
    let note = match frequencies(files, [a, b], &arguments.reading) {
        Ok(rows) => {
            all.extend(rows);
            None
        }
        Err(note) => Some(note),
    };
    let names = files.map(|file| file.display().to_string());
    let names = [names[0].as_str(), names[1].as_str()];
    let tolerance = arguments.tolerance;
    terminal.show(&blade_comparison(names, &all, tolerance, note.as_deref()));
    if all.iter().all(|one| one.relative <= tolerance) {
        DONE
    } else {
        NOT_REACHED
    }
}

/// The differences of the lowest frequencies of both blades, clamped and at rest.
///
/// # Errors
/// A blade that has no modes, as text.
fn frequencies(
    files: [&PathBuf; 2],
    readings: [&Reading; 2],
    options: &ReadingOptions,
) -> Result<Vec<BladeDifference>, String> {
    let [a, b] = [(files[0], readings[0]), (files[1], readings[1])].map(|(file, reading)| {
        match reading.blade.problems().first() {
            Some(problem) => Err(format!("{}: {problem}", file.display())),
            None => lowest(file, options),
        }
    });
    let (a, b) = (a?, b?);
    let rows = a.iter().zip(&b).map(|((name, a), (_, b))| BladeDifference {
        name: format!("frequency {name}"),
        unit: "Hz",
        a: *a,
        b: *b,
        relative: (b / a - 1.0).abs(),
        at: None,
    });
    Ok(rows.collect())
}

/// Names and values of the lowest frequencies of a blade file [Hz].
fn lowest(file: &Path, options: &ReadingOptions) -> Result<Vec<(String, f64)>, String> {
    let settings = BladeSettings {
        count: Some(MODES),
        length: options.length,
        rigid_shear: options.rigid_shear,
        ..BladeSettings::default()
    };
    let input = input::read_blade(file, &settings).map_err(|problems| problems.to_string())?;
    let settings = input.modes.clone();
    let settings = settings.ok_or_else(|| format!("{}: no modes", file.display()))?;
    let outcome = modes(&input.model, &settings);
    if let Some(failure) = outcome.failure {
        return Err(format!("{}: {failure}", file.display()));
    }
    let found = outcome.table.at_speed(0);
    let mut found: Vec<_> = found
        .into_iter()
        .map(|(branch, point)| (branch.name.clone(), point.frequency))
        .collect();
    found.sort_by(|a, b| a.1.total_cmp(&b.1));
    Ok(found)
}
