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

/// Times in milliseconds give the modes of times in seconds.
#[test]
fn times_have_their_unit() {
    let folder = Folder::new();
    folder.write("run.csv", &table());
    assert_eq!(folder.run(&["identify", "run.csv"]).code, 0);
    let seconds = folder.read("run.identified.csv");
    let mut text = "time [ms],tip [mm],still [m]\n".to_owned();
    for row in table().lines().skip(1) {
        let (time, rest) = row.split_once(',').unwrap();
        let time = 1e3 * time.parse::<f64>().unwrap();
        writeln!(text, "{time:.1},{rest}").unwrap();
    }
    folder.write("run.csv", &text);
    assert_eq!(folder.run(&["identify", "run.csv"]).code, 0);
    let found = folder.read("run.identified.csv");
    let numbers = |text: &str| -> Vec<f64> {
        let cells = text.split(['\n', ',']);
        cells.filter_map(|cell| cell.parse().ok()).collect()
    };
    let (found, expected) = (numbers(&found), numbers(&seconds));
    assert!(found.len() == expected.len() && found.len() > 9);
    for (found, expected) in found.iter().zip(&expected) {
        // Conversions of times move the numbers by round-off, amplified by the filters.
        assert!((found - expected).abs() <= 1e-6 * expected.abs().max(1e-3));
    }

    folder.write("run.csv", &table().replacen("[s]", "[m]", 1));
    let run = folder.run(&["identify", "run.csv"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("the unit of \"time\" is \"m\""),
        "{}",
        run.err
    );
}

/// Missing rows: no interpolation invents the motion in the gap.
#[test]
fn gaps_are_reported() {
    let folder = Folder::new();
    let whole = table();
    let rows = whole.lines().enumerate();
    let kept = rows.filter(|(k, _)| !(500..540).contains(k));
    let text: Vec<&str> = kept.map(|(_, row)| row).collect();
    folder.write("run.csv", &(text.join("\n") + "\n"));
    let run = folder.run(&["identify", "run.csv", "--columns", "tip"]);
    assert_eq!(run.code, 2, "{}", run.err);
    let words = "the record has a gap: from 2.49 s to 2.695 s, 40 times its mean step";
    assert!(run.err.contains(words), "{}", run.err);
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
