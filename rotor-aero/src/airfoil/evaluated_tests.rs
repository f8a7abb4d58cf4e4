use std::f64::consts::{PI, TAU};

use num_dual::{Dual64, DualSVec64};

use super::{Airfoil, AirfoilData, Flow};
use crate::airfoil::{
    BUILT_IN, Coefficients, Curve, FlatPlate, Interpolation, LinearLift, naca0012,
};

/// Numbers from 0 to 1 from a linear congruential generator.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.next()
    }
}

fn flow<T>(x: [T; 4]) -> Flow<T> {
    let [alpha, mach, reynolds, flap] = x;
    Flow {
        alpha,
        mach,
        reynolds,
        flap,
    }
}

fn list<T>(at: Coefficients<T>) -> [T; 3] {
    [at.lift, at.drag, at.moment]
}

fn curve(
    mach: Option<f64>,
    reynolds: Option<f64>,
    flap: Option<f64>,
    points: &[(f64, f64)],
) -> Curve {
    let (alpha, values) = points
        .iter()
        .map(|(deg, value)| (deg.to_radians(), *value))
        .unzip();
    Curve {
        mach,
        reynolds,
        flap,
        alpha,
        values,
    }
}

/// Lift that depends on all four variables, on grids that differ from curve to curve.
fn full_table() -> AirfoilData {
    let mut lift = Vec::new();
    for (f, flap) in [-0.1, 0.0, 0.2].into_iter().enumerate() {
        for (r, reynolds) in [1e5, 1e6, 4e6].into_iter().enumerate() {
            for (m, mach) in [0.2, 0.4, 0.5, 0.8].into_iter().enumerate() {
                let scale = 1.0 + 0.3 * m as f64 - 0.1 * (m * m) as f64 + 0.05 * r as f64;
                let stall = 14.0 - 2.0 * m as f64;
                let top = scale * (1.0 + 0.2 * f as f64);
                lift.push(curve(
                    Some(mach),
                    Some(reynolds),
                    Some(flap),
                    &[
                        (-180.0, 0.0),
                        (-90.0, -0.1),
                        (-stall, -top),
                        (f as f64 - 2.0, 0.01),
                        (stall, top),
                        (stall + 4.0, 0.7 * top),
                        (60.0, 0.9),
                        (180.0, 0.0),
                    ],
                ));
            }
        }
    }
    let drag = vec![curve(
        None,
        None,
        None,
        &[
            (-180.0, 0.02),
            (-90.0, 1.8),
            (0.0, 0.01),
            (90.0, 1.8),
            (180.0, 0.02),
        ],
    )];
    AirfoilData {
        name: "full".to_owned(),
        lift,
        drag,
        ..AirfoilData::default()
    }
}

fn airfoils() -> Vec<Airfoil> {
    let mut all: Vec<Airfoil> = BUILT_IN.iter().map(|entry| entry.airfoil()).collect();
    for interpolation in [Interpolation::Monotone, Interpolation::Linear] {
        all.push(Airfoil::new(&full_table(), interpolation).unwrap());
    }
    all.push(Airfoil::linear(LinearLift {
        slope: 5.7,
        zero_lift: -0.03,
        drag_0: 0.01,
        drag_2: 0.8,
        moment: -0.02,
        mach_limit: Some(0.8),
    }));
    all
}

/// Dual numbers against central differences. The step is 1e-6 of each variable's scale: the error
/// of the differences is the third derivative (1e6 at stall) times its square, and round-off of
/// 1e-10; a step that crosses a knot adds the second derivative (1e3) times the step. 2e-3 is
/// twice that; 1e-5 holds in 99 % of the points.
#[test]
fn derivatives_are_exact() {
    let mut random = Random(7);
    for airfoil in airfoils() {
        let mut larger = 0;
        for _ in 0..500 {
            let x = [
                random.between(-8.0, 8.0),
                random.between(0.0, 1.0),
                random.between(5e4, 8e6),
                random.between(-0.15, 0.25),
            ];
            for k in 0..4 {
                let scale = if k == 2 { x[2] } else { 1.0 };
                let mut seeds = x.map(Dual64::from);
                seeds[k] = Dual64::new(x[k], scale);
                let exact = list(airfoil.at(&flow(seeds))).map(|value| value.eps);
                let side = |step: f64| {
                    let mut moved = x;
                    moved[k] += step * scale;
                    list(airfoil.at(&flow(moved)))
                };
                let (high, low) = (side(1e-6), side(-1e-6));
                for i in 0..3 {
                    let error = ((high[i] - low[i]) / 2e-6 - exact[i]).abs();
                    larger += usize::from(error > 1e-5);
                    assert!(error < 2e-3, "{} {x:?} {k} {i} {error}", airfoil.name());
                }
            }
        }
        assert!(larger < 60, "{} {larger}", airfoil.name());
    }
}

