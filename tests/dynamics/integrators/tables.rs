//! Published tables, and independently derived coefficients.
//!
//! Sources: [Masarati], Tables 10.1, 10.2 and C.1; `tests/reference/dynamics`:
//! `integrator_coefficients.json`, `pendulum_errors.json`, `table_c1.csv`,
//! `bathe_pendulum.json`.

use beam_dynamics::integrator::{Formula, Scheme};
use serde_json::Value;

use super::system::{Bathe, Imposed, Pendulum, System};
use super::{integrator, no_clock, reference, reference_text, run};
use crate::record;

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(number).collect()
}

/// Rational numbers of few operations: 1e-12 allows for the cancellation of three digits.
#[test]
fn coefficients_are_those_derived_apart() {
    let data = reference("integrator_coefficients.json");
    let mut largest = 0.0_f64;
    let mut compare = |found: f64, expected: f64| largest = largest.max((found - expected).abs());
    for row in data["ms"].as_array().unwrap() {
        let formula = Formula::two_step(number(&row["rho"]), number(&row["r"]));
        compare(formula.before, number(&row["beta"]));
        compare(formula.weights[0][0], number(&row["b0"]));
        compare(formula.latest_rates[0], number(&row["b1"]));
        compare(formula.rates_before[0], number(&row["b2"]));
    }
    let radau = (&data["radau_IIA"], Formula::parabolic(-2.0 / 3.0));
    let cubic = data["cubic"].as_array().unwrap().iter();
    let cubic = cubic.map(|row| (row, Formula::cubic(number(&row["rho"]))));
    for (row, formula) in cubic.chain([radau]) {
        let [w1, wz, w0] = numbers(&row["w"])[..] else {
            panic!("three weights");
        };
        let [m0, _, n0, n1] = numbers(&row["shape_at_zeta"])[..] else {
            panic!("four shape functions");
        };
        compare(formula.positions[0], number(&row["zeta"]));
        compare(formula.latest_rates[1], w1);
        compare(formula.weights[1][0], wz);
        compare(formula.weights[1][1], w0);
        compare(formula.latest_rates[0], m0 * w1 + n1);
        compare(formula.weights[0][0], m0 * wz);
        compare(formula.weights[0][1], m0 * w0 + n0);
    }
    let source = "independent derivation";
    record::largest(source, "formulas", "coefficients", largest, 1e-12);
    assert!(largest < 1e-12, "{largest:e}");
}

/// `[Masarati]`, section 4.1: 4/3 at rho = 0, 1 at rho = 1, the least 0.79 at 0.58.
#[test]
fn error_constants_of_the_two_step_formula_are_those_published() {
    let data = reference("integrator_coefficients.json");
    let constants = &data["error_constant_h3"];
    let least = &constants["minimum"];
    let rows = [
        (0.0, number(&constants["rho_0"])),
        (1.0, number(&constants["rho_1"])),
        (number(&least["rho"]), number(&least["value"])),
    ];
    for (rho, expected) in rows {
        let found = 6.0 * Formula::two_step(rho, 1.0).error;
        assert!((found - expected).abs() < 1e-8, "{rho} {found}");
    }
}

/// The roots of |beta| = 1 were found by bisection to four digits.
#[test]
fn zero_stability_bounds_the_growth_of_steps() {
    let data = reference("integrator_coefficients.json");
    for (rho, expected) in data["max_step_ratio_zero_stable"].as_object().unwrap() {
        let rho: f64 = rho.parse().unwrap();
        let bound = Formula::largest_ratio(rho);
        assert!((bound - number(expected)).abs() < 1e-3, "{rho} {bound}");
        let beta = |ratio: f64| Formula::two_step(rho, ratio).before.abs();
        assert!((beta(bound) - 1.0).abs() < 1e-12);
        assert!(beta(0.99 * bound) < 1.0 && beta(1.01 * bound) > 1.0);
    }
}

/// Crank-Nicolson, then BDF2, on y = cos t, from consistent and from zero accelerations. The table
/// is printed to 16 digits: round-off, over h^2 in the multiplier: 1e-11.
#[test]
fn table_c1() {
    let text = reference_text("table_c1.csv");
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let rows: Vec<Vec<f64>> = reader.deserialize().map(Result::unwrap).collect();
    let step = rows[1][1];
    for (rates, column) in [([0.0, -1.0, 0.0], 4), ([0.0, 0.0, 0.0], 5)] {
        let start = [1.0, 0.0, -rates[1]];
        let mut system = System::new(Imposed, &start, &rates);
        let mut integrator = integrator(&system, Scheme::Bdf2, step);
        let mut largest = 0.0_f64;
        for row in &rows[1..] {
            integrator.step(&mut system, 1.0, &no_clock).unwrap();
            let expected = [row[2], row[3], row[column]];
            for (found, expected) in system.latest.y.iter().zip(expected) {
                largest = largest.max((found - expected).abs());
            }
        }
        let case = ["agreeing start", "start at rest"][column - 4];
        record::largest(
            "[Masarati], Table C.1",
            case,
            "y, v, lambda",
            largest,
            1e-11,
        );
        assert!(largest < 1e-11, "{largest:e}");
    }
}

