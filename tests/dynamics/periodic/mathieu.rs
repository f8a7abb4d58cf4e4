//! A hinged bar with a spring that is modulated in time: Mathieu's equation,
//!
//! ```text
//! q'' + ( delta + epsilon cos t ) q = 0
//! ```
//!
//! of a body with the moment of inertia one about its hinge.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix};

use super::{Random, analyzed, modes, monodromy, multipliers, off_by_sums};
use crate::effort::cases;
use crate::trim::reference;

/// A bar of mass one at the distance 0.5 from its hinge about y.
fn bar(delta: f64, epsilon: f64, settings: &str) -> String {
    bar_of(&format!("{delta:?}"), epsilon, settings)
}

/// The same with an expression of the mean stiffness.
pub fn bar_of(delta: &str, epsilon: f64, settings: &str) -> String {
    format!(
        "[[node]]\nname = \"bar\"\nposition = [0, 0, -0.5]\n\
         [[body]]\nname = \"bar\"\nnode = \"bar\"\nmass = 1\ninertia = [0.5, 0.75, 0.5]\n\
         [[joint]]\nname = \"hinge\"\nkind = \"revolute\"\nnodes = [\"bar\"]\nat = [0, 0, 0]\n\
         axis = [0, 1, 0]\n\
         [sensors.tilt]\nquantity = \"rotation\"\nof = \"bar\"\ncomponent = \"y\"\nunit = \"rad\"\n\
         [[load]]\nnode = \"bar\"\nmoment = [0, -1, 0]\n\
         drive = \"= ({delta} + {epsilon:?}*cos(t))*tilt\"\n\
         [periodic]\nperiod = {TAU:?}\n{settings}\n"
    )
}

fn exact(delta: f64, epsilon: f64) -> Vec<Complex<f64>> {
    let a = |t: f64| DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -(delta + epsilon * t.cos()), 0.0]);
    let found = monodromy(a, TAU, 4_000).complex_eigenvalues();
    found.iter().copied().collect()
}

const THREE: &str = "steps = 128\n[periodic.floquet]\nerror_estimate = false";

// Nine points of the chart, two of them with a damper, by an independent ordinary differential equation
// (`theory-periodic/mathieu.json`, relative tolerance 1e-12): multipliers to 1e-6, growth to 1e-7.
#[test]
fn points_of_the_chart() {
    let rows = reference("theory-periodic/mathieu.json")["chart"].clone();
    assert_eq!(rows.as_array().unwrap().len(), 9);
    for row in rows.as_array().unwrap() {
        let number = |name: &str| row[name].as_f64().unwrap();
        let (delta, epsilon, c) = (number("delta"), number("epsilon"), number("c"));
        let damper = format!(
            "{THREE}\n[[spring]]\nname = \"damper\"\nnode = \"bar\"\nstiffness = [0, 0, 0]\n\
             rotational_damping = [0, {c:?}, 0]\n"
        );
        let settings = if c > 0.0 { damper.as_str() } else { THREE };
        let (outcome, _) = analyzed(&bar(delta, epsilon, settings));
        let pairs = row["multipliers_ode"].as_array().unwrap().iter();
        let part = |pair: &serde_json::Value, i: usize| pair[i].as_f64().unwrap();
        let expected: Vec<_> = pairs
            .map(|mu| Complex::new(part(mu, 0), part(mu, 1)))
            .collect();
        let off = off_by_sums(&multipliers(&outcome), &expected);
        assert!(off < 1e-6, "{row}: {off:e}");
        let growth = row["exponents_ode"][0][0].as_f64().unwrap();
        let found = modes(&outcome)[0].exponent.re;
        assert!((found - growth).abs() < 1e-7, "{row}: {found}");
        let table = outcome.result.floquet.as_ref().unwrap();
        assert_eq!(table.states, Some(2));
        assert!(modes(&outcome)[0].name.contains("rotation about y"));
    }
}

