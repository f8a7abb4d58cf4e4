//! Beams of prestressed sections against the equations of one section.
//!
//! # References
//! - Equations (S-80), (D-240) of the book: `F = K e + 1/2 T e e`; a straight beam under end
//!   loads along its axis has the same strain everywhere.

use beam_dynamics::analysis::buckling::buckling;
use beam_dynamics::analysis::statics::{StaticOutcome, statics};
use beam_dynamics::input::{self, Input};
use nalgebra::{Matrix4, Vector2, Vector3, Vector4, Vector6};
use shared_geom::section::{
    self, Centers, CubicTable, Engineering, ImposedState, Prestress, Provenance, SectionProperties,
    StrainMeasure, prestress_part,
};

use crate::record;

const CLOSED: &str = "Uniform strain of a prestressed section";

/// `[EA, GAy, GAz, GJ, EIy, EIz]` of the strip.
const STIFFNESS: [f64; 6] = [7e6, 2e6, 1e6, 3.6, 2.3, 1460.0];
/// T144 = E Ip \[N m^2\].
const POLAR: f64 = 1462.0;

/// A strip whose table contains only the trapeze effect, and an extension-twist coupling.
fn strip() -> SectionProperties {
    let written = Engineering {
        stiffness: STIFFNESS,
        mass: [0.27, 9e-8, 5.6e-5],
        centers: Centers {
            tension: Vector2::zeros(),
            shear: Vector2::zeros(),
            mass: Vector2::zeros(),
        },
        stiffness_angle: 0.0,
        inertia_angle: 0.0,
    };
    let entry = |at: [usize; 3]| match at {
        [0, 1, 1] => POLAR,
        [1, 1, 1] => 0.7,
        [0, 0, 1] => -2e3,
        _ => 0.0,
    };
    SectionProperties {
        prestress: Some(Prestress {
            strain_measure: StrainMeasure::Biot,
            third: CubicTable::from_fn(entry),
            per_kelvin: None,
        }),
        ..written.section("strip", Provenance::default())
    }
}

/// A clamped strip of 1 m under a force \[N\] and a torque \[N m\] at its tip.
fn input(section: &SectionProperties, keys: &str, [force, torque]: [f64; 2], rest: &str) -> Input {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("strip.properties.json");
    std::fs::write(file, section::write(section)).unwrap();
    let text = format!(
        "units = \"SI\"\n[properties.strip]\nfile = \"strip.properties.json\"\n{keys}\n\
         [[blade]]\nname = \"strip\"\nproperties = \"strip\"\n\
         [[blade.piece]]\nlength = 1\nelements = 2\n\
         [[load]]\nnode = \"strip/tip\"\nforce = [{force:e}, 0, 0]\nmoment = [{torque:e}, 0, 0]\n\
         {rest}"
    );
    let file = folder.path().join("strip.dynamics.toml");
    std::fs::write(&file, text).unwrap();
    input::read(&file).unwrap_or_else(|problems| panic!("{problems}"))
}

fn loaded(keys: &str, loads: [f64; 2]) -> StaticOutcome {
    let input = input(&strip(), keys, loads, "[static]\n");
    statics(&input.model, &input.statics.unwrap())
}

/// Axial strain and twist under `N`, `M`, by Newton's method on the two equations.
fn strain(loads: [f64; 2]) -> Vector4<f64> {
    strain_with(loads, &Matrix4::zeros())
}

/// The same with a change of the stiffness.
fn strain_with([n, m]: [f64; 2], by_heat: &Matrix4<f64>) -> Vector4<f64> {
    let third = strip().prestress.unwrap().third;
    let mut p = Vector4::new(n / STIFFNESS[0], m / STIFFNESS[3], 0.0, 0.0);
    let stiffness = Vector4::new(STIFFNESS[0], STIFFNESS[3], STIFFNESS[4], STIFFNESS[5]);
    for _ in 0..50 {
        let change = third.along(&p);
        let force = stiffness.component_mul(&p) + 0.5 * change * p + by_heat * p;
        let tangent = Matrix4::from_diagonal(&stiffness) + change + by_heat;
        p -= tangent.try_inverse().unwrap() * (force - Vector4::new(n, m, 0.0, 0.0));
    }
    p
}

