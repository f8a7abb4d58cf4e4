//! Mechanisms with closed loops, in `cases/dynamics/squeezer`, `slider_crank` and
//! `bennett`.
//!
//! Sources: `tests/reference/dynamics/squeezer.json`, `slider_crank.csv`, `bennett.csv`.

use std::f64::consts::PI;

use beam_dynamics::case::Redundant;
use beam_dynamics::integrator::{Scheme, StepControl, Stepping};
use beam_dynamics::model::State;
use nalgebra::Vector3;

use crate::in_time::{Run, Table, json, numbers};
use crate::record;

/// Attitude about z.
fn angle(run: &Run, node: &str, time: f64) -> f64 {
    let rotation = &run.motion(node, time).rotation;
    rotation[(1, 0)].atan2(rotation[(0, 0)])
}

/// The smallest difference of two angles.
fn apart(a: f64, b: f64) -> f64 {
    let difference = (a - b).rem_euclid(2.0 * PI);
    difference.min(2.0 * PI - difference)
}

/// The bars of the squeezer, and their attitudes as sums of beta, theta, gamma, phi, delta, omega,
/// epsilon.
const BARS: [(&str, [usize; 2], f64); 7] = [
    ("crank", [0, 7], 0.0),
    ("coupler", [0, 1], PI),
    ("triangle", [2, 7], -PI / 2.0),
    ("arm 4", [3, 4], -PI / 2.0),
    ("arm 5", [4, 7], 0.0),
    ("arm 6", [5, 6], 0.0),
    ("arm 7", [6, 7], -PI / 2.0),
];

/// Attitudes of the bars and their angular velocities at 30 ms, the latter relative to the largest,
/// 1425 rad/s.
type Bars = [[f64; 7]; 2];

fn squeezer(scheme: Scheme, step: f64) -> Bars {
    let run = Run::new("squeezer", "squeezer.dynamics.toml", 1, |settings| {
        settings.scheme = scheme;
        settings.stepping = Stepping::Constant { step };
    });
    let turning = |name: &str| run.motion(name, 0.03).angular_velocity.z / 1425.0;
    [
        BARS.map(|(name, _, _)| angle(&run, name, 0.03)),
        BARS.map(|(name, _, _)| turning(name)),
    ]
}

/// The same as published, ten digits and more.
fn published() -> Bars {
    let of = |key: &str| {
        let mut list = numbers(&json("squeezer.json")["published"][key]);
        list.push(0.0);
        list
    };
    let (angles, rates) = (of("angles"), of("rates"));
    [
        BARS.map(|(_, [a, b], shift)| angles[a] + angles[b] + shift),
        BARS.map(|(_, [a, b], _)| (rates[a] + rates[b]) / 1425.0),
    ]
}

/// Largest differences of attitudes and of angular velocities.
fn differences(a: &Bars, b: &Bars) -> [f64; 2] {
    let largest = |of: fn(f64, f64) -> f64, i: usize| {
        let pairs = a[i].iter().zip(&b[i]);
        pairs.map(|(a, b)| of(*a, *b)).fold(0.0, f64::max)
    };
    [largest(apart, 0), largest(|a, b| (a - b).abs(), 1)]
}

/// Errors of the step are at most Richardson's estimate from twice the step, their difference over
/// 2^p - 1 with the least required order p; and their order.
fn check_squeezer(name: &str, scheme: Scheme, step: f64, orders: [f64; 2]) {
    let source = "Test Set for Initial Value Problem Solvers, andrews";
    let case = format!("squeezer, {name}");
    let [coarse, fine] = [2.0 * step, step].map(|step| squeezer(scheme, step));
    let exact = published();
    let between = differences(&coarse, &fine);
    let [coarse, fine] = [coarse, fine].map(|found| differences(&found, &exact));
    let quantities = [
        format!("angles at 30 ms, step {step} s [rad]"),
        format!("angular velocities at 30 ms, step {step} s, of the largest"),
    ];
    for (i, quantity) in quantities.iter().enumerate() {
        let order = (coarse[i] / fine[i]).log2();
        let (least, estimate) = (orders[i], between[i] / (orders[i].exp2() - 1.0));
        record::order(source, &case, &format!("order of {quantity}"), order, least);
        record::largest(source, &case, quantity, fine[i], estimate);
        assert!(order > least, "{quantity}: {coarse:?} {fine:?}");
        assert!(fine[i] < estimate, "{quantity}: {:e} {estimate:e}", fine[i]);
    }
}

