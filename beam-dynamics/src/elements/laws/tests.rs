//! Laws against closed forms, and their derivatives against differences.

#![allow(clippy::unwrap_used, reason = "tests")]

use std::sync::Arc;

use nalgebra::{Matrix1, Matrix3, SMatrix, SVector, Vector1, Vector3};

use shared_geom::expression::{Expression, Names};

use super::{
    Between, Bilinear, Cubic, Curve, Driven, ExpressionLaw, Extrapolation, Imposed, Law, LawKind,
    Quadratic, Term,
};
use crate::elements::Instant;
use crate::model::{Drive, Ramp};

fn symmetric() -> Matrix3<f64> {
    Matrix3::new(4.0, 1.0, 0.5, 1.0, 3.0, -0.2, 0.5, -0.2, 2.0)
}

fn cubic() -> Cubic {
    Cubic {
        first: 2.0,
        second: 3.0,
        third: 5.0,
    }
}

/// T_ijk of distinct entries, symmetric.
fn third() -> Box<[Matrix3<f64>; 3]> {
    let entry = |i: usize, j: usize, k: usize| {
        let mut sorted = [i, j, k];
        sorted.sort_unstable();
        (sorted[0] + 2 * sorted[1] + 5 * sorted[2]) as f64 - 4.0
    };
    Box::new(std::array::from_fn(|k| {
        Matrix3::from_fn(|i, j| entry(i, j, k))
    }))
}

/// The same under two states, one of which grows in time.
fn heated() -> Quadratic<3> {
    let growing = Drive::Ramp(Ramp {
        from: 0.2,
        to: 2.0,
        start: 0.0,
        end: 1.0,
        smooth: false,
    });
    Quadratic {
        third: third(),
        imposed: [Drive::Constant(0.5), growing]
            .into_iter()
            .map(|drive| Imposed {
                free_strain: Vector3::new(0.2, 0.1, -0.3),
                change: 0.4 * symmetric(),
                signal: drive.into(),
            })
            .collect(),
    }
}

fn curve(between: Between, extrapolation: Extrapolation) -> Curve {
    Curve::new(
        &[-1.0, -0.2, 0.3, 1.0],
        &[-2.0, -1.0, 0.5, 3.0],
        between,
        extrapolation,
    )
}

/// Every kind, as laws of dimension 3, with a prestrain and a prestress.
fn laws() -> Vec<Law<3>> {
    let bilinear = Bilinear {
        first: 2.0,
        second: 0.5,
        limit: 0.1,
    };
    let [stiffness, viscosity] = [symmetric(), 0.3 * symmetric()];
    let curves = [
        (Between::Linear, Extrapolation::Hold),
        (Between::Spline, Extrapolation::Extend),
    ];
    let [a, b] = curves.map(|(between, extrapolation)| Some(curve(between, extrapolation)));
    let kinds = vec![
        LawKind::Linear { stiffness },
        LawKind::Viscous { viscosity },
        LawKind::Viscoelastic {
            stiffness,
            viscosity,
        },
        LawKind::Quadratic(Quadratic::new(third())),
        LawKind::Cubic([cubic(); 3]),
        LawKind::Bilinear([bilinear; 3]),
        LawKind::Table([a, None, b]),
    ];
    let driven = |x, y, z| {
        Some(Driven {
            vector: Vector3::new(x, y, z),
            signal: Drive::Constant(0.5).into(),
        })
    };
    let term = |kind: &LawKind<3>| Term {
        kind: kind.clone(),
        prestrain: driven(0.1, -0.3, 0.2),
        prestress: driven(1.0, 2.0, -3.0),
    };
    let sum = Law::sum(kinds.iter().map(term).collect());
    let single = kinds.into_iter().map(Law::from);
    // not in the sum, whose forces would be too large for the round-off below
    let heated = LawKind::Quadratic(heated()).into();
    single.chain([sum, heated]).collect()
}

