//! Tests of the contract: round trip, checks on reading, invariance.

use super::*;

/// An off-center, coupled section: a strip moved and turned, with every option.
pub(super) fn section() -> SectionProperties {
    let stiffness = Matrix6::from_diagonal(&Vector6::new(7e6, 2e6, 1e6, 30.0, 40.0, 900.0));
    let mass = Matrix6::from_diagonal(&Vector6::new(2.0, 2.0, 2.0, 0.05, 0.01, 0.04));
    let mut coupled = stiffness;
    coupled[(0, 3)] = 500.0;
    coupled[(3, 0)] = 500.0;
    SectionProperties {
        name: "strip".to_owned(),
        reference_point: Vector2::new(0.1, -0.2),
        stiffness: coupled,
        mass,
        centers: Centers {
            tension: Vector2::new(0.01, 0.02),
            shear: Vector2::new(-0.01, 0.0),
            mass: Vector2::new(0.0, 0.03),
        },
        principal_axes: PrincipalAxes {
            bending_angle: 0.3,
            bending_stiffness: [40.0, 900.0],
            inertia_angle: -0.2,
            inertia: [0.01, 0.04],
        },
        initial_curvature: Some(InitialCurvature {
            curvature: Vector3::new(0.1, 0.2, 0.3),
            slope: Vector3::new(1.0, 0.0, 0.0),
        }),
        piezo: Some(Piezo {
            electrodes: vec!["top".to_owned(), "bottom".to_owned()],
            coupling: DMatrix::from_fn(6, 2, |i, j| (i as f64) - 2.0 * (j as f64)),
            capacitance: DMatrix::from_row_slice(2, 2, &[2e-9, -1e-9, -1e-9, 2e-9]),
        }),
        thermal_force: Some(Vector6::new(100.0, 0.0, 0.0, 0.1, 0.2, 1.0 / 3.0)),
        damping: Some(Damping::Viscous(1e-3 * stiffness)),
        provenance: Provenance {
            program: "section-analyzer".to_owned(),
            version: "0.1.0".to_owned(),
            input_hash: "sha256:00".to_owned(),
            nodes: 12,
            cells: 4,
            history: Vec::new(),
        },
    }
}

#[test]
fn the_file_keeps_every_digit_and_every_option() {
    let mut section = section();
    section.stiffness[(0, 0)] = 7e6 / 3.0;
    assert_eq!(parse(&write(&section), "a.json").unwrap(), section);
    section.initial_curvature = None;
    section.piezo = None;
    section.thermal_force = None;
    section.damping = Some(Damping::StiffnessProportional(1e-4));
    assert_eq!(parse(&write(&section), "a.json").unwrap(), section);
}

#[test]
fn matrices_take_a_line_a_row() {
    let text = write(&section());
    assert!(
        text.contains("\n    [7000000.0, 0.0, 0.0, 500.0, 0.0, 0.0],\n"),
        "{text}"
    );
}

/// Messages when the text of the file is changed from `old` to `new`.
fn refused(old: &str, new: &str) -> String {
    let text = write(&section());
    assert!(text.contains(old), "{old} is not in {text}");
    let changed = text.replacen(old, new, 1);
    parse(&changed, "a.json").unwrap_err().to_string()
}

#[test]
fn a_newer_version_is_refused_with_the_remedy() {
    let shown = refused("\"version\": 1", "\"version\": 3");
    assert_eq!(
        shown,
        "error: a.json:3: written in version 3 of the property-file format, expected at most 2\n  \
         help: use a newer version of this program"
    );
}

/// Both versions are read, and a file without a history stays one of version 1.
#[test]
fn the_history_is_kept_in_version_two() {
    let by = Vector2::new(0.1, 1.0 / 3.0);
    let moved = section().changed(Change::Shift(by), "a", "1");
    let turned = moved.changed(Change::Rotate(0.7), "b", "2");
    let text = write(&turned);
    assert!(text.contains("\n  \"version\": 2,\n"), "{text}");
    assert!(text.contains("\n        \"rotate\": 0.7,\n"), "{text}");
    assert_eq!(parse(&text, "a.json").unwrap(), turned);
    assert_eq!(turned.provenance.history.len(), 2);
    assert_eq!(turned.stiffness, section().shift(by).rotate(0.7).stiffness);

    let plain = write(&section());
    assert!(plain.contains("\n  \"version\": 1,\n"));
    assert!(!plain.contains("history"));
    let second = plain.replace("\"version\": 1", "\"version\": 2");
    assert_eq!(parse(&second, "a.json").unwrap(), section());
}

