//! The case `tiltrotor`: hover, conversion and gusts by the files of its page; its flutter is compared in
//! `tests/dynamics/whirl_flutter`.

use crate::workplace::Workplace;

const CASE: &str = "cases/dynamics/tiltrotor";

/// Numbers of a column of a table over its first column.
fn column(workplace: &Workplace, file: &str, name: &str) -> Vec<[f64; 2]> {
    let path = workplace.path(&format!("{CASE}/results/{file}"));
    let table = std::fs::read_to_string(&path).unwrap();
    let mut lines = table.lines();
    let mut headings = lines.next().unwrap().split(',');
    let index = headings.position(|text| text.split(" [").next() == Some(name));
    let index = index.unwrap_or_else(|| panic!("{file}: no column {name}"));
    let number = |line: &str, index: usize| line.split(',').nth(index).unwrap().parse().unwrap();
    lines
        .map(|line| [number(line, 0), number(line, index)])
        .collect()
}

/// Values between two times.
fn between(rows: &[[f64; 2]], [from, to]: [f64; 2]) -> impl Iterator<Item = f64> + '_ {
    let rows = rows
        .iter()
        .filter(move |row| from <= row[0] && row[0] <= to);
    rows.map(|row| row[1])
}

fn mean(rows: &[[f64; 2]], span: [f64; 2]) -> f64 {
    between(rows, span).sum::<f64>() / between(rows, span).count() as f64
}

fn largest(rows: &[[f64; 2]], span: [f64; 2]) -> f64 {
    between(rows, span).map(f64::abs).fold(0.0, f64::max)
}

fn run(workplace: &Workplace, command: &str, file: &str) {
    let run = workplace.run(&format!(
        "beam-dynamics {command} {CASE}/{file}.dynamics.toml"
    ));
    assert_eq!(run.code, 0, "{file}: {}", run.err);
}

// The numbers of the page: half of the gross weight at -30.0 degrees, and a collective that rises with the
// thrust, by less and less, as the induced velocity grows with its root.
#[test]
fn hover_has_the_collective_pitch_of_its_page() {
    let workplace = Workplace::new(&[CASE], ".");
    run(&workplace, "trim", "hover");
    let pitch = column(&workplace, "hover.trim.csv", "collective");
    let [_, _, _, _, [load, at_weight]] = pitch[..] else {
        panic!("{pitch:?}");
    };
    assert!(
        load == 28900.0 && (at_weight + 30.0).abs() < 0.05,
        "{pitch:?}"
    );
    let slopes: Vec<_> = pitch
        .windows(2)
        .map(|two| (two[1][1] - two[0][1]) / (two[1][0] - two[0][0]))
        .collect();
    assert!(slopes.iter().all(|slope| *slope > 0.0), "{slopes:?}");
    assert!(slopes.windows(2).all(|two| two[1] < two[0]), "{slopes:?}");
}

// The conversion of figure 11.14 of the thesis: the wind passes the disk along the shaft at its end, and the
// thrust falls from 32 to 10 kN at the same collective; the wing is twisted most at its start and, by less,
// at its abrupt end.
#[test]
fn the_thrust_falls_in_the_conversion() {
    let workplace = Workplace::new(&[CASE], ".");
    run(&workplace, "transient", "conversion");
    let of = |name: &str| column(&workplace, "conversion.transient.csv", name);
    let nacelle = of("nacelle");
    assert!((mean(&nacelle, [1.0, 1.5]) + 90.0).abs() < 0.3);
    assert!((mean(&nacelle, [3.0, 3.0]) + 45.0).abs() < 1.0);
    assert!(largest(&nacelle, [5.0, 5.5]) < 0.5);
    let thrust = of("thrust");
    assert!((mean(&thrust, [1.0, 1.5]) - 32.0).abs() < 0.5);
    assert!((mean(&thrust, [5.0, 5.5]) - 10.0).abs() < 0.3);
    let torsion = of("torsion");
    let [start, turning, end] =
        [[1.5, 2.5], [3.0, 3.5], [4.3, 5.0]].map(|span| largest(&torsion, span));
    assert!(
        (start - 14.6).abs() < 0.5 && (end - 10.6).abs() < 0.5,
        "{start} {end}"
    );
    assert!(turning < 0.5 * end, "{turning} {end}");
}

// Figures 11.15 and 11.16 of the thesis: off the downstop the pylon moves more in a gust, and its motion
// decays more slowly. Two seconds after the gust the tip on the downstop moves by 4 % of its largest motion.
#[test]
fn a_gust_moves_more_off_the_downstop() {
    let workplace = Workplace::new(&[CASE], ".");
    let [on, off] = ["gust_on", "gust_off"].map(|file| {
        run(&workplace, "transient", file);
        let table = format!("{file}.transient.csv");
        ["tip_z", "pitch"].map(|name| {
            let rows = column(&workplace, &table, name);
            [[0.1, 0.6], [2.5, 3.0]].map(|span| largest(&rows, span))
        })
    });
    for (on, off) in on.iter().zip(&off) {
        assert!(off[0] > 1.2 * on[0], "{on:?} {off:?}");
        assert!(off[1] / off[0] > 1.2 * on[1] / on[0], "{on:?} {off:?}");
    }
    let [tip, _] = on;
    assert!(tip[1] < 0.05 * tip[0], "{tip:?}");
}
