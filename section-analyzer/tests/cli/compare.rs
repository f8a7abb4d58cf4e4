//! `compare`: equal and different sections, and exit codes.

use nalgebra::Matrix6;
use shared_geom::section;

use crate::workplace::Workplace;

/// A folder with the property file `a.json` of two squares of steel.
fn squares() -> Workplace {
    let workplace = Workplace::with(&[], &[]);
    assert_eq!(workplace.run(&["analyze", "a.section.toml"]).code, 0);
    let text = workplace.read("results/a.properties.json");
    workplace.write("a.json", &text);
    workplace
}

/// Writes `b.json`: `a.json` with a change.
fn changed(workplace: &Workplace, change: impl Fn(&mut section::SectionProperties)) {
    let mut properties = section::read(&workplace.path("a.json")).unwrap();
    change(&mut properties);
    workplace.write("b.json", &section::write(&properties));
}

/// The same section about another point, in other axes, and both: equal to round-off, and
/// the output states the changes. As given they differ.
#[test]
fn a_moved_section_is_the_same() {
    let workplace = squares();
    let out = ["--out", "b.json"];
    let moved = [
        ["shift", "a.json", "--to", "0.5 mm, -0.3 mm"],
        ["rotate", "a.json", "--angle", "30 deg"],
    ];
    let said = [
        "reference point moved by (-0.0005, 0.0003) m",
        "axes turned by -30 deg about +x",
    ];
    for (arguments, said) in moved.iter().zip(said) {
        assert_eq!(workplace.run(&[&arguments[..], &out].concat()).code, 0);
        let run = workplace.run(&["compare", "a.json", "b.json", "--tolerance", "1e-14"]);
        assert_eq!((run.code, run.err.as_str()), (0, ""), "{}", run.out);
        assert!(
            run.out
                .contains(&format!("B is transformed to A: {said}\n")),
            "{}",
            run.out
        );
        assert!(run.out.contains("\nEqual within 1e-14: "), "{}", run.out);
        let run = workplace.run(&["compare", "a.json", "b.json", "--as-given"]);
        assert_eq!((run.code, run.err.as_str()), (1, ""));
        assert!(run.out.contains("\nDifferent: "), "{}", run.out);
    }
}

/// A coupling of a thousandth of sqrt(Kii Kjj), inserted by hand.
#[test]
fn the_worst_entries_are_named_and_the_exit_code_reports() {
    let workplace = squares();
    changed(&workplace, |b| {
        let scale = (b.stiffness[(0, 0)] * b.stiffness[(3, 3)]).sqrt();
        b.stiffness[(0, 3)] += 1e-3 * scale;
        b.stiffness[(3, 0)] += 1e-3 * scale;
        b.centers.shear.x += 1e-9;
    });
    let run = workplace.run(&["compare", "a.json", "b.json"]);
    assert_eq!((run.code, run.err.as_str()), (1, ""));
    let (_, verdict) = run
        .out
        .split_once("Different: 2 of 54 numbers by more than 1e-6")
        .unwrap();
    let lines: Vec<_> = verdict.lines().skip(2).collect();
    assert!(
        lines[0].starts_with("  stiffness  axial-torsion "),
        "{verdict}"
    );
    assert!(lines[0].ends_with("  N m   +1.0e-3"), "{verdict}");
    assert!(lines[1].starts_with("  center     shear y "), "{verdict}");
    for (tolerance, code) in [("0.99e-3", 1), ("1.01e-3", 0), ("0", 1)] {
        let run = workplace.run(&["compare", "a.json", "b.json", "--tolerance", tolerance]);
        assert_eq!(run.code, code, "{tolerance}");
    }
    assert_eq!(
        workplace
            .run(&["compare", "a.json", "a.json", "--tolerance", "0"])
            .code,
        0
    );
}

#[test]
fn a_section_without_mass_is_reported() {
    let workplace = squares();
    changed(&workplace, |b| b.mass = Matrix6::zeros());
    let run = workplace.run(&["compare", "a.json", "b.json"]);
    assert_eq!((run.code, run.err.as_str()), (1, ""));
    assert!(
        run.out.contains("\nUnlike\n  only A has mass\n"),
        "{}",
        run.out
    );
    assert!(
        !run.out.contains("NaN") && !run.out.contains("inf"),
        "{}",
        run.out
    );
    let run = workplace.run(&["compare", "b.json", "b.json"]);
    assert_eq!(run.code, 0);
    assert!(
        run.out
            .contains("\nMass per length\n  neither section has mass\n"),
        "{}",
        run.out
    );
}

#[test]
fn what_only_one_has_is_reported() {
    let workplace = squares();
    changed(&workplace, |b| {
        b.thermal_force = Some([1.0, 0.0, 0.0, 0.0, 0.0, 0.0].into())
    });
    let run = workplace.run(&["compare", "a.json", "b.json"]);
    assert_eq!(run.code, 1);
    assert!(
        run.out.contains("\nUnlike\n  only B has a thermal force\n"),
        "{}",
        run.out
    );
    assert!(
        run.out
            .contains("\nThe numbers of both are equal within 1e-6: "),
        "{}",
        run.out
    );
}

#[test]
fn lines_are_short_and_nothing_is_written() {
    let workplace = squares();
    changed(&workplace, |b| b.stiffness *= 1.1);
    let files = || std::fs::read_dir(workplace.path("")).unwrap().count();
    let before = files();
    let run = workplace.run(&["compare", "a.json", "b.json"]);
    assert!(
        run.out.lines().all(|line| line.chars().count() <= 110),
        "{}",
        run.out
    );
    assert!(run.out.contains("+1.0e-1"), "{}", run.out);
    assert_eq!(files(), before);
}