#[test]
fn a_wrong_history_is_refused_where_it_stands() {
    let text = write(&section().changed(Change::Rotate(0.7), "a", "1"));
    let line = 1 + text
        .lines()
        .position(|line| line.contains("history"))
        .unwrap();
    let cases = [
        ("\"version\": 2", "\"version\": 1", "belongs to version 2"),
        ("\"rotate\": 0.7,", "", "either \"shift\" or \"rotate\""),
        (
            "\"rotate\": 0.7",
            "\"rotate\": 0.7, \"shift\": [0, 0]",
            "either \"shift\" or \"rotate\"",
        ),
    ];
    for (old, new, expected) in cases {
        let shown = parse(&text.replacen(old, new, 1), "a.json").unwrap_err();
        let shown = shown.to_string();
        assert!(shown.contains(expected), "{shown}");
        assert!(
            shown.starts_with(&format!("error: a.json:{line}: ")),
            "{shown}"
        );
    }
    let unknown = parse(&text.replace("\"rotate\"", "\"turn\""), "a.json");
    assert!(
        unknown
            .unwrap_err()
            .to_string()
            .contains("unknown field `turn`")
    );
    let mut endless = section();
    endless = endless.changed(Change::Shift(Vector2::new(f64::NAN, 0.0)), "a", "1");
    let field = "history";
    assert!(
        endless
            .problems()
            .contains(&PropertyProblem::NotFinite { field })
    );
}

#[test]
fn changes_are_told_in_words() {
    let shift = Change::Shift(Vector2::new(0.025, -0.5));
    assert_eq!(
        shift.to_string(),
        "reference point moved by (0.025, -0.5) m"
    );
    let turn = Change::Rotate(30.0_f64.to_radians());
    assert_eq!(turn.to_string(), "axes turned by 30 deg about +x");
}

#[test]
fn unsound_content_is_refused_where_it_stands() {
    let cases = [
        (
            "\"units\": \"SI\"",
            "\"units\": \"US\"",
            "a.json:5: units are \"US\"",
        ),
        ("[7000000.0,", "[-7.0,", "has -7e0 at (1, 1) (axial)"),
        (
            "500.0, 0.0, 0.0]",
            "400.0, 0.0, 0.0]",
            "entry (1, 4) is 4e2 and (4, 1) is 5e2",
        ),
        ("[2.0, 0.0", "[2.1, 0.0", "expected three equal masses"),
        (
            "0.05, 0.0, 0.0]",
            "0.06, 0.0, 0.0]",
            "expected (5, 5) + (6, 6) = 5e-2",
        ),
        ("\"name\"", "\"nome\"", "unknown field `nome`"),
        ("1e-9", "1e999", "number out of range"),
        (
            "helicoid section",
            "other",
            "expected \"helicoid section properties\"",
        ),
        ("[1.0, -1.0]", "[1.0]", "ragged"),
    ];
    for (old, new, expected) in cases {
        let shown = refused(old, new);
        assert!(shown.contains(expected), "{old} -> {new}: {shown}");
    }
}

#[test]
fn an_indefinite_stiffness_is_refused() {
    let mut section = section();
    section.stiffness[(0, 3)] = 2e4;
    section.stiffness[(3, 0)] = 2e4;
    let problems = section.problems();
    assert!(matches!(
        problems[..],
        [PropertyProblem::Indefinite {
            field: "stiffness",
            ..
        }]
    ));
}

