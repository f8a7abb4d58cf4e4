//! The files of one result.

use std::path::{Path, PathBuf};

use shared_geom::files::{OutputProblem, make_folder, write_text};

use super::{
    FanPlot, comparison_csv, comparison_text, convention, frequency_csv, frequency_text, mode_csv,
};
use crate::result::{FrequencyTable, Measured};

/// Endings of all files that a result can have.
const ENDINGS: [&str; 6] = [TABLE, MODES, TEXT, COMPARISON, PNG, SVG];
const TABLE: &str = "frequencies.csv";
const MODES: &str = "modes.csv";
const TEXT: &str = "frequencies.txt";
const COMPARISON: &str = "comparison.csv";
const PNG: &str = "fan.png";
const SVG: &str = "fan.svg";

/// Files written, in order, and what was left out.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Written {
    /// The files.
    pub files: Vec<PathBuf>,
    /// Why there is no fan plot, if there is none.
    pub no_plot: Option<&'static str>,
    /// Columns that the figure of a run leaves out.
    pub not_drawn: Vec<String>,
}

/// The text of a result: the frequency table, the comparison with the measurements if
/// there are any, and what it all means.
pub fn result_text(table: &FrequencyTable, measured: &Measured) -> String {
    let comparison = match measured.points.is_empty() {
        true => String::new(),
        false => comparison_text(measured, table) + "\n",
    };
    format!(
        "{}\n{comparison}{}",
        frequency_text(table),
        convention(table)
    )
}

/// Writes `NAME.frequencies.csv`, `NAME.modes.csv`, `NAME.frequencies.txt`, with measurements
/// `NAME.comparison.csv`, and for two speeds or more `NAME.fan.png` and `NAME.fan.svg`
/// into `folder`, which is made when it does not exist. Those that an earlier run left
/// there and this one does not have are removed.
///
/// # Errors
/// [`OutputProblem`]: the folder or a file cannot be written.
pub fn write(
    table: &FrequencyTable,
    measured: &Measured,
    folder: &Path,
    name: &str,
) -> Result<Written, OutputProblem> {
    make_folder(folder)?;
    let path = |ending: &str| folder.join(format!("{name}.{ending}"));
    for ending in ENDINGS {
        // One that does not exist is no problem.
        let _ = std::fs::remove_file(path(ending));
    }

    let mut written = Written::default();
    let mut texts = vec![
        (TABLE, frequency_csv(table)),
        (MODES, mode_csv(table)),
        (TEXT, result_text(table, measured)),
    ];
    if !measured.points.is_empty() {
        texts.push((COMPARISON, comparison_csv(&measured.compare(table))));
    }
    for (ending, text) in texts {
        let path = path(ending);
        write_text(&path, &text)?;
        written.files.push(path);
    }
    match FanPlot::new(table, measured) {
        Some(plot) => {
            for ending in [PNG, SVG] {
                plot.save(&path(ending))?;
                written.files.push(path(ending));
            }
        }
        None => written.no_plot = Some(no_plot(table)),
    }
    Ok(written)
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
    use crate::output::samples;

    fn names(written: &Written) -> Vec<String> {
        let name = |path: &PathBuf| path.file_name().unwrap().to_string_lossy().into_owned();
        written.files.iter().map(name).collect()
    }

    #[test]
    fn all_files_are_written_into_a_new_folder() {
        let folder = tempfile::tempdir().unwrap();
        let results = folder.path().join("a/results");
        let written = write(&samples::small(), &samples::measured(), &results, "x").unwrap();
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
    fn a_second_run_leaves_nothing_of_the_first() {
        let folder = tempfile::tempdir().unwrap();
        let mut table = samples::small();
        write(&table, &samples::measured(), folder.path(), "x").unwrap();
        table.speeds.truncate(1);
        let written = write(&table, &Measured::default(), folder.path(), "x").unwrap();
        assert_eq!(
            names(&written),
            ["x.frequencies.csv", "x.modes.csv", "x.frequencies.txt"]
        );
        assert_eq!(written.no_plot, Some("a single rotor speed makes no lines"));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 3);
    }
}
