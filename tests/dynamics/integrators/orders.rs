//! Observed orders of convergence, of every scheme.
//!
//! An order is the slope between a step and its half, or the two finest of three; it may differ
//! from the order of the scheme by 0.1 (the next term of the error).

use beam_dynamics::integrator::Scheme;

use super::run;
use super::system::{Bathe, Linear, Pendulum, System};
use crate::record;

const OFF: f64 = 0.1;

/// A scheme with its name, its order on ordinary differential equations, and on index 3 its orders
/// of positions, velocities and multipliers: zero if multipliers do not converge, `None` if they
/// grow.
pub type Known = (&'static str, Scheme, i32, Option<[i32; 3]>);

pub const SCHEMES: [Known; 19] = [
    ("implicit Euler", Scheme::ImplicitEuler, 1, Some([1, 1, 1])),
    ("Crank-Nicolson", Scheme::CrankNicolson, 2, Some([2, 2, 0])),
    ("BDF2", Scheme::Bdf2, 2, Some([2, 2, 2])),
    ("two-step 0", two_step(0.0), 2, Some([2, 2, 2])),
    ("two-step 0.3", two_step(0.3), 2, Some([2, 2, 2])),
    ("two-step 0.6", two_step(0.6), 2, Some([2, 2, 2])),
    ("two-step 0.9", two_step(0.9), 2, Some([2, 2, 2])),
    ("two-step 1", two_step(1.0), 2, Some([2, 2, 0])),
    ("cubic 0", cubic(0.0), 3, Some([3, 3, 2])),
    ("cubic 0.3", cubic(0.3), 3, Some([3, 3, 2])),
    ("cubic 0.6", cubic(0.6), 3, Some([3, 3, 2])),
    ("cubic 0.9", cubic(0.9), 3, Some([3, 3, 2])),
    ("cubic 1", cubic(1.0), 4, Some([2, 2, 0])),
    ("Radau IIA", RADAU, 3, Some([3, 2, 1])),
    ("parabolic -0.8", parabolic(-0.8), 2, Some([2, 2, 1])),
    (
        "parabolic -1/2 (Gauss)",
        parabolic(-0.5),
        2,
        Some([2, 2, 1]),
    ),
    ("parabolic -1/4", parabolic(-0.25), 2, Some([2, 2, 1])),
    ("parabolic -0.1", parabolic(-0.1), 2, Some([2, 2, 1])),
    ("cubic Gauss", Scheme::CubicGauss, 4, None),
];

const RADAU: Scheme = parabolic(-2.0 / 3.0);

const fn two_step(radius: f64) -> Scheme {
    Scheme::TwoStep { radius }
}

const fn cubic(radius: f64) -> Scheme {
    Scheme::Cubic { radius }
}

const fn parabolic(zeta: f64) -> Scheme {
    Scheme::Parabolic { zeta }
}

/// x, y, their rates and lambda of the pendulum at t = 1: its ordinary equation, solved to
/// 1e-13 (`theory-dynamics` of the reference, model A).
pub const EXACT: [f64; 5] = [
    0.134_994_926_127_77,
    0.990_846_289_754_25,
    -1.710_951_582_285_85,
    0.233_103_544_764_91,
    3.972_538_869_262_65,
];

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f64::max)
}

pub fn check(case: &str, name: &str, quantity: &str, found: f64, order: i32) {
    let order = f64::from(order);
    let case = format!("{case}, {name}");
    let error = (found - order).abs();
    let source = "order of the scheme";
    record::value(source, &case, quantity, [found, order], error, OFF);
    assert!(error < OFF, "{case} {quantity}: {found}");
}

/// `y' = lambda y` against its exponential at t = 1.
#[test]
fn linear_equations_converge_with_the_order_of_the_formula() {
    let lambda: [f64; 2] = [-0.5, 3.0];
    let end = lambda[0].exp();
    let exact = [end * lambda[1].cos(), end * lambda[1].sin()];
    for (name, scheme, order, _) in SCHEMES {
        let error = |h: f64| {
            let system = System::new(Linear { lambda }, &[1.0, 0.0], &lambda);
            largest_difference(&run(system, scheme, h, 1.0), &exact)
        };
        let found = (error(0.025) / error(0.0125)).log2();
        check("y' = lambda y", name, "y", found, order);
    }
}

