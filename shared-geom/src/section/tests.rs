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
        imposed: Vec::new(),
        damping: Some(Damping::Viscous(1e-3 * stiffness)),
        prestress: None,
        provenance: Provenance {
            program: "section-analyzer".to_owned(),
            version: "0.1.0".to_owned(),
            input_hash: "sha256:00".to_owned(),
            nodes: 12,
            cells: 4,
            history: Vec::new(),
            sections: Vec::new(),
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
    let shown = refused("\"version\": 1", "\"version\": 4");
    assert_eq!(
        shown,
        "error: a.json:3: written in version 4 of the property-file format, expected at most 3\n  \
         help: use a newer version of this program"
    );
}

/// The section with one imposed state, valid.
pub(super) fn with_imposed() -> SectionProperties {
    let mut section = section();
    let free_strain = Vector6::new(1e-3, -2e-4, 1e-4, 0.02, -0.3, 0.1);
    section.imposed = vec![ImposedState {
        name: "hot".to_owned(),
        restrained_force: -(section.stiffness * free_strain),
        free_strain,
        stiffness_change: None,
    }];
    section
}

/// A file with imposed states is of version 3, and earlier versions do not have them.
#[test]
fn imposed_states_are_kept_in_version_three() {
    let section = with_imposed();
    let text = write(&section);
    assert!(text.contains("\n  \"version\": 3,\n"), "{text}");
    assert_eq!(parse(&text, "a.json").unwrap(), section);
    let earlier = text.replace("\"version\": 3", "\"version\": 2");
    let reported = parse(&earlier, "a.json").unwrap_err().to_string();
    let expected = "\"imposed\" belongs to version 3, and the file states version 2";
    assert!(reported.contains(expected), "{reported}");
}

/// Force and strain of a state agree with each other about every point and in all axes:
/// `theta = -K psi` and the work `theta . psi` stay, to round-off.
#[test]
fn imposed_states_move_with_point_and_axes() {
    let section = with_imposed();
    let work = |section: &SectionProperties| {
        let state = &section.imposed[0];
        let force = -(section.stiffness * state.free_strain);
        let scale = force.amax();
        assert!((force - state.restrained_force).amax() < 1e-12 * scale);
        assert_eq!(section.problems(), []);
        state.restrained_force.dot(&state.free_strain)
    };
    let before = work(&section);
    let moved = section.shift(Vector2::new(0.3, -0.4)).rotate(0.7);
    assert!((work(&moved) / before - 1.0).abs() < 1e-12);
    // a bent beam is longer on its outer side: nu_x of the point moved by d is nu_x + z
    // kappa_y - y kappa_z
    let moved = section.shift(Vector2::new(0.3, -0.4));
    let axial = 1e-3 - 0.4 * -0.3 - 0.3 * 0.1;
    assert!((moved.imposed[0].free_strain[0] - axial).abs() < 1e-15);
}

#[test]
fn imposed_states_that_contradict_are_reported() {
    let mut section = with_imposed();
    section.imposed.push(section.imposed[0].clone());
    section.imposed[1].free_strain[0] *= 1.01;
    let reported: Vec<_> = section.problems().iter().map(|p| p.to_string()).collect();
    assert_eq!(reported.len(), 2, "{reported:?}");
    assert_eq!(
        reported[0],
        "two imposed states are called \"hot\", expected one of this name"
    );
    assert!(reported[1].starts_with(
        "imposed state \"hot\": \"restrained_force\" is not minus the stiffness times"
    ));
    section.imposed[0].restrained_force[2] = f64::NAN;
    assert!(
        section
            .problems()
            .iter()
            .any(|p| p.to_string().contains("not finite"))
    );
}

