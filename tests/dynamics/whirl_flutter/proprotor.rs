//! A proprotor on a half wing, equivalent to the one of the XV-15 in symmetric modes.
//!
//! Source: an independent program of the same rotor in nine minimal coordinates (cone, gimbal, lag and
//! speed of the rotor in multiblade coordinates, beamwise and chordwise motion of the wing, pitch of the
//! pylon), linear, with constant coefficients by an average over the azimuth. Its strips have the angle
//! of attack of the quarter chord: they are compared with chords of a thousandth and a density of a
//! thousand times.
//! Published: predicted boundary of the symmetric chordwise mode, NASA TM X-62407, 1975, figures read by
//! eye; the wing and parts of the rotor are not public, so that only trends are compared.

use std::f64::consts::TAU;

use beam_dynamics::analysis::periodic::periodic_from;
use beam_dynamics::result::FloquetMode;

use super::edited;
use crate::record;

const FILE: &str = "flutter.dynamics.toml";
const STRIPS: &str = "proprotor in nine minimal coordinates";
/// Chords without effect of the rotation of the sections.
const NARROW: (&str, f64) = ("narrow", 1000.0);
/// Size of an exponent below which it is the azimuth of the rotor on its soft engine \[1/s\].
const AZIMUTH: f64 = 0.3;

/// The largest multipliers, without the azimuth, of a changed text of the file.
fn modes(parameters: &[(&str, f64)], change: impl Fn(String) -> String) -> Vec<FloquetMode> {
    let input = edited(FILE, parameters, change);
    let settings = input.periodic.as_ref().unwrap();
    let outcome = periodic_from(&input.model, settings, None);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let modes = outcome.result.floquet.unwrap().modes.into_iter();
    modes
        .filter(|mode| mode.exponent.norm() > AZIMUTH)
        .collect()
}

/// All multipliers by three stages.
fn accurate(text: String) -> String {
    text.replace("stages = \"two\"", "stages = \"three\"")
        .replace("count = 12", "count = 40")
        .replace("steps = 48", "steps = 96")
}

/// The distance of a mode from a growth \[1/s\] and a frequency \[Hz\], of which only the difference
/// from multiples of the speed is known.
fn distance(mode: &FloquetMode, [growth, frequency]: [f64; 2], rpm: f64) -> [f64; 2] {
    let turns = [-1.0, 1.0].map(|sign| (mode.frequency() / TAU + sign * frequency) * 60.0 / rpm);
    let off = turns.map(|turns| (turns - turns.round()).abs() * rpm / 60.0);
    [(mode.exponent.re - growth).abs(), off[0].min(off[1])]
}

// Frequencies and growth of the program without air at 458 rpm, to 0.1 % and 0.01 1/s: the model is the
// same to first order, but for the spring of the gimbal, which is in series with the flexures.
#[test]
fn frequencies_without_air() {
    let expected = [
        (2.975_02, 0.010_291),
        (3.720_01, 0.030_077),
        (5.906_18, 0.009_826),
        (7.914_61, 0.010_404),
        (13.538_06, 0.000_458),
        (15.418_21, 4.3e-7),
        (20.580_99, 0.007_007),
    ];
    let still = [("air_density", 1e-12), ("knots", 0.0)];
    let found = modes(&still, accurate);
    for (frequency, ratio) in expected {
        let growth = -ratio * TAU * frequency;
        let off = found
            .iter()
            .map(|mode| distance(mode, [growth, frequency], 458.0));
        let [slow, off] = off
            .min_by(|a, b| (a[0] + a[1]).total_cmp(&(b[0] + b[1])))
            .unwrap();
        let quantity = format!("frequency without air, {frequency} Hz");
        record::largest(STRIPS, "tiltrotor", &quantity, off / frequency, 1e-3);
        assert!(
            slow < 0.01 && off < 1e-3 * frequency,
            "{frequency}: {slow} {off}\n{found:#?}"
        );
    }
}

// Without air and damping mass and stiffness are symmetric and the gyroscopic terms skew: no motion
// grows or decays. Any wrong sign of a coupling shows. The error of 96 steps of three stages, of the
// size (w h)^6 w / 7200, is below 1e-5 1/s at the 28 Hz of the lag modes in the ground frame.
#[test]
fn nothing_grows_or_decays_without_air_and_damping() {
    let parameters = [
        ("air_density", 1e-12),
        ("knots", 0.0),
        ("wing_damping", 0.0),
        ("lag_damping", 0.0),
    ];
    let found = modes(&parameters, accurate);
    assert!(found.len() >= 7, "{found:#?}");
    for mode in &found {
        assert!(mode.exponent.re.abs() < 1e-4, "{mode:?}");
    }
}

// Critical speeds of the program \[kt\] and the frequency \[Hz\] of the motion that grows: stable at
// 99.5 % and unstable at 100.5 % of each. So the speeds fall with the speed of the rotor from 400 rpm on, and rise
// with altitude, as the published ones do: 400 kt at 458 rpm, 372 kt at 610 rpm, 440 and 507 kt at
// 10 000 and 20 000 ft.
#[test]
fn critical_speeds() {
    let rows = [
        (290.0, 1.225, 438.55),
        (400.0, 1.225, 441.06),
        (458.0, 1.225, 415.16),
        (520.0, 1.225, 387.65),
        (610.0, 1.225, 308.48),
        (458.0, 0.9046, 475.0),
        (458.0, 0.6527, 566.05),
    ];
    for (rpm, density, expected) in rows {
        let growth = [0.995, 1.005].map(|part| {
            let flight = [
                ("rpm", rpm),
                ("air_density", density),
                ("knots", part * expected),
                NARROW,
            ];
            modes(&flight, |text| text)[0].exponent.re
        });
        // Linear between both.
        let found = expected * (0.995 - 0.01 * growth[0] / (growth[1] - growth[0]));
        let quantity = format!("critical speed at {rpm} rpm, {density} kg/m^3 [kt]");
        let error = (found / expected - 1.0).abs();
        record::value(
            STRIPS,
            "tiltrotor",
            &quantity,
            [found, expected],
            error,
            0.005,
        );
        assert!(
            growth[0] < 0.0 && growth[1] > 0.0,
            "{rpm} {density}: {growth:?}"
        );
    }
}