/// A soft elastic pendulum, by the differences of runs with halved steps: nonlinear, and with all
/// the products of Jacobians that the linear equation does not distinguish.
#[test]
fn nonlinear_equations_converge_with_the_order_of_the_formula() {
    for (name, scheme, order, _) in SCHEMES {
        let at = |h: f64| {
            let pendulum = Bathe {
                length: 1.0,
                mass: 1.0,
                gravity: 9.8,
                stiffness: 100.0,
            };
            let system = System::new(pendulum, &[0.0; 4], &[0.0, 0.0, 9.8, 0.0]);
            run(system, scheme, h, 0.5)
        };
        // The error of implicit Euler is large: it needs finer steps to be in the limit.
        let h = if order == 1 { 0.5 / 1024.0 } else { 0.005 };
        let runs = [at(h), at(0.5 * h), at(0.25 * h)];
        let coarse = largest_difference(&runs[0], &runs[1]);
        let fine = largest_difference(&runs[1], &runs[2]);
        check(
            "soft pendulum",
            name,
            "state",
            (coarse / fine).log2(),
            order,
        );
    }
}

/// Steps that show the orders on index 3. Schemes with the inner stage near an end have weights
/// that make the next terms of the error large; with a large radius the error of the first step in
/// the multipliers, which decays as radius^n, hides their error for a long time.
pub fn steps(scheme: Scheme) -> [f64; 2] {
    match scheme {
        Scheme::Cubic { radius } if radius > 0.8 && radius < 1.0 => [1.25e-3, 6.25e-4],
        Scheme::TwoStep { radius } if radius > 0.8 && radius < 1.0 => [2.5e-3, 1.25e-3],
        Scheme::Parabolic { zeta } if !(-0.7..-0.2).contains(&zeta) => [2.5e-3, 1.25e-3],
        _ => [0.01, 0.005],
    }
}

/// The pendulum at t = 1 from a consistent start.
#[test]
fn constrained_systems_converge_with_the_orders_of_index_three() {
    for (name, scheme, _, orders) in SCHEMES {
        let Some(orders) = orders else { continue };
        let errors = |h: f64| {
            let y = run(Pendulum::consistent(), scheme, h, 1.0);
            [0, 3, 4].map(|i| (y[i] - EXACT[i]).abs())
        };
        check_index_three("pendulum, index 3", name, orders, steps(scheme).map(errors));
    }
}

/// Orders from errors of x, y' and lambda at a step and its half. Multipliers that do not converge
/// keep an error of more than a tenth.
pub fn check_index_three(case: &str, name: &str, orders: [i32; 3], errors: [[f64; 3]; 2]) {
    let [coarse, fine] = errors;
    for (i, quantity) in ["x", "y'", "lambda"].into_iter().enumerate() {
        match orders[i] {
            0 => assert!(fine[i] > 0.1 * EXACT[4], "{case}, {name}: {fine:?}"),
            order => check(case, name, quantity, (coarse[i] / fine[i]).log2(), order),
        }
    }
}

/// A warning is given exactly for the schemes whose multipliers do not converge.
#[test]
fn schemes_whose_multipliers_do_not_converge_are_warned_of() {
    for (name, scheme, _, orders) in SCHEMES {
        let converges = orders.is_some_and(|orders| orders[2] > 0);
        assert_eq!(scheme.warning(true).is_none(), converges, "{name}");
        assert_eq!(scheme.warning(false), None);
    }
}

/// The prototype's numbers for stage schemes, three digits: 1 %.
#[test]
fn stage_formulas_have_the_errors_found_apart() {
    let data = super::reference("pendulum_errors.json");
    let rows = [
        ("radau_IIA_zeta_m2_3", RADAU),
        ("cubic_rho_0_6", cubic(0.6)),
    ];
    for (key, scheme) in rows {
        for (quantity, i) in [("x", 0), ("lam", 4)] {
            let expected = data["higher_order"][key][quantity].as_array().unwrap();
            for (h, expected) in [0.05, 0.025, 0.0125].into_iter().zip(expected) {
                let y = run(Pendulum::consistent(), scheme, h, 1.0);
                let found = (y[i] / EXACT[i] - 1.0).abs();
                let expected = expected.as_f64().unwrap();
                let error = (found / expected - 1.0).abs();
                let (source, case) = ("independent script", format!("pendulum, {key}, h = {h}"));
                let quantity = format!("error of {quantity}");
                record::value(source, &case, &quantity, [found, expected], error, 0.01);
                assert!(error < 0.01, "{case} {quantity}: {found}");
            }
        }
    }
}
