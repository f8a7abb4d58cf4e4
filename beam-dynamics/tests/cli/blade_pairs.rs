//! `compare`, blades without shear stiffness, and blades written into existing files.

use std::f64::consts::PI;

use shared_geom::section::SectionProperties;

use crate::exchange::table_of;
use crate::{Folder, strip};

/// The strip without shear stiffness.
fn without_shear() -> SectionProperties {
    let mut section = strip();
    for i in 0..6 {
        for shear in [1, 2] {
            section.stiffness[(shear, i)] = 0.0;
            section.stiffness[(i, shear)] = 0.0;
        }
    }
    section
}

#[test]
fn a_converted_blade_is_equal() {
    let folder = Folder::new();
    folder.write("a.csv", &table_of(&strip()));
    assert_eq!(folder.run(&["convert", "a.csv", "b.inp"]).code, 0);
    let run = folder.run(&["compare", "a.csv", "b.inp"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    assert!(
        run.out.starts_with("Comparison\n  A  a.csv\n  B  b.inp\n"),
        "{}",
        run.out
    );
    assert!(run.out.contains("  frequency flap 1"), "{}", run.out);
    assert!(
        run.out
            .contains("\nEqual within 1e-6: the largest relative difference is ")
    );
}

// Half of the torsional stiffness: 0.5 of it, and torsion is too fast for six modes.
#[test]
fn a_difference_is_shown_with_its_size_and_ends_with_one() {
    let folder = Folder::new();
    folder.write("a.csv", &table_of(&strip()));
    let mut soft = strip();
    soft.stiffness[(3, 3)] *= 0.5;
    folder.write("b.csv", &table_of(&soft));
    let run = folder.run(&["compare", "a.csv", "b.csv"]);
    assert_eq!((run.code, run.err.as_str()), (1, ""));
    let reported = "largest first\n  quantity";
    let at = run
        .out
        .find(reported)
        .unwrap_or_else(|| panic!("{}", run.out));
    let list = &run.out[at..];
    assert!(list.contains("  stiffness torsion "), "{list}");
    assert!(list.contains("5.0e-1  0.0000"), "{list}");
    assert_eq!(
        folder
            .run(&["compare", "a.csv", "b.csv", "--tolerance", "0.51"])
            .code,
        0
    );
}

#[test]
fn what_cannot_be_compared_is_refused() {
    let folder = Folder::new();
    folder.write("a.csv", &table_of(&strip()));
    folder.write("notes.txt", "dear colleague\n");
    let run = folder.run(&["compare", "a.csv", "notes.txt"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(
        run.err
            .starts_with("error: notes.txt: the format of the file is not known")
    );
    let run = folder.run(&["compare", "a.csv", "a.csv", "--tolerance", "-1"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err.contains("expected a number, 0 or more"),
        "{}",
        run.err
    );
    // Without modes the properties are compared all the same.
    folder.write("b.csv", &table_of(&without_shear()));
    let run = folder.run(&["compare", "b.csv", "b.csv"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(
        run.out
            .contains("Frequencies are not compared: b.csv: station 1"),
        "{}",
        run.out
    );
}

// Two stations are reported one by one, three or more as one; with the option, flap 1 and
// lag 1 are as of a beam without shear strain, 1.8751^2 sqrt(EI / m) / (2 pi L^2). Its
// own shear strain lowers them by 3e-6; twenty elements, by less than 1e-6; rotary inertia
// by some 1e-6 in flap and, with a radius of 7 mm in 2 m, by 3e-5 in lag; damping, by 6e-4 in lag.
#[test]
fn blades_without_shear_stiffness_become_rigid_in_shear() {
    let folder = Folder::new();
    let section = without_shear();
    folder.write("a.csv", &table_of(&section));
    let run = folder.run(&["modes", "a.csv"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err
            .contains("help: a section without shear stiffness: --rigid-shear, or rigid_shear = true in [[blade]], makes the blade rigid in shear; it changes only stations whose shear rows are zero throughout, and whose bending stiffness is not"),
        "{}",
        run.err
    );
    let run = folder.run(&["modes", "a.csv", "--rigid-shear", "--count", "6"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(
        run.out
            .contains("rigid in shear: the shear stiffness, which is zero at 2 of 2")
    );
    let table = folder.read("results/a.frequencies.csv");
    let mut rows = table.lines().filter(|line| !line.starts_with('#'));
    let head: Vec<_> = rows.next().unwrap().split(',').collect();
    let hz = head
        .iter()
        .position(|name| name.starts_with("frequency"))
        .unwrap();
    let found: Vec<f64> = rows
        .map(|row| row.split(',').nth(hz).unwrap().parse().unwrap())
        .collect();
    let m = section.mass[(0, 0)];
    for i in [4, 5] {
        let bending = section.stiffness[(i, i)];
        let undamped = 1.875_104_07_f64.powi(2) * (bending / m).sqrt() / (8.0 * PI);
        // The internal damping of the table, 0.002 s, gives the damping ratio pi f 0.002.
        let expected = undamped * (1.0 - (PI * undamped * 0.002).powi(2)).sqrt();
        let nearest = found.iter().map(|f| (f / expected - 1.0).abs());
        let error = nearest.fold(f64::INFINITY, f64::min);
        assert!(error < 1e-4, "{expected} Hz, {error:e}, {found:?}");
    }
    let file = "units = \"SI\"\n[[blade]]\nname = \"b\"\nfile = \"a.csv\"\n";
    folder.write("a.dynamics.toml", file);
    assert_eq!(folder.run(&["check", "a.dynamics.toml"]).code, 2);
    folder.write("a.dynamics.toml", &format!("{file}rigid_shear = true\n"));
    let run = folder.run(&["check", "a.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
}

#[test]
fn helicoid_files_without_shear_stiffness_become_rigid_in_shear() {
    let folder = Folder::new();
    folder.write("a.csv", &table_of(&without_shear()));
    let made = folder.run(&["convert", "a.csv", "b.blade.json"]);
    assert_eq!(made.code, 0, "{}", made.err);
    let run = folder.run(&["modes", "b.blade.json", "--no-figures"]);
    assert_eq!(run.code, 2);
    assert!(
        run.err
            .contains("help: a section without shear stiffness: --rigid-shear")
    );
    let [a, b] = ["a.csv", "b.blade.json"].map(|file| {
        let run = folder.run(&[
            "modes",
            file,
            "--rigid-shear",
            "--no-figures",
            "--count",
            "6",
        ]);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        let stem = file.split('.').next().unwrap();
        let table = folder.read(&format!("results/{stem}.frequencies.csv"));
        let rows = table.lines().filter(|line| !line.starts_with('#'));
        rows.map(str::to_owned).collect::<Vec<_>>()
    });
    assert_eq!(a, b);
}

#[test]
fn words_and_units_of_blade_files_are_options() {
    let folder = Folder::new();
    folder.write("a.csv", &table_of(&strip()));
    let options = [
        "--speeds",
        "0,10.471975511965978 rad/s",
        "--frequency-unit",
        "rpm",
        "--count",
        "4",
    ];
    let run = folder.run(&[&["modes", "a.csv", "--words", "wind"][..], &options].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(
        run.out.contains("edge 1") && !run.out.contains("lag 1"),
        "{}",
        run.out
    );
    let table = folder.read("results/a.frequencies.csv");
    assert!(
        table.lines().any(|line| line.starts_with("100,")),
        "{table}"
    );
    // The strip has its first mode at 3.6 Hz: 2P of 100 rpm is 3.3 Hz.
    let chosen = ["--harmonics", "7,2", "--name-at", "100"];
    let run = folder.run(&[&["modes", "a.csv"][..], &options[..2], &chosen].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let fan = folder.read("results/a.fan.svg");
    for (multiple, is_drawn) in [("2P", true), ("7P", true), ("1P", false)] {
        assert_eq!(fan.contains(&format!("\n{multiple}\n")), is_drawn, "{fan}");
    }
}

#[test]
fn wrong_options_of_blade_files_are_named() {
    let folder = Folder::new();
    folder.write("a.csv", &table_of(&strip()));
    for (option, value, expected) in [
        ("--words", "sea", "[possible values: rotor, wind]"),
        (
            "--frequency-unit",
            "hz",
            "[possible values: Hz, rpm, rad/s, 1/rev]",
        ),
        ("--damping-ratio", "1.5", "--damping-ratio is 1.5"),
        (
            "--harmonics",
            "1,2000",
            "--harmonics has 2000, expected whole numbers from 1 to 1000",
        ),
        ("--harmonics", "1,2.5", "expected a whole number, 1 or more"),
        (
            "--name-at",
            "50",
            "--name-at has the speed 50 rpm, expected some of --speeds",
        ),
        (
            "--speeds",
            "4 m",
            "expected rotation speeds with commas between",
        ),
    ] {
        let run = folder.run(&["modes", "a.csv", option, value]);
        assert_eq!(run.code, 2);
        assert!(run.err.contains(expected), "{}", run.err);
    }
}

#[test]
fn problems_of_all_stations_are_one_in_lists() {
    let folder = Folder::new();
    let table = table_of(&without_shear());
    let last = table.trim_end().rsplit_once('\n').unwrap().1.to_owned();
    let middle = last.replacen('2', "1", 1);
    let table = table.replace(&last, &format!("{middle}\n{last}"));
    folder.write("a.csv", &table);
    let reported = "all 3 stations: stiffness has 0 at (2, 2) (shear y) and at (3, 3) (shear z), \
                    expected more than zero";
    for run in [
        folder.run(&["describe", "a.csv"]),
        folder.run(&["convert", "a.csv", "b.inp"]),
    ] {
        assert_eq!(run.code, 0, "{}", run.err);
        assert_eq!(
            run.out.matches("expected more than zero").count(),
            1,
            "{}",
            run.out
        );
        assert!(run.out.contains(reported), "{}", run.out);
    }
    let run = folder.run(&["convert", "a.csv", "b.inp"]);
    assert!(run.out.contains(
        "Everything is converted, but the blade cannot be analyzed for the problems below"
    ));
    let run = folder.run(&["convert", "a.csv", "c.inp", "--rigid-shear"]);
    assert!(
        run.out.contains("\nEverything is converted\n"),
        "{}",
        run.out
    );
    assert_eq!(folder.run(&["modes", "c.inp", "--count", "6"]).code, 0);
}

#[test]
fn a_blade_is_written_into_a_copy_of_a_windio_file() {
    let folder = Folder::new();
    folder.write("a.csv", &table_of(&strip()));
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
    let path = format!("{root}/tests/reference/exchange/windio2_iea15.yaml");
    let existing = std::fs::read_to_string(path).unwrap() + "# kept\nairfoils: []\n";
    folder.write("turbine.yaml", &existing);
    let run = folder.run(&["convert", "a.csv", "new.yaml", "--into", "turbine.yaml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    assert!(
        run.out.contains("-> a copy of turbine.yaml\n"),
        "{}",
        run.out
    );
    assert!(folder.read("new.yaml").ends_with("# kept\nairfoils: []\n"));
    assert_eq!(folder.read("turbine.yaml"), existing);
    let run = folder.run(&["compare", "a.csv", "new.yaml"]);
    assert_eq!(run.code, 0, "{}", run.out);
    for (to, into, expected) in [
        (
            "turbine.yaml",
            "turbine.yaml",
            "\"turbine.yaml\" would be overwritten",
        ),
        (
            "b.yaml",
            "a.csv",
            "expected a windIO file with components.blade",
        ),
        ("b.yaml", "none.yaml", "none.yaml"),
        ("b.json", "turbine.yaml", "expected the ending .yaml"),
    ] {
        let run = folder.run(&["convert", "a.csv", to, "--into", into]);
        assert_eq!(run.code, 2, "{}", run.out);
        assert!(run.err.contains(expected), "{}", run.err);
    }
}