/// The published state with the step of the case and twice this step: second order.
#[test]
fn the_squeezer_reaches_its_published_state() {
    check_squeezer("two steps", Scheme::default(), 2e-5, [1.9; 2]);
}

/// The same by Radau IIA: third order in positions and second in velocities on index 3.
#[test]
fn the_squeezer_by_radau() {
    let radau = Scheme::Parabolic { zeta: -2.0 / 3.0 };
    check_squeezer("Radau IIA", radau, 2e-5, [2.8, 1.9]);
}

/// The rod bends by up to 1.87 mm, and four and eight elements of the reference differ by 1 % of
/// it. Under the inertia of the slider, 380 N, the rod also rings along its axis by 2e-5 m at 4
/// kHz, which the step does not resolve: this with both signs.
#[test]
fn the_rod_of_the_slider_crank_bends() {
    let file = "slider_crank.dynamics.toml";
    let run = Run::new("slider_crank", file, 20, |settings| {
        settings.to = 0.04;
        settings.stepping = Stepping::Constant { step: 2.5e-5 };
    });
    let table = Table::new("slider_crank.csv");
    let [slider, bend] = ["x_slider", "deflection"].map(|name| table.column(name));
    // Six beams: thirteen nodes.
    let [first, middle, last] = ["rod 0", "rod 6", "rod 12"].map(|name| run.node(name));
    let (mut bends, mut slides) = (0.0_f64, 0.0_f64);
    for row in table.rows.iter().filter(|row| row[0] < 0.04 + 1e-9) {
        let state = run.at(row[0]);
        let position = |node: usize| state.nodes[node].position;
        let chord = (position(last) - position(first)).normalize();
        let found = chord.cross(&(position(middle) - position(first))).z;
        bends = bends.max((found - row[bend]).abs());
        slides = slides.max((position(last).x - row[slider]).abs());
    }
    let source = "eight quadratic elements of a plane beam, independent script";
    record::largest(
        source,
        "slider-crank",
        "bending of the rod [m]",
        bends,
        2e-5,
    );
    record::largest(
        source,
        "slider-crank",
        "position of the slider [m]",
        slides,
        5e-5,
    );
    assert!(bends < 2e-5 && slides < 5e-5, "{bends:e} {slides:e}");
}

/// The closed form of the angles, which the constraints determine to the tolerance of the
/// iteration, and the moment of the drive by the growth of the kinetic energy, whose error is of
/// second order: 1e-3 of its largest, 3.87 N m, at 512 steps per turn.
#[test]
fn bennetts_mechanism_moves() {
    let run = Run::new("bennett", "bennett.dynamics.toml", 1, |settings| {
        settings.stepping = Stepping::Constant { step: 1.0 / 512.0 };
    });
    let reported = run.outcome.remarks.join("\n");
    assert!(reported.contains("hinge"), "{reported}");
    let table = Table::new("bennett.csv");
    let moment = table.column("moment");
    let (mut positions, mut moments) = (0.0_f64, 0.0_f64);
    for row in &table.rows {
        for (node, first) in [("second", "x2"), ("third", "x3")] {
            let found = run.motion(node, row[0]).position;
            positions = positions.max((found - table.vector(row, first)).norm());
        }
        let [_, found] = run.reaction("drive", "first", row[0]);
        moments = moments.max((found.dot(&Vector3::z()) - row[moment]).abs());
    }
    let source = "closed form, Bennett 1903";
    record::largest(
        source,
        "Bennett mechanism",
        "positions of the hinges [m]",
        positions,
        1e-7,
    );
    record::largest(
        source,
        "Bennett mechanism",
        "moment of the drive [N m]",
        moments,
        4e-3,
    );
    assert!(
        positions < 1e-7 && moments < 4e-3,
        "{positions:e} {moments:e}"
    );
}

