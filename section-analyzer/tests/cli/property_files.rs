//! Commands that work with property files: report, compare, shift, rotate.

use nalgebra::Matrix6;
use shared_geom::section::{self, Change, SectionProperties};

use crate::workplace::{Run, Workplace};

/// A strip of carbon at 30 degrees next to one of steel, off the origin: all internal
/// forces except the shear along z are coupled, and all centers are different.
const COUPLED: [(&str, &str); 2] = [
    (
        "[[region]]\ngroup = \"skin\"\nmaterial = \"steel\"",
        "[material.carbon]\ne1 = 140\ne2 = 10\ne3 = 10\nnu12 = 0.3\nnu13 = 0.3\nnu23 = 0.4\n\
         g12 = 5\ng13 = 5\ng23 = 3.5\ndensity = \"1600 kg/m^3\"\n\n\
         [[region]]\ngroup = \"skin\"\nmaterial = \"carbon\"\nfiber_angle = 30\nplane_angle = 20",
    ),
    ("fiber_angle = 0\nplane_angle = 0\n", ""),
];

/// A folder with the property file `a.json` of [`COUPLED`].
fn coupled() -> Workplace {
    let workplace = Workplace::with(&COUPLED, &[]);
    let run = workplace.run(&["analyze", "a.section.toml"]);
    assert_eq!((run.code, run.err.as_str()), (0, ""));
    let text = workplace.read("results/a.properties.json");
    workplace.write("a.json", &text);
    workplace
}

fn properties(workplace: &Workplace, file: &str) -> SectionProperties {
    section::read(&workplace.path(file)).unwrap()
}

/// Runs a command that must succeed.
fn good(workplace: &Workplace, arguments: &[&str]) -> Run {
    let run = workplace.run(arguments);
    assert_eq!((run.code, run.err.as_str()), (0, ""), "{arguments:?}");
    run
}

/// Shifts the first file into the second.
fn shift(workplace: &Workplace, [from, out]: [&str; 2], to: &str) -> Run {
    good(workplace, &["shift", from, "--to", to, "--out", out])
}

/// Rotates the first file into the second.
fn rotate(workplace: &Workplace, [from, out]: [&str; 2], angle: &str) -> Run {
    good(workplace, &["rotate", from, "--angle", angle, "--out", out])
}

/// Largest difference of two matrices, relative to sqrt(Aii Ajj).
fn relative(a: &Matrix6<f64>, b: &Matrix6<f64>) -> f64 {
    let root = a.diagonal().map(f64::sqrt);
    (b - a).component_div(&(root * root.transpose())).amax()
}

/// Checks that two files contain the same section to `tolerance`, in all transformed
/// data: matrices relative to sqrt(Aii Ajj), positions relative to the size of 1 mm,
/// angles.
fn same(workplace: &Workplace, a: &str, b: &str, tolerance: f64) {
    let (a, b) = (properties(workplace, a), properties(workplace, b));
    assert!(relative(&a.stiffness, &b.stiffness) < tolerance);
    assert!(relative(&a.mass, &b.mass) < tolerance);
    let workplaces = [
        (a.reference_point, b.reference_point),
        (a.centers.tension, b.centers.tension),
        (a.centers.shear, b.centers.shear),
        (a.centers.mass, b.centers.mass),
    ];
    for (a, b) in workplaces {
        assert!((b - a).amax() < 1e-3 * tolerance, "{a} {b}");
    }
    let (a, b) = (a.principal_axes, b.principal_axes);
    assert!((b.bending_angle - a.bending_angle).abs() < tolerance);
    assert!((b.inertia_angle - a.inertia_angle).abs() < tolerance);
    assert_eq!(
        (b.bending_stiffness, b.inertia),
        (a.bending_stiffness, a.inertia)
    );
}

/// There and back: a few products with round-off 1e-16 each, with a shift of the size of
/// the section.
#[test]
fn shift_and_back_is_where_it_began() {
    let workplace = coupled();
    shift(&workplace, ["a.json", "b.json"], "0.7 mm, -4e-4 m");
    shift(&workplace, ["b.json", "c.json"], "-0.7 mm,0.4 mm");
    same(&workplace, "a.json", "c.json", 1e-14);
    let (a, b) = (
        properties(&workplace, "a.json"),
        properties(&workplace, "b.json"),
    );
    assert!(relative(&a.stiffness, &b.stiffness) > 0.1);
    assert!((b.centers.shear - a.centers.shear).amax() > 5e-4);
}

