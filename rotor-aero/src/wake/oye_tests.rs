//! The filter against its exact response, and its derivatives.

use num_dual::Dual64;
use serde_json::Value;

use super::*;

fn reference() -> Value {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/aero/theory/dynamic_inflow.json"
    );
    let text = std::fs::read_to_string(path).expect("the reference file");
    serde_json::from_str(&text).expect("JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("a list");
    list.iter()
        .map(|it| it.as_f64().expect("a number"))
        .collect()
}

/// One step of the trapezoidal rule after a unit step of the velocity: two linear rows.
fn trapezoid(state: FilterState<f64>, dt: f64, constants: (f64, f64)) -> FilterState<f64> {
    let now = rates(&state, 1.0, constants);
    let (one, two) = (0.5 * dt / constants.0, 0.5 * dt / constants.1);
    let target = 1.0 - SHARE;
    let first = (state.first + 0.5 * dt * now.first + one * target) / (1.0 + one);
    let second = state.induced + 0.5 * dt * now.induced + two * (first + SHARE);
    FilterState {
        first,
        induced: second / (1.0 + two),
    }
}

/// The exact response was evaluated by an independent script: rounding. The trapezoidal rule at
/// .1 s has an error of `dt^2 / (12 tau2^2)` of the second stage, at most 7e-5.
#[test]
fn response_to_a_step() {
    for case in reference()["cases"].as_array().expect("cases") {
        let number = |key: &str| case[key].as_f64().expect("a number");
        let constants = TimeScale::Turbine.constants(63.0, number("r_over_R"), 8.0, number("a"));
        assert!((constants.0 - number("tau1")).abs() < 1e-12 * constants.0);
        assert!((constants.1 - number("tau2")).abs() < 1e-12 * constants.1);
        let (times, expected) = (numbers(&case["t"]), numbers(&case["w_over_wqs"]));
        for (time, expected) in times.into_iter().zip(expected) {
            assert!((step_response(time, constants) - expected).abs() < 1e-12);
            let steps = (10.0 * time).round() as usize;
            let start = FilterState::default();
            let end = (0..steps).fold(start, |state, _| trapezoid(state, 0.1, constants));
            assert!(
                (end.induced - expected).abs() < 1e-4,
                "{time} {end:?} {expected}"
            );
        }
    }
}

#[test]
fn limits_of_the_time_constants() {
    let turbine = |speed: f64, a: f64| TimeScale::Turbine.constants(63.0, 1.0, speed, a).0;
    assert_eq!(turbine(0.0, 0.3), 100.0);
    assert_eq!(turbine(8.0, 0.5), turbine(8.0, 0.9));
    assert!(turbine(8.0, -5.0) > 0.0);
    assert_eq!(turbine(-8.0, 0.2), turbine(8.0, 0.2));
    let frozen = TimeScale::Frozen.constants(63.0, 1.0, 8.0, 0.3_f64);
    assert_eq!(frozen.0, 864_000.0);
    assert!((frozen.1 - 0.13 * frozen.0).abs() < 1e-6);
    let scale = TimeScale::Hover {
        least_speed: 0.5,
        cap: 0.5,
    };
    let hover = |speed: f64| scale.constants(0.127, 0.0, speed, 0.0);
    assert_eq!(hover(0.0).0, 0.127 / 0.5);
    assert_eq!(hover(-8.0).0, 0.127 / 8.0);
    assert_eq!(scale.constants(3.0f64, 0.0, 1.0, 0.0).0, 0.5);
    assert!((hover(1.0).1 - 0.39 * hover(1.0).0).abs() < 1e-16);
}

/// Rates by one variable that all inputs depend on.
fn along<T: Real>(scale: TimeScale, x: T, start: [f64; 5], slope: [f64; 5]) -> [T; 2] {
    let at = |i: usize| x * slope[i] + start[i];
    let constants = scale.constants(T::from(2.0), T::from(0.6), at(0), at(1));
    let state = FilterState {
        first: at(2),
        induced: at(3),
    };
    let rates = rates(&state, at(4), constants);
    [rates.first, rates.induced]
}

#[test]
fn derivatives_in_all_regimes() {
    let mut seed = 5u64;
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    };
    let hover = TimeScale::Hover {
        least_speed: 0.5,
        cap: 2.0,
    };
    for case in 0..800 {
        let scale = if case % 2 == 0 {
            TimeScale::Turbine
        } else {
            hover
        };
        let start = [4.0, 0.8, 3.0, 3.0, 3.0].map(|size| size * random());
        let slope = [0; 5].map(|_| random());
        if start[0].abs() < 0.02 || (start[0].abs() - 0.5).abs() < 1e-3 {
            continue;
        }
        let exact = along(scale, Dual64::from(0.0).derivative(), start, slope);
        let h = 1e-6;
        let above = along(scale, h, start, slope);
        let below = along(scale, -h, start, slope);
        for row in 0..2 {
            let central = (above[row] - below[row]) / (2.0 * h);
            // rounding: 1e-16 / 1e-6 times rates up to 10
            let error = (exact[row].eps - central).abs();
            assert!(error < 1e-6 * (1.0 + central.abs()), "{scale:?} {start:?}");
            let value = along(scale, 0.0, start, slope)[row];
            assert!((exact[row].re - value).abs() < 1e-14 * (1.0 + value.abs()));
        }
    }
}
