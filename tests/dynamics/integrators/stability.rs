//! Amplification of `y' = lambda y`, x = lambda h, and spectral radii.

use beam_dynamics::integrator::{Formula, Scheme, StepControl, Stepping};
use nalgebra::Complex;

use super::system::{Linear, System};
use super::{no_clock, run, tight};
use crate::record;

type C = Complex<f64>;

/// One step of length one, from a small y: the error of its prediction is x y, and corrections
/// beyond the size of the system are rejected.
fn amplification(scheme: Scheme, x: C) -> C {
    let (lambda, start) = ([x.re, x.im], 1e-7);
    let rates = [start * x.re, start * x.im];
    let system = System::new(Linear { lambda }, &[start, 0.0], &rates);
    let y = run(system, scheme, 1.0, 1.0);
    C::new(y[0] / start, y[1] / start)
}

fn cubic(z: f64, x: C) -> C {
    let numerator = x * x * (-z / 6.0) + x * ((1.0 - z) / 3.0) + 1.0;
    let denominator = x * x * ((1.0 + z) / 6.0) - x * ((2.0 + z) / 3.0) + 1.0;
    numerator / denominator
}

fn parabolic(z: f64, x: C) -> C {
    let numerator = x * (-z / 2.0) + 1.0;
    let denominator = x * x * ((z + 1.0) / 2.0) - x * ((z + 2.0) / 2.0) + 1.0;
    numerator / denominator
}

/// The closed forms of `[Masarati]`, appendix B.4 and B.5; iterated to round-off: 1e-11.
#[test]
fn one_step_formulas_amplify_as_their_closed_forms() {
    let positions = [
        C::new(-0.3, 0.0),
        C::new(0.0, 2.0),
        C::new(-4.0, 7.0),
        C::new(0.0, 30.0),
    ];
    let mut largest = 0.0_f64;
    for x in positions {
        let mut compare = |scheme: Scheme, expected: C| {
            let error = (amplification(scheme, x) - expected).norm();
            largest = largest.max(error);
            assert!(error < 1e-11, "{scheme:?} {x}: {error:e}");
        };
        compare(Scheme::ImplicitEuler, C::new(1.0, 0.0) / (-x + 1.0));
        compare(Scheme::CrankNicolson, (x * 0.5 + 1.0) / (x * -0.5 + 1.0));
        for radius in [0.3, 0.6, 1.0] {
            let scheme = Scheme::Cubic { radius };
            compare(scheme, cubic(-radius / (1.0 + radius), x));
        }
        for zeta in [-2.0 / 3.0, -0.5, -0.25] {
            compare(Scheme::Parabolic { zeta }, parabolic(zeta, x));
        }
        compare(Scheme::CubicGauss, cubic(-0.5, x));
    }
    let source = "[Masarati], appendix B";
    record::largest(source, "one-step schemes", "amplification", largest, 1e-11);
}

/// At x = i 1e6 the radius differs from its limit by about 1/x.
#[test]
fn radii_of_stage_formulas_for_large_steps_are_those_requested() {
    let far = C::new(0.0, 1e6);
    for radius in [0.1, 0.3, 0.6, 0.9, 1.0] {
        let found = amplification(Scheme::Cubic { radius }, far).norm();
        assert!((found - radius).abs() < 1e-5, "{radius} {found}");
    }
    // The limit is taken at zeta = -1e-3.
    let limit = amplification(Scheme::Cubic { radius: 0.0 }, far).norm();
    assert!((limit - 1e-3 / (1.0 - 1e-3)).abs() < 1e-5);
    for zeta in [-2.0 / 3.0, -0.5, -0.25] {
        assert!(amplification(Scheme::Parabolic { zeta }, far).norm() < 1e-5);
    }
}

/// The two roots of a two-step scheme at x, the principal one first.
fn roots(formula: &Formula, x: C) -> [C; 2] {
    let a = x * -formula.weights[0][0] + 1.0;
    let b = -(x * formula.latest_rates[0] + (1.0 - formula.before));
    let c = -(x * formula.rates_before[0] + formula.before);
    let discriminant = (b * b - a * c * 4.0).sqrt();
    [-b + discriminant, -b - discriminant].map(|root| root / (a * 2.0))
}

