//! `section-analyzer layup` and `mesh layup`.

use crate::workplace::Workplace;

/// A layup along the span with all forms of places. Lines are counted in the tests.
const LAYUP: &str = "\
[units]
length = \"mm\"
stress = \"GPa\"

[shape]
chord = { eta = [0, 1], value = [500, 300], course = \"linear\" }
origin = 0.3
airfoils = [{ eta = 0, naca = \"0024\" }, { eta = 1, naca = \"0018\" }]

[[layer]]
name = \"skin\"
material = \"glass\"
thickness = 0.6
fiber_angle = \"30 deg\"

[[layer]]
name = \"cap_upper\"
material = \"glass\"
thickness = { eta = [0, 0.8], value = [4, 2] }
from = { x = 0.45, side = \"suction\" }
to = { x = 0.2, side = \"suction\" }

[[layer]]
name = \"cap_lower\"
material = \"glass\"
thickness = { eta = [0, 0.8], value = [4, 2] }
from = { x = 0.2, side = \"pressure\" }
to = { x = 0.45, side = \"pressure\" }

[[layer]]
name = \"panel\"
material = \"foam\"
thickness = 3
from = { distance = 60, side = \"suction\" }
to = \"cap_upper.start\"

[[layer]]
name = \"inner\"
material = \"glass\"
thickness = 0.4

[[web]]
name = \"web\"
suction = { at = \"cap_upper.start\", shift = 40 }
pressure = { at = \"cap_lower.end\", shift = -40 }
plies = [
  { name = \"web_fore\", material = \"glass\", thickness = 0.5, fiber_angle = \"45 deg\" },
  { name = \"web_core\", material = \"foam\", thickness = 5 },
  { name = \"web_aft\", material = \"glass\", thickness = 0.5 },
]

[material.glass]
e1 = 40
e2 = 10
g12 = 4
nu12 = 0.28
nu23 = 0.4
density = \"1900 kg/m^3\"

[material.foam]
young = 0.1
poisson = 0.3
density = \"80 kg/m^3\"
";

/// From a layup to stiffness, by the commands of the book.
#[test]
fn a_layup_becomes_a_section() {
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", LAYUP);
    let mesh = [
        "mesh",
        "layup",
        "a.layup.toml",
        "--eta",
        "0.5",
        "--out",
        "a.msh",
    ];
    let run = workplace.run(&[&mesh[..], &["--section", "a.section.toml"]].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(
        run.out.contains("materials, regions and angles"),
        "{}",
        run.out
    );
    let section = workplace.read("a.section.toml");
    assert!(section.contains("group = \"skin@pressure\"") && section.contains("\"-30 deg\""));
    let run = workplace.run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let again = workplace.run(&[&mesh[..], &["--section", "a.section.toml"]].concat());
    assert_eq!(again.code, 2);
    assert!(again.err.contains("exists already"), "{}", again.err);
    let run = workplace.run(&["analyze", "a.section.toml", "--no-figures"]);
    assert_eq!(run.code, 0, "{}", run.err);
}

/// Beyond its table the cap is absent, and the place that refers to it remains.
#[test]
fn a_layup_is_described_at_its_stations() {
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", LAYUP);
    let run = workplace.run(&["layup", "a.layup.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    let stations: Vec<&str> = run
        .out
        .split("\n\n")
        .filter(|part| !part.trim().is_empty())
        .collect();
    assert_eq!(stations.len(), 3, "{}", run.out);
    assert!(stations[0].contains("eta 0: chord 500"), "{}", run.out);
    assert!(stations[1].contains("cap_upper") && !stations[2].contains("cap_upper"));
    assert!(stations[2].contains("panel"), "{}", run.out);
}

#[test]
fn mistakes_are_reported_with_their_lines() {
    let cases: [(&str, &str, &str); 8] = [
        (
            "material = \"foam\"\nthickness = 3",
            "material = \"faom\"\nthickness = 3",
            "error: a.layup.toml:32: material \"faom\" is not in the file\n  help: did you mean \"foam\"?",
        ),
        (
            "to = \"cap_upper.start\"",
            "to = \"cap_uper.start\"",
            "a.layup.toml:35: place \"cap_uper.start\" is not in the file\n  help: did you mean \"cap_upper.start\"?",
        ),
        (
            "from = { x = 0.45, side = \"suction\" }",
            "from = \"panel.end\"",
            "a.layup.toml:20: places go in a circle: panel.end -> cap_upper.start -> panel.end",
        ),
        (
            "name = \"inner\"",
            "name = \"skin\"",
            "\"skin\" is the name of another layer, web or fill on line 10",
        ),
        (
            "value = [500, 300]",
            "value = [500]",
            "as many values as positions: 2",
        ),
        (
            "eta = [0, 1]",
            "eta = [0, 0]",
            "ascending positions from 0 to 1",
        ),
        ("naca = \"0024\"", "naca = \"24\"", "is not a NACA airfoil"),
        ("thickness = 0.6", "thickness = 60", "eta 0: "),
    ];
    for (from, to, expected) in cases {
        let workplace = Workplace::new();
        assert!(LAYUP.contains(from), "{from}");
        workplace.write("a.layup.toml", &LAYUP.replacen(from, to, 1));
        let run = workplace.run(&["layup", "a.layup.toml", "--eta", "0"]);
        // a section that cannot be meshed is no wrong input
        let code = if to == "thickness = 60" { 1 } else { 2 };
        assert_eq!(run.code, code, "{to}: {}", run.out);
        assert!(run.err.contains(expected), "{to}: {}", run.err);
    }
    let workplace = Workplace::new();
    workplace.write("a.layup.toml", LAYUP);
    for command in [
        &["layup", "a.layup.toml"][..],
        &["mesh", "layup", "a.layup.toml", "--out", "a.msh"],
    ] {
        let run = workplace.run(&[command, &["--eta", "20%"]].concat());
        assert_eq!(run.code, 2);
        let expected = "expected positions from 0 at the root to 1 at the tip";
        assert!(run.err.contains(expected), "{}", run.err);
    }
}

/// A turbine file of windIO is read as a layup file, and written as one.
#[test]
fn a_turbine_file_becomes_a_layup_file() {
    let workplace = Workplace::new();
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/layup/files/tube.windio.yaml"
    );
    let text = std::fs::read_to_string(file).expect("a file");
    workplace.write("a.yaml", &text);
    let run = workplace.run(&["layup", "a.yaml", "--out", "a.layup.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("5 layers and 1 webs"), "{}", run.out);
    assert!(run.out.contains("remark: line "), "{}", run.out);
    let written = workplace.read("a.layup.toml");
    assert!(written.starts_with("# made of a.yaml\n# "), "{written}");
    assert!(written.contains("\n# line "), "{written}");
    let describe = |file: &str| {
        let run = workplace.run(&["layup", file, "--eta", "0.5"]);
        assert_eq!(run.code, 0, "{}", run.err);
        let rows = run.out.lines().filter(|row| !row.contains("remark: "));
        rows.map(str::to_owned).collect::<Vec<_>>()
    };
    assert_eq!(describe("a.yaml"), describe("a.layup.toml"));
    let again = workplace.run(&["layup", "a.yaml", "--out", "a.layup.toml"]);
    assert_eq!(again.code, 2);
    assert!(again.err.contains("exists already"), "{}", again.err);
    let mesh = ["mesh", "layup", "a.yaml", "--eta", "0.5", "--out", "a.msh"];
    let run = workplace.run(&[&mesh[..], &["--section", "a.section.toml"]].concat());
    assert_eq!(run.code, 0, "{}", run.err);
    let run = workplace.run(&["check", "a.section.toml"]);
    assert_eq!(run.code, 0, "{}", run.err);
}

/// A material that cannot be is refused, or repaired on demand.
#[test]
fn impossible_materials_are_repaired_on_demand() {
    let workplace = Workplace::new();
    let file = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/layup/files/tube.windio.yaml"
    );
    let text = std::fs::read_to_string(file).expect("a file");
    let text = text.replacen("nu: 0.35", "nu: 0.5", 1);
    let text = text.replacen("nu: [0.28, 0.28, 0.4]", "nu: [0.28, 0.28, 1.1]", 1);
    workplace.write("a.yaml", &text);
    let run = workplace.run(&["layup", "a.yaml", "--eta", "0.5"]);
    assert_eq!(run.code, 2);
    assert!(run.err.contains("--repair-materials"), "{}", run.err);
    let run = workplace.run(&["layup", "a.yaml", "--eta", "0.5", "--repair-materials"]);
    assert_eq!(run.code, 0, "{}", run.err);
    assert!(run.out.contains("replaced by 0.49"), "{}", run.out);
    assert!(run.out.contains("multiplied by 0."), "{}", run.out);
}

/// Files that are no layups are named by their format, once.
#[test]
fn other_files_are_no_layups() {
    let workplace = Workplace::new();
    let blade = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../tests/reference/exchange/plain_BeamDyn_Blade.dat"
    );
    workplace.write(
        "blade.dat",
        &std::fs::read_to_string(blade).expect("a file"),
    );
    workplace.write("notes.txt", "dear colleague\n");
    workplace.write("a.dynamics.toml", "[[blade]]\n");
    for (file, words) in [
        (
            "blade.dat",
            "error: blade.dat: this is no layup, but the format BeamDyn",
        ),
        (
            "notes.txt",
            "error: notes.txt: this is no layup, expected NAME.layup.toml",
        ),
        (
            "a.dynamics.toml",
            "error: a.dynamics.toml: this is a dynamics file, expected a layup",
        ),
    ] {
        let run = workplace.run(&["blade", file]);
        assert_eq!(run.code, 2);
        assert!(run.err.starts_with(words), "{}", run.err);
        assert_eq!(run.err.matches("error:").count(), 1, "{}", run.err);
    }
}
