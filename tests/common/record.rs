//! The numbers of the suites, recorded for the validation pages of the book.
//!
//! A test that compares with a source records its result in a line next to its assert. The
//! rows are written to `validation/<suite>/<test>.csv` in the build folder, a file for each
//! test, rewritten in each run; `docs/validation.rs` creates the pages from them.
//!
//! Rows of equal source, case and quantity become one row of the page: the row with the
//! largest error relative to its tolerance.

#![allow(dead_code, reason = "no suite records every kind of row")]

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

const HEADER: [&str; 7] = [
    "source",
    "case",
    "quantity",
    "expected",
    "found",
    "error",
    "tolerance",
];

/// Rows of each test of this run so far.
static ROWS: Mutex<BTreeMap<String, Vec<[String; 7]>>> = Mutex::new(BTreeMap::new());

/// Records a number, its error as defined by the test, and the bound of the error.
pub fn value(
    source: &str,
    case: &str,
    quantity: &str,
    [found, expected]: [f64; 2],
    error: f64,
    tolerance: f64,
) {
    let numbers = [expected, found, error, tolerance].map(|number| format!("{number:e}"));
    push(source, case, quantity, numbers);
}

/// Records the largest error of many numbers (a matrix, a field), and its bound.
pub fn largest(source: &str, case: &str, quantity: &str, error: f64, tolerance: f64) {
    let [error, tolerance] = [error, tolerance].map(|number| format!("{number:e}"));
    let numbers = [String::new(), String::new(), error, tolerance];
    push(source, case, quantity, numbers);
}

/// Records an observed order of convergence and the least required order.
pub fn order(source: &str, case: &str, quantity: &str, found: f64, least: f64) {
    let [least, found] = [least, found].map(|number| format!("{number:e}"));
    push(
        source,
        case,
        quantity,
        [least, found, String::new(), String::new()],
    );
}

fn push(source: &str, case: &str, quantity: &str, numbers: [String; 4]) {
    let [expected, found, error, tolerance] = numbers;
    let [source, case, quantity] = [source, case, quantity].map(str::to_owned);
    let row = [source, case, quantity, expected, found, error, tolerance];
    // The harness names each thread after its test.
    let thread = std::thread::current();
    let test = thread.name().unwrap_or("main").replace("::", ".");
    // The rows of a test that failed while it held the lock are complete.
    let mut rows = ROWS.lock().unwrap_or_else(PoisonError::into_inner);
    let of_test = rows.entry(test.clone()).or_default();
    of_test.push(row);
    write(&test, of_test);
}

/// Rewrites the file of a test, without the rows of earlier runs.
fn write(test: &str, rows: &[[String; 7]]) {
    let build = Path::new(env!("CARGO_TARGET_TMPDIR")).join("..");
    let folder = build.join("validation").join(env!("CARGO_CRATE_NAME"));
    std::fs::create_dir_all(&folder).expect("the build folder can be written");
    let file = folder.join(format!("{test}.csv"));
    let mut table = csv::Writer::from_path(file).expect("the build folder can be written");
    for row in std::iter::once(&HEADER.map(str::to_owned)).chain(rows) {
        table.write_record(row).expect("a row of a table");
    }
    table.flush().expect("the build folder can be written");
}