/// A double root -rho for large steps (its square root of round-off: 1e-3), and no root
/// outside the unit circle on the imaginary axis.
#[test]
fn two_step_formulas_are_stable_with_the_radius_requested() {
    for rho in [0.0, 0.3, 0.6, 0.9, 1.0] {
        let formula = Formula::two_step(rho, 1.0);
        for radius in roots(&formula, C::new(0.0, 1e9)).map(C::norm) {
            assert!((radius - rho).abs() < 1e-3, "{rho} {radius}");
        }
        let mut largest = 0.0_f64;
        for i in -400..=400 {
            let x = C::new(0.0, 10.0_f64.powf(f64::from(i) / 100.0));
            largest = roots(&formula, x)
                .map(C::norm)
                .into_iter()
                .fold(largest, f64::max);
        }
        let error = (largest - 1.0).abs();
        let case = format!("two-step, rho = {rho}");
        let quantity = "largest radius on the imaginary axis";
        record::value("A-stable", &case, quantity, [largest, 1.0], error, 1e-7);
        assert!(error < 1e-7, "{rho} {largest}");
    }
}

/// Numerical damping and relative error of the frequency of `y' = i w y`, with x = w h and
/// s = (1 - rho) / (1 + rho):
///
/// ```text
/// two-step    damping - s^3 x^3 / 4      frequency - (1 + 3 s^2) x^2 / 12
/// Radau IIA   damping - x^3 / 72         of two stages
/// ```
///
/// The listed roots (`theory-periodic/formula_damping.json`) to their round-off; the closed forms are
/// the first terms of series in x^2, within 3 % up to x = 0.1.
#[test]
fn damping_and_frequency_errors_are_the_closed_forms() {
    let text = include_str!("../../reference/theory-periodic/formula_damping.json");
    let list: serde_json::Value = serde_json::from_str(text).unwrap();
    let mut largest = 0.0_f64;
    let mut count = 0;
    for row in list["rows"].as_array().unwrap() {
        let number = |key: &str| row[key].as_f64();
        let x = number("x").unwrap();
        let at = C::new(0.0, x);
        let (root, closed) = match (number("rho"), row["radau_stages"].as_u64()) {
            (Some(rho), _) => {
                let s = (1.0 - rho) / (1.0 + rho);
                let root = roots(&Formula::two_step(rho, 1.0), at)[0];
                let frequency = -(1.0 + 3.0 * s * s) * x * x / 12.0;
                (root, [-s.powi(3) * x.powi(3) / 4.0, frequency])
            }
            (_, Some(2)) => {
                let root = amplification(Scheme::Parabolic { zeta: -2.0 / 3.0 }, at);
                (root, [-x.powi(3) / 72.0, f64::NAN])
            }
            _ => continue,
        };
        count += 1;
        let found = root.ln() / x;
        for (found, key, closed) in [
            (found.re, "damp", closed[0]),
            (found.im - 1.0, "freq", closed[1]),
        ] {
            // A logarithm near zero divided by x; steps of Radau IIA are iterated to 1e-11.
            let listed = number(key).unwrap();
            let tolerance = if row["rho"].is_null() { 1e-11 } else { 1e-13 } / x;
            assert!((found - listed).abs() < tolerance, "{row} {found}");
            if x <= 0.1 && closed.is_finite() {
                largest = largest.max((listed / closed - 1.0).abs());
            }
        }
    }
    assert!(count > 15, "{count}");
    let source = "first term of the series";
    record::largest(source, "two-step and Radau IIA", "damping", largest, 0.03);
    assert!(largest < 0.03, "{largest}");
}

/// Steps that grow each time, on `y' = 0` with an error in the state before the latest: the
/// change from step to step is multiplied by -beta. At rho = 0 and r = 1.5 beta is -0.56
/// and the changes sum up to 1.3 of the error, at other radii they alternate.
#[test]
fn growing_steps_do_not_amplify_an_error_of_the_past() {
    for radius in [0.0, 0.6, 0.8, 0.9, 0.95, 1.0] {
        let control = StepControl {
            first: 1e-6,
            least: 1e-9,
            most: 1e3,
            tolerance: 1.0,
        };
        let lambda = [0.0, 0.0];
        let mut system = System::new(Linear { lambda }, &[1.0, 0.0], &[0.0, 0.0]);
        let (scheme, stepping) = (Scheme::TwoStep { radius }, Stepping::Variable(control));
        let new = beam_dynamics::integrator::Integrator::new;
        let mut integrator = new(&system, scheme, stepping, tight(), 0.0);
        let mut step = |system: &mut System<Linear>| {
            integrator.step(system, 1e3, &no_clock).unwrap();
            integrator.counters().most_step
        };
        step(&mut system);
        let first = step(&mut system);
        system.before.y[0] += 1e-6;
        while step(&mut system) < 1e2 {}
        assert!(step(&mut system) > 1e7 * first);
        assert!((system.latest.y[0] - 1.0).abs() < 1.3e-6, "{radius}");
    }
}
