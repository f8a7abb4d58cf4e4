//! Figures of made-up tables, read back as text.

use shared_geom::error::Explain;
use shared_geom::figure::{CATEGORIES, Color, Drawing, Figure};

use super::{Heading, RunFileProblem, TimePlot, TimeTable};

fn heading(name: &str, unit: &str) -> Heading {
    Heading {
        name: name.to_owned(),
        unit: unit.to_owned(),
        words: String::new(),
    }
}

fn table(file: &str, rows: usize) -> TimeTable {
    let time: Vec<_> = (0..rows).map(|k| 0.01 * k as f64).collect();
    let of = |f: &dyn Fn(f64) -> f64| time.iter().map(|t| f(*t)).collect::<Vec<_>>();
    TimeTable {
        file: file.to_owned(),
        title: "a model".to_owned(),
        headings: vec![
            heading("time", "s"),
            heading("tip_x", "mm"),
            heading("tip_y", "mm"),
            heading("count", "1"),
        ],
        columns: vec![
            of(&|t| t),
            of(&f64::sin),
            of(&f64::cos),
            of(&|t| if t > 1.0 { f64::NAN } else { t }),
        ],
    }
}

/// A table with `count` more columns of zero to two meters.
fn wide(count: usize) -> TimeTable {
    let mut table = table("a.csv", 3);
    for k in 0..count {
        table.headings.push(heading(&format!("place_{k}"), "m"));
        table.columns.push(vec![0.0, 1.0, 2.0]);
    }
    table
}

fn drawn(tables: &[TimeTable], across: &str, wanted: &[&str]) -> Result<Drawing, RunFileProblem> {
    let wanted: Vec<_> = wanted.iter().map(|name| (*name).to_owned()).collect();
    Ok(TimePlot::new(tables, across, &wanted)?.drawing())
}

fn has(drawing: &Drawing, text: &str) -> bool {
    drawing.texts().any(|found| found == text)
}

fn assert_texts(drawing: &Drawing, expected: &[&str]) {
    for text in expected {
        assert!(has(drawing, text), "no \"{text}\"");
    }
}

/// Colors of the lines with more than five points: the colors of curves.
fn colors(drawing: &Drawing) -> Vec<Color> {
    let curves = drawing.lines().filter(|(points, ..)| points.len() > 5);
    curves.map(|(_, color, _)| color).collect()
}

#[test]
fn a_run_has_a_panel_for_each_unit_and_a_color_for_each_column() {
    let one = table("results/a.transient.csv", 400);
    let drawing = drawn(std::slice::from_ref(&one), "time", &[]).unwrap();
    let expected = [
        "a model",
        "tip_x",
        "tip_y",
        "count",
        "length [mm]",
        "count [-]",
        "time [s]",
    ];
    assert_texts(&drawing, &expected);
    let found = colors(&drawing);
    assert_eq!(found.len(), 3);
    assert_ne!(found[0], found[1]);
    let drawing = drawn(&[one], "tip_x", &["tip_y"]).unwrap();
    assert_texts(&drawing, &["tip_x [mm]"]);
}

#[test]
fn runs_of_one_column_are_reported_by_color() {
    let both = ["a", "b"].map(|name| table(&format!("results/{name}.transient.csv"), 100));
    let drawing = drawn(&both, "time", &["tip_x", "count"]).unwrap();
    assert_texts(&drawing, &["a model", "a", "b", "tip_x", "count"]);
    // The line of the second run is drawn as dashes, in both panels.
    let found = colors(&drawing);
    assert_eq!(found.len(), 2);
    assert_eq!(found[0], found[1]);
    let second = CATEGORIES[1];
    assert_ne!(found[0], second);
    let dashes = drawing.lines().filter(|(_, color, _)| *color == second);
    assert!(dashes.count() > 20);
}

#[test]
fn runs_of_many_columns_are_reported_by_tone_and_columns_by_color() {
    let both = ["a", "b"].map(|name| table(&format!("results/{name}.transient.csv"), 100));
    let drawing = drawn(&both, "time", &["tip_*"]).unwrap();
    assert_texts(&drawing, &["a", "b", "tip_x", "tip_y"]);
    assert!(!has(&drawing, "count [-]"));
    let found = colors(&drawing);
    let distinct: std::collections::BTreeSet<_> = found.iter().collect();
    assert_eq!((found.len(), distinct.len()), (4, 4));
    // More runs than tones: one panel per column, and colors for the runs.
    let five = [1, 2, 3, 4, 5].map(|k| table(&format!("r{k}.csv"), 20));
    let found = colors(&drawn(&five, "time", &["tip_*"]).unwrap());
    assert_eq!(found.len(), 10);
    assert_eq!(found[..5], found[5..]);
}