/// Strains of every section under tension and torque. Newton's method of the beam stops
/// at 1e-9 of the loads or earlier.
#[test]
fn a_stretched_strip_is_stiffer_in_torsion() {
    const TOLERANCE: f64 = 1e-8;
    let loads = [5e3, 0.5];
    let outcome = loaded("prestress = true", loads);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let expected = strain(loads);
    let linear = loads[1] / STIFFNESS[3];
    assert!(expected[1] < 0.8 * linear, "{expected} {linear}");
    for section in &outcome.result.last().unwrap().sections {
        let found = prestress_part(&section.strain);
        for (i, quantity) in [(0, "axial strain [-]"), (1, "twist [1/m]")] {
            let error = (found[i] / expected[i] - 1.0).abs();
            let pair = [found[i], expected[i]];
            record::value(
                CLOSED,
                "strip, tension and torque",
                quantity,
                pair,
                error,
                TOLERANCE,
            );
            assert!(error < TOLERANCE, "{quantity} {pair:?}");
        }
    }
}

/// Without the request it has no effect: the beam itself adds no N Ip/A.
#[test]
fn without_the_request_tension_does_not_stiffen_torsion() {
    const TOLERANCE: f64 = 1e-8;
    for keys in ["", "prestress = false"] {
        let outcome = loaded(keys, [5e3, 0.5]);
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let expected = 0.5 / STIFFNESS[3];
        for section in &outcome.result.last().unwrap().sections {
            let error = (section.strain[3] / expected - 1.0).abs();
            let pair = [section.strain[3], expected];
            record::value(
                CLOSED,
                "strip, no request",
                "twist [1/m]",
                pair,
                error,
                TOLERANCE,
            );
            assert!(error < TOLERANCE, "{pair:?}");
        }
    }
}

/// Compression beyond `GJ EA / E Ip` removes the torsional stiffness: the run ends with a status
/// and a message.
#[test]
fn a_section_that_has_lost_its_stiffness_ends_the_run() {
    let critical = STIFFNESS[3] * STIFFNESS[0] / POLAR;
    let outcome = loaded("prestress = true", [-1.5 * critical, 1e-3]);
    println!("{:?}", outcome.failure);
    assert!(outcome.failure.is_some());
}

