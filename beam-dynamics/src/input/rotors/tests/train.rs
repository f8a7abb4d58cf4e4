//! Drive trains against closed forms.

use std::f64::consts::TAU;

use super::{Run, read, refused, text};
use crate::analysis::modes::modes;

/// Moment of inertia of the rotor of the tests about its shaft [kg m^2].
fn inertia() -> f64 {
    3.0 * 2.0 * (1.2_f64.powi(3) - 0.2_f64.powi(3)) / 3.0
}

// Two inertias on a spring: omega^2 = k (1 / I + 1 / (n^2 J)), with damping c the growth
// -c (1 / I + 1 / (n^2 J)) / 2. The blades bend by 1e-6 of it; with an engine that turns at constant
// speed its inertia is infinite.
#[test]
fn shafts_have_their_torsional_frequency() {
    const STIFFNESS: f64 = 500.0;
    const DAMPING: f64 = 2.0;
    let shaft = format!("[rotor.drive]\nstiffness = {STIFFNESS}\ndamping = {DAMPING}\n");
    for (keys, engine) in [
        (
            format!("torque = 0\n{shaft}inertia = 0.02\ngear = 12\n"),
            144.0 * 0.02,
        ),
        (format!("speed = 0\n{shaft}"), f64::INFINITY),
    ] {
        let input = read(&text("rigid", &keys, "[modes]\nspeeds = [0]\ncount = 2\n"));
        let outcome = modes(&input.model, &input.modes.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let points = outcome.table.at_speed(0).into_iter();
        let torsion = points.map(|(_, point)| [point.frequency, point.growth]);
        let [frequency, growth] = torsion
            .filter(|found| found[0] > 0.1)
            .min_by(|a, b| a[0].total_cmp(&b[0]))
            .unwrap();
        let flexibility = 1.0 / inertia() + 1.0 / engine;
        let decay = -0.5 * DAMPING * flexibility;
        let expected = (STIFFNESS * flexibility - decay * decay).sqrt() / TAU;
        assert!(
            (frequency / expected - 1.0).abs() < 1e-4,
            "{frequency} {expected}"
        );
        assert!((growth / decay - 1.0).abs() < 1e-3, "{growth} {decay}");
    }
}

/// Speed of the hub at the end of a run [rad/s].
fn last_speed(keys: &str, rest: &str) -> f64 {
    let run = Run::new(&text("rigid", keys, rest));
    let motions = run.motions(["r/hub"]);
    motions.last().unwrap().1[0].angular_velocity.z
}

// Under the load Q a proportional governor is slower by Q / K_p, with an integral it has no error:
// after 1.2 s with time constants of 0.05 s and K_p / K_i = 0.1 s. At its limit, 0.5 Q, the rotor slows
// down by 0.5 Q t / (I + n^2 J), from the speed at the start.
#[test]
fn governors_have_their_droop() {
    const LOAD: f64 = 12.0;
    let whole = inertia() + 4.0 * 0.5;
    let proportional = whole / 0.05;
    let rest = format!(
        "[[load]]\nnode = \"r/hub\"\nmoment = [0, 0, {}]\n[transient]\nto = 1.2\nstep = 5e-3\n",
        -LOAD
    );
    let governor = |more: &str| {
        format!(
            "speed = 60\n[rotor.drive]\ninertia = 0.5\ngear = 2\ngovernor = {{ proportional = \
             \"{proportional} N*m*s\"{more} }}\n"
        )
    };
    let droop = TAU - last_speed(&governor(""), &rest);
    assert!(
        (droop / (LOAD / proportional) - 1.0).abs() < 1e-5,
        "{droop}"
    );
    let integral = format!(", integral = {}", proportional / 0.1);
    let error = TAU - last_speed(&governor(&integral), &rest);
    assert!(error.abs() < 1e-3 * LOAD / proportional, "{error}");
    let slowed = TAU
        - last_speed(
            &governor(&format!("{integral}, largest = {}", 0.5 * LOAD)),
            &rest,
        );
    let expected = 0.5 * LOAD * 1.2 / whole;
    // Until the torque is at its limit it is less: up to half of the droop.
    assert!(
        slowed > expected && slowed < expected + LOAD / proportional,
        "{slowed} {expected}"
    );
}

// An engine that brakes leaves a rotor with a free wheel at its speed, after the start with
// an error of (Omega h)^2 in the speed; one that drives accelerates both by M / (I + n^2 J), after the
// shaft is wound up.
#[test]
fn free_wheels_transmit_no_negative_torque() {
    let keys = |torque: f64| {
        format!(
            "torque = {torque}\nspeed = 60\n[rotor.drive]\ninertia = 0.5\nstiffness = 2000\n\
             damping = 40\nfree_wheel = true\n"
        )
    };
    let rest = "[transient]\nto = 0.5\nstep = 2e-3\n";
    let run = Run::new(&text("rigid", &keys(-2.0), rest));
    let motions = run.motions(["r/hub", "r/engine"]);
    let [(_, [early, first]), (_, [late, last])] = [&motions[50], &motions[250]];
    let change = late.angular_velocity.z - early.angular_velocity.z;
    // The tolerance of the iteration; the engine changes by 1.6 rad/s.
    assert!(change.abs() < 1e-6, "{change}");
    assert!((late.angular_velocity.z - TAU).abs() < 1e-3, "{late:?}");
    let braked = first.angular_velocity.z - last.angular_velocity.z;
    assert!((braked / (2.0 * 0.4 / 0.5) - 1.0).abs() < 1e-3, "{braked}");
    let run = Run::new(&text("rigid", &keys(2.0), rest));
    let motions = run.motions(["r/hub", "r/engine"]);
    let [(early, [first, _]), (late, [last, _])] = [&motions[150], &motions[250]];
    let rate = (last.angular_velocity.z - first.angular_velocity.z) / (late - early);
    let expected = 2.0 / (inertia() + 0.5);
    assert!((rate / expected - 1.0).abs() < 2e-2, "{rate} {expected}");
}

/// Wrong drive trains, and the problem of each.
const WRONG: [(&str, &str); 7] = [
    (
        "speed = 1\n[rotor.drive]\n",
        "rotor \"r\" has \"drive\" without \"stiffness\", expected both\n  help: add \"stiffness\", or remove \
         \"drive\"",
    ),
    (
        "speed = 1\n[rotor.drive]\nstiffness = 1\ninertia = 1",
        "rotor \"r\" has \"inertia\" without \"torque\" or \"governor\"",
    ),
    (
        "torque = 1\n[rotor.drive]\nstiffness = 1",
        "rotor \"r\" has \"drive\" without \"inertia\"",
    ),
    (
        "torque = 1\n[rotor.drive]\ninertia = 1\nfree_wheel = true",
        "rotor \"r\" has \"free_wheel\" without \"stiffness\"",
    ),
    (
        "torque = 1\n[rotor.drive]\ninertia = 1\ngovernor = { proportional = 1, speed = 3 }",
        "rotor \"r\" has \"governor\" and \"torque\", expected one of them",
    ),
    (
        "speed = 0\n[rotor.drive]\ninertia = 1\ngovernor = { proportional = 1 }",
        "the governor of rotor \"r\" holds 0 rpm, expected a speed above zero",
    ),
    (
        "torque = 1\n[rotor.drive]\ninertia = 1\ngovernor = { proportional = 1 }",
        "rotor \"r\" has \"governor\" without \"speed\"",
    ),
];

#[test]
fn wrong_drives_are_explained() {
    for (keys, expected) in WRONG {
        let shown = refused(&text(
            "rigid",
            &format!("{keys}\n"),
            "[transient]\nto = 0.1\nstep = 1e-3\n",
        ));
        assert!(shown.contains(expected), "{shown}");
    }
    let keys = "speed = 60\n[rotor.drive]\ninertia = 1\ngovernor = { proportional = 1 }\n";
    let shown = refused(&text("rigid", keys, "[modes]\nspeeds = [60]\n"));
    let expected = "rotor \"r\" has \"governor\", which has no state of steady rotation: the azimuth may have any value\n  help: remove it, so \
                    that the engine has the constant \"speed\" of the rotor, or compute the motion in time \
                    from start = \"given\"";
    assert!(shown.ends_with(expected), "{shown}");
    for card in [
        "governor = { proportional = 1 }",
        "stiffness = 1e5\nfree_wheel = true",
    ] {
        let inertia = if card.starts_with('g') {
            "inertia = 1\n"
        } else {
            ""
        };
        let keys = format!("speed = 60\n[rotor.drive]\n{inertia}{card}\n");
        let periodic = "[periodic]\nspeed = 60\nsteps = 24\n";
        let shown = refused(&text("rigid", &keys, periodic));
        assert!(
            shown.contains("which has no state of steady rotation"),
            "{shown}"
        );
    }
}
