//! The velocity form against the solution by the angle, and its derivatives.

use num_dual::{Dual64, DualSVec64};

use super::*;
use crate::momentum::annulus::Options;
use crate::momentum::steady::{Outcome, solve};

struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
}

fn section<T: Real>(alpha: T) -> Coefficients<T> {
    let (sin, cos) = alpha.sin_cos();
    Coefficients {
        lift: sin * cos * 5.5,
        drag: sin * sin * 1.2 + 0.01,
        moment: T::from(0.0),
    }
}

fn ring(random: &mut Random, law: HighInduction) -> Annulus {
    let radius = random.between(0.15, 0.97);
    Annulus {
        radius,
        hub_radius: 0.1,
        tip_radius: 1.0,
        blades: 3,
        chord: random.between(0.02, 0.1),
        options: Options {
            high_induction: law,
            ..Options::default()
        },
    }
}

/// The solution by the angle is in balance in the velocity form, where momentum holds: the
/// residual over the load is the share of `e^2 = 1e-6` in the square of `m`.
#[test]
fn steady_states_are_in_balance() {
    let mut random = Random(3);
    let mut compared = 0;
    for _ in 0..2000 {
        let annulus = ring(&mut random, HighInduction::Buhl);
        let (vx, vy) = (random.between(1.0, 40.0), 100.0 * annulus.radius);
        let pitch = random.between(-0.2, 0.6);
        let state = solve(&annulus, pitch, vx, vy, section);
        if state.outcome != Outcome::Solved || -state.axial / vx > 0.399 {
            continue;
        }
        let ambient = Ambient {
            axial: vx,
            rotation: vy,
            skew: 0.0,
        };
        let (u, v) = (state.axial, state.swirl);
        let coefficients = section(pitch - induced_flow(&ambient, u, v).phi);
        let (u_qs, v_qs) = quasi_steady(&annulus, &ambient, u, v, coefficients);
        let share = 1e-6 / (vx + u).powi(2) + 1e-8;
        if (vx + u).abs() < 0.01 * vy {
            continue;
        }
        assert!(
            (u_qs - u).abs() < share * (1.0 + u.abs()),
            "{annulus:?} {u} {u_qs}"
        );
        assert!(
            (v_qs - v).abs() < share * (1.0 + v.abs()),
            "{annulus:?} {v} {v_qs}"
        );
        compared += 1;
    }
    assert!(compared > 1000, "{compared}");
}

/// `u m(u)` grows with `u` from climb to descent, for all laws of one branch.
#[test]
fn loads_grow_with_the_induced_velocity() {
    let mut random = Random(5);
    let laws = [
        HighInduction::Buhl,
        HighInduction::BuhlOutside,
        HighInduction::Polynomial,
    ];
    for law in laws {
        let annulus = ring(&mut random, law);
        for loss in [1.0, 0.7, 0.4, 0.1] {
            let ambient = Ambient {
                axial: 10.0,
                rotation: 50.0,
                skew: 0.0,
            };
            let load = |u: f64| u * mass_flow(&annulus, &ambient, u, loss);
            for step in 0..1000 {
                let u = -40.0 + 0.06 * f64::from(step);
                assert!(load(u + 0.06) > load(u), "{law:?} {loss} {u}");
            }
        }
    }
}

#[test]
fn hover_is_the_limit_of_climb_and_descent() {
    let mut random = Random(9);
    let annulus = ring(&mut random, HighInduction::BuhlOutside);
    let at = |axial: f64, loss: f64| {
        let ambient = Ambient {
            axial,
            rotation: 80.0,
            skew: 0.0,
        };
        mass_flow(&annulus, &ambient, 5.0, loss)
    };
    for loss in [1.0, 0.5, 0.05] {
        let hover = at(0.0, loss);
        assert!((hover - 5.0).abs() < 1e-6);
        for axial in [1e-4, -1e-4, 1e-300, -1e-300] {
            assert!((at(axial, loss) - hover).abs() < 2e-4, "{axial}");
        }
    }
}

/// Velocities and the angle of attack as independent variables: Vx, Vy, Vt, u, v.
fn evaluate<T: Real>(annulus: &Annulus, pitch: f64, x: [T; 5]) -> [T; 4] {
    let ambient = Ambient {
        axial: x[0],
        rotation: x[1],
        skew: x[2],
    };
    let flow = induced_flow(&ambient, x[3], x[4]);
    let coefficients = section(-flow.phi + pitch);
    let (u, v) = quasi_steady(annulus, &ambient, x[3], x[4], coefficients);
    let (r, s) = balance(annulus, &ambient, x[3], x[4], coefficients);
    [u, v, r, s]
}

