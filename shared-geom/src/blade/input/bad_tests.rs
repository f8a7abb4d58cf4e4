//! Wrong blade files: each is reported with its location, the value found and the remedy.

use std::path::Path;

use crate::blade::{parse, read};

/// A blade of two engineering stations.
const GOOD: &str = "units = \"SI\"
frame = \"helicoid\"
reference_point = \"line\"

[line]
length = 10

[[station]]
arc_length = 0
ea = 7e6
gay = 2e6
gaz = 1e6
gj = 30
eiy = 40
eiz = 900
m = 0.3
iy = 0.01
iz = 0.04

[[station]]
arc_length = 10
ea = 7e6
gay = 2e6
gaz = 1e6
gj = 30
eiy = 40
eiz = 900
m = 0.3
iy = 0.01
iz = 0.04
";

fn reported(text: &str) -> String {
    match parse(text, "a.blade.toml") {
        Ok(reading) => reading.remarks.join("\n"),
        Err(problems) => problems.to_string(),
    }
}

fn assert_reported(text: &str, expected: &[&str]) {
    let shown = reported(text);
    for words in expected {
        assert!(shown.contains(words), "{words} is not in\n{shown}");
    }
}

/// Checks that each text yields the message listed with it.
fn assert_each(cases: &[(String, &str)]) {
    for (text, expected) in cases {
        assert_reported(text, &[expected]);
    }
}

#[test]
fn the_good_file_is_good() {
    assert_eq!(reported(GOOD), "");
}

#[test]
fn a_frame_that_is_not_declared_is_an_error_that_teaches() {
    assert_reported(
        &GOOD.replace("frame = \"helicoid\"\n", ""),
        &[
            "a.blade.toml:1: the file declares no \"frame\": the axes of its numbers",
            "help: frame = \"helicoid\" (x to the tip, y to the leading edge",
            "\"beamdyn\" (x to the suction side",
        ],
    );
    assert_reported(
        &GOOD.replace("\"helicoid\"", "\"hawk2\""),
        &[
            "a.blade.toml:2: \"frame\" is \"hawk2\", expected one of",
            "did you mean \"hawc2\"?",
        ],
    );
    assert_reported(
        &GOOD.replace("\"helicoid\"", "[\"tip\", \"leading edge\", \"lower\"]"),
        &["\"frame\" is [tip, leading edge, lower], expected three directions of a right-handed"],
    );
}

#[test]
fn an_order_that_is_not_declared_is_an_error_that_teaches() {
    let directions = "frame = [\"tip\", \"leading edge\", \"upper\"]";
    let text = GOOD.replace("frame = \"helicoid\"", directions);
    assert_reported(
        &text,
        &[
            "a.blade.toml:2: the file declares axes by their directions and no \"order\"",
            "help: order = [\"Fx\", \"Fy\", \"Fz\", \"Mx\", \"My\", \"Mz\"] is the order of the rows",
        ],
    );
    let order = "\norder = [\"Fx\", \"Fy\", \"Fz\", \"Mx\", \"My\", \"My\"]";
    assert_reported(
        &text.replace(directions, &format!("{directions}{order}")),
        &["a.blade.toml:3: \"order\" is [Fx, Fy, Fz, Mx, My, My], expected each of"],
    );
    assert_reported(
        &GOOD.replace("reference_point = \"line\"\n", ""),
        &[
            "a.blade.toml:1: the file declares no \"reference_point\"",
            "help: reference_point =",
        ],
    );
}

#[test]
fn stations_out_of_order_are_reported_where_they_are() {
    assert_reported(
        &GOOD.replace("arc_length = 0\n", "arc_length = 10\n").replacen(
            "arc_length = 10\nea = 7e6\ngay = 2e6\ngaz = 1e6\ngj = 30\neiy = 40\neiz = 900\nm = 0.3\niy = 0.01\niz = 0.04\n\n[[station]]\narc_length = 10",
            "arc_length = 10\nea = 7e6\ngay = 2e6\ngaz = 1e6\ngj = 30\neiy = 40\neiz = 900\nm = 0.3\niy = 0.01\niz = 0.04\n\n[[station]]\narc_length = 5",
            1,
        ),
        &[
            "a.blade.toml:20: station 2 lies at 5 m, and the station before at 10 m",
            "help: put the stations in order of arc length",
        ],
    );
    assert_reported(
        &GOOD.replace("arc_length = 10", "arc_length = 12"),
        &["a.blade.toml:20: station 2 lies at 12 m, and the line is 10 m long"],
    );
}