#[test]
fn rotate_and_back_is_where_it_began() {
    let workplace = coupled();
    rotate(&workplace, ["a.json", "b.json"], "40 deg");
    rotate(&workplace, ["b.json", "c.json"], "-40 deg");
    same(&workplace, "a.json", "c.json", 1e-14);
    let (a, b) = (
        properties(&workplace, "a.json"),
        properties(&workplace, "b.json"),
    );
    assert!(relative(&a.stiffness, &b.stiffness) > 0.1);
    let turned = b.principal_axes.bending_angle - a.principal_axes.bending_angle;
    assert!((turned + 40.0_f64.to_radians()).abs() < 1e-14);
}

/// The mesh moved by (0.7, -0.4) mm has its section at another position: the reference
/// point of the first, moved by the opposite, is the reference point of the second. The
/// two solutions agree to their own round-off, 1e-11 after the shift.
#[test]
fn a_shifted_file_is_that_of_the_moved_mesh() {
    let workplace = coupled();
    shift(&workplace, ["a.json", "b.json"], "-0.7 mm, 0.4 mm");
    let mut mesh = workplace.read("two.msh");
    for (tag, y, z) in [
        (1, 0, 0),
        (2, 1, 0),
        (3, 2, 0),
        (4, 0, 1),
        (5, 1, 1),
        (6, 2, 1),
    ] {
        let moved = format!("\n{tag} {} {} 0\n", f64::from(y) + 0.7, f64::from(z) - 0.4);
        mesh = mesh.replacen(&format!("\n{tag} {y} {z} 0\n"), &moved, 1);
    }
    workplace.write("two.msh", &mesh);
    good(&workplace, &["analyze", "a.section.toml"]);
    let files = ["results/a.properties.json", "b.json"];
    let run = good(
        &workplace,
        &[
            "compare",
            files[0],
            files[1],
            "--as-given",
            "--tolerance",
            "1e-11",
        ],
    );
    assert!(
        run.out
            .contains("(0, 0) m for A, (-0.0007, 0.0004) m for B: as given"),
        "{}",
        run.out
    );
}

#[test]
fn provenance_keeps_the_source_and_says_what_was_done() {
    let workplace = coupled();
    shift(&workplace, ["a.json", "b.json"], "25 mm, 0");
    rotate(&workplace, ["b.json", "c.json"], "0.5 rad");
    let (a, c) = (
        properties(&workplace, "a.json"),
        properties(&workplace, "c.json"),
    );
    assert_eq!(c.provenance.input_hash, a.provenance.input_hash);
    assert!(a.provenance.history.is_empty());
    let changes: Vec<_> = c
        .provenance
        .history
        .iter()
        .map(|step| step.change)
        .collect();
    assert_eq!(
        changes,
        [Change::Shift([0.025, 0.0].into()), Change::Rotate(0.5)]
    );
    assert!(
        c.provenance
            .history
            .iter()
            .all(|step| step.program == "section-analyzer")
    );
    let report = good(&workplace, &["report", "c.json"]).out;
    for line in [
        "  history   reference point moved by (0.025, 0) m by section-analyzer 0.1.0",
        "            axes turned by 28.6479 deg about +x by section-analyzer 0.1.0",
        "  point     reference point at (0.0219396, -0.0119856) m in mesh axes turned likewise",
    ] {
        assert!(
            report.lines().any(|found| found == line),
            "{line} is not in\n{report}"
        );
    }
}

/// A center to which the reference point moves has zero coordinates.
#[test]
fn the_reference_point_moves_to_a_center() {
    let workplace = coupled();
    for center in ["tension-center", "shear-center", "mass-center"] {
        shift(&workplace, ["a.json", "b.json"], center);
        let b = properties(&workplace, "b.json");
        let point = match center {
            "tension-center" => b.centers.tension,
            "shear-center" => b.centers.shear,
            _ => b.centers.mass,
        };
        assert_eq!(point.amax(), 0.0, "{center}");
    }
    // about the mass center, momentum and angular momentum are uncoupled
    assert!(properties(&workplace, "b.json").mass[(0, 4)].abs() < 1e-20);
}