const STRAINS: [[f64; 3]; 4] = [
    [0.01, 0.05, -0.04],
    [0.4, -0.7, 0.23],
    [-1.5, 0.3, 1.7],
    [0.17, 0.9, -2.0],
];

/// Step 1e-6 on forces of size ten and energies of size 100, whose round-off is 1e-14 of
/// them: 1e-8 and 1e-7 over the step; third derivatives of size 30 add 1e-11.
#[test]
fn derivatives_are_those_of_the_force_and_forces_those_of_the_energy() {
    const STEP: f64 = 1e-6;
    let rate = Vector3::new(0.3, -0.8, 0.5);
    for law in laws() {
        for strain in STRAINS.map(Vector3::from) {
            let at = law.at(&strain, &rate, &Instant::at(0.3));
            let still = law.at(&strain, &Vector3::zeros(), &Instant::at(0.3));
            assert_eq!(at.by_rate != Matrix3::zeros(), law.is_viscous());
            for i in 0..3 {
                let mut by = Vector3::zeros();
                by[i] = STEP;
                let ends = [strain + by, strain - by];
                let [up, down] = ends.map(|strain| law.at(&strain, &rate, &Instant::at(0.3)).force);
                let error = (up - down) / (2.0 * STEP) - at.by_strain.column(i);
                assert!(error.amax() < 1e-8, "{law:?} {error}");
                let [up, down] = [rate + by, rate - by]
                    .map(|rate| law.at(&strain, &rate, &Instant::at(0.3)).force);
                let error = (up - down) / (2.0 * STEP) - at.by_rate.column(i);
                assert!(error.amax() < 1e-8, "{law:?} {error}");
                let [up, down] = ends.map(|strain| law.energy(&strain, &Instant::at(0.3)));
                let error = (up - down) / (2.0 * STEP) - still.force[i];
                assert!(error.abs() < 1e-7, "{law:?} {error}");
            }
        }
    }
}

fn one(kind: LawKind<1>, strain: f64) -> (f64, f64, f64) {
    let law = Law::from(kind);
    let at = law.at(&Vector1::new(strain), &Vector1::zeros(), &Instant::at(0.0));
    let energy = law.energy(&Vector1::new(strain), &Instant::at(0.0));
    (at.force[0], at.by_strain[(0, 0)], energy)
}

#[test]
fn values_are_those_of_the_closed_forms() {
    let stiffness = Matrix1::new(7.0);
    assert_eq!(one(LawKind::Linear { stiffness }, -2.0), (-14.0, 7.0, 14.0));
    // 2 (-2) - 3 (4) + 5 (-8); 2 + 6 (2) + 15 (4); 4 + 8 + 20.
    assert_eq!(one(LawKind::Cubic([cubic()]), -2.0), (-56.0, 74.0, 32.0));
    let bilinear = |limit| {
        LawKind::Bilinear([Bilinear {
            first: 4.0,
            second: 1.0,
            limit,
        }])
    };
    assert_eq!(one(bilinear(0.5), 0.5), (2.0, 4.0, 0.5));
    assert_eq!(one(bilinear(0.5), -2.5), (-4.0, 1.0, 6.5));
    let table = |extrapolation| LawKind::Table([Some(curve(Between::Linear, extrapolation))]);
    // Halfway between the last points; beyond them by one, where the slope is 2.5/0.7.
    let slope = 2.5 / 0.7;
    for (extrapolation, force, tangent) in [
        (Extrapolation::Hold, 3.0, 0.0),
        (Extrapolation::Extend, 3.0 + slope, slope),
    ] {
        let inside = one(table(extrapolation), 0.65);
        assert!((inside.0 - 1.75).abs() < 1e-15 && (inside.1 - slope).abs() < 1e-15);
        let beyond = one(table(extrapolation), 2.0);
        assert!((beyond.0 - force).abs() < 1e-14 && (beyond.1 - tangent).abs() < 1e-14);
        assert_eq!(one(table(extrapolation), 0.0).2, 0.0);
    }
}