// Tension center 0.3 m off, and EA of 7e6 N: the bending stiffness must exceed the entry
// of the matrix given here, so that it is not positive definite.
#[test]
fn a_stiffness_that_is_not_positive_definite_is_reported_with_its_reach() {
    let stiffness =
        "stiffness = [1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1.25, 0, 1, 0, 1]\n";
    let engineering = "ea = 7e6\ngay = 2e6\ngaz = 1e6\ngj = 30\neiy = 40\neiz = 900\n";
    let good = "stiffness = [1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1]\n";
    let text = GOOD
        .replacen(engineering, good, 1)
        .replacen(engineering, stiffness, 1);
    // 1.25 v > 1 for v > 0.8.
    assert_reported(
        &text,
        &[
            "a.blade.toml:15: stiffness is not positive definite from 7.99999",
            "m to 10 m, about station 2 at 10 m: there its smallest scaled eigenvalue is -2.500e-1",
            "help: check the signs of the couplings, and that frame and order agree",
        ],
    );
}

// A strip of 2700 kg/m^3 at 70 GPa has m = EA rho/E = 0.27 kg/m: 2.65 N/m.
#[test]
fn a_weight_for_a_mass_is_remarked() {
    let text = GOOD
        .replace("m = 0.3", "m = 2.65")
        .replace("iy = 0.01", "iy = 1e-3");
    let text = text.replace("iz = 0.04", "iz = 4e-3");
    assert_reported(
        &text,
        &["the mass looks like a weight (N/m), 9.80665 times the mass"],
    );
    // In meters it is no weight in pounds, although 32.174 is nearer to the usual ratio.
    let heavier = text
        .replace("m = 2.65", "m = 7")
        .replace("iy = 1e-3", "iy = 2.7e-3");
    let heavier = reported(&heavier.replace("iz = 4e-3", "iz = 1.1e-2"));
    assert!(heavier.contains("(N/m), 9.80665 times"), "{heavier}");
    assert!(!heavier.contains("lbf/"), "{heavier}");
    let folder = tempfile::tempdir().unwrap();
    let table = "s,A,w\n0,2.0,0.5\n10,2.0,0.5\n";
    let file = with_table(
        folder.path(),
        table,
        "m = { column = \"w\", unit = \"N/m\" }",
    );
    let shown = read_reported(&file);
    let expected =
        "\"N/m\" measures a weight, expected a mass\n  help: a weight in lbf is a mass in lb";
    assert!(shown.contains(expected), "{shown}");
}

#[test]
fn slips_of_the_pen_in_the_line_are_reported() {
    assert_each(&[
        (
            GOOD.replace("length = 10\n\n", "length = -1\n\n"),
            "expected a length greater than zero",
        ),
        (
            GOOD.replace("length = 10\n\n", "course = \"spline\"\n\n"),
            "[line] has neither",
        ),
        (
            GOOD.replace("length = 10\n\n", "length = 10\nspan = [1, 2]\n\n"),
            "[line] has both \"length\" and \"span\", expected one of them",
        ),
        (
            GOOD.replace("length = 10\n\n", "span = [0, 10]\n\n"),
            "[line] has no \"course\", expected \"polyline\" or \"spline\"",
        ),
        (
            GOOD.replace(
                "length = 10\n\n",
                "course = \"spline\"\nspan = [0, 10]\ntwist = [1]\n\n",
            ),
            "\"twist\" lists 1, and \"span\" lists 2",
        ),
        (
            GOOD.replace("\"line\"", "[1, 2, 3]"),
            "\"reference_point\" is a list of 3, expected two lengths, y and z",
        ),
    ]);
}