/// Both versions are read, and a file without a history remains one of version 1.
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
fn a_wrong_history_is_refused_where_it_is() {
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
            .contains("unknown field \"turn\" of the step 1")
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
fn changes_are_reported_in_words() {
    let shift = Change::Shift(Vector2::new(0.025, -0.5));
    assert_eq!(
        shift.to_string(),
        "reference point moved by (0.025, -0.5) m"
    );
    let turn = Change::Rotate(30.0_f64.to_radians());
    assert_eq!(turn.to_string(), "axes turned by 30 deg about +x");
}

#[test]
fn unsound_content_is_refused_where_it_is() {
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
        ("\"name\"", "\"nome\"", "unknown field \"nome\""),
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

/// A change and its inverse give the identity, for every field; 1e-12 of the largest
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

/// Free thermal strain `K^-1 f` transforms like a strain, so force and stiffness must be
/// moved consistently. The moved stiffness has a condition number of about 1e6 (EA d^2
/// compared with GJ), so its inverse keeps about ten digits.
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

/// A table of distinct entries.
pub(super) fn with_prestress() -> SectionProperties {
    let third = |[i, j, k]: [usize; 3]| 1e4 * (1 + i + 5 * j + 25 * k) as f64 / 3.0;
    SectionProperties {
        prestress: Some(Prestress {
            strain_measure: StrainMeasure::Biot,
            third: CubicTable::from_fn(third),
            per_kelvin: None,
        }),
        initial_curvature: None,
        ..section()
    }
}

/// Files with prestress are of version 3; others keep their version.
#[test]
fn prestress_is_kept_in_version_three() {
    let section = with_prestress();
    let text = write(&section);
    assert!(text.contains("\n  \"version\": 3,\n"), "{text}");
    assert!(
        text.contains("\n      [1, 4, 4, 103333.33333333333],\n"),
        "{text}"
    );
    assert_eq!(parse(&text, "a.json").unwrap(), section);
    // omitted rows are zero, and their order does not matter
    let sparse = text.replacen(
        "\n      [1, 1, 1, ",
        "\n      [6, 4, 6, 2.5],\n      [1, 1, 1, ",
        1,
    );
    let sparse: String = sparse
        .lines()
        .filter(|line| !line.contains("[4, 6, 6, ") && !line.contains("[1, 1, 4, "))
        .map(|line| format!("{line}\n"))
        .collect();
    let found = parse(&sparse, "a.json").unwrap().prestress.unwrap();
    assert_eq!(found.third.at([1, 3, 3]), 2.5);
    assert_eq!(found.third.at([0, 0, 1]), 0.0);
}

#[test]
fn a_wrong_table_is_refused_where_it_is() {
    let text = write(&with_prestress());
    let line = 1 + text
        .lines()
        .position(|line| line.contains("\"prestress\""))
        .unwrap();
    let cases = [
        ("[1, 4, 4, ", "[1, 2, 4, ", "another index than 1 (axial)"),
        ("[1, 4, 4, ", "[1, 4, 1, ", "that another row gives already"),
        (
            "\"version\": 3",
            "\"version\": 2",
            "belongs to version 3, and the file states version 2",
        ),
    ];
    for (old, new, expected) in cases {
        let shown = parse(&text.replacen(old, new, 1), "a.json")
            .unwrap_err()
            .to_string();
        assert!(shown.contains(expected), "{shown}");
        assert!(
            shown.starts_with(&format!("error: a.json:{line}: ")),
            "{shown}"
        );
    }
    let word = parse(&text.replace("biot", "log"), "a.json")
        .unwrap_err()
        .to_string();
    let expected =
        "\"prestress.strain_measure\" is the text \"log\", expected \"biot\" or \"green\"";
    assert!(word.contains(expected), "{word}");
    let mut endless = with_prestress();
    endless.prestress.as_mut().unwrap().third = CubicTable::from_fn(|_| f64::NAN);
    let field = "prestress";
    assert!(
        endless
            .problems()
            .contains(&PropertyProblem::NotFinite { field })
    );
}

/// The tangent stiffness is moved as the stiffness: the same section at the same load,
/// about another point. The condition number of the moved stiffness, 1e6, costs the
/// strain digits: 1e-9 of the largest entry.
#[test]
fn stiffness_under_load_moves_with_the_section() {
    let section = with_prestress();
    let force = Vector6::new(3e3, 0.0, 0.0, 0.2, -0.4, 5.0);
    let tangent = section.stiffness_at(&force).unwrap();
    assert!((tangent - section.stiffness).amax() > 1e3);
    let by = Vector2::new(0.3, -0.7);
    let d = Vector3::new(0.0, by.x, by.y);
    let u = wrench::shift_matrix(&d);
    let moved = section.shift(by).stiffness_at(&(u * force)).unwrap();
    assert!((moved - wrench::shift(&tangent, &d)).amax() < 1e-9 * tangent.amax());
    let q = rotation_about_x(0.7);
    let into = wrench::rotation_matrix(&q).transpose();
    let turned = section.rotate(0.7).stiffness_at(&(into * force)).unwrap();
    assert!((turned - wrench::rotate(&tangent, &q)).amax() < 1e-9 * tangent.amax());
}

/// Every field of another shape is reported with its name and line, the rows of a table
/// too.
#[test]
fn wrong_numbers_are_reported_by_their_fields() {
    let mut section = with_prestress();
    section.imposed = with_imposed().imposed;
    let text = write(&section);
    let mut file: serde_json::Value = serde_json::from_str(&text).unwrap();
    file["thermal_force"] = serde_json::json!([1.0, 2.0]);
    file["stiffness"][2] = serde_json::json!([1, 2, "x", 4, 5, 6]);
    file["imposed"][0]["free_strain"] = serde_json::json!(3);
    file["prestress"]["third_derivatives"] = serde_json::json!([[1, 4, 4, 2.0], [1, 4, "x"], 7]);
    let text = serde_json::to_string_pretty(&file).unwrap();
    let shown = parse(&text, "a.json").unwrap_err().to_string();
    let line = |field: &str| {
        let key = format!("\"{field}\":");
        1 + text.lines().position(|line| line.contains(&key)).unwrap()
    };
    for (field, message) in [
        (
            "thermal_force",
            "\"thermal_force\" is an array of 2, expected 6 numbers",
        ),
        (
            "stiffness",
            "row 3 of \"stiffness\" is an array with the text \"x\", expected 6 numbers",
        ),
        (
            "free_strain",
            "\"free_strain\" of the imposed state \"hot\" is 3, expected 6 numbers",
        ),
        (
            "third_derivatives",
            "row 2 of \"prestress.third_derivatives\" is an array with the text \"x\", expected \
             three whole numbers and a number, as in [1, 4, 4, 1462.1]",
        ),
        (
            "third_derivatives",
            "row 3 of \"prestress.third_derivatives\" is 7, expected three",
        ),
    ] {
        assert!(shown.contains(message), "{message}\n{shown}");
        let position = format!("a.json:{}: ", line(field));
        assert!(shown.contains(&position), "{position}\n{shown}");
    }
    assert_eq!(shown.matches("error: ").count(), 5, "{shown}");
}

/// The stiffness under an imposed state moves with the section, and is kept in its file.
#[test]
fn changes_by_imposed_states_are_kept_and_move() {
    let mut section = with_prestress();
    section.imposed = with_imposed().imposed;
    let change = Matrix4::from_fn(|i, j| 1e3 * (1 + i * j + i + j) as f64);
    section.imposed[0].stiffness_change = Some(change);
    let prestress = section.prestress.as_mut().unwrap();
    prestress.per_kelvin = Some(0.1 * change);
    let text = write(&section);
    assert!(text.contains("\n  \"version\": 3,\n"), "{text}");
    assert_eq!(parse(&text, "a.json").unwrap(), section);

    let names = ["hot".to_owned()];
    let before = section.change_by_imposed(&names).unwrap();
    let d = Vector3::new(0.0, 0.3, -0.7);
    let moved = section.shift(Vector2::new(d.y, d.z));
    let expected = wrench::shift(&before, &d);
    let found = moved.change_by_imposed(&names).unwrap();
    assert!((found - expected).amax() < 1e-12 * expected.amax());
    let turned = section.rotate(0.7);
    let expected = wrench::rotate(&before, &rotation_about_x(0.7));
    let found = turned.change_by_imposed(&names).unwrap();
    assert!((found - expected).amax() < 1e-12 * expected.amax());
    let kelvin = turned.prestress.unwrap().per_kelvin.unwrap();
    let of_state = turned.imposed[0].stiffness_change.unwrap();
    assert!((10.0 * kelvin - of_state).amax() < 1e-12 * of_state.amax());

    let mut skew = section.clone();
    skew.imposed[0].stiffness_change.as_mut().unwrap()[(0, 3)] += 100.0;
    let reported = skew.problems();
    assert!(
        matches!(reported[..], [PropertyProblem::OfState { index: 0, .. }]),
        "{reported:?}"
    );
    assert_eq!(section.change_by_imposed(&["cold".to_owned()]), None);
}