#[test]
fn a_mass_center_outside_the_inertia_is_refused() {
    // m = 2, inertia about z 0.04: the mass center can be at most 0.1414 m away.
    let mut section = section();
    section.mass[(0, 5)] = -2.0 * 0.15;
    section.mass[(5, 0)] = -2.0 * 0.15;
    let problems = section.problems();
    assert!(matches!(
        problems[..],
        [PropertyProblem::Indefinite { field: "mass", .. }]
    ));
}

/// Strain energy and kinetic energy do not depend on point or axes: the
/// generalized strain transforms with `psi' = U^-T psi` (shift) and
/// `psi' = diag(Q,Q)^T psi` (rotation). Round-off of a few products: 1e-12.
#[test]
fn shift_and_rotate_keep_the_energies() {
    let section = section();
    let psi = Vector6::new(1e-3, -2e-3, 5e-4, 0.1, -0.2, 0.3);
    let by = Vector2::new(0.3, -0.7);
    let d = Vector3::new(0.0, by.x, by.y);
    let inverse = wrench::shift_matrix(&-d).transpose();
    let moved = section.shift(by);
    let turned = section.rotate(0.7);
    let into = wrench::rotation_matrix(&rotation_about_x(0.7)).transpose();
    let energy = |k: &Matrix6<f64>, psi: &Vector6<f64>| (psi.transpose() * k * psi)[0];
    for (name, pick) in [("stiffness", 0usize), ("mass", 1)] {
        let of = |s: &SectionProperties| if pick == 0 { s.stiffness } else { s.mass };
        let reference = energy(&of(&section), &psi);
        let shifted = energy(&of(&moved), &(inverse * psi));
        let rotated = energy(&of(&turned), &(into * psi));
        assert!((shifted / reference - 1.0).abs() < 1e-12, "{name}");
        assert!((rotated / reference - 1.0).abs() < 1e-12, "{name}");
    }
}

/// Going there and back is the identity, for every field; 1e-12 of the largest
/// entry of each.
#[test]
fn shift_and_rotate_have_inverses() {
    let section = section();
    let by = Vector2::new(0.3, -0.7);
    let back = section.shift(by).shift(-by);
    let turned = section.rotate(0.7).rotate(-0.7);
    for other in [back, turned] {
        let scale = section.stiffness.amax();
        assert!((other.stiffness - section.stiffness).amax() < 1e-12 * scale);
        assert!((other.mass - section.mass).amax() < 1e-12);
        assert!((other.reference_point - section.reference_point).amax() < 1e-15);
        assert!((other.centers.shear - section.centers.shear).amax() < 1e-15);
        assert!((other.centers.mass - section.centers.mass).amax() < 1e-15);
        let (a, b) = (
            other.initial_curvature.unwrap(),
            section.initial_curvature.unwrap(),
        );
        assert!((a.curvature - b.curvature).amax() < 1e-15);
        assert!((a.slope - b.slope).amax() < 1e-15);
        let angle = other.principal_axes.bending_angle;
        assert!((angle - section.principal_axes.bending_angle).abs() < 1e-15);
        let thermal = other.thermal_force.unwrap() - section.thermal_force.unwrap();
        assert!(thermal.amax() < 1e-12);
    }
}

/// Free thermal strain `K^-1 f` is a strain: it transforms like one, so force and
/// stiffness must be moved consistently. The moved stiffness has a condition number
/// of about 1e6 (EA d^2 beside GJ), so its inverse keeps about ten digits.
#[test]
fn thermal_force_and_coupling_move_with_the_stiffness() {
    let section = section();
    let by = Vector2::new(0.3, -0.7);
    let d = Vector3::new(0.0, by.x, by.y);
    let moved = section.shift(by);
    let free = section.stiffness.try_inverse().unwrap() * section.thermal_force.unwrap();
    let free_moved = moved.stiffness.try_inverse().unwrap() * moved.thermal_force.unwrap();
    let expected = wrench::shift_matrix(&-d).transpose() * free;
    assert!((free_moved - expected).amax() < 1e-9 * expected.amax());
    let column = moved.piezo.unwrap().coupling.column(0).into_owned();
    let expected = wrench::shift_matrix(&d) * section.piezo.unwrap().coupling.column(0);
    assert!((column - expected).amax() < 1e-14);
}