// All 28 boundaries of seven kinds at four epsilons (`theory-periodic/mathieu.json`: characteristic values
// of Mathieu functions): both multipliers are 1 or -1 there. Their sum, which has a slope of 1 to 10 in
// delta, is +-2 to 1e-6; at the next boundary it is -+2, and it passes through all values between.
#[test]
fn both_multipliers_are_one_at_the_boundaries() {
    let tables = reference("theory-periodic/mathieu.json")["boundaries"].clone();
    let mut count = 0;
    for table in tables.as_array().unwrap() {
        let epsilon = table["epsilon"].as_f64().unwrap();
        for (name, delta) in table["boundaries_delta"].as_object().unwrap() {
            let sign = if ["a1", "b1", "a3", "b3"].contains(&name.as_str()) {
                -1.0
            } else {
                1.0
            };
            let (outcome, _) = analyzed(&bar(delta.as_f64().unwrap(), epsilon, THREE));
            let sum = multipliers(&outcome).iter().sum::<Complex<f64>>();
            let off = (sum - 2.0 * sign).norm();
            assert!(off < 1e-6, "{epsilon} {name}: {sum}");
            count += 1;
        }
    }
    assert_eq!(count, 28);
}

// The equation has no damping: multipliers come in reciprocal pairs. Exact multipliers by 4 000
// steps of fourth order, errors below 1e-10; Radau IIA of fifth order at the largest x = 0.12.
#[test]
fn multipliers_of_random_bars() {
    let mut random = Random(1);
    for _ in 0..cases(30) {
        let (delta, epsilon) = (2.0 * random.next().abs(), random.next());
        let (outcome, _) = analyzed(&bar(delta, epsilon, THREE));
        let found = multipliers(&outcome);
        let off = off_by_sums(&found, &exact(delta, epsilon));
        assert!(off < 1e-6, "{delta} {epsilon}: {off:e}");
        let product = found[0] * found[1];
        assert!(
            (product - 1.0).norm() < 1e-6,
            "{delta} {epsilon}: {product}"
        );
    }
}

// Errors of exponents are of third order with two stages and of fifth with three; with two stages
// (8 s(2n) - s(n))/7 is more accurate by two digits at least.
#[test]
fn orders_of_both_formulas() {
    let (delta, epsilon) = (6.3504, 1.2);
    let exact = exact(delta, epsilon)[0];
    let exact = Complex::new(exact.ln().re / TAU, exact.ln().im.abs() / TAU);
    let exponent = |stages: &str, steps: usize| {
        let settings = format!(
            "steps = {steps}\nstages = \"{stages}\"\n[periodic.floquet]\nerror_estimate = false"
        );
        let (outcome, _) = analyzed(&bar(delta, epsilon, &settings));
        let ln = modes(&outcome)[0].multiplier.ln() / TAU;
        Complex::new(ln.re, ln.im.abs())
    };
    for (stages, steps, order) in [("two", [128, 256], 3.0), ("three", [32, 64], 5.0)] {
        let found = steps.map(|steps| exponent(stages, steps));
        let errors = found.map(|s| (s - exact).re.abs());
        let observed = (errors[0] / errors[1]).log2();
        assert!(
            (observed - order).abs() < 0.3,
            "{stages}: {observed}, {errors:?}"
        );
        if stages == "two" {
            let extrapolated = (8.0 * found[1] - found[0]) / 7.0;
            assert!(
                (extrapolated - exact).norm() < 1e-6,
                "{extrapolated} {exact}"
            );
        }
    }
}

// The estimate from half the steps is of the size of the error.
#[test]
fn errors_are_estimated() {
    let settings = "steps = 48\n[periodic.floquet]\ncount = 2";
    let (outcome, _) = analyzed(&bar(6.3504, 1.2, settings));
    let mode = &modes(&outcome)[0];
    let exact = exact(6.3504, 1.2)[0];
    let exact = Complex::new(exact.re, exact.im.abs());
    let off = ((mode.multiplier / exact).ln() / TAU).norm();
    let estimated = mode.error.unwrap();
    assert!(
        estimated > 0.5 * off && estimated < 2.0 * off,
        "{estimated:e} {off:e}"
    );
    assert_eq!(mode.stability().word(), "below error");
}
