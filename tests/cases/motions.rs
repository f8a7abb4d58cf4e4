//! The cases of the dynamics: the commands of their pages and their results.
//!
//! Commands are the blocks marked `sh` in `cases/dynamics/<name>/README.md`, run in the
//! top folder. `expected.toml` in the same folder has the numbers of runs in time: a
//! `[[value]]` is in the `column` of a `file` of results, `at` a time (linear between two
//! rows), or is the `largest` or `smallest` of the column `between` two times. It is
//! compared with `expected` in the unit of the column, with the tolerance `within`. The
//! comparisons with the same sources in `tests/dynamics` record the numbers for the
//! validation pages; here the shipped files and commands are tested.

use std::fmt::Write;

use serde::Deserialize;

use crate::effort::is_long;
use crate::gallery::{blocks, commands};
use crate::workplace::{Workplace, root};

/// Cases of many modes or periodic motions, which take longer than all others together, and run in the
/// long form only; `tests/dynamics` checks the values of the same models, trims of other rotors in place of
/// `rotor_trim`, modes of a smaller rotor in place of `turbine_modes`, and `turbine_gust` with longer steps;
/// `tiltrotor` is in a file of its own.
const ELSEWHERE: [&str; 7] = [
    "four_blades",
    "ground_resonance",
    "helicopter",
    "rotor_trim",
    "tiltrotor",
    "turbine_gust",
    "turbine_modes",
];

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Expected {
    value: Vec<Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Value {
    file: String,
    column: String,
    at: Option<f64>,
    take: Option<Extreme>,
    between: Option<[f64; 2]>,
    expected: f64,
    within: f64,
    source: String,
}

#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Extreme {
    Largest,
    Smallest,
}

impl Value {
    /// The value in the table, with its unit.
    fn found(&self, table: &str) -> (f64, String) {
        let mut lines = table.lines();
        let headings: Vec<_> = lines.next().unwrap().split(',').collect();
        let first = format!("{} [", self.column);
        let index = headings.iter().position(|text| text.starts_with(&first));
        let index = index.unwrap_or_else(|| panic!("{}: no column {}", self.file, self.column));
        let unit = headings[index][first.len()..].trim_end_matches(']');
        let number = |line: &str, column: usize| -> f64 {
            line.split(',').nth(column).unwrap().parse().unwrap()
        };
        let points: Vec<_> = lines
            .map(|line| [number(line, 0), number(line, index)])
            .collect();
        (self.of(&points), unit.to_owned())
    }

    fn of(&self, points: &[[f64; 2]]) -> f64 {
        let [from, to] = self.between.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        let values = points
            .iter()
            .filter(|point| point[0] >= from && point[0] <= to);
        let values = values.map(|point| point[1]);
        match (self.at, self.take) {
            (Some(time), None) => at(points, time),
            (None, Some(Extreme::Largest)) => values.fold(f64::NEG_INFINITY, f64::max),
            (None, Some(Extreme::Smallest)) => values.fold(f64::INFINITY, f64::min),
            _ => panic!("{}: expected either \"at\" or \"take\"", self.column),
        }
    }

    /// The compared quantity, for the table of the test.
    fn quantity(&self, unit: &str) -> String {
        let column = &self.column;
        match (self.at, self.take) {
            (Some(time), _) => format!("{column} at {time} s [{unit}]"),
            (_, Some(Extreme::Smallest)) => format!("smallest {column} [{unit}]"),
            _ => format!("largest {column} [{unit}]"),
        }
    }
}

/// The value of a curve at `time`: of a row within round-off, or interpolated between two
/// rows.
fn at(points: &[[f64; 2]], time: f64) -> f64 {
    let after = points.iter().position(|point| point[0] >= time - 1e-9);
    let after = after.unwrap_or_else(|| panic!("no row at {time} s"));
    let [t, y] = points[after];
    if after == 0 || (t - time).abs() <= 1e-9 {
        return y;
    }
    let [before, value] = points[after - 1];
    value + (y - value) * (time - before) / (t - before)
}

/// The command with a `*` in the last part of a path replaced by the matching files.
fn expanded(command: &str) -> String {
    let words = command.split_whitespace().map(|word| {
        let Some((first, last)) = word.split_once('*') else {
            return word.to_owned();
        };
        let (folder, start) = first.rsplit_once('/').unwrap();
        let names = std::fs::read_dir(folder).unwrap();
        let names = names.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let mut fitting: Vec<_> = names
            .filter(|name| name.starts_with(start) && name.ends_with(last))
            .map(|name| format!("{folder}/{name}"))
            .collect();
        fitting.sort();
        assert!(!fitting.is_empty(), "{word}: no file");
        fitting.join(" ")
    });
    words.collect::<Vec<_>>().join(" ")
}

/// Runs the commands of a case, and compares all its values before a failure.
fn check(case: &str) {
    let folder = format!("cases/dynamics/{case}");
    let workplace = Workplace::new(&[&folder], ".");
    let page = std::fs::read_to_string(workplace.path(&format!("{folder}/README.md"))).unwrap();
    assert!(
        page.contains("**Expected"),
        "{case}: no line \"**Expected\""
    );
    let mut ran = 0;
    for (_, _, text) in blocks(&page).iter().filter(|block| block.0 == "sh") {
        for command in commands(text) {
            let run = workplace.run(&expanded(&command));
            assert_eq!(run.code, 0, "{command}\n{}", run.err);
            ran += 1;
        }
    }
    assert!(ran > 0, "{case}: README.md has no command");
    let Ok(text) = std::fs::read_to_string(workplace.path(&format!("{folder}/expected.toml")))
    else {
        return;
    };
    let expected: Expected =
        toml::from_str(&text).unwrap_or_else(|error| panic!("{case}: {error}"));
    let mut reported = String::new();
    let mut is_met = true;
    for value in &expected.value {
        let path = format!("{folder}/results/{}.transient.csv", value.file);
        let table = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path}: {e}"));
        let (found, unit) = value.found(&table);
        let error = (found - value.expected).abs();
        let quantity = value.quantity(&unit);
        is_met &= error <= value.within;
        writeln!(
            reported,
            "{quantity:40} expected {:14e} found {found:14e} error {error:8.1e} of {:8.1e}, {}",
            value.expected, value.within, value.source
        )
        .unwrap();
    }
    println!("{case}\n{reported}");
    assert!(is_met, "{case}\n{reported}");
}

/// All cases, one after the other: a new folder in `cases/dynamics` is a new case.
#[test]
fn every_case_of_dynamics_gives_its_expected_values() {
    let mut cases: Vec<_> = std::fs::read_dir(root().join("cases/dynamics"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    cases.sort();
    assert!(cases.len() >= 20, "{cases:?}");
    for case in cases
        .iter()
        .filter(|case| is_long() || !ELSEWHERE.contains(&case.as_str()))
    {
        check(case);
    }
}

#[test]
fn values_are_taken_at_times_and_between_them() {
    let points = [[0.0, 1.0], [1.0, 3.0], [2.0, -1.0]];
    assert_eq!(
        [0.0, 0.5, 1.0, 1.75].map(|time| at(&points, time)),
        [1.0, 2.0, 3.0, 0.0]
    );
    let text = "file = \"a\"\ncolumn = \"b\"\ntake = \"largest\"\nbetween = [0, 0.5]
expected = 1\nwithin = 0.1\nsource = \"s\"";
    let value: Value = toml::from_str(text).unwrap();
    assert_eq!(
        value.found("time [s],b [mm]\n0,1\n1,3\n"),
        (1.0, "mm".to_owned())
    );
}