/// The difference of the slopes before and after a knot is proportional to the distance: its
/// limit is zero, in angle of attack and in Mach number.
#[test]
fn slopes_are_continuous_at_the_knots() {
    let airfoil = Airfoil::new(&naca0012(), Interpolation::Monotone).unwrap();
    let jump = |knot: [f64; 2], k: usize, step: f64| {
        let slope = |side: f64| {
            let mut x = [knot[0], knot[1], 1e6, 0.0].map(Dual64::from);
            x[k] = Dual64::new(knot[k] + side * step, 1.0);
            list(airfoil.at(&flow(x))).map(|value| value.eps)
        };
        let (after, before) = (slope(1.0), slope(-1.0));
        (0..3)
            .map(|i| (after[i] - before[i]).abs())
            .fold(0.0, f64::max)
    };
    for alpha_deg in [-180.0, -90.0, 0.0, 11.0, 17.0, 18.0, 30.0, 160.0_f64] {
        for mach in [0.15, 0.2, 0.3, 0.6, 0.75, 0.8] {
            let knot = [alpha_deg.to_radians(), mach];
            for k in 0..2 {
                let far = jump(knot, k, 1e-4);
                let near = jump(knot, k, 1e-6);
                // A hundredth, and a half more for the third derivative.
                assert!(near < 0.015 * far + 1e-9, "{knot:?} {k} {far} {near}");
            }
        }
    }
}

#[test]
fn knots_are_interpolated_and_ranges_end_with_constants() {
    let data = full_table();
    for interpolation in [Interpolation::Monotone, Interpolation::Linear] {
        let airfoil = Airfoil::new(&data, interpolation).unwrap();
        for curve in &data.lift {
            let at = |alpha| {
                [
                    alpha,
                    curve.mach.unwrap(),
                    curve.reynolds.unwrap(),
                    curve.flap.unwrap(),
                ]
            };
            for (alpha, value) in curve.alpha.iter().zip(&curve.values) {
                for turns in [-2.0, 0.0, 1.0] {
                    let found = airfoil.at(&flow(at(alpha + turns * TAU))).lift;
                    assert!((found - value).abs() < 1e-12);
                }
            }
        }
        let end = airfoil.at(&flow([0.1, 0.2, 1e5, -0.1]));
        for x in [
            [0.1, 0.1, 1e3, -0.3],
            [0.1, 0.0, 0.0, -1.0],
            [0.1, -1.0, -5.0, -9.0],
        ] {
            assert_eq!(airfoil.at(&flow(x)), end);
        }
        let end = airfoil.at(&flow([0.1, 0.8, 4e6, 0.2]));
        assert_eq!(airfoil.at(&flow([0.1, 7.0, 1e9, 0.9])), end);
    }
}

/// Between two curves: linear in the logarithm of the Reynolds number, and in the deflection;
/// with linear interpolation also in angle and Mach number.
#[test]
fn linear_interpolation_is_the_mean_half_way() {
    let airfoil = Airfoil::new(&full_table(), Interpolation::Linear).unwrap();
    let lift = |x| airfoil.at(&flow(x)).lift;
    let mean = |a, b| (lift(a) + lift(b)) / 2.0;
    let (low, high) = ([0.1, 0.4, 1e5, 0.0], [0.1, 0.4, 1e6, 0.0]);
    assert!((lift([0.1, 0.4, 1e5 * 10_f64.sqrt(), 0.0]) - mean(low, high)).abs() < 1e-12);
    let high = [0.1, 0.4, 1e5, 0.2];
    assert!((lift([0.1, 0.4, 1e5, 0.1]) - mean(low, high)).abs() < 1e-12);
    let high = [0.1, 0.5, 1e5, 0.0];
    assert!((lift([0.1, 0.45, 1e5, 0.0]) - mean(low, high)).abs() < 1e-12);
    let high = [0.12, 0.4, 1e5, 0.0];
    assert!((lift([0.11, 0.4, 1e5, 0.0]) - mean(low, high)).abs() < 1e-12);
}

#[test]
fn no_input_panics_and_no_number_stays_no_number() {
    let odd = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        -1.0,
        1e300,
        f64::MIN_POSITIVE,
    ];
    for airfoil in airfoils() {
        for alpha in odd {
            for mach in odd {
                for reynolds in odd {
                    for flap in odd {
                        let at = airfoil.at(&flow([alpha, mach, reynolds, flap]));
                        assert!(!alpha.is_nan() || at.lift.is_nan());
                    }
                }
            }
        }
    }
}

