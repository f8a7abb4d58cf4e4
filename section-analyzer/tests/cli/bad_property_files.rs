//! Property files that cannot be read, and commands that do not apply to them.

use shared_geom::section;

use crate::workplace::Workplace;

fn steel() -> Workplace {
    let workplace = Workplace::with(&[], &[]);
    assert_eq!(workplace.run(&["analyze", "a.section.toml"]).code, 0);
    let text = workplace.read("results/a.properties.json");
    workplace.write("a.json", &text);
    workplace
}

/// Every command reports the same problem of a file that it cannot read, and writes
/// nothing.
#[test]
fn files_that_are_no_property_files_are_refused_by_all_commands() {
    let workplace = steel();
    let good = workplace.read("a.json");
    let first_row = good
        .lines()
        .position(|line| line == "  \"stiffness\": [")
        .unwrap()
        + 1;
    let number = good.lines().nth(first_row).unwrap().trim().to_owned();
    let cases = [
        (
            "{}",
            "error: b.json:1: not a property file: it has no \"format\", expected \"helicoid",
        ),
        (
            "mesh = \"a.msh\"",
            "error: b.json:1: not a property file: it is not JSON",
        ),
        (
            "",
            "error: b.json:1: not a property file: the file is empty",
        ),
        (
            &good.replace("\"version\": 1", "\"version\": 4"),
            "error: b.json:3: written in version 4 of the property-file format, expected at most 3",
        ),
        (
            &good.replace("helicoid section properties", "something else"),
            "error: b.json:2: not a property file: \"format\" is \"something else\"",
        ),
        (
            &good.replace(&number, &number.replacen("[", "[NaN, ", 1)),
            "error: b.json:9: not a property file: not JSON at column 6: expected value",
        ),
        (
            &good.replace(&number, &number.replacen('[', "[1e400, ", 1)),
            "error: b.json:9: not a property file: number out of range",
        ),
        (
            &good.replace(&number, &number.replacen('[', "[-", 1)),
            "error: b.json:8: stiffness has -",
        ),
    ];
    for (text, start) in cases {
        workplace.write("b.json", text);
        for arguments in [
            &["report", "b.json"][..],
            &["compare", "a.json", "b.json"],
            &["compare", "b.json", "a.json"],
            &["shift", "b.json", "--to", "0,0", "--out", "c.json"],
            &["rotate", "b.json", "--angle", "1 deg", "--out", "c.json"],
        ] {
            let run = workplace.run(arguments);
            assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
            assert!(run.err.starts_with(start), "{arguments:?}: {}", run.err);
        }
    }
    assert!(!workplace.path("c.json").exists());
}

#[test]
fn all_files_that_are_missing_are_reported() {
    let workplace = steel();
    let run = workplace.run(&["compare", "none.json", "neither.json"]);
    let expected = "error: none.json: cannot be read: no such file\n  help: files there: a.json\n\
                    error: neither.json: cannot be read: no such file\n  help: files there: a.json\n";
    assert_eq!((run.code, run.err.as_str()), (2, expected));
    let run = workplace.run(&["report", "none.json", "a.json", "neither.json"]);
    assert_eq!((run.code, run.err.as_str()), (2, expected));
    assert!(run.out.starts_with("Section \"a\"\n"), "{}", run.out);
    assert_eq!(run.out.matches("Section \"").count(), 1);
}

#[test]
fn the_input_is_never_overwritten() {
    let workplace = steel();
    let before = workplace.read("a.json");
    std::fs::create_dir(workplace.path("deep")).unwrap();
    for out in ["a.json", "./a.json", "deep/../a.json"] {
        let run = workplace.run(&["shift", "a.json", "--to", "1 m, 1 m", "--out", out]);
        assert_eq!(
            (run.code, run.err.as_str()),
            (
                2,
                "error: --out names the file that is read, \"a.json\", expected another one\n  \
                 help: the input is never overwritten\n"
            )
        );
        let run = workplace.run(&["rotate", "a.json", "--angle", "1 deg", "--out", out]);
        assert_eq!((run.code, run.out.as_str()), (2, ""));
    }
    assert_eq!(workplace.read("a.json"), before);
}

