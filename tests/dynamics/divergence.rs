//! Torsional divergence of an elastic cantilever wing in quasi-steady strip theory.
//!
//! With the torsional stiffness GJ, the slope a of lift, the chord c and the elastic axis at the
//! distance e behind the quarter chord, the twist theta of a wing of the angle of attack alpha_0 is
//! (Bisplinghoff, Ashley, Halfman, Aeroelasticity, 1955, chapter 8)
//!
//! ```text
//! GJ theta'' + q e c a (theta + alpha_0) = 0         theta(0) = 0, theta'(L) = 0
//! theta + alpha_0 = alpha_0 (tan(l L) sin(l x) + cos(l x))        l^2 = q e c a / GJ
//! q_D = pi^2 GJ / (4 L^2 e c a)                                   l L = pi/2
//! ```

use std::f64::consts::PI;
use std::fmt::Write;

use beam_dynamics::analysis::modes::{ModesOutcome, modes};
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::input::{self, Input};

use crate::record;

const SOURCE: &str = "Bisplinghoff, torsional divergence";
const DENSITY: f64 = 1.225;
const SLOPE: f64 = 5.7;
const CHORD: f64 = 0.5;
const SPAN: f64 = 4.0;
const BEAMS: usize = 8;
const GJ: f64 = 2000.0;
/// Moment of inertia about the axis per length [kg m].
const INERTIA: f64 = 0.1;
/// Elastic axis behind the quarter chord \[m\]: behind three quarters of the chord, where the lift of
/// the pitch rate damps the twist, so that no mode grows before the divergence.
const AXIS: f64 = 0.275;
/// Angle of attack of the root \[deg\].
const ROOT: f64 = 0.01;

/// q_D [N/m^2].
fn divergence() -> f64 {
    PI * PI * GJ / (4.0 * SPAN * SPAN * AXIS * CHORD * SLOPE)
}

/// A wing along x in a wind along y of a dynamic pressure [N/m^2], at an angle of attack \[deg\]; the
/// leading edge is upwind. It is stiff in bending: bending does not change the angle of attack of an
/// unswept wing.
fn wing([pressure, angle]: [f64; 2], analysis: &str) -> Input {
    let speed = (2.0 * pressure / DENSITY).sqrt();
    let half = 0.5 * INERTIA;
    let mut text = format!(
        "units = \"SI\"\n[air]\ndensity = {DENSITY}\nwind = [0, {speed}, 0]\n\
         [airfoils.wing]\nslope = {SLOPE}\n\
         [properties.p]\nea = 1e8\ngay = 1e8\ngaz = 1e8\ngj = {GJ}\neiy = 1e9\neiz = 1e9\n\
         m = 5\niy = {half}\niz = {half}\n[[clamp]]\nnode = \"n0\"\n"
    );
    for node in 0..=2 * BEAMS {
        let x = SPAN * node as f64 / (2 * BEAMS) as f64;
        // Writing to a String cannot fail.
        let _ = writeln!(text, "[[node]]\nname = \"n{node}\"\nposition = [{x}, 0, 0]");
    }
    let mut names = Vec::new();
    for beam in 0..BEAMS {
        let [a, b, c] = [0, 1, 2].map(|i| 2 * beam + i);
        let _ = writeln!(
            text,
            "[[beam]]\nname = \"b{beam}\"\nnodes = [\"n{a}\", \"n{b}\", \"n{c}\"]\nproperties = \"p\""
        );
        names.push(format!("\"b{beam}\""));
    }
    let line = 0.25 + AXIS / CHORD;
    let station = |at: f64| {
        format!(
            "{{ at = {at}, chord = {CHORD}, twist = {angle}, axis = {line}, airfoil = \"wing\" }}"
        )
    };
    let _ = writeln!(
        text,
        "[[strip]]\nname = \"wing\"\nbeams = [{}]\nforward = [0, -1, 0]\n\
         section = \"quasi_steady\"\nstations = [{}, {}]\n{analysis}",
        names.join(", "),
        station(0.0),
        station(SPAN)
    );
    input::parse(&text, "wing.dynamics.toml").unwrap()
}

