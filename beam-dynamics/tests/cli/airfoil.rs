//! `airfoil`: description, figure and conversion of tables, and wrong inputs.

use crate::Folder;

/// Text of a reference file.
fn reference(name: &str) -> String {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/reference/aero/");
    std::fs::read_to_string(format!("{folder}{name}")).unwrap()
}

#[test]
fn a_built_in_airfoil_is_described_and_drawn() {
    let folder = Folder::new();
    let run = folder.run(&["airfoil", "naca0012"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    for expected in [
        "naca0012: built-in airfoil, 1 airfoil\n",
        "angle of attack   -180 to 180 deg\n",
        "Mach number       0.15 to 0.8, ",
        "zero lift [deg]",
        "\nWritten\n  results/naca0012.airfoil.png\n  results/naca0012.airfoil.svg\n",
    ] {
        assert!(run.out.contains(expected), "{expected:?} in:\n{}", run.out);
    }
    assert!(
        folder
            .read("results/naca0012.airfoil.svg")
            .contains("lift cl [-]")
    );
    let run = folder.run(&[
        "airfoil",
        "flat_plate",
        "--no-figures",
        "--out",
        "a/plate.csv",
    ]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("Everything is converted"), "{}", run.out);
    assert!(!folder.path("a/plate.airfoil.svg").exists());
    let run = folder.run(&["airfoil", "a/plate.csv", "--no-figures"]);
    assert!(
        run.out.contains("a/plate.csv: CSV file of airfoils"),
        "{}",
        run.out
    );
}

/// Numbers of DU21 by hand from its table: 1.408 at 8.5 deg is the largest lift up to stall.
#[test]
fn numbers_of_a_table_are_in_the_file() {
    let folder = Folder::new();
    folder.write("du21.csv", &reference("nrel5mw/polar_DU21_A17.csv"));
    let run = folder.run(&["airfoil", "du21.csv", "--no-figures"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let row = run
        .out
        .lines()
        .skip_while(|line| !line.contains("zero lift"))
        .nth(1);
    let cells: Vec<f64> = row
        .unwrap()
        .split_whitespace()
        .map(|cell| cell.parse().unwrap())
        .collect();
    let table = reference("nrel5mw/polar_DU21_A17.csv");
    let points = table.lines().skip(2).map(|line| {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        [cells[0], cells[1], cells[2]]
    });
    let points: Vec<_> = points
        .filter(|point| (0.0..=30.0).contains(&point[0]))
        .collect();
    let largest = points.iter().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap();
    // Columns: zero lift, slope, largest lift and its angle, with three and one digits.
    assert!((cells[2] - largest[1]).abs() < 5.1e-4 && (cells[3] - largest[0]).abs() < 0.051);
    assert!(
        cells[0] < -3.0 && cells[1] > 5.5 && cells[1] < 7.5,
        "{cells:?}"
    );
}

/// The digits of a table return through a CSV file; C81 has six characters for a number.
#[test]
fn conversions_report_the_loss() {
    let folder = Folder::new();
    folder.write("pc.dat", &reference("iea15/hawc2_pc.dat"));
    let name = "t/c 21.1 %";
    let run = |arguments: &[&str]| {
        let run = folder.run(&[&["airfoil"], arguments, &["--no-figures"]].concat());
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{arguments:?}");
        run.out
    };
    let shown = run(&["pc.dat"]);
    assert!(shown.contains("HAWC2 pc file, 8 airfoils"), "{shown}");
    run(&["pc.dat", "--name", name, "--out", "one.csv"]);
    run(&["one.csv", "--out", "two.csv"]);
    assert_eq!(folder.read("one.csv"), folder.read("two.csv"));
    folder.write(
        "long.csv",
        "alpha [deg],cl,cd,cm\n-180,0,0.123456789,0\n0,0.2,0.01,0\n180,0,0.123456789,0\n",
    );
    let shown = run(&["long.csv", "--out", "long.c81"]);
    assert!(shown.contains("Cannot be represented"), "{shown}");
    assert!(run(&["long.c81"]).contains("C81 table, 1 airfoil"));
    let many = folder.run(&["airfoil", "one.csv", "--out", "one.c81"]);
    assert_eq!((many.code, many.out.as_str()), (2, ""));
    assert!(
        many.err.contains("120 angles, expected at most 99"),
        "{}",
        many.err
    );
    assert!(many.err.contains("help: leave angles out"), "{}", many.err);
    run(&["one.csv", "--out", "one.dat", "--to", "aerodyn15"]);
    assert!(run(&["one.dat"]).contains("AeroDyn 15 polar"));
    run(&["one.csv", "--mirror", "--out", "down.csv"]);
    run(&["down.csv", "--mirror", "--out", "up.csv"]);
    let numbers = |name: &str| {
        let text = folder.read(name);
        let cells = text
            .split([',', '\n'])
            .filter_map(|cell| cell.parse::<f64>().ok());
        cells.collect::<Vec<_>>()
    };
    assert_eq!(numbers("up.csv"), numbers("one.csv"));
}

/// Two polars of XFOIL-like angles, described as incomplete and then extended.
#[test]
fn tables_that_end_before_180_deg_are_extended() {
    let folder = Folder::new();
    let polar = |reynolds: &str| {
        format!(
            "airfoil,reynolds,alpha [deg],cl,cd,cm\na,{reynolds},-10,-0.8,0.02,0\n\
             a,{reynolds},0,0.2,0.01,0\na,{reynolds},12,1.3,0.03,0\n"
        )
    };
    folder.write("1.csv", &polar("1e6"));
    folder.write("2.csv", &polar("2e6"));
    let run = folder.run(&["airfoil", "1.csv", "2.csv"]);
    assert_eq!((run.code, run.err.as_str()), (2, ""));
    assert!(
        run.out
            .contains("Reynolds number   1000000 to 2000000, 2 values"),
        "{}",
        run.out
    );
    assert!(run.out.contains("\nWrong\n"), "{}", run.out);
    assert!(
        run.out.contains("-10 to 12 deg, expected -180 to 180 deg"),
        "{}",
        run.out
    );
    let more = ["--viterna=17", "--out", "full.csv", "--no-figures"];
    let run = folder.run(&[&["airfoil", "1.csv", "2.csv"], &more[..]].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(!run.out.contains("\nWrong\n"), "{}", run.out);
    // 1.11 + 0.018 * 17 at 90 deg.
    assert!(
        folder.read("full.csv").contains("1.416"),
        "{}",
        folder.read("full.csv")
    );
}

/// A folder of a good table, tables with faults, and no table.
fn faults() -> Folder {
    let folder = Folder::new();
    for (name, rows) in [
        ("good.csv", "-180,0,0.1,0\n0,0.2,0.1,0\n180,0,0.1,0\n"),
        ("gap.csv", "-180,0,0.1,0\n0,,,\n10,1\n180,0,0.1,0\n"),
        (
            "back.csv",
            "-180,0,0.1,0\n20,1,0.1,0\n10,1,0.1,0\n180,0,0.1,0\n",
        ),
    ] {
        folder.write(name, &format!("alpha [deg],cl,cd,cm\n{rows}"));
    }
    folder.write("notes.txt", "dear colleague\n");
    folder.write("blade.dat", &reference("iea15/AeroDyn15_blade.dat"));
    folder.write("strip.blade.toml", "[format]\n");
    folder
}

/// Files of blades are named as what they are, with the command that reads them.
#[test]
fn files_of_blades_are_no_airfoils() {
    let folder = faults();
    for (file, expected, help) in [
        (
            "blade.dat",
            "\"blade.dat\" is the geometry of a blade (AeroDyn 15 blade), expected tables of an airfoil",
            "name it as \"file\" of [rotor] in a rotor file, NAME.rotor.toml, and run \
             \"beam-dynamics performance NAME.rotor.toml\"",
        ),
        (
            "strip.blade.toml",
            "\"strip.blade.toml\" is a blade file, of stiffness and mass, expected tables of an airfoil",
            "run \"beam-dynamics check strip.blade.toml\"",
        ),
    ] {
        let run = folder.run(&["airfoil", file, "--no-figures"]);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{file}");
        for part in [expected, help] {
            assert!(run.err.contains(part), "{part:?} in:\n{}", run.err);
        }
    }
}

/// A polar has the constants of one table.
#[test]
fn constants_of_one_table_are_counted() {
    let folder = Folder::new();
    folder.write("a.dat", &reference("iea15/AeroDyn15_Polar_20.dat"));
    let run = folder.run(&["airfoil", "a.dat", "--no-figures"]);
    assert!(
        run.out.contains("unsteady          constants of 1 table\n"),
        "{}",
        run.out
    );
}

#[test]
fn wrong_inputs_have_remedies() {
    let folder = faults();
    for (arguments, expected, help) in [
        (
            vec!["none.dat"],
            "\"none.dat\" is neither a file nor",
            "naca0012",
        ),
        (
            vec!["naca0021"],
            "\"naca0021\" is neither",
            "did you mean \"naca0012\"?",
        ),
        (vec!["gap.csv"], "gap.csv:4: ", "help: "),
        (vec!["back.csv"], "back.csv:4: ", "help: "),
        (vec!["notes.txt"], "dear colleague", "help: "),
        (
            vec!["good.csv", "--name", "god"],
            "no airfoil \"god\" in the file",
            "good",
        ),
        (
            vec!["good.csv", "--out", "a.dat"],
            "belongs to no written format",
            "--to",
        ),
        (
            vec!["good.csv", "--out", "good.csv"],
            "but it is the input",
            "another name",
        ),
        (
            vec!["good.csv", "--out", "a.x", "--to", "pdf"],
            "invalid value 'pdf'",
            "aerodyn15",
        ),
        (
            vec!["good.csv", "--viterna=-3"],
            "expected an aspect ratio above zero",
            "12",
        ),
        (vec!["good.csv", "--to", "csv"], "--out", "Usage"),
    ] {
        let run = folder.run(&[&["airfoil", "--no-figures"], &arguments[..]].concat());
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
        for part in [expected, help] {
            assert!(run.err.contains(part), "{part:?} in:\n{}", run.err);
        }
        // Rows out of order are no absent tables.
        assert!(!run.err.contains("is missing"), "{}", run.err);
    }
}