/// In principal axes of inertia about the mass center, the product of inertia is zero; in
/// principal axes of bending, the compliance does not couple the two bendings.
#[test]
fn the_axes_turn_to_principal_ones() {
    let workplace = coupled();
    rotate(&workplace, ["a.json", "t.json"], "25 deg");
    good(
        &workplace,
        &[
            "rotate",
            "t.json",
            "--to-principal",
            "bending",
            "--out",
            "b.json",
        ],
    );
    let b = properties(&workplace, "b.json");
    assert_eq!(b.principal_axes.bending_angle, 0.0);
    let c = b.stiffness.try_inverse().unwrap();
    assert!(c[(4, 5)].abs() < 1e-10 * (c[(4, 4)] * c[(5, 5)]).sqrt());
    shift(&workplace, ["t.json", "m.json"], "mass-center");
    good(
        &workplace,
        &[
            "rotate",
            "m.json",
            "--to-principal",
            "inertia",
            "--out",
            "i.json",
        ],
    );
    let m = properties(&workplace, "i.json").mass;
    assert!(m[(4, 5)].abs() < 1e-14 * (m[(4, 4)] * m[(5, 5)]).sqrt());
    assert!(
        (m[(4, 4)] / properties(&workplace, "t.json").principal_axes.inertia[0] - 1.0).abs()
            < 1e-13
    );
}

#[test]
fn the_report_has_the_layout_of_an_analysis() {
    let workplace = coupled();
    let analysis = workplace.read("results/a.report.txt");
    let report = good(&workplace, &["report", "a.json"]).out;
    let part = |text: &str, title: &str| {
        let start = text.find(&format!("\n{title}")).unwrap();
        let rest = &text[start + 1..];
        rest[..rest.find("\n\n").unwrap_or(rest.len())]
            .trim_end()
            .to_owned()
    };
    for title in [
        "Stiffness, internal",
        "Mass per length, momentum",
        "Engineering values",
        "Centers, from",
        "Principal axes",
        "Couplings about",
    ] {
        assert_eq!(part(&report, title), part(&analysis, title));
    }
    assert!(
        report.contains("  mesh      6 nodes, 2 cells\n"),
        "{report}"
    );
    let two = good(&workplace, &["report", "a.json", "a.json"]).out;
    assert_eq!(two, format!("{report}\n{report}"));
}

#[test]
fn options_of_a_property_file_are_reported() {
    let workplace = coupled();
    let mut section = properties(&workplace, "a.json");
    section.mass = Matrix6::zeros();
    section.thermal_force = Some([100.0, 0.0, 0.0, 0.0, 0.5, 0.0].into());
    section.damping = Some(section::Damping::StiffnessProportional(1e-4));
    section.initial_curvature = Some(section::InitialCurvature {
        curvature: [0.1, 0.0, 0.0].into(),
        slope: [1.0, 0.0, 0.0].into(),
    });
    section.piezo = Some(section::Piezo {
        electrodes: vec!["top".to_owned()],
        coupling: nalgebra::DMatrix::from_fn(6, 1, |i, _| 1.0 + i as f64),
        capacitance: nalgebra::DMatrix::from_element(1, 1, 2e-9),
    });
    workplace.write("b.json", &section::write(&section));
    let report = good(&workplace, &["report", "b.json"]).out;
    for line in [
        "  mass              0           0  the section has no mass",
        "  twist and curvature [1/m]        1.00000e-1          0  0",
        "  bending z  6.00000e0",
        "  top  2.00000e-9",
        "  bending y  5.00000e-1",
        "  the stiffness times 1.00000e-4 s",
    ] {
        let words: Vec<_> = line.split_whitespace().collect();
        let is_line = |found: &str| found.split_whitespace().collect::<Vec<_>>() == words;
        assert!(report.lines().any(is_line), "{line} is not in\n{report}");
    }
    assert!(!report.contains("inertia, at the mass center"));
}

/// The matrices are another program's, the shear center of another definition.
#[test]
fn centers_that_do_not_follow_from_the_stiffness_are_a_warning() {
    let workplace = coupled();
    let mut section = properties(&workplace, "a.json");
    section.centers.shear.x += 1e-3;
    workplace.write("b.json", &section::write(&section));
    let to = ["shift", "b.json", "--to", "shear-center", "--out", "c.json"];
    for arguments in [&["report", "b.json"][..], &to] {
        let run = workplace.run(arguments);
        assert_eq!(run.code, 0);
        let warned = "warning: b.json: the shear center is given at (";
        assert!(run.err.starts_with(warned), "{}", run.err);
        assert_eq!(run.err.lines().count(), 1, "{}", run.err);
    }
    assert_eq!(workplace.run(&["report", "a.json"]).err, "");
}
