//! Modes of a single blade file.

use nalgebra::Vector2;
use shared_geom::blade::{self, Blade, Interpolation, Station};
use shared_geom::line::ReferenceLine;

use crate::{Folder, strip};

/// A folder with a blade file: the strip, 2 m long.
fn folder() -> Folder {
    let folder = Folder::new();
    let section = strip();
    let station = |arc_length| Station {
        arc_length,
        stiffness: section.stiffness,
        mass: section.mass,
    };
    let blade = Blade {
        name: "strip".to_owned(),
        line: ReferenceLine::straight(2.0),
        reference_point: Vector2::zeros(),
        stations: vec![station(0.0), station(2.0)],
        interpolation: Interpolation::Linear,
        damping: None,
        provenance: section.provenance.clone(),
    };
    folder.write("a.blade.json", &blade::write(&blade));
    folder
}

// Clamped and at rest: flap 1 of a uniform beam, 3.5160 sqrt(EI/(m L^4))/2 pi with EI =
// 0.634, m = 0.109, L = 2 is 0.3374 Hz; torsion 1, sqrt(GJ/J)/(4 L), is the twelfth, 81 Hz.
#[test]
fn one_command_gives_the_modes_of_a_blade() {
    let folder = folder();
    let run = folder.run(&["modes", "a.blade.json", "--count", "14"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    assert!(run.out.contains("0.337"), "{}", run.out);
    assert!(run.out.contains("torsion 1"), "{}", run.out);
    let table = folder.read("results/a.frequencies.csv");
    assert!(table.lines().count() > 14, "{table}");
    let hash = shared_geom::hash::sha256_of_content(folder.read("a.blade.json").as_bytes());
    let file = format!(",a.blade.json {}", shared_geom::hash::fingerprint(&hash));
    let modes = folder.read("results/a.modes.csv");
    let mut rows = modes.lines().skip(1);
    assert!(rows.all(|row| row.ends_with(&file)), "{file}: {modes}");
    let run = folder.run(&["check", "a.blade.json"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(
        run.out.contains("20 beams, 1 clamp, mass 0.218 kg"),
        "{}",
        run.out
    );
}

#[test]
fn options_mount_the_blade() {
    let folder = folder();
    let options = [
        "--speeds",
        "0,300",
        "--hub-radius",
        "0.2",
        "--root",
        "hinged",
    ];
    let more = [
        "--blades",
        "2",
        "--elements",
        "6",
        "--precone",
        "-2",
        "--pitch",
        "5",
        "--count",
        "6",
    ];
    let run = folder.run(&[&["modes", "a.blade.json"][..], &options, &more].concat());
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
    assert!(run.out.contains("300"), "{}", run.out);
    assert!(folder.path("results/a.fan.svg").exists());
}

#[test]
fn wrong_blade_files_and_options_are_explained() {
    let folder = folder();
    folder.write("words.dat", "some words\nand no numbers\n");
    folder.write("a.dynamics.toml", crate::BLADE);
    for (arguments, expected) in [
        (&["words.dat"][..], "error: words.dat"),
        (&["none.dat"], "none.dat"),
        (
            &["a.dynamics.toml", "--speeds", "3"],
            "error: \"a.dynamics.toml\" is a dynamics file, for which --speeds is not an option\n  help:",
        ),
        (
            &["a.blade.json", "--elements", "0"],
            "'0' for '--elements <N>': expected a whole number, 1 or more",
        ),
        (
            &["a.blade.json", "--speeds=-3"],
            "error: a.blade.json: --speeds has the speed -3 rpm, expected zero or more",
        ),
        (
            &["a.blade.json", "--hub-radius", "nan"],
            "expected a number",
        ),
        (&["a.blade.json", "--root", "clamp"], "clamped"),
        (
            &["a.blade.json", "--hub-radius", "-1"],
            "error: a.blade.json: --hub-radius is -1, expected a length, zero or more",
        ),
        (
            &["a.blade.json", "--length", "-3"],
            "error: a.blade.json: --length is -3, expected a length greater than zero",
        ),
        (
            &["b.blade.json"],
            "error: b.blade.json: cannot be read: no such file",
        ),
    ] {
        let run = folder.run(&[&["modes"][..], arguments].concat());
        assert_eq!(run.code, 2, "{arguments:?}: {}{}", run.out, run.err);
        assert!(run.err.contains(expected), "{arguments:?}: {}", run.err);
        assert!(!folder.path("results").exists());
    }
}

#[test]
fn a_blade_file_requests_no_statics() {
    let folder = folder();
    for command in ["static", "buckling"] {
        let run = folder.run(&[command, "a.blade.json"]);
        assert_eq!(run.code, 2);
        let reported = format!(
            "error: a.blade.json: is a blade file, which has no [{command}], expected a dynamics \
             file\n  help: write a NAME.dynamics.toml with [[blade]] and file = \"a.blade.json\""
        );
        assert!(run.err.starts_with(&reported), "{}", run.err);
    }
}

#[test]
fn a_card_reports_a_missing_blade_file_and_a_mass_that_is_nowhere() {
    let folder = folder();
    let text = "units = \"SI\"\n[[blade]]\nname = \"b\"\nfile = \"aa.blade.json\"\n";
    let message = "error: a.dynamics.toml:4: \"file\": no file \"aa.blade.json\"\n  \
        help: did you mean \"a.blade.json\"?";
    folder.refuses(text, message);
    let mass = "[[blade.mass]]\nat = \"mid\"\nmass = 1\n";
    let message = "error: a.dynamics.toml:6: \"at\" is the text \"mid\", expected a length from the root \
        along the line, or \"tip\"";
    folder.refuses(&(text.replace("aa.blade", "a.blade") + mass), message);
}