/// Friction at 0 deg, and the drag of the fit at 90 deg with its center of pressure at half chord.
#[test]
fn flat_plate_has_the_values_of_the_fit() {
    let plate = Airfoil::flat_plate(FlatPlate::default());
    let at = |deg: f64| plate.at(&flow([deg.to_radians(), 0.0, 1e6, 0.0]));
    assert_eq!(list(at(0.0)), [0.0, 0.009, 0.0]);
    let normal = at(90.0);
    assert!((normal.drag - 1.989).abs() < 1e-12 && (normal.moment + 1.98 / 4.0).abs() < 1e-12);
    // The same plate from behind, and from above.
    for deg in [10.0, 40.0, 100.0, 170.0] {
        let (front, above) = (at(deg), at(-deg));
        assert!((front.lift + above.lift).abs() < 1e-12 && (front.drag - above.drag).abs() < 1e-12);
        let back = at(180.0 - deg);
        assert!((front.lift + back.lift).abs() < 1e-12);
        // Moments about half chord change sign with the direction of the flow.
        let normal = |c: Coefficients<f64>, deg: f64| {
            c.lift * deg.to_radians().cos() + (c.drag - 0.009) * deg.to_radians().sin()
        };
        let half = |c: Coefficients<f64>, deg: f64| c.moment + 0.25 * normal(c, deg);
        assert!((half(front, deg) + half(back, 180.0 - deg)).abs() < 1e-12);
    }
}

#[test]
fn linear_lift_is_exact_to_60_deg_and_absent_in_reverse_flow() {
    let thin = Airfoil::linear(LinearLift::default());
    let at = |alpha: f64, mach: f64| thin.at(&flow([alpha, mach, 1e6, 0.0]));
    for alpha in [-1.0, -0.1, 0.0, 0.3, 1.04] {
        assert!((at(alpha, 0.5).lift - TAU * alpha).abs() < 1e-12 && at(alpha, 0.5).drag == 0.0);
    }
    assert_eq!(at(2.0, 0.1).lift, 0.0);
    assert_eq!(at(-PI, 0.1).lift, 0.0);
    let compressible = Airfoil::linear(LinearLift {
        mach_limit: Some(0.8),
        ..LinearLift::default()
    });
    let lift = |mach| compressible.at(&flow([0.1, mach, 1e6, 0.0])).lift;
    assert!((lift(0.6) - 0.1 * TAU / 0.8).abs() < 1e-12);
    assert!((lift(0.9) - 0.1 * TAU / 0.6).abs() < 1e-12);
}

#[test]
fn powers_of_dual_numbers_have_second_derivatives() {
    let airfoil = Airfoil::new(&naca0012(), Interpolation::Monotone).unwrap();
    let alpha = num_dual::Dual2_64::new(0.12, 1.0, 0.0);
    let others = [0.3, 1e6, 0.0].map(num_dual::Dual2_64::from);
    let lift = airfoil
        .at(&flow([alpha, others[0], others[1], others[2]]))
        .lift;
    let plain = |alpha: f64| {
        airfoil
            .at(&flow([
                Dual64::new(alpha, 1.0),
                0.3.into(),
                1e6.into(),
                0.0.into(),
            ]))
            .lift
    };
    let second = (plain(0.12 + 1e-5).eps - plain(0.12 - 1e-5).eps) / 2e-5;
    assert!(
        (lift.v2 - second).abs() < 1e-4 * (1.0 + second.abs()),
        "{} {second}",
        lift.v2
    );
    assert!((plain(0.12).re - lift.re).abs() < 1e-15);
}

/// Derivatives of tables in plain numbers compared with dual numbers, at five hundred random flows
/// inside and outside of the tables, with both interpolations: equal up to round-off.
#[test]
fn slopes_are_the_ones_of_dual_numbers() {
    let mut random = Random(11);
    for interpolation in [Interpolation::Monotone, Interpolation::Linear] {
        let airfoil = Airfoil::new(&full_table(), interpolation).unwrap();
        for _ in 0..500 {
            let x = [
                random.between(-4.0, 4.0),
                random.between(0.0, 1.0),
                random.between(1e4, 6e6),
                random.between(-0.2, 0.3),
            ];
            let of = |i: usize| DualSVec64::<4>::from_re(x[i]).derivative(i);
            let expected = airfoil.at(&flow([of(0), of(1), of(2), of(3)]));
            let found = airfoil.slopes(&flow(x));
            for (found, expected) in list(found).into_iter().zip(list(expected)) {
                let slopes = [found, expected]
                    .map(|it| it.eps.unwrap_generic(nalgebra::Const, nalgebra::Const));
                assert!((found.re - expected.re).abs() < 1e-13);
                let off = (slopes[0] - slopes[1]).amax();
                assert!(off < 1e-11 * slopes[1].amax().max(1.0), "{x:?}: {off}");
            }
            assert_eq!(airfoil.drag(&flow(x)), airfoil.at(&flow(x)).drag);
            let drag = airfoil.drag_slopes(&flow(x));
            assert_eq!(drag.re, airfoil.slopes(&flow(x)).drag.re);
        }
    }
}
