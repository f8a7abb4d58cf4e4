//! Frequencies of hubs against closed forms.

use crate::analysis::modes::modes;

use super::{read, text};

/// Mass per length \[kg/m\], root and tip \[m\] of the blade of the tests.
const BLADE: [f64; 3] = [2.0, 0.2, 1.2];

/// Moment of inertia of two blades about the center \[kg m^2\].
fn inertia() -> f64 {
    let [mass, root, tip] = BLADE;
    2.0 * mass * (tip.powi(3) - root.powi(3)) / 3.0
}

/// The lowest frequency at the last speed \[Hz\].
fn lowest(text: &str) -> f64 {
    let input = read(text);
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let table = &outcome.table;
    let points = table.at_speed(table.speeds.len() - 1).into_iter();
    points
        .map(|(_, point)| point.frequency)
        .fold(f64::INFINITY, f64::min)
}

// A rigid teetering rotor of slender blades, whose moment of inertia about the shaft is the one about
// the teeter hinge: nu^2 = 1 + K / (I Omega^2). The blades bend by a part of (Omega / omega)^2,
// 1e-4, of their own frequencies.
#[test]
fn a_teetering_rotor_has_one_per_revolution() {
    let omega = 300.0 * std::f64::consts::PI / 30.0;
    for stiffness in [0.0, 300.0] {
        let keys = format!("speed = 300\n[rotor.tilt]\nstiffness = {stiffness}\n");
        let found = lowest(&text(
            "teetering",
            &keys,
            "[modes]\nspeeds = [300]\ncount = 2\n",
        ));
        let expected = 5.0 * (1.0 + stiffness / (inertia() * omega * omega)).sqrt();
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    }
}

// At rest the center of mass hangs below the hinge: a pendulum of omega^2 = m g u / (I + m u^2).
#[test]
fn an_underslung_rotor_is_a_pendulum() {
    const DISTANCE: f64 = 0.15;
    let keys = format!("speed = 0\nundersling = {DISTANCE}\n");
    let rest = "[gravity]\nacceleration = [0, 0, -9.81]\n[modes]\nspeeds = [0]\ncount = 2\n";
    let found = lowest(&text("teetering", &keys, rest));
    let mass = 2.0 * BLADE[0] * (BLADE[2] - BLADE[1]);
    let inertia = inertia() + mass * DISTANCE * DISTANCE;
    let expected = (mass * 9.81 * DISTANCE / inertia).sqrt() / std::f64::consts::TAU;
    assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
}

// A gimbal of a rotor of three slender blades: with the spring k in each direction and the moment of
// inertia I of the rotor about a diameter, half of the polar one, the frequencies in the
// turning frame are the ones of the fixed frame -+ Omega. In the fixed frame the tilt is the one of a
// disk: I x'' + 2 I Omega y' + k x = 0.
#[test]
fn a_gimballed_rotor_precesses() {
    const STIFFNESS: f64 = 300.0;
    let omega = 300.0 * std::f64::consts::PI / 30.0;
    let keys = format!("speed = 300\nlink = 0.1\n[rotor.tilt]\nstiffness = {STIFFNESS}\n");
    let input = read(&text(
        "gimballed",
        &keys,
        "[modes]\nspeeds = [300]\ncount = 3\n",
    ));
    let outcome = modes(&input.model, &input.modes.unwrap());
    let mut found: Vec<_> = outcome
        .table
        .at_speed(0)
        .iter()
        .map(|(_, point)| point.frequency)
        .collect();
    found.sort_by(f64::total_cmp);
    let diametral = 0.75 * inertia();
    let root = (omega * omega + STIFFNESS / diametral).sqrt();
    // (root -+ Omega) in the fixed frame, seen from the turning one.
    let expected = root / std::f64::consts::TAU;
    for found in &found[..2] {
        assert!((found / expected - 1.0).abs() < 1e-3, "{found} {expected}");
    }
}
