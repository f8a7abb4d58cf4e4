//! Differences against changes made by hand.

use std::f64::consts::FRAC_PI_2;

use super::*;
use approx::assert_relative_eq;
use nalgebra::{DMatrix, Matrix4, Vector6};
use shared_geom::section::{
    Centers, CubicTable, Damping, ImposedState, InitialCurvature, Piezo, Prestress, PrincipalAxes,
    Provenance, Step, StrainMeasure,
};

/// A bar of 0.2 m x 0.1 m with E = 1 GPa about its center, with a coupling of extension and
/// torsion and every option, about a point outside it.
fn section() -> SectionProperties {
    let (young, width, height) = (1e9, 0.2_f64, 0.1_f64);
    let area = width * height;
    let iy = width * height.powi(3) / 12.0;
    let iz = height * width.powi(3) / 12.0;
    let diagonal = Vector6::new(area, 0.3 * area, 0.25 * area, 0.2 * iz, iy, iz);
    let mut stiffness = young * Matrix6::from_diagonal(&diagonal);
    stiffness[(0, 3)] = 1e5;
    stiffness[(3, 0)] = 1e5;
    let mass = 2e3 * Matrix6::from_diagonal(&Vector6::new(area, area, area, iy + iz, iy, iz));
    let section = SectionProperties {
        name: "bar".to_owned(),
        reference_point: Vector2::new(0.5, 0.1),
        stiffness,
        mass,
        centers: Centers {
            tension: Vector2::zeros(),
            shear: Vector2::zeros(),
            mass: Vector2::zeros(),
        },
        principal_axes: PrincipalAxes {
            bending_angle: 0.0,
            bending_stiffness: [young * iy, young * iz],
            inertia_angle: 0.0,
            inertia: [2e3 * iy, 2e3 * iz],
        },
        initial_curvature: Some(InitialCurvature {
            curvature: Vector3::new(0.1, 0.2, 0.3),
            slope: Vector3::x(),
        }),
        piezo: Some(Piezo {
            electrodes: vec!["top".to_owned(), "bottom".to_owned()],
            coupling: DMatrix::from_fn(6, 2, |i, j| 1.0 + i as f64 - 2.0 * j as f64),
            capacitance: DMatrix::from_row_slice(2, 2, &[2e-9, -1e-9, -1e-9, 2e-9]),
        }),
        thermal_force: Some(Vector6::new(100.0, 0.0, 0.0, 0.1, 0.2, 0.3)),
        imposed: Vec::new(),
        damping: Some(Damping::StiffnessProportional(1e-3)),
        prestress: None,
        provenance: Provenance {
            program: "by hand".to_owned(),
            version: "1".to_owned(),
            input_hash: String::new(),
            nodes: 0,
            cells: 0,
            history: Vec::new(),
            sections: Vec::new(),
        },
    };
    section.shift(Vector2::new(0.03, -0.02))
}

fn between(a: &SectionProperties, b: &SectionProperties) -> Difference {
    Difference::between(a, b, false)
}

/// Radius of gyration of a rectangle: sqrt((b^2 + h^2) / 12), from any point.
#[test]
fn length_is_the_radius_of_gyration() {
    let exact = ((0.2_f64.powi(2) + 0.1_f64.powi(2)) / 12.0).sqrt();
    let section = section();
    for by in [Vector2::zeros(), Vector2::new(0.3, -0.4)] {
        let moved = section.shift(by);
        assert_relative_eq!(radius_of_gyration(&moved), exact, max_relative = 1e-13);
        assert_eq!(
            between(&section, &moved).length,
            radius_of_gyration(&section)
        );
    }
}

#[test]
fn equal_sections_do_not_differ() {
    let section = section();
    let difference = between(&section, &section);
    assert_eq!(difference.largest(), 0.0);
    assert!(difference.beyond(0.0).is_empty());
    assert!(difference.unlike.is_empty() && difference.brought.is_empty());
    // 21 each of stiffness, mass, damping; 6 of centers and of axes; 6 of curvature
    // and slope; 6 + 6 + 3 of electrodes; 6 thermal
    assert_eq!(difference.entries.len(), 3 * 21 + 6 + 6 + 6 + 15 + 6);
}

