//! Strips without a rotor, on bodies and beams, against closed forms of quasi-steady strip theory.
//!
//! A body turns about a hinge of stiffness k; its wing of area S has its quarter chord at the
//! distance l downstream of the hinge. With q = rho U^2/2 and the slope a of lift at the angle of
//! the three-quarter chord (Bisplinghoff, Ashley, Halfman, Aeroelasticity, 1955, chapters 5 and 8),
//!
//! ```text
//! I theta'' + q S a l (l + c/2)/U theta' + (k + q S a l) theta = 0
//! ```
//!
//! A wing ahead of its hinge, l = -e, diverges at q = k / (S a e).

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::statics::statics;
use beam_dynamics::input::{self, Input};
use nalgebra::Vector3;

use crate::record;

const SOURCE: &str = "quasi-steady strip theory";
const DENSITY: f64 = 1.225;
const SLOPE: f64 = 5.7;
const DRAG: f64 = 0.02;
const CHORD: f64 = 0.4;
const SPAN: f64 = 2.0;
const INERTIA: f64 = 3.0;

/// A hinged body with a wing, in a wind along x.
fn body(speed: f64, strip: &str, stiffness: f64, analysis: &str) -> Input {
    let text = format!(
        "units = \"SI\"\n[air]\ndensity = {DENSITY}\nwind = [{speed}, 0, 0]\n\
         [airfoils.wing]\nslope = {SLOPE}\ndrag = {DRAG}\n\
         [[node]]\nname = \"ground\"\nposition = [0, 0, 0]\n\
         [[node]]\nname = \"body\"\nposition = [0, 0, 0]\n\
         [[clamp]]\nnode = \"ground\"\n\
         [[body]]\nnode = \"body\"\nmass = 1\ninertia = [{INERTIA}, {INERTIA}, {INERTIA}]\n\
         [[hinge]]\nname = \"pivot\"\nnodes = [\"ground\", \"body\"]\naxis = [0, 0, 1]\n\
         stiffness = {stiffness}\n\
         [[strip]]\nname = \"wing\"\nnode = \"body\"\nsection = \"quasi_steady\"\n{strip}\n{analysis}"
    );
    input::parse(&text, "wing.dynamics.toml").unwrap()
}

/// A wing of constant chord whose quarter chord is at x.
fn wing(x: f64, twist: f64) -> String {
    format!(
        "from = [{x}, 0, {}]\nto = [{x}, 0, {}]\nforward = [-1, 0, 0]\n\
         stations = [{{ at = 0, chord = {CHORD}, twist = {twist}, airfoil = \"wing\" }},\n\
         {{ at = {SPAN}, chord = {CHORD}, twist = {twist}, airfoil = \"wing\" }}]",
        -0.5 * SPAN,
        0.5 * SPAN
    )
}

