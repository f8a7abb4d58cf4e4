//! The laws against published formulas and their own inverses.

use num_dual::Dual64;
use serde_json::Value;

use super::*;

const LAWS: [HighInduction; 3] = [
    HighInduction::Buhl,
    HighInduction::BuhlOutside,
    HighInduction::Polynomial,
];

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter()
        .map(|it| it.as_f64().expect("a number"))
        .collect()
}

/// Values of the published formulas, evaluated by an independent script: equal to rounding.
#[test]
fn factors_of_published_formulas() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/aero/theory/high_induction.json"
    );
    let text = std::fs::read_to_string(path).expect("the reference file");
    let data: Value = serde_json::from_str(&text).expect("JSON");
    let cases = [
        ("a_momentum_buhl_F1", HighInduction::Buhl, 1.0),
        ("a_momentum_buhl_F1", HighInduction::BuhlOutside, 1.0),
        ("a_buhl_F_half", HighInduction::Buhl, 0.5),
        ("a_hawc2_polynomial", HighInduction::Polynomial, 1.0),
    ];
    for (name, law, loss) in cases {
        for (ct, a) in numbers(&data["CT"]).into_iter().zip(numbers(&data[name])) {
            let found = law.factor(ct, loss);
            assert!((found - a).abs() < 1e-12, "{name} {ct}: {found} {a}");
        }
    }
}

#[test]
fn thrust_is_the_inverse_of_the_factor() {
    for law in LAWS {
        for loss in [1.0, 0.7, 0.3, 0.05] {
            for step in -60..60 {
                let a = 0.025 * f64::from(step);
                let ct = law.thrust(a, loss);
                let back = law.factor(ct, loss);
                assert!((back - a).abs() < 1e-12, "{law:?} {loss} {a} {back}");
            }
        }
    }
}

/// The factor by `k` satisfies `CT = 4 F k (1 - a)^2`, the definition of `k`.
#[test]
fn factor_by_k_has_the_same_thrust() {
    for law in LAWS {
        for loss in [1.0, 0.7, 0.3, 0.05] {
            for step in -19_i32..200 {
                let k = 0.05 * f64::from(step * step.abs()) / 20.0;
                let a = law.factor_by(k, loss, true);
                let ct = 4.0 * loss * k * (1.0 - a) * (1.0 - a);
                let expected = law.thrust(a, loss);
                // near a = 1 the difference 1 - a loses digits: 1e-16 k
                assert!((ct - expected).abs() < 1e-9, "{law:?} {loss} {k} {a}");
            }
        }
    }
}

#[test]
fn glauert_limits() {
    for loss in [1.0f64, 0.4] {
        let at = |a: f64| HighInduction::Buhl.thrust(a, loss);
        assert!((at(1.0) - 2.0).abs() < 1e-14);
        let momentum = 4.0 * loss * SWITCH * (1.0 - SWITCH);
        assert!((at(SWITCH + 1e-12) - momentum).abs() < 1e-10);
        let slope = (at(SWITCH + 2e-6) - at(SWITCH + 1e-6)) / 1e-6;
        assert!((slope - 4.0 * loss * (1.0 - 2.0 * SWITCH)).abs() < 1e-4);
    }
    assert!((HighInduction::BuhlOutside.thrust(1.0f64, 0.4) - 0.8).abs() < 1e-14);
}

#[test]
fn derivatives_by_the_factor_and_the_loss() {
    for law in LAWS {
        for step in 0..300 {
            let a = 0.01 + 0.0067 * f64::from(step);
            let loss = 0.1 + 0.9 * f64::from((step * 53) % 300) / 300.0;
            if (a - SWITCH).abs() < 1e-4 {
                continue;
            }
            let by_a = law
                .thrust(Dual64::from(a).derivative(), Dual64::from(loss))
                .eps;
            let by_loss = law
                .thrust(Dual64::from(a), Dual64::from(loss).derivative())
                .eps;
            let h = 1e-6;
            let central_a = (law.thrust(a + h, loss) - law.thrust(a - h, loss)) / (2.0 * h);
            let central_f = (law.thrust(a, loss + h) - law.thrust(a, loss - h)) / (2.0 * h);
            // rounding of central differences: 1e-16 / 1e-6 times values up to 20
            assert!((by_a - central_a).abs() < 2e-8, "{law:?} {a} {loss}");
            assert!((by_loss - central_f).abs() < 2e-8, "{law:?} {a} {loss}");
        }
    }
}
