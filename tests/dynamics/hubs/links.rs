//! Feathering on elastic pitch links, and dampers with a curve.

use beam_dynamics::analysis::modes::modes;
use beam_dynamics::analysis::periodic::periodic;
use std::f64::consts::{PI, TAU};

use super::{Rows, over_time, parsed, rotor, stiff};

/// Moments of inertia per length of the blade about y and z \[kg m\], over a length of 1 m.
const INERTIA: [f64; 2] = [2e-3, 8e-3];
/// Stiffness of a link about the pitch axis \[N m\].
const LINK: f64 = 800.0;
/// Distance of the horn from the pitch axis \[m\].
const HORN: f64 = 0.1;

/// A rigid hub with blades that turn about their axes, with a link.
fn text(rpm: f64, pitch: &str, cards: &str) -> String {
    let keys = format!("speed = {rpm:?}\n[rotor.swashplate]\ncollective = 0\n{pitch}\n");
    let text = rotor("rigid", 2, &keys, cards);
    text.replace(&stiff([1e-5, 1e-5]), &stiff(INERTIA))
}

/// Square of the frequency of feathering \[rad^2/s^2\]: the link, and the difference of the moments of inertia across
/// the axis, which turns the blade flat.
fn expected(omega: f64) -> f64 {
    let [flat, across] = INERTIA;
    (LINK + omega * omega * (across - flat)) / (across + flat)
}

// By the control stiffness at the bearing in a turning model. The blades bend and twist by 1e-4.
#[test]
fn blades_feather_on_their_control_stiffness() {
    for rpm in [0.0, 300.0, 600.0_f64] {
        let link = format!("[rotor.pitch_link]\nstiffness = {LINK:?}\n");
        let cards = format!("[modes]\nspeeds = [{rpm:?}]\ncount = 4\n");
        let input = parsed(&text(rpm, &link, &cards));
        let outcome = modes(&input.model, &input.modes.unwrap());
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let own = expected(rpm * PI / 30.0).sqrt() / TAU;
        let points = outcome.table.at_speed(0).into_iter();
        let found = points.filter(|(_, point)| (point.frequency / own - 1.0).abs() < 1e-3);
        assert_eq!(found.count(), 2, "{rpm}: {own}");
    }
}

// By rods of finite stiffness between a plate and the horns of blades that turn: the stiffness about the axis is
// the one of the rod times the square of the distance of the horn. The exponents are known modulo the speed.
#[test]
fn blades_feather_on_elastic_rods() {
    let rpm = 300.0;
    let omega = rpm * PI / 30.0;
    let own = expected(omega).sqrt();
    let plate = format!(
        "[rotor.swashplate.plate]\nbelow = 0.15\nhorn = [0.05, {HORN:?}]\nstiffness = {:?}\n",
        LINK / (HORN * HORN)
    );
    let cards = format!(
        "[periodic]\nspeed = {rpm:?}\n[periodic.floquet]\ncount = 4\nerror_estimate = false\nnear = [\"{:?} Hz\"]\n",
        own / TAU
    );
    let input = parsed(&text(rpm, &plate, &cards));
    let mut rows = Rows::of(&input);
    let outcome = periodic(&input.model, input.periodic.as_ref().unwrap(), &mut rows);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    let modes = outcome.result.floquet.unwrap().modes;
    let near = modes
        .iter()
        .filter(|mode| (mode.frequency() / own - 1.0).abs() < 1e-3);
    assert_eq!(near.count(), 2, "{own}: {modes:#?}");
}

// A lag hinge is moved by A sin(w t), and the damper has a relief valve: c v up to the rate v_0, less beyond it. In
// a cycle it takes, with cos(p) = v_0 / V of the largest rate V = A w,
//
//     4 V / w ( (M_0 - c_2 v_0) sin p + c_2 V (p/2 + sin(2 p)/4) + c V ((pi/2 - p)/2 - sin(2 p)/4) )
//
// which is the work of the joint that moves the blade: the inertia of the blade has none. The trapezoidal rule over
// 200 steps has an error of 1e-4 by the corners of the curve.
#[test]
fn a_hydraulic_damper_takes_the_work_of_its_curve() {
    const AMPLITUDE: f64 = 0.02;
    const W: f64 = 8.0 * PI;
    let (v, v0, [c, c2]) = (AMPLITUDE * W, 0.2, [400.0, 30.0]);
    let m0 = c * v0;
    let far = [1.0, m0 + c2 * (1.0 - v0)];
    let keys = format!(
        "speed = 0\n[[rotor.hinge]]\nkind = \"lag\"\nstiffness = 20\ndamper = {{ rates = [\"-1 rad/s\", \
         \"{:?} rad/s\", \"{v0:?} rad/s\", \"1 rad/s\"], moments = [{:?}, {:?}, {m0:?}, {:?}] }}\n",
        -v0, -far[1], -m0, far[1]
    );
    let cards = format!(
        "[[joint]]\nname = \"mover\"\nkind = \"rotation\"\nnodes = [\"r/hub\", \"r 1/lag\"]\n\
         rotation = {{ z = \"= {:?}*sin(8*pi*t)*(1 - exp(-(20*t)^3))\" }}\n\
         [transient]\nto = 0.5\nstep = 1.25e-3\n[output]\n[[output.column]]\nname = \"m\"\n\
         quantity = \"reaction_moment\"\nof = \"mover\"\ncomponent = \"z\"\n",
        AMPLITUDE.to_degrees()
    );
    let input = parsed(&rotor("hingeless", 1, &keys, &cards));
    let rows = over_time(&input);
    let cycle: Vec<_> = rows
        .times
        .iter()
        .zip(rows.column(0))
        .filter(|(time, _)| **time > 0.25 - 1e-9)
        .map(|(time, moment)| (moment, AMPLITUDE * (W * time).sin()))
        .collect();
    assert_eq!(cycle.len(), 201);
    let steps = cycle.windows(2);
    let work: f64 = steps
        .map(|pair| 0.5 * (pair[0].0 + pair[1].0) * (pair[1].1 - pair[0].1))
        .sum();
    let p = (v0 / v).acos();
    let beyond = (m0 - c2 * v0) * p.sin() + c2 * v * (0.5 * p + 0.25 * (2.0 * p).sin());
    let below = c * v * (0.5 * (0.5 * PI - p) - 0.25 * (2.0 * p).sin());
    let expected = 4.0 * v / W * (beyond + below);
    assert!((work / expected - 1.0).abs() < 1e-3, "{work} {expected}");
}