const QUANTITIES: [&str; 5] = ["x", "y", "x'", "y'", "lambda"];

/// Errors as printed: x, y, x', y', lambda for h = .01, .005, .0025.
pub const TABLE_10_1: [[f64; 3]; 5] = [
    [3.1e-3, 7.8e-4, 2.0e-4],
    [5.7e-5, 1.4e-5, 3.6e-6],
    [3.1e-4, 7.6e-5, 1.9e-5],
    [3.0e-3, 7.4e-4, 1.9e-4],
    [2.4e-4, 5.9e-5, 1.4e-5],
];
pub const TABLE_10_2: [[f64; 3]; 5] = [
    [9.5e-4, 2.4e-4, 6.0e-5],
    [1.8e-5, 4.4e-6, 1.1e-6],
    [9.2e-5, 2.3e-5, 5.6e-6],
    [9.1e-4, 2.2e-4, 5.7e-5],
    [7.1e-5, 1.8e-5, 4.3e-6],
];

/// Relative errors of the pendulum at t = 1.
fn pendulum_errors(rho: f64, h: f64, is_consistent: bool) -> [f64; 5] {
    let data = reference("pendulum_errors.json");
    let exact = ["x", "y", "xdot", "ydot", "lam"].map(|name| number(&data["reference"][name]));
    let system = if is_consistent {
        Pendulum::consistent()
    } else {
        Pendulum::inconsistent()
    };
    let found = run(system, Scheme::TwoStep { radius: rho }, h, 1.0);
    std::array::from_fn(|i| (found[i] / exact[i] - 1.0).abs())
}

/// Half a unit of the last of two digits.
pub fn rounding(printed: f64) -> f64 {
    0.05 * 10.0_f64.powf(printed.log10().floor())
}

/// The errors of the thesis to 2 % beyond the rounding of their two digits.
#[test]
fn tables_10_1_and_10_2() {
    for (rho, table) in [(0.0, TABLE_10_1), (0.6, TABLE_10_2)] {
        let source = format!("[Masarati], Table 10.{}", if rho == 0.0 { 1 } else { 2 });
        for (column, h) in [0.01, 0.005, 0.0025].into_iter().enumerate() {
            let found = pendulum_errors(rho, h, false);
            for (i, quantity) in QUANTITIES.into_iter().enumerate() {
                let printed = table[i][column];
                let tolerance = 0.02 + rounding(printed) / printed;
                let error = (found[i] / printed - 1.0).abs();
                let (case, pair) = (format!("pendulum, h = {h}"), [found[i], printed]);
                let quantity = format!("error of {quantity} at t = 1");
                record::value(&source, &case, &quantity, pair, error, tolerance);
                assert!(error < tolerance, "{case} {quantity} {pair:?}");
            }
        }
    }
}

/// The same errors from an independent script, to three digits: 1 %.
#[test]
fn pendulum_errors_are_those_found_apart() {
    let data = reference("pendulum_errors.json");
    for row in data["runs"].as_array().unwrap() {
        let (rho, h) = (number(&row["rho"]), number(&row["h"]));
        for (name, is_consistent) in [("inconsistent", false), ("consistent", true)] {
            let found = pendulum_errors(rho, h, is_consistent);
            let mut largest = 0.0_f64;
            for (found, expected) in found.iter().zip(numbers(&row[name])) {
                largest = largest.max((found / expected - 1.0).abs());
            }
            let case = format!("pendulum, rho = {rho}, h = {h}, {name} start");
            record::largest("independent script", &case, "errors", largest, 0.01);
            assert!(largest < 0.01, "{case} {largest}");
        }
    }
}

/// Angles in degrees from the downward vertical, of a rod whose axial period is 2e-4 of the period
/// of the pendulum. The script's angles have ten digits, 1e-8 degrees; the stiff rod loses two of
/// the iteration's: 1e-6.
#[test]
fn bathe_pendulum_in_rotation_coordinates() {
    let data = reference("bathe_pendulum.json");
    let inputs = &data["inputs"];
    let length = number(&inputs["L"]);
    let schemes = [
        ("two_step_rho06", Scheme::TwoStep { radius: 0.6 }),
        ("cubic_rho06", Scheme::Cubic { radius: 0.6 }),
    ];
    for (name, scheme) in schemes {
        for (key, step) in [("h0.01", 0.01), ("h0.5", 0.5)] {
            for (i, expected) in numbers(&data[name][key]).into_iter().enumerate() {
                let bathe = Bathe {
                    length,
                    mass: number(&inputs["m"]),
                    gravity: number(&inputs["g"]),
                    stiffness: number(&inputs["EA"]) / length,
                };
                let gravity = bathe.gravity;
                let rates = [0.0, 0.0, gravity / length, 0.0];
                let system = System::new(bathe, &[0.0; 4], &rates);
                let time = 2.5 * (i + 1) as f64;
                let found = run(system, scheme, step, time)[0].to_degrees() - 90.0;
                let error = (found - expected).abs();
                let (case, quantity) = (format!("{name}, {key}"), format!("angle at {time} s"));
                let source = "independent script";
                record::value(source, &case, &quantity, [found, expected], error, 1e-6);
                assert!(error < 1e-6, "{case} {quantity}: {found} {expected}");
            }
        }
    }
}