/// The growth of the slope along a strain is the difference of the slopes, which are linear: a few
/// rounding errors of numbers below 100.
#[test]
fn the_slope_of_a_quadratic_force_grows_with_the_strain() {
    let law = Law::from(LawKind::Quadratic(heated()));
    let growth = Vector3::new(0.2, -0.3, 0.7);
    let strain = Vector3::new(1.1, 0.4, -0.6);
    let slope = |strain| {
        law.at(&strain, &Vector3::zeros(), &Instant::at(0.0))
            .by_strain
    };
    let difference = slope(strain + growth) - slope(strain);
    assert!(difference.amax() > 1.0);
    assert!((law.growth_of_stiffness(&growth) - difference).amax() < 1e-13);
    assert_eq!(
        Law::linear(symmetric()).growth_of_stiffness(&growth),
        Matrix3::zeros()
    );
}

/// The force of a sum is the sum; a prestrain shifts it, a prestress adds to it.
#[test]
fn sums_prestrains_and_prestresses() {
    let (k, d) = (3.0, 0.4);
    let kind = LawKind::Viscoelastic {
        stiffness: SMatrix::<f64, 1, 1>::new(k),
        viscosity: SMatrix::<f64, 1, 1>::new(d),
    };
    let driven = |value: f64| {
        Some(Driven {
            vector: SVector::<f64, 1>::new(value),
            signal: Drive::Constant(2.0).into(),
        })
    };
    let term = Term {
        kind: kind.clone(),
        prestrain: driven(0.05),
        prestress: driven(10.0),
    };
    let law = Law::sum(vec![term, kind.into()]);
    let found = law.at(&Vector1::new(0.3), &Vector1::new(0.7), &Instant::at(1.0));
    let expected = k * (0.3 - 0.1) + d * 0.7 + 20.0 + k * 0.3 + d * 0.7;
    assert!((found.force[0] - expected).abs() < 1e-14);
    assert_eq!(law.stiffness_at_rest()[(0, 0)], 2.0 * k);
    assert_eq!(
        law.signals()
            .map(|drive| drive.next_corner(0.0))
            .fold(f64::INFINITY, f64::min),
        f64::INFINITY
    );
}

/// `f_x = 2 x^3 y' + t`, in mm, kN and minutes: with x = 3 mm, y' = 0.5 mm/min, t = 2 min
/// this is 29 kN, and its slopes are 27 kN/mm and 54 kN min/mm.
#[test]
fn expressions_count_in_their_own_units() {
    let names = Names {
        variables: &["x", "y", "z", "x_rate", "y_rate", "z_rate", "t"],
        constants: &[],
    };
    let expression = Expression::parse("2*x^3*y_rate + t", &names).unwrap();
    let law = Law::from(LawKind::Expression(ExpressionLaw {
        components: [Some(Arc::new(expression)), None, None],
        strain_units: Vector3::repeat(1e-3),
        force_units: Vector3::repeat(1e3),
        time_unit: 60.0,
    }));
    assert!(law.is_viscous());
    let strain = Vector3::new(3e-3, 7e-3, 0.0);
    let rate = Vector3::new(1.0, 0.5e-3 / 60.0, 1.0);
    let found = law.at(&strain, &rate, &Instant::at(120.0));
    let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-14;
    assert!(near(found.force.x, 29e3) && found.force.yz().norm() == 0.0);
    assert!(near(found.by_strain[(0, 0)], 27e6));
    assert!(near(found.by_rate[(0, 1)], 54e6 * 60.0));
    assert_eq!(found.by_strain.norm(), found.by_strain[(0, 0)]);
    assert_eq!(found.by_rate.norm(), found.by_rate[(0, 1)]);
    assert_eq!(law.energy(&strain, &Instant::at(0.0)), 0.0);
}
