//! Attached unsteady flow against Theodorsen's theory.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;
use serde_json::Value;

use super::march::March;
use super::polars::Linear;
use crate::unsteady::{Lagged, Lags, SectionFlow, SectionForce, Strip};

/// Semichord 1 m, speed 50 m/s, amplitude small enough for a linear response.
const STRIP: Strip = Strip {
    chord: 2.0,
    density: 1.2,
};
const SPEED: f64 = 50.0;
const AMPLITUDE: f64 = 1e-4;
const STEPS: usize = 200;
const PERIODS: usize = 12;

fn reference() -> Value {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/reference/theory-rotor/theodorsen.json"
    );
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

/// Bessel functions J0, J1, Y0, Y1 by their power series, exact to rounding for x up to 2.
fn bessel(x: f64) -> [f64; 4] {
    /// Euler's constant.
    const GAMMA: f64 = 0.577_215_664_901_532_9;
    let square = -x * x / 4.0;
    let (mut zero, mut one) = (1.0, x / 2.0);
    let (mut j0, mut j1, mut y0, mut y1) = (0.0, 0.0, 0.0, 0.0);
    let mut harmonic = 0.0;
    for m in 0..40 {
        let next = harmonic + 1.0 / f64::from(m + 1);
        j0 += zero;
        j1 += one;
        y0 -= zero * harmonic;
        y1 -= one * (harmonic + next) / 2.0;
        let k = f64::from(m + 1);
        zero *= square / (k * k);
        one *= square / (k * (k + 1.0));
        harmonic = next;
    }
    let log = (x / 2.0).ln() + GAMMA;
    [
        j0,
        j1,
        2.0 / PI * (log * j0 + y0),
        2.0 / PI * (log * j1 + y1) - 2.0 / (PI * x),
    ]
}

/// Theodorsen's function C(k) = H1 / (H1 + i H0) with Hankel functions of the second kind.
fn theodorsen(k: f64) -> Complex<f64> {
    if k == 0.0 {
        return Complex::new(1.0, 0.0);
    }
    let [j0, j1, y0, y1] = bessel(k);
    let h1 = Complex::new(j1, -y1);
    // i H0 = i (J0 - i Y0)
    h1 / (h1 + Complex::new(y0, j0))
}

/// The function of two exponentials.
fn exponentials(lags: &Lags, k: f64) -> Complex<f64> {
    let part = |i: usize| {
        let ik = Complex::new(0.0, k);
        -ik * lags.parts[i] / (ik + lags.rates[i])
    };
    part(0) + part(1) + 1.0
}

fn complex(it: &Value) -> Complex<f64> {
    Complex::new(it[0].as_f64().unwrap(), it[1].as_f64().unwrap())
}

#[test]
fn theodorsens_function_is_exact() {
    // Closed form by an independent script with library functions: rounding alone.
    let it = reference();
    for (k, expected) in it["k"]
        .as_array()
        .unwrap()
        .iter()
        .zip(it["C_exact"].as_array().unwrap())
    {
        let k = k.as_f64().unwrap();
        assert!((theodorsen(k) - complex(expected)).norm() < 1e-12, "k {k}");
    }
}

#[test]
fn two_exponentials_fit_theodorsens_function() {
    let it = reference();
    for (k, expected) in it["k"]
        .as_array()
        .unwrap()
        .iter()
        .zip(it["C_jones"].as_array().unwrap())
    {
        let k = k.as_f64().unwrap();
        let fit = exponentials(&Lags::JONES, k);
        assert!((fit - complex(expected)).norm() < 1e-12, "k {k}");
    }
    // The largest errors for 0 < k <= 1, as listed there with four digits.
    let names = [
        "RTJones",
        "WJones/Leishman",
        "BL (needs its own impulsive terms)",
    ];
    for (lags, name) in [Lags::JONES, Lags::JONES_W, Lags::BEDDOES]
        .iter()
        .zip(names)
    {
        let error = |i: u32| {
            let k = f64::from(i) * 1e-3;
            (exponentials(lags, k) - theodorsen(k)).norm()
        };
        let worst = (1..=1000).map(error).fold(0.0, f64::max);
        let listed = it["max_abs_error_k_0_1"][name].as_f64().unwrap();
        assert!((worst - listed).abs() < 1e-3 * listed, "{name}: {worst}");
    }
}

/// First harmonic of lift and moment over the last period of a march.
fn harmonics(k: f64, flow: impl Fn(Complex<f64>, f64) -> SectionFlow<f64>) -> [Complex<f64>; 2] {
    let omega = k * SPEED;
    let march = March {
        model: &Lagged::default(),
        polar: &Linear { slope: TAU },
        strip: STRIP,
        step: TAU / omega / STEPS as f64,
    };
    let phase = |t: f64| Complex::from_polar(AMPLITUDE, omega * t);
    let forces = march.run(|t| flow(phase(t), omega), STEPS * PERIODS);
    let first = |value: fn(&SectionForce<f64>) -> f64| {
        let last = STEPS * (PERIODS - 1);
        let term = |i: usize| {
            let turn =
                Complex::from_polar(2.0 / STEPS as f64, -TAU * (i + 1) as f64 / STEPS as f64);
            turn * value(&forces[last + i]) / AMPLITUDE
        };
        (0..STEPS).map(term).sum::<Complex<f64>>()
    };
    [first(|it| it.normal), first(|it| it.moment)]
}

/// Lift and moment about the quarter chord of a unit amplitude of plunge (up, m) and pitch.
fn exact(k: f64, plunge: f64, pitch: f64) -> [Complex<f64>; 2] {
    let s = Complex::new(0.0, k * SPEED);
    let rho = STRIP.density;
    // Semichord 1: quarter chord at -1/2, so mid chord and three-quarter chord at 1/2 and 1.
    let middle = -s * plunge + (s * 0.5 + SPEED) * pitch;
    let rear = -s * plunge + (s + SPEED) * pitch;
    let added = s * middle * PI * rho;
    let lift = added + theodorsen(k) * rear * TAU * rho * SPEED;
    let couple = -s * (s / 8.0 + SPEED / 2.0) * pitch * PI * rho;
    [lift, couple - added * 0.5]
}

fn pitching(phase: Complex<f64>, omega: f64) -> SectionFlow<f64> {
    let (angle, rate) = (phase.re, -omega * phase.im);
    SectionFlow::rigid(SPEED * angle.sin(), SPEED * angle.cos(), rate, STRIP.chord)
}

fn plunging(phase: Complex<f64>, omega: f64) -> SectionFlow<f64> {
    SectionFlow::rigid(omega * phase.im, SPEED, 0.0, STRIP.chord)
}

#[test]
fn lift_and_moment_in_pitch_and_plunge_follow_theodorsen() {
    for k in [0.05, 0.1, 0.2, 0.5, 1.0] {
        for (it, expected) in [
            (harmonics(k, pitching), exact(k, 0.0, 1.0)),
            (harmonics(k, plunging), exact(k, 1.0, 0.0)),
        ] {
            let error = |i: usize| (it[i] - expected[i]).norm() / expected[i].norm();
            // Lift: the fit of C(k) by two exponentials. Moment: the scheme at 200 steps.
            assert!(error(0) < 0.025, "k {k}: lift {}", error(0));
            assert!(error(1) < 1e-3, "k {k}: moment {}", error(1));
        }
    }
}