/// The branch that holds: a point near its limit is not differentiable.
fn is_smooth(annulus: &Annulus, pitch: f64, x: [f64; 5], h: f64) -> bool {
    let slopes = |shift: f64, i: usize| {
        let at = |e: f64| {
            let mut y = x;
            y[i] += shift + e;
            evaluate(annulus, pitch, y)[2]
        };
        (at(h) - at(-h)) / (2.0 * h)
    };
    (0..5).all(|i| {
        let (one, other) = (slopes(-2.0 * h, i), slopes(2.0 * h, i));
        (one - other).abs() < 1e-2 * (1.0 + one.abs())
    })
}

/// From climb to descent, in skewed flow too: a jump would leave equations without a solution. The slopes are
/// below 4 (the turbulent wake of small loss).
#[test]
fn the_mass_flow_is_continuous() {
    let mut random = Random(7);
    for law in [HighInduction::BuhlOutside, HighInduction::Polynomial] {
        let annulus = ring(&mut random, law);
        for axial in [-15.0, -1e-3, 1e-3, 9.0] {
            for skew in [0.0, 1.0, 10.0] {
                let ambient = Ambient {
                    axial,
                    rotation: 50.0,
                    skew,
                };
                let at = |u: f64| mass_flow(&annulus, &ambient, u, 0.6);
                for step in -3000..3000 {
                    // u = 0 lies between two values.
                    let [one, other] = [0.0, 0.01].map(|h| at(0.01 * f64::from(step) - 0.005 + h));
                    assert!((one - other).abs() < 0.04, "{law:?} {axial} {skew} {step}");
                }
            }
        }
    }
}

#[test]
fn derivatives_in_all_regimes() {
    let mut random = Random(11);
    let laws = [
        HighInduction::Buhl,
        HighInduction::BuhlOutside,
        HighInduction::Polynomial,
        HighInduction::Momentum,
    ];
    let mut compared = 0;
    for case in 0..1200 {
        let annulus = ring(&mut random, laws[case % 4]);
        let pitch = random.between(-0.5, 0.8);
        let mut x = [0.0; 5];
        for (value, (low, high)) in x.iter_mut().zip([
            (-20.0, 30.0),
            (5.0, 120.0),
            (-5.0, 5.0),
            (-40.0, 25.0),
            (-5.0, 10.0),
        ]) {
            *value = random.between(low, high);
        }
        let h = 1e-5;
        if !is_smooth(&annulus, pitch, x, h) {
            continue;
        }
        compared += 1;
        compare_derivatives(&annulus, pitch, x, h);
    }
    assert!(compared > 900, "{compared}");
}

fn compare_derivatives(annulus: &Annulus, pitch: f64, x: [f64; 5], h: f64) {
    for i in 0..5 {
        let mut dual = x.map(Dual64::from);
        dual[i] = dual[i].derivative();
        let exact = evaluate(annulus, pitch, dual);
        let shifted = |h: f64| {
            let mut y = x;
            y[i] += h;
            evaluate(annulus, pitch, y)
        };
        let (above, below, values) = (shifted(h), shifted(-h), evaluate(annulus, pitch, x));
        for row in 0..4 {
            let central = (above[row] - below[row]) / (2.0 * h);
            // truncation 1e-10 f''' near the ends of blades, rounding 1e-16 f / 1e-5
            let size = 1.0 + central.abs() + values[row].abs();
            let error = (exact[row].eps - central).abs();
            assert!(
                error < 2e-5 * size,
                "{annulus:?} {x:?} {i} {row}: {error} {central}"
            );
            // the same operations in another order
            assert!((exact[row].re - values[row]).abs() < 1e-13 * size);
        }
    }
}

#[test]
fn any_input_is_finite_or_not_a_number() {
    let mut random = Random(13);
    let annulus = ring(&mut random, HighInduction::Buhl);
    for axial in [0.0, -0.0, 1e-310, -1e-12, 12.0] {
        for u in [0.0, 4.0, -4.0, -1e-8, -30.0] {
            for rotation in [0.0, 40.0, -40.0] {
                let x = [axial, rotation, 0.0, u, 0.0].map(DualSVec64::<2>::from);
                let values = evaluate(&annulus, 0.2, x);
                assert!(
                    values.iter().all(|it| it.re.is_finite()),
                    "{axial} {u} {rotation}"
                );
            }
        }
    }
    assert!(evaluate(&annulus, 0.2, [f64::NAN; 5])[0].is_nan());
}