// Folders of a machine are not shown if they are not needed to distinguish the runs.
#[test]
fn runs_are_named_with_as_many_folders_as_it_takes() {
    let names = |files: &[&str]| {
        let tables: Vec<_> = files.iter().map(|file| table(file, 3)).collect();
        let plot = TimePlot::new(&tables, "time", &[]).unwrap();
        plot.run_names().to_vec()
    };
    assert_eq!(names(&["/x/y/a.transient.csv", "b.csv"]), ["a", "b"]);
    assert_eq!(
        names(&["r/a.transient.csv", "r/a.transient.nc"]),
        ["a.transient.csv", "a.transient.nc"]
    );
    assert_eq!(
        names(&["/x/1/results/a.csv", "/x/2/results/a.csv"]),
        ["1/a", "2/a"]
    );
    assert_eq!(names(&["a.csv", "a.csv"]), ["a", "a"]);
}

#[test]
fn gaps_and_columns_without_numbers_are_drawn_as_such() {
    let mut one = table("a.csv", 400);
    for (row, value) in one.columns[1].iter_mut().enumerate() {
        if row % 100 == 50 {
            *value = f64::NAN;
        }
    }
    one.columns[2].fill(f64::NAN);
    let drawing = drawn(&[one], "time", &["tip_*"]).unwrap();
    assert_eq!(colors(&drawing).len(), 5);
    assert_texts(&drawing, &["tip_y (no numbers)"]);
}

#[test]
fn wrong_columns_units_and_times_are_reported() {
    let one = table("results/a.transient.csv", 400);
    let wrong = drawn(std::slice::from_ref(&one), "time", &["tip_z"]).unwrap_err();
    assert_eq!(
        wrong.to_string(),
        "unknown column \"tip_z\" of \"results/a.transient.csv\""
    );
    assert!(wrong.help().unwrap().starts_with("did you mean \"tip_"));
    let wrong = drawn(&[table("a.csv", 1)], "time", &[]).unwrap_err();
    assert!(
        wrong
            .to_string()
            .contains("has 1 row, expected at least two")
    );
    let mut other = table("b.csv", 10);
    other.headings[1].unit = "m".to_owned();
    let wrong = drawn(&[one.clone(), other], "tip_x", &["tip_y"]).unwrap_err();
    assert_eq!(
        wrong.to_string(),
        "column \"tip_x\" of \"b.csv\" is in m, and of another table in mm"
    );
    let mut part = one;
    part.between(0.995, 1.205);
    assert_eq!(part.rows(), 21);
    assert_eq!(part.columns[0][0], 1.0);
}

// Beside a position of one meter, 1e-15 m are zero; alone they are not.
#[test]
fn round_off_is_drawn_flat_with_a_note() {
    let mut one = wide(8);
    for column in &mut one.columns[4..10] {
        column.fill(1e-15);
    }
    let wanted: Vec<_> = (0..8).map(|k| format!("place_{k}")).collect();
    let wanted: Vec<_> = wanted.iter().map(String::as_str).collect();
    let note = "zero up to round-off: at most 1e-15 m";
    let both = drawn(std::slice::from_ref(&one), "time", &wanted).unwrap();
    assert_texts(&both, &[note, "length [m]"]);
    let alone = drawn(&[one], "time", &wanted[..6]).unwrap();
    assert!(!has(&alone, note));
}

#[test]
fn figures_of_thousands_of_columns_are_shortened_or_refused() {
    let mut plot = TimePlot::new(&[wide(2000)], "time", &[]).unwrap();
    // Two of millimetres and one number, and six in each of 334 panels.
    let reported = plot.check_size().unwrap_err().to_string();
    assert!(reported.contains("2003 curves in 336 panels"), "{reported}");
    let left_out = plot.shorten();
    assert_eq!(left_out.len(), 2000 - 60);
    assert_eq!(left_out[0], "place_60");
    plot.check_size().unwrap();
    let text = super::not_drawn_text(&left_out);
    assert!(text.contains("place_67 and 1932 more"), "{text}");
}

// Vectors are not split: four of three components are two panels of six, not seven and five.
#[test]
fn components_of_a_vector_stay_together() {
    let mut one = table("a.csv", 3);
    for k in 0..5 {
        for axis in ["x", "y"] {
            one.headings.push(heading(&format!("n{k}_{axis}"), "m"));
            one.columns.push(vec![0.0, 1.0, 2.0]);
        }
    }
    let mut plot = TimePlot::new(&[one], "time", &["n*".to_owned()]).unwrap();
    assert_eq!(plot.panel_columns(), [6, 4]);
    assert!(plot.shorten().is_empty());
}
