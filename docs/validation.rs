//! Makes the validation pages of the book from the numbers that the tests recorded.
//!
//! ```sh
//! cargo test
//! cargo run --example validation
//! ```
//!
//! A record is used if its test is in the source of its suite and ran after the last
//! change of it; all others are left from earlier builds and are ignored.
//!
//! With `-- --check` it writes nothing, and fails if a page lacks a recorded comparison,
//! shows one that was not recorded, or shows another expected value or tolerance. The
//! values found may differ in the last digits between machines.
//!
//! `tests/common/record.rs` writes the rows: `validation/<suite>/<test>.csv` in the build
//! folder. A suite becomes the page `docs/src/validation-<suite>.md`, a source a table in
//! it. The text depends only on the numbers: errors have two digits, and round-off is
//! rounded up to a power of ten, which is equal on other machines.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use serde::Deserialize;

/// A suite, its folder, the title of its page, and the first sentence of the page.
const PAGES: [[&str; 4]; 5] = [
    [
        "section",
        "tests/section",
        "Sections in numbers",
        "Comparisons of the suite of the sections, by source.",
    ],
    [
        "cases",
        "tests/cases",
        "Cases in numbers",
        "Results of the cases of `cases/section`, by source.",
    ],
    [
        "dynamics",
        "tests/dynamics",
        "Beams in numbers",
        "Comparisons of the suite of the beams, by source.",
    ],
    [
        "chain",
        "tests/chain",
        "Blades in numbers",
        "Comparisons of the chain of both programs, by source.",
    ],
    [
        "air",
        "rotor-aero/tests/air",
        "Rotors in the air in numbers",
        "Comparisons of the suite of the aerodynamics of rotors, by source.",
    ],
];

/// Errors below this are round-off, of which only the order of magnitude is shown.
const ROUND_OFF: f64 = 1e-9;

/// Round-off is not distinguished below this: it differs between machines.
const LEAST: f64 = 1e-14;

/// A row as the tests record it; an observed order has no error, a largest error over
/// many numbers has no single number.
#[derive(Debug, Clone, Deserialize)]
struct Row {
    source: String,
    case: String,
    quantity: String,
    expected: Option<f64>,
    found: Option<f64>,
    error: Option<f64>,
    tolerance: Option<f64>,
}

impl Row {
    /// Error relative to the tolerance; the largest of equal rows is shown.
    fn strain(&self) -> f64 {
        match (self.error, self.tolerance) {
            (Some(error), Some(tolerance)) => error / tolerance,
            _ => -self.found.unwrap_or_default(),
        }
    }

    fn is_round_off(&self) -> bool {
        self.error.is_some_and(|error| error < ROUND_OFF)
    }

    fn cells(&self) -> [String; 4] {
        if self.error.is_none() {
            let least = format!("at least {}", plain(self.expected));
            let found = format!("{:.1}", self.found.unwrap_or_default());
            return [least, found, "-".into(), "-".into()];
        }
        // round-off of a zero has no digits to show
        let found = match (self.expected, self.is_round_off()) {
            (Some(0.0), true) => plain(self.expected),
            _ => plain(self.found),
        };
        [
            plain(self.expected),
            found,
            self.error.map_or_else(String::new, magnitude),
            self.tolerance.map_or_else(String::new, |bound| {
                format!("{bound:.1e}").replace(".0e", "e")
            }),
        ]
    }
}

