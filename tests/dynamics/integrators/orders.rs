//! Observed orders of convergence, of every scheme.
//!
//! An order is the slope between the two finest of three steps, halved each time; it may
//! fall short of the order of the formula by 0.1 (the next term of the error).

use beam_dynamics::integrator::Scheme;

use super::run;
use super::system::{Bathe, Linear, Pendulum, System};
use crate::record;

const SHORTFALL: f64 = 0.1;

/// Schemes with their orders on ordinary differential equations, and on index 3 those of
/// positions, velocities and multipliers (`None`: the multipliers do not converge).
const SCHEMES: [(&str, Scheme, i32, Option<[i32; 3]>); 13] = [
    ("implicit Euler", Scheme::ImplicitEuler, 1, Some([1, 1, 1])),
    ("Crank-Nicolson", Scheme::CrankNicolson, 2, None),
    ("BDF2", Scheme::Bdf2, 2, Some([2, 2, 2])),
    ("two-step 0.3", TWO_STEP[0], 2, Some([2, 2, 2])),
    ("two-step 0.6", TWO_STEP[1], 2, Some([2, 2, 2])),
    ("two-step 1", Scheme::TwoStep { radius: 1.0 }, 2, None),
    ("cubic 0", CUBIC[0], 3, Some([3, 3, 2])),
    ("cubic 0.6", CUBIC[1], 3, Some([3, 3, 2])),
    ("cubic 1", Scheme::Cubic { radius: 1.0 }, 4, None),
    ("Radau IIA", PARABOLIC[0], 3, Some([3, 2, 1])),
    ("parabolic -1/2 (Gauss)", PARABOLIC[1], 2, Some([2, 2, 1])),
    ("parabolic -1/4", PARABOLIC[2], 2, Some([2, 2, 1])),
    ("cubic Gauss", Scheme::CubicGauss, 4, None),
];

const TWO_STEP: [Scheme; 2] = [
    Scheme::TwoStep { radius: 0.3 },
    Scheme::TwoStep { radius: 0.6 },
];
const CUBIC: [Scheme; 2] = [Scheme::Cubic { radius: 0.0 }, Scheme::Cubic { radius: 0.6 }];
const PARABOLIC: [Scheme; 3] = [
    Scheme::Parabolic { zeta: -2.0 / 3.0 },
    Scheme::Parabolic { zeta: -0.5 },
    Scheme::Parabolic { zeta: -0.25 },
];

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f64::max)
}

fn check(case: &str, name: &str, quantity: &str, found: f64, order: i32) {
    let least = f64::from(order) - SHORTFALL;
    let case = format!("{case}, {name}");
    record::order("order of the formula", &case, quantity, found, least);
    assert!(found > least, "{case} {quantity}: {found}");
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

/// A soft elastic pendulum, by the differences of runs with halved steps: nonlinear, and
/// with all the products of Jacobians that the linear equation cannot tell apart.
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

/// The pendulum at t = 1 from an agreeing start: x, y' and lambda against the solution of
/// its ordinary equation to 1e-13 (`theory-dynamics` of the reference, model A).
#[test]
fn constrained_systems_converge_with_the_orders_of_index_three() {
    let exact = [
        0.134_994_926_127_77,
        0.233_103_544_764_91,
        3.972_538_869_262_65,
    ];
    for (name, scheme, _, orders) in SCHEMES {
        let Some(orders) = orders else { continue };
        let errors = |h: f64| {
            let y = run(Pendulum::consistent(), scheme, h, 1.0);
            let found = [y[0], y[3], y[4]];
            std::array::from_fn::<_, 3, _>(|i| (found[i] - exact[i]).abs())
        };
        let (coarse, fine) = (errors(0.01), errors(0.005));
        for (i, quantity) in ["x", "y'", "lambda"].into_iter().enumerate() {
            let found = (coarse[i] / fine[i]).log2();
            check("pendulum, index 3", name, quantity, found, orders[i]);
        }
    }
}

/// Schemes that do not damp: positions of second order, multipliers that stay wrong by
/// more than a tenth whatever the step; exactly these schemes are warned of.
#[test]
fn schemes_whose_multipliers_do_not_converge_are_warned_of() {
    for (name, scheme, _, orders) in SCHEMES {
        assert_eq!(scheme.warning(true).is_some(), orders.is_none(), "{name}");
        assert_eq!(scheme.warning(false), None);
        if orders.is_some() || scheme == Scheme::CubicGauss {
            continue;
        }
        for h in [0.02, 0.01] {
            let y = run(Pendulum::consistent(), scheme, h, 1.0);
            assert!((y[4] / 3.972_538_869_262_65 - 1.0).abs() > 0.1, "{name}");
            assert!((y[0] / 0.134_994_926_127_77 - 1.0).abs() < 5e-3, "{name}");
        }
    }
}

/// The prototype's numbers for stage formulas, three digits: 1 %.
#[test]
fn stage_formulas_have_the_errors_found_apart() {
    let data = super::reference("pendulum_errors.json");
    let exact = [0.134_994_926_127_77, 3.972_538_869_262_65];
    let rows = [
        ("radau_IIA_zeta_m2_3", PARABOLIC[0]),
        ("cubic_rho_0_6", CUBIC[1]),
    ];
    for (key, scheme) in rows {
        for (quantity, i) in [("x", 0), ("lam", 4)] {
            let expected = data["higher_order"][key][quantity].as_array().unwrap();
            for (h, expected) in [0.05, 0.025, 0.0125].into_iter().zip(expected) {
                let y = run(Pendulum::consistent(), scheme, h, 1.0);
                let found = (y[i] / exact[i / 4] - 1.0).abs();
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