/// Growing air speed: the angles of attack of all strips up to 0.95 q_D. Eight beams represent a
/// quarter of a sine with an error of about `(l L / 16)^4 / 30`, 3e-6, which the distance from the
/// divergence multiplies by up to twenty; so does it half the square of the angles of up to 0.25 deg,
/// by which the arm of the lift is shorter, 1e-5.
#[test]
fn a_wing_twists_by_the_closed_form_up_to_its_divergence() {
    for part in [0.25, 0.5, 0.8, 0.95] {
        let input = wing([part * divergence(), ROOT], "[static]\n");
        let outcome = statics(&input.model, &input.statics.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let strips = &outcome.result.steps[0].air;
        assert_eq!(strips.len(), 2 * BEAMS);
        let angle = 0.5 * PI * part.sqrt();
        for strip in strips {
            let x = angle * strip.location.span / SPAN;
            let expected = ROOT.to_radians() * (angle.tan() * x.sin() + x.cos());
            let error = (strip.flow.alpha / expected - 1.0).abs();
            assert!(error < 1e-3, "{part}: {} {expected}", strip.flow.alpha);
            assert!(strip.rotor.is_none() && strip.location.blade == "wing");
        }
        let last = &strips[strips.len() - 1];
        let x = angle * last.location.span / SPAN;
        let expected = ROOT * (angle.tan() * x.sin() + x.cos());
        let found = last.flow.alpha.to_degrees();
        let error = (found / expected - 1.0).abs();
        let case = format!("cantilever wing at {part} q_D");
        let name = "angle of attack of the last strip [deg]";
        record::value(SOURCE, &case, name, [found, expected], error, 1e-3);
    }
}

/// Modes of a wing without an angle of attack at a part of q_D.
fn modes_at(part: f64) -> ModesOutcome {
    let input = wing(
        [part * divergence(), 0.0],
        "[modes]\nspeeds = [0]\ncount = 4\n",
    );
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    outcome
}

/// The roots s of the first torsion mode, sin(pi x / 2 L), whose frequency tends to zero: with the
/// damping of the lift of the pitch rate,
///
/// ```text
/// |s|^2 = omega^2 (1 - q / q_D)        Re s = - q a c e (e - c/2) / (2 U I)
/// ```
///
/// Bending, with frequencies more than fifty times as large, changes the damping by some thousandths.
#[test]
fn the_torsion_frequency_tends_to_zero_at_the_divergence() {
    let frequency = 0.5 * PI / SPAN * (GJ / INERTIA).sqrt();
    let mut squares = Vec::new();
    for part in [0.3, 0.6, 0.9, 0.99] {
        let outcome = modes_at(part);
        let point = outcome.table.at_speed(0)[0].1;
        let rate = std::f64::consts::TAU * point.frequency;
        let square = (point.growth * point.growth + rate * rate) / (frequency * frequency);
        assert!((square - (1.0 - part)).abs() < 1e-4, "{part}: {square}");
        let pressure = part * divergence();
        let speed = (2.0 * pressure / DENSITY).sqrt();
        let lift = pressure * SLOPE * CHORD * AXIS * (AXIS - 0.5 * CHORD) / speed;
        let growth = -0.5 * lift / INERTIA;
        assert!(
            (point.growth / growth - 1.0).abs() < 1e-2,
            "{part}: {growth}"
        );
        squares.push((part, square));
    }
    // The straight line through the last two.
    let [_, _, a, b]: [(f64, f64); 4] = squares.try_into().unwrap();
    let found = divergence() * (b.0 + b.1 * (b.0 - a.0) / (a.1 - b.1));
    let error = (found / divergence() - 1.0).abs();
    record::value(
        SOURCE,
        "cantilever wing, torsion frequency of zero",
        "dynamic pressure [N/m^2]",
        [found, divergence()],
        error,
        1e-4,
    );
    assert!(error < 1e-4, "{found} {}", divergence());
}

/// Beyond the divergence the modes report a motion that grows.
#[test]
fn a_motion_grows_beyond_the_divergence() {
    for (part, grows) in [(0.997, false), (1.003, true)] {
        let remarks = modes_at(part).table.remarks;
        let found = remarks.iter().any(|remark| remark.contains("unstable"));
        assert_eq!(found, grows, "{part}: {remarks:?}");
    }
}
