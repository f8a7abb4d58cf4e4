//! `identify`: the modes of a table, and the message without any.

use std::f64::consts::TAU;
use std::fmt::Write;

use crate::Folder;

/// A decay of 3.2 Hz and 0.3 1/s about 5 mm, and a column at rest.
fn table() -> String {
    let mut text = "time [s],tip [mm],still [m]\n".to_owned();
    for k in 0..1500 {
        let time = 0.005 * f64::from(k);
        let value = 5.0 + 3.0 * (-0.3 * time).exp() * (TAU * 3.2 * time).cos();
        writeln!(text, "{time:.4},{value:.9},1").unwrap();
    }
    text
}

#[test]
fn frequencies_and_damping_of_a_table() {
    let folder = Folder::new();
    folder.write("run.transient.csv", &table());
    let run = folder.run(&["identify", "run.transient.csv"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let out = run.out;
    for words in [
        "\"tip\" from 0 s to 7.495 s, 1500 samples",
        "amplitude [mm]",
        "moving block",
        "decrement",
        "run.identified.csv",
    ] {
        assert!(out.contains(words), "{words}: {out}");
    }
    let written = folder.read("run.identified.csv");
    let rows: Vec<Vec<&str>> = written
        .lines()
        .skip(1)
        .map(|row| row.split(',').collect())
        .collect();
    assert_eq!(rows.len(), 3, "{written}");
    for row in rows {
        let number = |k: usize| row[k].parse::<f64>().unwrap();
        // The extremes of 60 samples in a period are off by a part of (2 pi / 60)^2.
        assert!((number(4) / 3.2 - 1.0).abs() < 1e-2, "{written}");
        assert!((number(5) + 0.3).abs() < 1e-2, "{written}");
    }
}

#[test]
fn tables_without_oscillations_are_reported() {
    let folder = Folder::new();
    folder.write("run.csv", &table());
    for (arguments, expected, words) in [
        (
            vec!["--columns", "still"],
            1,
            "\"still\" of \"run.csv\": the record has no oscillation",
        ),
        (vec!["--columns", "tpi"], 2, "did you mean \"tip\"?"),
        (
            vec!["--from", "3", "--to", "1"],
            2,
            "--from 3 is later than --to 1",
        ),
        (
            vec!["--from", "7.45"],
            2,
            "10 samples are too few, expected at least 20",
        ),
        (vec!["--noise", "2"], 2, "expected a number from 0 up to 1"),
    ] {
        let all: Vec<_> = ["identify", "run.csv"]
            .into_iter()
            .chain(arguments)
            .collect();
        let run = folder.run(&all);
        assert_eq!(run.code, expected, "{}", run.err);
        assert!(run.err.contains(words), "{words}: {}", run.err);
    }
}
