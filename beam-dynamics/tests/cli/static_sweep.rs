//! `static` over a parameter: files, reports and exit codes.

use crate::Folder;

/// A clamped strip under a force at its tip, with a parameter.
const STRIP: &str = "units = \"SI\"\n[parameters]\nf = 1\n[properties.p]\nea = 2.8e7\ngay = 9e6\ngaz = 9e6\n\
    gj = 300\neiy = 240\neiz = 3700\nm = 1\niy = 1e-6\niz = 1e-6\n[[blade]]\nname = \"b\"\n\
    properties = \"p\"\npiece = [{ length = 2, elements = 4 }]\n[[load]]\nnode = \"b/tip\"\n\
    force = [0, 0, \"= 1/f\"]\n[static]\n";

#[test]
fn a_sweep_has_a_table_a_figure_and_files_of_each_value() {
    let folder = Folder::new();
    let sweep = "[static.sweep]\nparameter = \"f\"\nvalues = [2, 1, 0.5]\n";
    folder.write("a.dynamics.toml", &format!("{STRIP}{sweep}"));
    let run = folder.run(&["static", "a.dynamics.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    for words in [
        "3 of 3 equilibria",
        "a.sweep.csv",
        "a.sweep.svg",
        "b tip flap [m]",
    ] {
        assert!(run.out.contains(words), "{words}: {}", run.out);
    }
    let table = folder.read("results/a.sweep.csv");
    let flap = |row: &str| row.split(',').nth(2).unwrap().parse::<f64>().unwrap();
    for (row, f) in table.lines().skip(1).zip([2.0, 1.0, 0.5]) {
        // F L^3 / 3 EI and the shear; the square of the slope is neglected.
        let expected = (8.0 / 720.0 + 2.0 / 9e6) / f;
        assert!(
            (flap(row) / expected - 1.0).abs() < 1e-3,
            "{row} {expected}"
        );
    }
    for file in [
        "f_2.static.txt",
        "f_0.5.deformed.png",
        "f_1.displacements.csv",
    ] {
        assert!(
            folder.path(&format!("results/a.sweep/{file}")).exists(),
            "{file}"
        );
    }
    // A value without a model is reported, and the others are kept.
    let wrong = sweep.replace("1, 0.5", "0, 0.5");
    folder.write("a.dynamics.toml", &format!("{STRIP}{wrong}"));
    let run = folder.run(&["static", "a.dynamics.toml", "--no-figures"]);
    assert_eq!(run.code, 1, "{}", run.err);
    assert!(run.err.contains("error: a at f = 0: "), "{}", run.err);
    assert!(run.out.contains("2 of 3 equilibria"), "{}", run.out);
    assert!(folder.read("results/a.sweep.csv").contains("not found"));
    for file in ["a.sweep.png", "a.sweep/f_1.static.txt"] {
        assert!(!folder.path(&format!("results/{file}")).exists(), "{file}");
    }
    // A run without a sweep removes the files of the sweep.
    folder.write("a.dynamics.toml", STRIP);
    let run = folder.run(&["static", "a.dynamics.toml", "--no-figures"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(folder.path("results/a.static.txt").exists());
    assert!(
        !folder.path("results/a.sweep.csv").exists() && !folder.path("results/a.sweep").exists()
    );
}

#[test]
fn wrong_sweeps_are_wrong_input() {
    let folder = Folder::new();
    let sweep = "[static.sweep]\nparameter = \"ff\"\nvalues = [2]\n";
    folder.write("a.dynamics.toml", &format!("{STRIP}{sweep}"));
    let run = folder.run(&["static", "a.dynamics.toml"]);
    assert_eq!(run.code, 2, "{}", run.out);
    for words in [
        "\"ff\" is not one of the [parameters]",
        "did you mean \"f\"?",
    ] {
        assert!(run.err.contains(words), "{words}: {}", run.err);
    }
}