/// Each change by hand is found under its name, relative to its scale; the largest
/// first.
#[test]
fn entries_are_relative_to_what_they_matter_beside() {
    let a = section();
    let mut b = a.clone();
    let root = |i: usize, j: usize| (a.stiffness[(i, i)] * a.stiffness[(j, j)]).sqrt();
    for (i, j, relative) in [(0, 5, 0.02), (3, 3, -0.03)] {
        b.stiffness[(i, j)] += relative * root(i, j);
        if i != j {
            b.stiffness[(j, i)] = b.stiffness[(i, j)];
        }
    }
    b.centers.shear.y += 0.01 * radius_of_gyration(&a);
    b.principal_axes.inertia[1] *= 1.25;
    b.damping = Some(Damping::Viscous(1e-3 * a.stiffness));
    let difference = between(&a, &b);
    let found: Vec<_> = difference
        .beyond(1e-9)
        .iter()
        .map(|e| e.name.clone())
        .collect();
    let names = [
        "inertia, second axis",
        "torsion",
        "axial-bending z",
        "shear z",
    ];
    assert_eq!(found, names);
    let relative = difference
        .beyond(1e-9)
        .iter()
        .map(|e| e.relative)
        .collect::<Vec<_>>();
    for (found, expected) in relative.iter().zip([0.2, -0.03, 0.02, 0.01]) {
        assert_relative_eq!(*found, expected, max_relative = 1e-12);
    }
    assert_relative_eq!(difference.stiffness[(5, 0)], 0.02, max_relative = 1e-12);
    assert_eq!(difference.stiffness[(0, 5)], difference.stiffness[(5, 0)]);
    assert_eq!(difference.beyond(0.021).len(), 2);
    assert_relative_eq!(difference.largest(), 0.2, max_relative = 1e-12);
}

/// A section that was shifted and turned is brought back by its history: 1e-13, the
/// round-off of a few products with entries that Steiner's terms make ten times
/// larger. As given, the two differ.
#[test]
fn other_points_and_axes_are_brought_together() {
    let a = section();
    let by = Vector2::new(0.1, -0.05);
    let shifted = a.changed(Change::Shift(by), "a", "1");
    let turned = shifted.changed(Change::Rotate(0.7), "a", "1");
    let back = turned.changed(Change::Rotate(-0.7), "a", "1");
    for (b, count) in [(&shifted, 1), (&turned, 2), (&back, 1)] {
        for (a, b) in [(&a, b), (b, &a)] {
            let difference = between(a, b);
            assert_eq!(difference.brought.len(), count);
            assert!(difference.largest() < 1e-13, "{}", difference.largest());
            assert!(difference.unlike.is_empty());
            assert!(Difference::between(a, b, true).largest() > 0.1);
        }
    }
    let there_and_back = shifted.changed(Change::Shift(-by), "a", "1");
    assert!(between(&a, &there_and_back).brought.is_empty());
    let only_turned = a.changed(Change::Rotate(0.7), "a", "1");
    let difference = between(&a, &only_turned);
    assert_eq!(difference.brought, [Change::Rotate(-0.7)]);
    assert!(difference.largest() < 1e-13);
}

/// The order of the axes does not matter, only their directions.
#[test]
fn axes_named_the_other_way_round_are_the_same() {
    let a = section();
    let mut b = a.clone();
    let [first, second] = a.principal_axes.bending_stiffness;
    b.principal_axes.bending_stiffness = [second, first];
    for angle in [FRAC_PI_2, -FRAC_PI_2] {
        b.principal_axes.bending_angle = angle;
        assert!(between(&a, &b).largest() < 1e-15);
    }
    // an angle of 0.01 is weighted by the relative difference of the stiffnesses, 3/4
    b.principal_axes.bending_angle = FRAC_PI_2 + 0.01;
    assert_relative_eq!(between(&a, &b).largest(), 0.0075, max_relative = 1e-12);
    let round = |section: &mut SectionProperties, angle: f64| {
        section.principal_axes.bending_stiffness = [first; 2];
        section.principal_axes.bending_angle = angle;
    };
    let mut a = a.clone();
    round(&mut a, 0.0);
    round(&mut b, 0.4);
    assert_eq!(between(&a, &b).largest(), 0.0);
}