#[test]
fn slips_of_the_pen_in_the_stations_are_reported() {
    assert_each(&[
        (
            GOOD.replace("gaz", "gax"),
            "unknown key \"gax\" in [[station]] number 1",
        ),
        (
            GOOD.replace("gj = 30", "gj = \"30 N\""),
            "\"N\" measures a force, expected a bending or torsional stiffness",
        ),
        (
            GOOD.replace("\"helicoid\"", "\"beamdyn\""),
            "gives engineering properties (\"ea\") in axes other than Helicoid's",
        ),
        (
            GOOD.replace("ea = 7e6\n", "stiffness = [1, 2]\n"),
            "expected 6 rows of 6 numbers, or the 21",
        ),
        (
            GOOD.replace("arc_length = 0\n", ""),
            "neither \"arc_length\" nor \"eta\"",
        ),
        (
            GOOD.replace("arc_length = 0\n", "arc_length = 0\neta = 0\n"),
            "has both \"arc_length\"",
        ),
        (
            format!("{GOOD}[damping]\n"),
            "[damping] has neither \"proportional\" nor \"times\"",
        ),
        (
            format!("{GOOD}[damping]\nproportional = -1\n"),
            "damping is -1 s, expected zero or more",
        ),
        (
            format!("{GOOD}[damping]\ntimes = [1, 2]\n"),
            "expected six times, one for each",
        ),
        (
            GOOD.replace("[line]", "interpolation = \"cubic\"\n[line]"),
            "\"interpolation\" is \"cubic\", expected one of \"linear\", \"constant\"",
        ),
        (
            GOOD[..GOOD.find("[[station]]").unwrap()].to_owned(),
            "has neither [stations] with a \"file\" nor tables [[station]]",
        ),
    ]);
}

/// One problem does not make known keys unknown.
#[test]
fn no_key_is_unknown_because_of_another_mistake() {
    let line = "length = 10\n\n";
    let points = "course = \"spline\"\nx = [0, \"1 kg\"]\ny = [0, 1]\ntwist = [0, 1]\n\n";
    for text in [
        GOOD.replace(
            "frame = \"helicoid\"",
            "order = [\"Fx\"]\ntwist_positive = \"nose up\"",
        ),
        GOOD.replace(
            "\"helicoid\"",
            "7\norder = [\"Fx\"]\ntwist_positive = \"nose up\"",
        ),
        GOOD.replace(line, points),
        GOOD.replace("reference_point = \"line\"\n", ""),
        GOOD.replace("units = \"SI\"\n", ""),
    ] {
        let shown = reported(&text);
        assert!(
            !shown.is_empty() && !shown.contains("unknown key"),
            "{shown}"
        );
    }
}

/// A blade whose stations are `table`, with `mass` as the column of its mass.
fn with_table(folder: &Path, table: &str, mass: &str) -> std::path::PathBuf {
    std::fs::write(folder.join("t.csv"), table).unwrap();
    let head = &GOOD[..GOOD.find("[[station]]").unwrap()];
    let columns = format!(
        "[stations]\nfile = \"t.csv\"\n[stations.columns]\narc_length = \"s\"\n\
         ea = {{ column = \"A\", factor = 2e6 }}\ngay = {{ value = 2e6 }}\n\
         gaz = {{ value = 1e6 }}\ngj = {{ value = 30 }}\neiy = {{ value = 40 }}\n\
         eiz = {{ value = 900 }}\niy = {{ value = 0.01 }}\niz = {{ value = 0.04 }}\n{mass}\n"
    );
    let file = folder.join("a.blade.toml");
    std::fs::write(&file, format!("{head}{columns}")).unwrap();
    file
}

fn read_reported(file: &Path) -> String {
    match read(file) {
        Ok(reading) => reading.remarks.join("\n"),
        Err(problems) => problems.to_string(),
    }
}

#[test]
fn what_is_wrong_with_a_table_is_reported_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let good = "# a comment\ns,A,w\n0,2.0,0.5\n\n10,2.0,0.5\n";
    let cases = [
        (good.to_owned(), ""),
        (
            good.replace("10,2.0,0.5", "10,2.0"),
            "t.csv:5: the line has 2 columns, expected 3",
        ),
        (
            good.replace("10,2.0,0.5", "10,2.0,0.5,1"),
            "t.csv:5: the line has 4 columns, expected 3",
        ),
        (
            good.replace("10,2.0", "10,2.o"),
            "t.csv:5: column \"A\" has \"2.o\", expected a number",
        ),
        (
            good.replace("10,", "nan,"),
            "t.csv:5: column \"s\" has \"nan\", expected a number",
        ),
        (
            good.replace("s,A,w\n", ""),
            "t.csv:2: the table has numbers in its first line",
        ),
        (
            "s,A,w\n".to_owned(),
            "t.csv:1: the table has no row of numbers",
        ),
        (String::new(), "t.csv:1: the table has no line"),
        (
            good.replace("s,A,w", "s,area,w"),
            "t.csv has no column \"A\" (for \"ea\")",
        ),
        (
            good.replace("s,A,w", "radius,A,w"),
            "has no column \"s\" (for \"arc_length\")",
        ),
        (
            good.replace("\n\n10", "\n-1"),
            "t.csv:4: station 2 lies at -1 m",
        ),
        (
            "s,A,w,x\n0,2.0,0.5,a\n10,2.0,0.5,b\n".to_owned(),
            "t.csv: unused columns: x",
        ),
    ];
    for (table, expected) in cases {
        let shown = read_reported(&with_table(folder.path(), &table, "m = \"w\""));
        assert!(shown.contains(expected), "{expected} is not in\n{shown}");
        assert_eq!(shown.is_empty(), expected.is_empty(), "{shown}");
    }
}

