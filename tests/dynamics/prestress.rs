//! Beams of prestressed sections against the equations of one section.
//!
//! # References
//! - Equations (S-80), (D-240) of the book: `F = K e + 1/2 T e e`; a straight beam under end
//!   loads along its axis has the same strain everywhere.

use beam_dynamics::analysis::buckling::buckling;
use beam_dynamics::analysis::statics::{StaticOutcome, statics};
use beam_dynamics::input::{self, Input};
use nalgebra::{Vector2, Vector3, Vector4};
use shared_geom::section::{
    self, Centers, CubicTable, Engineering, Prestress, Provenance, SectionProperties,
    StrainMeasure, prestress_part,
};

use crate::record;

const CLOSED: &str = "Uniform strain of a prestressed section";

/// `[EA, GAy, GAz, GJ, EIy, EIz]` of the strip.
const STIFFNESS: [f64; 6] = [7e6, 2e6, 1e6, 3.6, 2.3, 1460.0];
/// T144 = E Ip \[N m^2\].
const POLAR: f64 = 1462.0;

/// A strip whose table is that of the trapeze alone, and an extension-twist coupling.
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
fn strain([n, m]: [f64; 2]) -> Vector4<f64> {
    let third = strip().prestress.unwrap().third;
    let mut p = Vector4::new(n / STIFFNESS[0], m / STIFFNESS[3], 0.0, 0.0);
    let stiffness = Vector4::new(STIFFNESS[0], STIFFNESS[3], STIFFNESS[4], STIFFNESS[5]);
    for _ in 0..50 {
        let change = third.along(&p);
        let force = stiffness.component_mul(&p) + 0.5 * change * p;
        let tangent = nalgebra::Matrix4::from_diagonal(&stiffness) + change;
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

/// Without the request nothing of it is there: the beam itself adds no N Ip/A.
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

/// Compression beyond `GJ EA / E Ip` takes the torsional stiffness away: the run ends with a
/// status, and says so.
#[test]
fn a_section_that_has_lost_its_stiffness_ends_the_run() {
    let critical = STIFFNESS[3] * STIFFNESS[0] / POLAR;
    let outcome = loaded("prestress = true", [-1.5 * critical, 1e-3]);
    println!("{:?}", outcome.failure);
    assert!(outcome.failure.is_some());
}

/// Torsional buckling: all sections of a strip under compression lose their torsional
/// stiffness at the load -K44/(dK44/dN), which no bending of this one does before. One number in
/// both evaluation points: a few roundings of numbers that differ by 1e6.
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