#[test]
fn points_and_angles_must_be_reported_with_sense() {
    let workplace = steel();
    let cases = [
        (
            ["shift", "--to", "sheer-center"],
            "did you mean \"shear-center\"?",
        ),
        (
            ["shift", "--to", "middle"],
            "expected Y,Z as in \"25 mm, 0\", or tension-center",
        ),
        (["shift", "--to", "1"], "expected Y,Z"),
        (
            ["shift", "--to", "nan,0"],
            "expected a length with its unit",
        ),
        (
            ["shift", "--to", "1 kg, 0"],
            "\"kg\" measures a mass, expected a length",
        ),
        (
            ["rotate", "--angle", "30"],
            "it has no unit, expected an angle with its unit",
        ),
        (
            ["rotate", "--angle", "inf deg"],
            "expected an angle with its unit",
        ),
        (
            ["rotate", "--to-principal", "torsion"],
            "possible values: bending, inertia",
        ),
    ];
    for ([command, option, value], expected) in cases {
        let run = workplace.run(&[command, "a.json", option, value, "--out", "b.json"]);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{value}");
        assert!(run.err.contains(expected), "{}", run.err);
    }
    assert!(!workplace.path("b.json").exists());
}

#[test]
fn options_must_be_complete_and_exclude_each_other() {
    let workplace = steel();
    for arguments in [
        &["shift", "a.json", "--out", "b.json"][..],
        &["shift", "a.json", "--to", "0,0"],
        &["rotate", "a.json", "--out", "b.json"],
        &[
            "rotate",
            "a.json",
            "--angle",
            "1 deg",
            "--to-principal",
            "bending",
            "--out",
            "b.json",
        ],
        &["compare", "a.json"],
        &["compare", "a.json", "a.json", "--tolerance", "-1e-3"],
        &["compare", "a.json", "a.json", "--tolerance", "nan"],
        &["report"],
    ] {
        let run = workplace.run(arguments);
        assert_eq!((run.code, run.out.as_str()), (2, ""), "{arguments:?}");
    }
    assert!(!workplace.path("b.json").exists());
}

#[test]
fn centers_of_mass_need_mass() {
    let workplace = steel();
    let mut properties = section::read(&workplace.path("a.json")).unwrap();
    properties.mass.fill(0.0);
    workplace.write("b.json", &section::write(&properties));
    let run = workplace.run(&["shift", "b.json", "--to", "mass-center", "--out", "c.json"]);
    assert_eq!(
        run.err,
        "error: section \"a\" has no mass, expected one for the mass center\n"
    );
    assert_eq!(run.code, 2);
    let run = workplace.run(&[
        "rotate",
        "b.json",
        "--to-principal",
        "inertia",
        "--out",
        "c.json",
    ]);
    assert_eq!(run.code, 2);
    let run = workplace.run(&["shift", "b.json", "--to", "shear-center", "--out", "c.json"]);
    assert_eq!(run.code, 0);
}

/// So far away that the section's own stiffness is lost in round-off of Steiner's terms.
#[test]
fn a_point_out_of_reach_is_refused() {
    let workplace = steel();
    for to in ["1e9 m, 0", "0, 1e20 m"] {
        let run = workplace.run(&["shift", "a.json", "--to", to, "--out", "b.json"]);
        assert_eq!((run.code, run.out.as_str()), (2, ""));
        assert!(
            run.err
                .contains("error: the changed section is not sound: "),
            "{}",
            run.err
        );
        assert!(
            run.err.contains("help: the new point is too far"),
            "{}",
            run.err
        );
    }
    assert!(!workplace.path("b.json").exists());
    let run = workplace.run(&["shift", "a.json", "--to", "1 m,1 m", "--out", "no/b.json"]);
    assert_eq!(
        run.err,
        "error: file \"no/b.json\" cannot be written: its folder does not exist\n"
    );
    assert_eq!(run.code, 2);
}
