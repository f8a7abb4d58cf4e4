//! The files of one result.

use shared_geom::files::{OutputProblem, make_folder};

use super::critical_table::critical_text;
use super::decaying::decaying_text;
use super::folder::{ResultLocation, Results, Written};
use super::{
    FanPlot, campbell_csv, comparison_csv, comparison_text, convention, critical_csv, decaying_csv,
    fixed_text, frequency_csv, frequency_text, mode_csv,
};
use crate::result::{CriticalSpeed, FixedTable, FrequencyTable, Measured};

const TABLE: &str = "frequencies.csv";
const MODES: &str = "modes.csv";
const DECAYING: &str = "decaying.csv";
const TEXT: &str = "frequencies.txt";
const COMPARISON: &str = "comparison.csv";
const FAN: [&str; 2] = ["fan.png", "fan.svg"];
const CAMPBELL: [&str; 2] = ["campbell.png", "campbell.svg"];
const FIXED: &str = "campbell.csv";
const CRITICAL: &str = "critical_speeds.csv";

/// The modes of a table in the fixed system, for figures and tables.
fn fixed(table: &FrequencyTable) -> Option<FixedTable> {
    FixedTable::new(table, &table.harmonics())
}

/// The critical speeds of a single blade.
fn critical_of_blade(table: &FrequencyTable) -> Vec<CriticalSpeed> {
    table.critical_of_blade(&table.harmonics())
}

/// The text of a result: the frequency table, that in the fixed system with the critical speeds for
/// rotors and shafts, the critical speeds of a single blade, the comparison with the measurements if there are
/// any, and the conventions.
pub fn result_text(table: &FrequencyTable, measured: &Measured) -> String {
    let comparison = if measured.points.is_empty() {
        String::new()
    } else {
        comparison_text(measured, table) + "\n"
    };
    let seen = match fixed(table) {
        Some(fixed) => fixed_text(table, &fixed),
        None => critical_text(table, "the turning axes", &critical_of_blade(table)),
    };
    format!(
        "{}\n{seen}{}{comparison}{}",
        frequency_text(table),
        decaying_text(table),
        convention(table)
    )
}

/// Writes `NAME.frequencies.csv`, `NAME.modes.csv`, `NAME.frequencies.txt`, with motions that decay
/// without oscillation `NAME.decaying.csv`, with measurements
/// `NAME.comparison.csv`, and for two speeds or more, if figures are drawn, `NAME.fan.png` and
/// `NAME.fan.svg` to `location`; of rotors and shafts also `NAME.campbell.csv`,
/// `NAME.critical_speeds.csv`, `NAME.campbell.png` and `NAME.campbell.svg`, of a single blade
/// `NAME.critical_speeds.csv`. Files of an earlier run that this run does not write are removed.
///
/// # Errors
/// [`OutputProblem`]: the folder or a file cannot be written.
pub fn write(
    table: &FrequencyTable,
    measured: &Measured,
    location: &ResultLocation,
) -> Result<Written, OutputProblem> {
    make_folder(&location.folder)?;
    let mut results = Results::new(location);
    let tables = [TABLE, MODES, DECAYING, TEXT, COMPARISON, FIXED, CRITICAL];
    results.remove(tables.into_iter().chain(FAN).chain(CAMPBELL));

    results.text(TABLE, &frequency_csv(table))?;
    results.text(MODES, &mode_csv(table))?;
    results.text(TEXT, &result_text(table, measured))?;
    if table.decaying.iter().any(|motions| !motions.is_empty()) {
        results.text(DECAYING, &decaying_csv(table))?;
    }
    if !measured.points.is_empty() {
        results.text(COMPARISON, &comparison_csv(measured, table))?;
    }
    let is_drawn = results.figures(FAN, || FanPlot::new(table, measured))?;
    if results.draws() && !is_drawn {
        results.written.no_plot = Some(no_plot(table));
    }
    if let Some(fixed) = fixed(table) {
        results.text(FIXED, &campbell_csv(table, &fixed))?;
        results.text(CRITICAL, &critical_csv(table, &fixed.critical))?;
        let plot = || Some(FanPlot::campbell(table, &fixed));
        results.figures(CAMPBELL, plot)?;
    } else if table.is_single_blade && table.speeds.len() > 1 {
        results.text(CRITICAL, &critical_csv(table, &critical_of_blade(table)))?;
    }
    Ok(results.written)
}

fn no_plot(table: &FrequencyTable) -> &'static str {
    match table.speeds.len() {
        0 => "no rotor speed was reached",
        1 => "a single rotor speed makes no lines",
        _ => "there are no modes",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::PathBuf;

    use crate::output::samples;

    fn names(written: &Written) -> Vec<String> {
        let name = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
        written.files.iter().map(name).collect()
    }

    #[test]
    fn all_files_are_written_into_a_new_folder() {
        let folder = tempfile::tempdir().unwrap();
        let results = folder.path().join("a/results");
        let location = ResultLocation::new(&results, "x");
        let written = write(&samples::small(), &samples::measured(), &location).unwrap();
        let expected = [
            "x.frequencies.csv",
            "x.modes.csv",
            "x.frequencies.txt",
            "x.comparison.csv",
            "x.fan.png",
            "x.fan.svg",
        ];
        assert_eq!(names(&written), expected);
        assert!(written.files.iter().all(|path| path.is_file()));
        let text = std::fs::read_to_string(&written.files[2]).unwrap();
        assert!(
            text.contains("\n\nComparison with measurements\n\n"),
            "{text}"
        );
    }

    #[test]
    fn rotors_have_a_campbell_diagram() {
        let folder = tempfile::tempdir().unwrap();
        let location = ResultLocation::new(folder.path(), "x");
        let written = write(&samples::waves(), &Measured::default(), &location).unwrap();
        let expected = [
            "x.campbell.csv",
            "x.critical_speeds.csv",
            "x.campbell.png",
            "x.campbell.svg",
        ];
        assert_eq!(names(&written)[5..], expected);
        write(&samples::small(), &Measured::default(), &location).unwrap();
        let left = expected.map(|name| folder.path().join(name).exists());
        assert_eq!(left, [false; 4]);
    }

    #[test]
    fn a_second_run_leaves_nothing_of_the_first() {
        let folder = tempfile::tempdir().unwrap();
        let mut table = samples::small();
        let location = ResultLocation::new(folder.path(), "x");
        write(&table, &samples::measured(), &location).unwrap();
        table.speeds.truncate(1);
        let written = write(&table, &Measured::default(), &location).unwrap();
        assert_eq!(
            names(&written),
            ["x.frequencies.csv", "x.modes.csv", "x.frequencies.txt"]
        );
        assert_eq!(written.no_plot, Some("a single rotor speed makes no lines"));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 3);
    }
}