#[test]
fn a_section_without_mass_is_reported() {
    let a = section();
    let mut b = a.clone();
    b.mass = Matrix6::zeros();
    for (one, other, words) in [(&a, &b, "only A has mass"), (&b, &a, "only B has mass")] {
        let difference = between(one, other);
        assert_eq!(difference.unlike, [words]);
        assert_eq!(difference.mass[(0, 0)].abs(), 1.0);
        assert!(
            difference
                .entries
                .iter()
                .all(|entry| !entry.name.starts_with("mass"))
        );
        assert!(
            difference
                .entries
                .iter()
                .all(|entry| !entry.name.starts_with("inertia"))
        );
    }
    let difference = between(&b, &b);
    assert_eq!((difference.largest(), difference.unlike.len()), (0.0, 0));
}

#[test]
fn options_of_one_file_only_are_reported() {
    let a = section();
    let mut b = a.clone();
    b.piezo = None;
    b.thermal_force = None;
    let words = ["only A has electrodes", "only A has a thermal force"];
    assert_eq!(between(&a, &b).unlike, words);
    b = a.clone();
    if let Some(piezo) = &mut b.piezo {
        piezo.electrodes[0] = "upper".to_owned();
    }
    let words = ["the electrodes of A are top, bottom, the electrodes of B upper, bottom"];
    assert_eq!(between(&a, &b).unlike, words);
    // damping that one of the two lacks differs by its full value
    b = a.clone();
    b.damping = None;
    assert_relative_eq!(between(&a, &b).largest(), 1.0, max_relative = 1e-12);
    // a beam without initial curvature is a straight one
    b = a.clone();
    b.initial_curvature = None;
    let curvature = 0.3 * radius_of_gyration(&a);
    assert_relative_eq!(between(&a, &b).largest(), curvature, max_relative = 1e-12);
    let mut straight = b.clone();
    straight.initial_curvature = Some(InitialCurvature {
        curvature: Vector3::zeros(),
        slope: Vector3::x(),
    });
    assert_eq!(between(&straight, &b).largest(), 0.0);
}

/// The thermal force is compared in terms of the stiffness: 1 N/K of 100 N/K.
#[test]
fn forces_are_relative_to_the_largest() {
    let mut a = section();
    a.thermal_force = Some(Vector6::new(100.0, 0.0, 0.0, 0.0, 0.0, 0.0));
    let mut b = a.clone();
    b.thermal_force = Some(Vector6::new(101.0, 0.0, 0.0, 0.0, 0.0, 0.0));
    assert_relative_eq!(between(&a, &b).largest(), 0.01, max_relative = 1e-12);
    b.thermal_force = Some(Vector6::zeros());
    assert_relative_eq!(between(&b, &a).largest(), 1.0, max_relative = 1e-12);
}

/// NaN is never equal.
#[test]
fn numbers_that_are_none_are_beyond_every_tolerance() {
    let a = section();
    let mut b = a.clone();
    b.centers.shear.x = f64::NAN;
    let difference = between(&a, &b);
    assert!(difference.largest().is_nan());
    assert_eq!(difference.beyond(f64::MAX).len(), 1);
}

/// The turns of a history add up; moves of the point are ignored.
#[test]
fn turns_of_a_history_add_up() {
    let mut section = section();
    let step = |change| Step {
        change,
        program: String::new(),
        version: String::new(),
    };
    let changes = [0.5, -0.2].map(|angle| step(Change::Rotate(angle)));
    section.provenance.history.extend(changes);
    section
        .provenance
        .history
        .push(step(Change::Shift(Vector2::new(1.0, 1.0))));
    assert_eq!(turn(&section), 0.5 - 0.2);
}

/// Entries of a table relative to `sqrt(K_ii K_jj K_kk / K_11)`.
#[test]
fn tables_of_prestress_are_compared_beside_the_stiffness() {
    let mut a = section();
    let table = |value: f64| {
        Some(Prestress {
            strain_measure: StrainMeasure::Biot,
            third: CubicTable::from_fn(|at| if at == [0, 1, 1] { value } else { 0.0 }),
            per_kelvin: None,
        })
    };
    let mut b = a.clone();
    (a.prestress, b.prestress) = (table(2.0), table(2.5));
    let expected = 0.5 / a.stiffness[(3, 3)];
    assert_relative_eq!(between(&a, &b).largest(), expected, max_relative = 1e-12);
    b.prestress = None;
    assert_eq!(between(&a, &b).unlike, ["only A has a table of prestress"]);
}