/// Angle of the last hinge, 180 degrees less b, as a function of the driven angle a, with tan(a/2)
/// tan(b/2) = sqrt 3.
fn last_hinge(driven: f64) -> f64 {
    2.0 * (0.5 * driven)
        .sin()
        .atan2(3.0_f64.sqrt() * (0.5 * driven).cos())
}

/// Over three turns, through positions at which a fixed choice of eighteen constraints does not
/// determine it, with steps of several lengths. The constraints determine the angles to the
/// tolerance of the iteration, 1e-9; from a twentieth of a turn on the moment follows from the
/// power, `d(kinetic)/dt = moment * speed`, with errors of the energy differences and of the moment
/// of the order of the square of the step: 1e-3 of 3.87 N m at 1 ms, and twelve times this if the
/// length of the steps changes.
#[test]
fn bennetts_mechanism_turns_over_and_over() {
    let variable = Stepping::Variable(StepControl {
        first: 1e-3,
        least: 1e-9,
        most: 2e-3,
        tolerance: 1e-7,
    });
    let constant = |step| Stepping::Constant { step };
    for (name, stepping, limit) in [
        ("steps of 1 ms", constant(1e-3), 4e-3),
        ("steps of 0.5 ms", constant(5e-4), 1e-3),
        ("variable steps", variable, 5e-2),
    ] {
        let run = Run::new("bennett", "bennett.dynamics.toml", 1, |settings| {
            settings.to = 3.0;
            settings.stepping = stepping;
        });
        let speed = 2.0 * PI;
        let (first, third) = (run.node("first"), run.node("third"));
        let energy = |instant: &(f64, State)| run.energy(&instant.1, instant.0).kinetic;
        let (mut angles, mut moments) = (0.0_f64, 0.0_f64);
        for around in run.instants.windows(3) {
            let (time, state) = (around[1].0, &around[1].1);
            let position = state.nodes[third].position;
            let driven = 50.0_f64.to_radians() + speed * time;
            angles = angles.max(apart(
                position.z.atan2(position.x + 1.0),
                last_hinge(driven),
            ));
            if time > 0.05 {
                let (h, k) = (time - around[0].0, around[2].0 - time);
                let [low, now, high] = [0, 1, 2].map(|i| energy(&around[i]));
                let power = ((high - now) / k * h + (now - low) / h * k) / (h + k);
                let [_, reaction] = run.reaction_in(state, time, "drive", first);
                moments = moments.max((reaction.z - power / speed).abs());
            }
        }
        let source = "closed form, Bennett 1903";
        let case = format!("Bennett mechanism, three turns, {name}");
        record::largest(source, &case, "angle of the last hinge [rad]", angles, 1e-9);
        record::largest(source, &case, "moment by the power [N m]", moments, limit);
        assert!(
            angles < 1e-9 && moments < limit,
            "{name}: {angles:e} {moments:e}"
        );
    }
}

/// Without permission no constraint is removed, and the redundant ones are named.
#[test]
fn redundant_constraints_are_named() {
    let run = Run::attempt("bennett", "bennett.dynamics.toml", 1, |settings| {
        settings.redundant = Redundant::Error;
    });
    let failure = run.outcome.failure.unwrap();
    let reported = failure.to_string();
    assert!(reported.contains("hinge"), "{reported}");
    assert!(
        failure.remedy().contains("redundant"),
        "{}",
        failure.remedy()
    );
}
