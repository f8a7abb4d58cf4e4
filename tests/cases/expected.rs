//! `expected.toml` of every case: commands and expected values.
//!
//! A `[[run]]` has a `command` and, if it is not 0, its exit `code`; lines that it
//! `prints`; `same_files`, two that are equal after it; and values. A value is in a JSON
//! `file` (by default the property file of the case) `at` a JSON pointer, or is the first
//! number after the text `line` in a line of the output. It is compared with `expected`
//! in `unit` (SI by default), relative to it.

use std::fmt::Write;

use serde::Deserialize;
use shared_geom::units;

use crate::record;
use crate::workplace::{Run, Workplace, root};

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Expected {
    run: Vec<Command>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Command {
    command: String,
    #[serde(default)]
    code: u8,
    #[serde(default)]
    prints: Vec<String>,
    same_files: Option<[String; 2]>,
    #[serde(default)]
    value: Vec<Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Value {
    what: String,
    file: Option<String>,
    at: Option<String>,
    line: Option<String>,
    expected: f64,
    unit: Option<String>,
    tolerance: f64,
    source: String,
}

impl Value {
    /// The value found, in the unit of the expected one.
    fn found(&self, case: &str, run: &Run) -> f64 {
        let unit = self.unit.as_deref().unwrap_or("1");
        self.in_si(case, run) / units::parse(unit).unwrap().factor
    }

    fn in_si(&self, case: &str, run: &Run) -> f64 {
        let what = &self.what;
        if let Some(line) = &self.line {
            let mut lines = run
                .out
                .lines()
                .filter_map(|text| text.trim().strip_prefix(line));
            let rest = lines
                .next()
                .unwrap_or_else(|| panic!("{what}: no line \"{line}\""));
            let mut numbers = rest.split_whitespace().filter_map(|word| word.parse().ok());
            return numbers
                .next()
                .unwrap_or_else(|| panic!("{what}: no number in \"{rest}\""));
        }
        let properties = format!("results/{case}.properties.json");
        let file = self.file.as_ref().unwrap_or(&properties);
        let text = std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{file}: {error}"));
        let json: serde_json::Value = serde_json::from_str(&text).unwrap();
        let at = self.at.as_deref().unwrap_or_default();
        let number = json.pointer(at).and_then(serde_json::Value::as_f64);
        number.unwrap_or_else(|| panic!("{what}: no number at \"{at}\" of {file}"))
    }
}

/// Runs the commands of a case, and compares all its values before a failure.
fn check(case: &str) {
    let folder = format!("cases/section/{case}");
    let workplace = Workplace::new(&[&folder], &folder);
    let text = std::fs::read_to_string(workplace.path(&format!("{folder}/expected.toml"))).unwrap();
    let expected: Expected =
        toml::from_str(&text).unwrap_or_else(|error| panic!("{case}: {error}"));
    let mut table = String::new();
    let mut is_met = true;
    let mut values = 0;
    for command in &expected.run {
        let run = workplace.run(&command.command);
        assert_eq!(run.code, command.code, "{}\n{}", command.command, run.err);
        for line in &command.prints {
            let is_there = run.out.lines().any(|found| found.trim() == line.trim());
            assert!(
                is_there,
                "{}: \"{line}\" is not in\n{}",
                command.command, run.out
            );
        }
        if let Some([one, two]) = &command.same_files {
            let [one, two] = [one, two].map(|file| std::fs::read(file).unwrap());
            assert!(
                one == two,
                "{}: {:?} differ",
                command.command,
                command.same_files
            );
        }
        for value in &command.value {
            let found = value.found(case, &run);
            let error = (found / value.expected - 1.0).abs();
            let compared = [found, value.expected];
            let unit = value
                .unit
                .as_ref()
                .map_or_else(String::new, |unit| format!(" [{unit}]"));
            let quantity = format!("{}{unit}", value.what);
            record::value(
                &value.source,
                case,
                &quantity,
                compared,
                error,
                value.tolerance,
            );
            is_met &= error <= value.tolerance;
            values += 1;
            writeln!(
                table,
                "{quantity:40} expected {:14e} found {found:14e} error {error:8.1e} of {:8.1e}",
                value.expected, value.tolerance
            )
            .unwrap();
        }
    }
    println!("{case}\n{table}");
    assert!(is_met, "{case}\n{table}");
    assert!(values > 0, "{case}: nothing is compared");
}

/// All cases, one after the other: a new folder in `cases/section` is a new case.
#[test]
fn every_case_gives_its_expected_values() {
    let mut cases: Vec<_> = std::fs::read_dir(root().join("cases/section"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    cases.sort();
    assert!(cases.len() >= 4, "{cases:?}");
    for case in &cases {
        let readme = root().join(format!("cases/section/{case}/README.md"));
        let text = std::fs::read_to_string(&readme).unwrap_or_default();
        assert!(
            text.contains("**Expected"),
            "{case}: no README.md with the expected results"
        );
        check(case);
    }
}