/// A table of zeros with a change per kelvin, and one imposed state with a change.
fn with_changes(
    per_kelvin: Option<Matrix4<f64>>,
    by_state: Option<Matrix4<f64>>,
) -> SectionProperties {
    let mut section = section();
    let free_strain = Vector6::new(-1e-3, 0.0, 0.0, 0.0, 0.0, 0.0);
    section.imposed = vec![ImposedState {
        name: "hot".to_owned(),
        restrained_force: -(section.stiffness * free_strain),
        free_strain,
        stiffness_change: by_state,
    }];
    section.prestress = Some(Prestress {
        strain_measure: StrainMeasure::Biot,
        third: CubicTable::from_fn(|_| 0.0),
        per_kelvin,
    });
    section
}

/// Changes of the stiffness differ in terms of their largest entry, however small compared
/// with the stiffness: a change of 1e-5 of the stiffness, by a tenth.
#[test]
fn changes_of_the_stiffness_are_compared_beside_their_own_size() {
    let stiffness = section().stiffness;
    let mut change = Matrix4::zeros();
    change[(1, 1)] = 1e-2 * stiffness[(3, 3)];
    change[(1, 2)] = 2e-3 * (stiffness[(3, 3)] * stiffness[(4, 4)]).sqrt();
    change[(2, 1)] = change[(1, 2)];
    let mut other = change;
    other[(1, 2)] *= 1.5;
    other[(2, 1)] *= 1.5;
    let a = with_changes(Some(1e-3 * change), Some(change));
    for (b, name, unit) in [
        (
            with_changes(Some(1e-3 * other), Some(change)),
            "per kelvin, stiffness 45",
            "N m^2/K",
        ),
        (
            with_changes(Some(1e-3 * change), Some(other)),
            "imposed hot, stiffness 45",
            "N m^2",
        ),
    ] {
        let difference = between(&a, &b);
        let [entry] = difference.beyond(1e-9)[..] else {
            panic!("{:?}", difference.beyond(1e-9));
        };
        assert_eq!((entry.name.as_str(), entry.unit), (name, unit));
        assert_eq!(entry.part, Part::Prestress);
        assert_relative_eq!(entry.relative, 0.1, max_relative = 1e-12);
    }
}

/// Changes that are only round-off are round-off compared with the free strain, here 1e-3.
#[test]
fn changes_that_vanish_are_compared_beside_the_strain_of_their_cause() {
    let stiffness = section().stiffness;
    let noise = |part: f64| {
        let mut change = Matrix4::zeros();
        change[(1, 1)] = part * stiffness[(3, 3)];
        change
    };
    let [a, b] = [1e-17, -2e-17].map(|part| with_changes(None, Some(noise(part))));
    assert_relative_eq!(between(&a, &b).largest(), 3e-14, max_relative = 1e-9);
}

/// A change that only one of the two has is reported, for either cause and on either side.
#[test]
fn changes_of_one_file_only_are_reported() {
    let change = Some(Matrix4::identity());
    let both = with_changes(change, change);
    let kelvin = "a change of the stiffness per kelvin";
    let state = "a change of the stiffness by the imposed state hot";
    for (b, what) in [
        (with_changes(None, change), kelvin),
        (with_changes(change, None), state),
    ] {
        assert_eq!(between(&both, &b).unlike, [format!("only A has {what}")]);
        assert_eq!(between(&b, &both).unlike, [format!("only B has {what}")]);
        assert!(between(&b, &b).unlike.is_empty());
    }
}

/// Second-order strains of another measure change the stiffness differently.
#[test]
fn prestress_by_other_strains_is_reported_and_not_compared() {
    let a = with_changes(Some(Matrix4::identity()), Some(Matrix4::identity()));
    let mut b = with_changes(Some(Matrix4::zeros()), Some(Matrix4::zeros()));
    if let Some(table) = &mut b.prestress {
        table.strain_measure = StrainMeasure::Green;
    }
    let difference = between(&a, &b);
    let words =
        ["the prestress of A uses the strain of biot, the prestress of B the strain of green"];
    assert_eq!(difference.unlike, words);
    assert_eq!(difference.largest(), 0.0);
}