#[test]
fn a_table_or_column_that_is_not_there_is_reported() {
    let folder = tempfile::tempdir().unwrap();
    let good = "s,A,w\n0,2.0,0.5\n10,2.0,0.5\n";
    let shown = read_reported(&with_table(folder.path(), good, "mm = \"w\""));
    assert!(
        shown.contains("unknown key \"mm\" in [stations.columns]"),
        "{shown}"
    );
    assert!(shown.contains("t.csv has no column \"m\", and \"columns\" names no other"));
    std::fs::remove_file(folder.path().join("t.csv")).unwrap();
    let shown = read_reported(&folder.path().join("a.blade.toml"));
    assert!(shown.contains("\"file\": no file \"t.csv\""), "{shown}");
}

// In millimeters the mass of GOOD is a thousand times too large: no weight in pounds.
#[test]
fn a_weight_by_inches_is_offered_for_inches_only() {
    let of = |unit: &str| {
        let text = GOOD
            .replace("m = 0.3", "m = 180")
            .replace("iy = 0.01", "iy = 0.1");
        let text = text.replace("iz = 0.04", "iz = 0.4");
        text.replace(
            "units = \"SI\"",
            &format!("units = {{ length = \"{unit}\" }}"),
        )
    };
    // EA / m = 7e6 / (180 / 0.001) and 7e6 / (180 / 0.0254) m^2/s^2.
    assert_reported(
        &of("mm"),
        &["units of length, force and mass do not fit each other"],
    );
    assert!(!reported(&of("mm")).contains("lbf"));
    let text = of("in").replace("m = 180", "m = 4");
    assert_reported(
        &text,
        &["the mass looks like a weight (lbf/in with inches)"],
    );
}

#[test]
fn files_that_are_not_there_are_reported_with_who_names_them() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("b.csv"), "s\n0\n").unwrap();
    let file = folder.path().join("a.blade.toml");
    let head = GOOD.split("[[station]]").next().unwrap();
    std::fs::write(&file, format!("{head}[stations]\nfile = \"c.csv\"\n")).unwrap();
    let shown = read_reported(&file);
    let expected = "a.blade.toml:9: \"file\": no file \"c.csv\"\n  help: did you mean \"b.csv\"?";
    assert!(shown.contains(expected), "{shown}");
    let before = head.split("[line]").next().unwrap();
    let line = "[line]\nfile = \"d.csv\"\ncourse = \"spline\"\n";
    std::fs::write(&file, format!("{before}{line}")).unwrap();
    let shown = read_reported(&file);
    assert!(shown.contains("\"file\": no file \"d.csv\""), "{shown}");
    assert!(!shown.contains("\"course\""), "{shown}");
    let station = "[[station]]\narc_length = 0\nfile = \"nix.json\"\n";
    std::fs::write(&file, format!("{head}{station}")).unwrap();
    let shown = read_reported(&file);
    let expected = "a.blade.toml:10: \"file\": no file \"nix.json\"\n  help: no file there ends in .json; files there: a.blade.toml";
    assert!(shown.contains(expected), "{shown}");
}

#[test]
fn curvatures_of_arcs_are_reported_in_their_units() {
    let with = |curvature: &str| {
        let arc = format!("[[line.arc]]\nlength = 10\ncurvature = {curvature}\n");
        GOOD.replace("[line]\nlength = 10\n", &arc)
    };
    assert_each(&[
        (
            with("[0, 0, \"0.5 deg\"]"),
            "a.blade.toml:7: \"curvature\": \"deg\" measures an angle, expected a curvature \
             (angle per length)\n  help: units of it: deg/m, rad/m; the inverse of a radius in m \
             is in rad/m",
        ),
        (
            with("0.5"),
            "\"curvature\" is 0.5, expected an array of 3: one over a radius, or angles per \
             length, as in \"5 deg/m\"",
        ),
        (
            with("[0, 0.5]"),
            "expected an array of 3: one over a radius, or angles per length",
        ),
        (
            with("[0, \"a\", \"b\"]"),
            "\"b\" cannot be read, expected a number and a unit, as in \"5 deg/m\"",
        ),
    ]);
}