/// Torsional buckling: all sections of a strip under compression lose their torsional stiffness at
/// the load -K44/(dK44/dN), below its bending loads. One number in both evaluation points: a few
/// rounding errors of numbers that differ by 1e6.
#[test]
fn strips_buckle_in_torsion() {
    const TOLERANCE: f64 = 1e-6;
    let mut section = strip();
    let mut stiffness = section.stiffness;
    (stiffness[(4, 4)], stiffness[(5, 5)]) = (1e5, 1e5);
    section.stiffness = stiffness;
    section.prestress = section.prestress.map(|prestress| Prestress {
        third: CubicTable::from_fn(|at| match at {
            [0, 1, 1] => POLAR,
            _ => 0.0,
        }),
        ..prestress
    });
    let input = input(
        &section,
        "prestress = true",
        [-1.0, 0.0],
        "[buckling]\ncount = 1\n",
    );
    let outcome = buckling(&input.model, &input.buckling.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let mode = &outcome.result.modes[0];
    let expected = STIFFNESS[3] * STIFFNESS[0] / POLAR;
    let error = (mode.factor / expected - 1.0).abs();
    let pair = [mode.factor, expected];
    println!("{pair:?}");
    record::value(
        CLOSED,
        "strip, torsional buckling",
        "load [N]",
        pair,
        error,
        TOLERANCE,
    );
    assert!(error < TOLERANCE, "{pair:?}");
    let turn = mode.rotations.iter().map(Vector3::norm).fold(0.0, f64::max);
    let about_x = mode.rotations.iter().map(|r| r.x.abs()).fold(0.0, f64::max);
    assert!(about_x > 0.999 * turn);
}

/// Strains of the strip heated evenly by one kelvin, and in the state "edge".
const PER_KELVIN: [f64; 6] = [2e-5, 0.0, 0.0, 1e-4, 0.0, 0.0];
const EDGE: [f64; 6] = [3e-4, 0.0, 0.0, -2e-3, 0.0, 0.0];

/// The strip with heat and a state, and their effect on its stiffness.
fn heated_strip() -> (SectionProperties, Matrix4<f64>) {
    let mut section = strip();
    let free = Vector6::from(PER_KELVIN);
    section.thermal_force = Some(-(section.stiffness * free));
    let change = |axial_torsion: f64, torsion: f64| {
        let mut change = Matrix4::zeros();
        (change[(0, 1)], change[(1, 0)]) = (axial_torsion, axial_torsion);
        change[(1, 1)] = torsion;
        change
    };
    let (even, edge) = (change(0.4, -4e-3), change(5.0, -0.7));
    let prestress = section.prestress.as_mut().unwrap();
    prestress.per_kelvin = Some(even);
    let free_strain = Vector6::from(EDGE);
    section.imposed = vec![ImposedState {
        name: "edge".to_owned(),
        restrained_force: -(section.stiffness * free_strain),
        free_strain,
        stiffness_change: Some(edge),
    }];
    (section, 50.0 * even + 2.0 * edge)
}

/// Under heat and an imposed state the table acts on the strain beyond the free strain, (D-252): `e
/// = q + sum c_i psi_i`, with q the strain of the section of changed stiffness. Free ends, and ends
/// that are pushed back so that the bar does not grow.
#[test]
fn the_table_acts_on_the_strain_that_is_not_free() {
    const TOLERANCE: f64 = 1e-8;
    let (section, change) = heated_strip();
    let free = 50.0 * Vector6::from(PER_KELVIN) + 2.0 * Vector6::from(EDGE);
    let free = prestress_part(&free);
    let heat = "prestress = true\ntemperature = 50\nimposed = { edge = \"= 1 + 1\" }";
    let held = -STIFFNESS[0] * 1e-3;
    for (case, loads) in [
        ("free", [0.0, 0.1]),
        ("held", [held, 0.1]),
        ("pulled", [5e3, 0.5]),
    ] {
        let input = input(&section, heat, loads, "[static]\n");
        let outcome = statics(&input.model, &input.statics.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let expected = strain_with(loads, &change) + free;
        for section in &outcome.result.last().unwrap().sections {
            let found = prestress_part(&section.strain);
            for (i, quantity) in [(0, "axial strain [-]"), (1, "twist [1/m]")] {
                let error = (found[i] - expected[i]).abs() / strain(loads)[i].abs().max(1e-3);
                let case = format!("heated strip, {case}");
                let pair = [found[i], expected[i]];
                record::value(CLOSED, &case, quantity, pair, error, TOLERANCE);
                assert!(error < TOLERANCE, "{case} {quantity} {pair:?}");
            }
        }
    }
}

/// The trapeze effect alone: a free heated strip twists like a cold one, `M/GJ`; one that is held,
/// pressed by EA alpha T, as `M/(GJ - T144 alpha T)`.
#[test]
fn free_heat_does_not_stiffen_and_held_heat_softens() {
    const TOLERANCE: f64 = 1e-6;
    let mut section = strip();
    section.thermal_force = Some(Vector6::new(-STIFFNESS[0] * 2e-5, 0.0, 0.0, 0.0, 0.0, 0.0));
    let prestress = section.prestress.as_mut().unwrap();
    prestress.third = CubicTable::from_fn(|at| if at == [0, 1, 1] { POLAR } else { 0.0 });
    prestress.per_kelvin = Some(Matrix4::zeros());
    // small enough for its own shortening to be negligible, 1e-7 of GJ
    let torque = 1e-4;
    for (case, force, torsion) in [
        ("free", 0.0, STIFFNESS[3]),
        ("held", -STIFFNESS[0] * 1e-3, STIFFNESS[3] - POLAR * 1e-3),
    ] {
        let keys = "prestress = true\ntemperature = 50";
        let input = input(&section, keys, [force, torque], "[static]\n");
        let outcome = statics(&input.model, &input.statics.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let found = outcome.result.last().unwrap().sections[0].strain[3];
        let expected = torque / torsion;
        let error = (found / expected - 1.0).abs();
        let case = format!("strip at 50 K, {case}");
        record::value(
            CLOSED,
            &case,
            "twist [1/m]",
            [found, expected],
            error,
            TOLERANCE,
        );
        assert!(error < TOLERANCE, "{case} {found} {expected}");
        // 40 % of GJ is reported
        let remarks = outcome.result.remarks.join("\n");
        assert_eq!(
            remarks.contains("changes the stiffness of beam"),
            case.ends_with("held"),
            "{remarks}"
        );
    }
}