/// Growth and frequency [rad/s] of the first mode.
fn root(speed: f64, x: f64, stiffness: f64) -> [f64; 2] {
    let analysis = "[modes]\nspeeds = [0]\ncount = 1\n";
    let input = body(speed, &wing(x, 0.0), stiffness, analysis);
    let outcome = modes(&input.model, &input.modes.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let point = outcome.table.at_speed(0)[0].1;
    [point.growth, std::f64::consts::TAU * point.frequency]
}

/// The same by the closed form. The drag turns with the flow: at the quarter chord it adds its
/// coefficient to the slope of the force across the wind, at the velocity of the quarter chord.
fn expected(speed: f64, x: f64, stiffness: f64) -> [f64; 2] {
    let area = 0.5 * DENSITY * speed * speed * CHORD * SPAN;
    let lift = SLOPE * (x + 0.5 * CHORD) + DRAG * x;
    let damping = area * x * lift / (speed * INERTIA);
    let square = (stiffness + area * (SLOPE + DRAG) * x) / INERTIA;
    [-0.5 * damping, (square - 0.25 * damping * damping).sqrt()]
}

/// Tail behind the hinge, and wing ahead of it up to 0.9 of the pressure of divergence. The
/// tolerance of 1e-5 of the frequency covers the smooth speed of the section: `(0.01 m/s)^2 / 2 U^2`
/// is below 2e-6.
#[test]
fn a_weathercock_has_the_frequency_and_the_damping_of_strip_theory() {
    let stiffness = 40.0;
    let ahead = 0.15;
    let divergence = stiffness / (CHORD * SPAN * (SLOPE + DRAG) * ahead);
    let at = |part: f64| (2.0 * part * divergence / DENSITY).sqrt();
    for (speed, x) in [
        (20.0, 0.8),
        (8.0, 0.6),
        (at(0.3), -ahead),
        (at(0.9), -ahead),
    ] {
        let (found, expected) = (root(speed, x, stiffness), expected(speed, x, stiffness));
        let case = format!("hinged wing, {speed:.3} m/s, quarter chord at {x} m");
        for (name, k) in [("growth [1/s]", 0), ("frequency [rad/s]", 1)] {
            let error = (found[k] - expected[k]).abs() / expected[1];
            record::value(SOURCE, &case, name, [found[k], expected[k]], error, 1e-5);
            assert!(error < 1e-5, "{case}, {name}: {found:?} {expected:?}");
        }
    }
}

/// Force of the air on the ground, of a wing whose quarter chord is on the axis of the hinge.
fn force(strip: &str, speed: f64) -> Vector3<f64> {
    let input = body(speed, strip, 1e5, "[static]\n");
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let reactions = &outcome.result.steps[0].reactions;
    -reactions
        .iter()
        .fold(Vector3::zeros(), |sum, reaction| sum + reaction.force)
}

/// Lift and drag of a wing at 4 deg: the upper surface is on the side of z times (-x), which is -y.
#[test]
fn a_wing_has_the_lift_and_the_drag_of_its_airfoil() {
    let found = force(&wing(0.0, 4.0), 30.0);
    let area = 0.5 * DENSITY * 30.0 * 30.0 * CHORD * SPAN;
    let expected = area * Vector3::new(DRAG, -SLOPE * 4f64.to_radians(), 0.0);
    let error = (found - expected).norm() / expected.norm();
    record::value(
        SOURCE,
        "wing at 4 deg",
        "force across the wind [N]",
        [found.y, expected.y],
        error,
        1e-6,
    );
    assert!(error < 1e-6, "{found} {expected}");
}

/// A wind along the span has friction with the drag at zero angle only if it is requested.
#[test]
fn radial_drag_is_the_friction_of_the_flow_along_the_span() {
    let along_wind = format!(
        "from = [0, 0, 0]\nto = [{SPAN}, 0, 0]\nforward = [0, 1, 0]\n\
         stations = [{{ at = 0, chord = {CHORD}, airfoil = \"wing\" }},\n\
         {{ at = {SPAN}, chord = {CHORD}, airfoil = \"wing\" }}]\n"
    );
    let friction = 0.5 * DENSITY * 30.0 * 30.0 * CHORD * SPAN * DRAG;
    for (flag, expected) in [("", 0.0), ("radial_drag = true", friction)] {
        let found = force(&format!("{along_wind}{flag}"), 30.0);
        // the smooth speed is 1e-3 m/s
        let expected = Vector3::new(expected, 0.0, 0.0);
        assert!((found - expected).norm() < 1e-5 * friction, "{found}");
    }
}

/// A stiff beam along x, in a wind along y: the line times the direction forward, x times (-y), is
/// -z. It bends and twists by less than 1e-6 rad.
#[test]
fn a_wing_on_a_beam_has_the_lift_and_the_drag_of_its_airfoil() {
    let stations = [0.0, SPAN].map(|at| {
        format!("{{ at = {at}, chord = {CHORD}, twist = 4, axis = 0.25, airfoil = \"wing\" }}")
    });
    let nodes = [("a", 0.0), ("b", 0.5 * SPAN), ("c", SPAN)]
        .map(|(name, x)| format!("[[node]]\nname = \"{name}\"\nposition = [{x}, 0, 0]\n"));
    let text = format!(
        "units = \"SI\"\n[air]\ndensity = {DENSITY}\nwind = [0, 30, 0]\n\
         [airfoils.wing]\nslope = {SLOPE}\ndrag = {DRAG}\n\
         [properties.p]\nea = 7e9\ngay = 9e9\ngaz = 9e9\ngj = 8e9\neiy = 7e9\neiz = 7e9\n\
         m = 11\niy = 0.001\niz = 0.001\n{}\
         [[beam]]\nname = \"spar\"\nnodes = [\"a\", \"b\", \"c\"]\nproperties = \"p\"\n\
         [[clamp]]\nnode = \"a\"\n[[strip]]\nbeams = [\"spar\"]\nforward = [0, -1, 0]\n\
         section = \"quasi_steady\"\nstations = [{}]\n[static]\n",
        nodes.concat(),
        stations.join(", ")
    );
    let input = input::parse(&text, "wing.dynamics.toml").unwrap();
    let outcome = statics(&input.model, &input.statics.unwrap());
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let found = -outcome.result.steps[0].reactions[0].force;
    let area = 0.5 * DENSITY * 30.0 * 30.0 * CHORD * SPAN;
    let expected = area * Vector3::new(0.0, DRAG, -SLOPE * 4f64.to_radians());
    assert!(
        (found - expected).norm() < 1e-4 * expected.norm(),
        "{found} {expected}"
    );
}

#[test]
fn wrong_strips_are_problems() {
    let station = "stations = [{ at = 0, chord = 1, airfoil = \"thin\" },\n\
        { at = 1, chord = 1, airfoil = \"thin\" }]\n";
    for (keys, expected) in [
        ("", "neither \"node\" nor \"beams\""),
        ("node = \"a\"\n", "\"node\" without both ends"),
        (
            "node = \"a\"\nbeams = [\"b\"]\n",
            "both \"node\" and \"beams\"",
        ),
        (
            "beams = [\"b\"]\nfrom = [0, 0, 0]\n",
            "with an end on a node",
        ),
        ("beams = [\"b\"]\n", "unknown beam \"b\""),
        (
            "node = \"a\"\nfrom = [0, 0, 1]\nto = [0, 0, 1]\n",
            "are the same point",
        ),
        (
            "node = \"a\"\nfrom = [0, 0, 0]\nto = [1, 0, 0]\n",
            "along the line of the strip",
        ),
        (
            "node = \"a\"\nfrom = [0, 0, 0]\nto = [0, 0.5, 0]\n",
            "expected a position on the line",
        ),
    ] {
        let text = format!(
            "units = \"SI\"\n[[node]]\nname = \"a\"\nposition = [0, 0, 0]\n\
             [[body]]\nnode = \"a\"\nmass = 1\n\
             [[strip]]\nforward = [1, 0, 0]\n{keys}{station}[transient]\nto = 1\nstep = 0.1\n"
        );
        let problems = input::parse(&text, "wrong.dynamics.toml").unwrap_err();
        let problems = problems.to_string();
        assert!(problems.contains(expected), "{keys}: {problems}");
        assert!(problems.contains("wrong.dynamics.toml"), "{problems}");
    }
}
