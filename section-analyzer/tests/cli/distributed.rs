//! Distributed loads and end effects in the section file.

use crate::workplace::{Run, SECTION, Workplace};

/// The section with more text at its end, from line 21 on, and changes of its mesh.
fn with(more: &str, mesh_changes: &[(&str, &str)]) -> Workplace {
    let workplace = Workplace::with(&[], mesh_changes);
    workplace.write("a.section.toml", &format!("{SECTION}{more}"));
    workplace
}

fn run(more: &str, command: &str) -> (Workplace, Run) {
    let workplace = with(more, &[]);
    let run = workplace.run(&[command, "a.section.toml"]);
    (workplace, run)
}

/// Words of a text with one space between them.
fn squeezed(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

const GUST: &str = "\
[load.gust]
[[load.gust.traction]]
curve = \"edge\"
pressure = \"1 MPa\"
along = [1, 0.5]
[[load.gust.traction]]
curve = 3
force = [\"1 kPa\", 0, 0]
[[load.gust.volume]]
region = \"web\"
acceleration = [0, 0, \"-10 m/s^2\"]
[[load.gust.volume]]
force = [0, \"2 MN/m^3\", 0]
";

/// On 1 mm of the lower side, pushed up: 1 kN/m, half a millimeter from the origin; on
/// 1 mm^2 of the right cell, pulled down: 0.0785 N/m; on both, 4 N/m to the right, at
/// half a millimeter of height; 1 kPa along, 1 N/m.
#[test]
fn loads_along_the_beam_are_recovered() {
    for command in ["analyze", "stress"] {
        let (workplace, run) = run(GUST, command);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        let report = squeezed(&workplace.read("results/a.gust.stress.txt"));
        for line in [
            "axial 1.00000e0",
            "shear y 4.00000e0",
            "shear z 9.99921e2",
            "torsion 4.97882e-1",
            "bending z -5.00000e-4",
            "the work of its stresses on the central solutions differs",
        ] {
            assert!(report.contains(line), "{command} {line}: {report}");
        }
        for words in [
            "with a load along the beam, shown at the end",
            "pressure 1000000 Pa on curve \"edge\", times 1 + 500 x",
            "force [1000, 0, 0] Pa on curve \"3\"",
            "acceleration [0, 0, -10] m/s^2 in region \"web\"",
            "force [0, 2000000, 0] N/m^3 everywhere",
        ] {
            assert!(report.contains(words), "{command} {words}: {report}");
        }
        assert!(workplace.path("results/a.gust.stress.vtu").exists());
    }
}

/// A load of the command line replaces all loads of the file.
#[test]
fn a_load_of_the_command_line_has_no_distributed_part() {
    let workplace = with(GUST, &[]);
    let run = workplace.run(&["stress", "a.section.toml", "--axial", "1 N"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    assert!(!run.out.contains("Distributed load"), "{}", run.out);
}

/// Loads with about every possible mistake.
const WRONG: &str = "\
[load.none]
[[load.gust.traction]]
curve = \"edges\"
pressure = 1
[[load.gust.traction]]
curve = \"edge\"
[[load.gust.traction]]
curve = \"edge\"
pressure = 1
force = [1, 0, 0]
[[load.gust.volume]]
region = \"wed\"
force = [1, 0, 0]
along = []
[[load.gust.volume]]
acceleration = [1, 0]
along = [0]
[[load.gust.traction]]
curve = \"bare\"
tangential = \"3 mm\"
[[load.tip.volume]]
region = \"wed\"
force = [1, 0, 0]
";

#[test]
fn everything_wrong_with_loads_along_the_beam_is_reported_at_once() {
    let workplace = with(WRONG, &[]);
    let text = format!("end_effects = 21\n{}", workplace.read("a.section.toml"));
    workplace.write("a.section.toml", &text);
    let run = workplace.run(&["check", "a.section.toml"]);
    println!("{}", run.err);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    for (line, reported) in [
        (
            1,
            "\"end_effects\" is 21, expected a whole number from 1 to 20",
        ),
        (22, "load \"none\" is zero, expected at least one of"),
        (
            26,
            "the traction has no \"pressure\", \"tangential\" or \"force\", expected one of them",
        ),
        (
            31,
            "the traction has \"pressure\" and \"force\", expected one of them",
        ),
        (35, "expected an array of 1 to 9 numbers, not all zero"),
        (
            37,
            "\"acceleration\" is an array of 2, expected an array of 3",
        ),
        (38, "expected an array of 1 to 9 numbers, not all zero"),
        (41, "\"mm\" measures a length, expected a stress"),
        (24, "the mesh has no physical curve \"edges\""),
        (43, "the mesh has no physical surface \"wed\""),
    ] {
        let start = format!("error: a.section.toml:{line}: ");
        let found = run
            .err
            .lines()
            .any(|l| l.starts_with(&start) && l.contains(reported));
        assert!(found, "{line} {reported}:\n{}", run.err);
    }
    assert!(run.err.contains("did you mean \"edge\"?"), "{}", run.err);
    assert!(run.err.contains("did you mean \"web\"?"), "{}", run.err);
}

/// Loads that are zero, numbers beyond all structures, and wrong names together with
/// wrong values.
const EMPTY: &str = "\
[load.gust]
point = [1, 0]
[[load.gust.traction]]
curve = \"edge\"
pressure = 0
[[load.gust.volume]]
acceleration = [0, 0, 0]
[[load.gust.traction]]
curve = \"edge\"
pressure = 1
along = [1, 1e21]
[load.single.traction]
curve = \"edge\"
pressure = 1
[load.wrong]
shear_z = \"2 K\"
[[load.wrong.traction]]
curve = \"edges\"
pressure = \"x\"
[[load.wrong.volume]]
group = \"web\"
region = \"wed\"
force = [1, 2]
[load.Gust]
axial = 1
";

#[test]
fn loads_without_effect_and_names_beside_wrong_values_are_reported() {
    let run = with(EMPTY, &[]).run(&["check", "a.section.toml"]);
    println!("{}", run.err);
    assert_eq!(run.code, 2);
    for (line, reported) in [
        (22, "load \"gust\" has a \"point\", but no force or moment"),
        (23, "the traction is zero, expected a nonzero number"),
        (26, "the volume force is zero, expected a nonzero number"),
        (
            31,
            "number 2 of \"along\" is 1e24 in SI units, expected at most 1e20",
        ),
        (36, "\"K\" measures"),
        (38, "the mesh has no physical curve \"edges\""),
        (41, "unknown key \"group\""),
        (42, "the mesh has no physical surface \"wed\""),
        (43, "\"force\" is an array of 2, expected an array of 3"),
        (
            44,
            "load \"Gust\" differs from load \"gust\" on line 21 only in upper and lower case",
        ),
    ] {
        let start = format!("error: a.section.toml:{line}: ");
        let mut lines = run.err.lines();
        let found = lines.any(|l| l.starts_with(&start) && l.contains(reported));
        assert!(found, "{line} {reported}:\n{}", run.err);
    }
    assert!(run.err.contains("did you mean \"region\"?"), "{}", run.err);
    assert!(!run.err.contains("load \"single\" is zero"), "{}", run.err);
}

#[test]
fn curves_inside_and_curves_of_no_cell_are_reported() {
    let pressed = "[[load.a.traction]]\ncurve = \"edge\"\npressure = 1\n";
    with(pressed, &[("13 1 2 3 1 1 2", "13 1 2 3 1 2 5")]).is_refused(&[
        "error: a.section.toml:22: curve \"edge\" has cells on both sides of line 13, \
         expected a pressure on a surface",
        "  help: the direction of the pressure is undetermined: give \"force\" in section axes, \
         or name a curve on the outline or around a hole",
    ]);
    with(pressed, &[("13 1 2 3 1 1 2", "13 1 2 3 1 1 5")]).is_refused(&[
        "error: a.section.toml:22: line 13 of curve \"edge\", at (0.0005, 0.0005) m, is \
         not a side of a cell, expected a curve along sides of cells",
        "  help: in gmsh, make the physical curve of curves that bound surfaces of the section",
    ]);
    with("[[load.a.traction]]\ncurve = \"bare\"\npressure = 1\n", &[]).is_refused(&[
        "error: a.section.toml:22: physical curve \"bare\" has no lines in the mesh, expected at \
         least one",
    ]);
    // a force may act inside
    let force = "[[load.a.traction]]\ncurve = \"edge\"\nforce = [0, 0, 1]\n";
    let workplace = with(force, &[("13 1 2 3 1 1 2", "13 1 2 3 1 2 5")]);
    assert_eq!(workplace.run(&["stress", "a.section.toml"]).code, 0);
}

/// Two linear cells: plausible numbers, one for each requested end effect, and the text.
#[test]
fn end_effects_are_reported() {
    let workplace = Workplace::with(&[], &[]);
    let text = format!("end_effects = 3\n{SECTION}");
    workplace.write("a.section.toml", &text);
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let report = workplace.read("results/a.report.txt");
    let (_, part) = report.split_once("End effects: ").unwrap();
    assert!(
        part.contains("End effects fall to 1/e within 0.000"),
        "{part}"
    );
    assert!(part.contains("the beam model holds beyond"), "{part}");
    let rows = part
        .lines()
        .skip(2)
        .take_while(|line| !line.contains("End effects"));
    assert_eq!(rows.count(), 3, "{part}");
    assert!(!part.contains("no further"), "{part}");
    // the mesh has fewer than twenty
    workplace.write("a.section.toml", &format!("end_effects = 20\n{SECTION}"));
    let many = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!((many.code, many.err.as_str()), (0, ""));
    let reported = "The mesh has no further end effects.";
    assert!(many.out.contains(reported), "{}", many.out);
    assert!(!run.out.is_empty());
}