/// A number with six digits, without trailing zeros; a dash if absent.
fn plain(number: Option<f64>) -> String {
    let Some(number) = number else {
        return "-".into();
    };
    let text = format!("{number:.5e}");
    let rounded: f64 = text.parse().unwrap_or(number);
    if rounded == 0.0 {
        "0".into()
    } else if (1e-3..1e6).contains(&rounded.abs()) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

/// An error with two digits; the next power of ten if it is round-off.
fn magnitude(error: f64) -> String {
    if error >= ROUND_OFF {
        return format!("{error:.1e}");
    }
    let exponent = error.max(LEAST).log10().ceil();
    format!("< 1e{exponent:.0}")
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Makes or checks all pages.
fn run() -> Result<(), Box<dyn Error>> {
    let only_check = std::env::args()
        .skip(1)
        .any(|argument| argument == "--check");
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for [suite, folder, title, opening] in PAGES {
        let rows = read(&records()?.join(suite), &root.join(folder))?;
        let page = root.join(format!("docs/src/validation-{suite}.md"));
        let text = text(suite, title, opening, &rows);
        if !only_check {
            std::fs::write(&page, &text)?;
        } else if lasting(&std::fs::read_to_string(&page)?) != lasting(&text) {
            return Err(outdated(&page, &text)?.into());
        }
        println!("{}: {} rows", page.display(), rows.len());
    }
    Ok(())
}

/// Lists the lines that a page lacks, and the lines that it has too many.
fn outdated(page: &Path, text: &str) -> Result<String, Box<dyn Error>> {
    let written = std::fs::read_to_string(page)?;
    let (known, recorded) = (lasting(&written), lasting(text));
    let mut message = format!("{} differs from the records of the tests\n", page.display());
    let only = |mark: char, lines: &[Vec<&str>], others: &[Vec<&str>]| {
        let lines = lines.iter().filter(|line| !others.contains(line));
        let list: Vec<String> = lines
            .map(|line| format!("  {mark} {}\n", line.join(" | ")))
            .collect();
        list.concat()
    };
    message += &only('-', &known, &recorded);
    message += &only('+', &recorded, &known);
    message += "help: cargo test, then cargo run --example validation";
    Ok(message)
}

/// The part of a page that is equal on all machines: all except the columns of the found
/// value and the error.
fn lasting(page: &str) -> Vec<Vec<&str>> {
    let columns = |line| {
        let cells: Vec<&str> = str::split(line, " | ").collect();
        match cells[..] {
            [case, quantity, expected, _, _, tolerance] => {
                vec![case, quantity, expected, tolerance]
            }
            _ => cells,
        }
    };
    page.lines().map(columns).collect()
}

/// Folder in which the tests record their rows: in the build folder, which contains this
/// program.
fn records() -> Result<PathBuf, Box<dyn Error>> {
    let program = std::env::current_exe()?;
    // <build folder>/debug/examples/validation
    let build = program.ancestors().nth(3).ok_or("not in a build folder")?;
    Ok(build.join("validation"))
}

/// Whether the test of a record, `<module>.<test>.csv`, is in the source of its suite and
/// ran after the last change of it.
fn is_current(record: &Path, source: &Path) -> Result<bool, Box<dyn Error>> {
    let name = record.file_stem().and_then(|name| name.to_str());
    let Some((module, test)) = name.and_then(|name| name.rsplit_once('.')) else {
        return Ok(false);
    };
    let file = source.join(format!("{}.rs", module.replace('.', "/")));
    let Ok(text) = std::fs::read_to_string(&file) else {
        return Ok(false);
    };
    let ran = std::fs::metadata(record)?.modified()?;
    let changed = std::fs::metadata(&file)?.modified()?;
    Ok(text.contains(&format!("fn {test}(")) && ran >= changed)
}

/// All rows of a suite: tests in the order of their names, rows as recorded.
fn read(folder: &Path, source: &Path) -> Result<Vec<Row>, Box<dyn Error>> {
    let entries = std::fs::read_dir(folder)
        .map_err(|error| format!("{}: {error}; run the tests first", folder.display()))?;
    let files: Result<Vec<_>, _> = entries.map(|entry| entry.map(|e| e.path())).collect();
    let mut files = files?;
    files.sort();
    let mut rows = Vec::new();
    for file in files {
        if !is_current(&file, source)? {
            continue;
        }
        for row in csv::Reader::from_path(file)?.deserialize() {
            merge(&mut rows, row?);
        }
    }
    Ok(rows)
}

/// Adds a row, or replaces the equal row if the new one is nearer to failing. Of rows with
/// round-off, which of them is nearer differs between machines: the first remains, with the
/// largest error.
fn merge(rows: &mut Vec<Row>, row: Row) {
    let key = |row: &Row| (row.source.clone(), row.case.clone(), row.quantity.clone());
    let is_alike = |known: &Row| {
        known.is_round_off() && row.is_round_off() && known.tolerance == row.tolerance
    };
    match rows.iter_mut().find(|known| key(known) == key(&row)) {
        Some(known) if is_alike(known) && known.strain() < row.strain() => known.error = row.error,
        Some(known) if is_alike(known) => {}
        Some(known) if known.strain() < row.strain() => *known = row,
        Some(_) => {}
        None => rows.push(row),
    }
}

fn text(suite: &str, title: &str, opening: &str, rows: &[Row]) -> String {
    let mut by_source: BTreeMap<&str, Vec<&Row>> = BTreeMap::new();
    for row in rows {
        by_source.entry(&row.source).or_default().push(row);
    }
    let mut page = format!(
        "# {title}\n\n{opening}\n\
         Made by `cargo run --example validation` from the numbers that `cargo test --test {suite}` recorded; \
         do not edit.\n\n\
         The error is measured as in the test, the tolerance is the test's, with its reason there.\n\
         If a comparison runs on several meshes, cells or speeds, the row shows the one nearest to its tolerance.\n\
         An error of round-off is shown by the power of ten above it; of several the row has the largest, and the numbers of the first.\n\
         The overview is in [Validation](validation.md).\n"
    );
    for (source, rows) in by_source {
        // Writing into a text cannot fail.
        let _ = write!(
            page,
            "\n## {source}\n\n| case | quantity | expected | found | error | tolerance |\n\
             | --- | --- | --- | --- | --- | --- |\n"
        );
        for row in rows {
            let cells = row.cells().join(" | ");
            let _ = writeln!(page, "| {} | {} | {cells} |", row.case, row.quantity);
        }
    }
    page
}
