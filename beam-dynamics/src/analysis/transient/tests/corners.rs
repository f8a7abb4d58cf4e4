//! Corners of drives: impulses, and the motion after them.

use nalgebra::{Matrix3, Vector3};

use super::models::{body, node, run, states};
use crate::analysis::transient::TransientFailure;
use crate::analysis::transient::corner::after_impulse;
use crate::assembly::System;
use crate::case::{Model, TransientSettings};
use crate::elements::Element;
use crate::elements::joints::{ConstraintJoint, JointEnds, Placing, Turning, axes_along};
use crate::integrator::{Scheme, StepControl, Stepping};
use crate::model::{Drive, Node, Ramp, State, Step};

/// Half the length of a bar, its mass and its moment of inertia about its center.
const HALF: f64 = 0.5;
const MASS: f64 = 3.0;
const INERTIA: f64 = MASS * 4.0 * HALF * HALF / 12.0;

/// Angular velocity after the corner.
const SPEED: f64 = 2.0;
/// Beginning and end of the motion, neither on the grid of the steps.
const BEGIN: f64 = 0.103;
const END: f64 = 0.417;
const STEP: f64 = 0.01;

/// Bars along x, one after the other, the first at `first`.
fn bars(count: usize) -> (Vec<Node>, Vec<Box<dyn Element>>) {
    let center = |i: usize| (1.0 + 2.0 * i as f64) * HALF * Vector3::x();
    let nodes: Vec<_> = (0..count)
        .map(|i| node(&format!("bar {i}"), center(i), Matrix3::identity()))
        .collect();
    let moments = [1e-3 * INERTIA, INERTIA, INERTIA];
    let bodies = (0..count).map(|i| body(i, MASS, Vector3::zeros(), moments));
    let elements = bodies.collect();
    (nodes, elements)
}

/// A joint about z at the beginning of bar `b`, with the previous bar or the frame.
fn hinge(nodes: &[Node], b: usize, turning: Option<Turning>) -> Box<dyn Element> {
    let a = b.checked_sub(1).map(|a| (a, &nodes[a]));
    let ends = JointEnds {
        a,
        b: (b, &nodes[b]),
    };
    let position = 2.0 * HALF * b as f64 * Vector3::x();
    let placing = Placing::at(&position, &axes_along(&Vector3::z()));
    let label = format!("hinge {b}");
    Box::new(ConstraintJoint::revolute(label, &ends, &placing, turning))
}

/// Bars on hinges, the first of which is driven.
fn chain(count: usize, turning: Turning) -> Model {
    let (nodes, mut elements) = bars(count);
    elements.push(hinge(&nodes, 0, Some(turning)));
    for b in 1..count {
        elements.push(hinge(&nodes, b, None));
    }
    Model::new("chain", System::new(nodes, elements))
}

fn ramp() -> Drive {
    Drive::Ramp(Ramp {
        from: 0.0,
        to: SPEED * (END - BEGIN),
        start: BEGIN,
        end: END,
        smooth: false,
    })
}

/// The speed of [`ramp`].
fn speed() -> Drive {
    let step = |to, time| {
        Drive::Step(Step {
            from: 0.0,
            to,
            time,
        })
    };
    Drive::Sum(vec![step(SPEED, BEGIN), step(-SPEED, END)].into())
}

fn all_settings() -> Vec<TransientSettings> {
    let schemes = [
        Scheme::TwoStep { radius: 0.6 },
        Scheme::TwoStep { radius: 0.0 },
        Scheme::Bdf2,
        Scheme::Parabolic { zeta: -2.0 / 3.0 },
    ];
    let control = StepControl {
        first: STEP / 4.0,
        least: 1e-6,
        most: STEP,
        tolerance: 1e-5,
    };
    let steppings = [
        Stepping::Constant { step: STEP },
        Stepping::Variable(control),
    ];
    let all = schemes.iter().flat_map(|&scheme| {
        steppings.map(|stepping| TransientSettings {
            scheme,
            stepping,
            ..TransientSettings::new(0.6, STEP)
        })
    });
    all.collect()
}

/// Moment of the hinge about its point on the bar [N m], and the force along the bar [N].
fn reaction(model: &Model, state: &State, time: f64) -> [f64; 2] {
    let observed = model.system.observe(state, &model.conditions_at(time));
    let hinge = &observed.joints[0];
    let along = state.nodes[0].rotation.column(0).into_owned();
    [hinge.moment.z, hinge.force.dot(&along)]
}

// Rotation at a constant rate: no moment, the force m c^2 r to the center; at rest zero. The
// parameters of a rotation by p in a step are not linear in time: the error of its rate is of the
// order of p^2 = 4e-4, and of the moment, since the first steps differ from the later ones, J c p^2
// / h. Without the impulse the moment rings with J c / h = 200 N m.
#[test]
fn a_bar_that_an_angle_begins_to_turn_does_so_at_once() {
    for settings in all_settings() {
        let angle = chain(1, Turning::Angle(ramp().into()));
        let speed = chain(1, Turning::Speed(speed().into()));
        for model in [&angle, &speed] {
            let (kept, outcome) = run(model, &settings);
            assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
            let turned = SPEED * STEP;
            let about_end = INERTIA + MASS * HALF * HALF;
            let (off_speed, off_moment) = (SPEED * turned * turned, about_end * SPEED / STEP);
            for (time, state) in kept.times.iter().zip(&kept.states).skip(1) {
                let expected = if *time > BEGIN && *time <= END {
                    SPEED
                } else {
                    0.0
                };
                let omega = state.nodes[0].angular_velocity.z;
                let off = (omega - expected).abs();
                assert!(off <= off_speed, "{settings:?} {time} {omega}");
                let [moment, force] = reaction(model, state, *time);
                let off = moment.abs() / off_moment;
                assert!(off < turned * turned, "{settings:?} {time} {moment}");
                let off = (force + MASS * expected * expected * HALF).abs();
                assert!(off < 1e-2 * MASS * SPEED * SPEED * HALF, "{time} {force}");
            }
            let reported: Vec<_> = outcome
                .remarks
                .iter()
                .filter(|r| r.contains("impulse"))
                .collect();
            // J c about the hinge; the second to the error of the velocities of the steps.
            let expected = "the drive of \"hinge 0\" jumps in rate at t = 0.103 s and once more: \
                an impulse of up to ";
            let [reported] = &reported[..] else {
                panic!("{reported:?}")
            };
            let reported = reported.strip_prefix(expected).unwrap();
            let size = reported.strip_suffix(" N m s; velocities were set to follow it");
            let size: f64 = size.unwrap().parse().unwrap();
            let about_hinge = INERTIA + MASS * HALF * HALF;
            assert!((size - about_hinge * SPEED).abs() < 2e-3, "{size}");
        }
    }
}

// A bar of length l = 1 at rest is given at its end the velocity v = c l across: its center
// then has v/4 and it turns at -3 v/(2 l), by the impulse m v/4 and with the energy m v^2/8. The
// driven bar then has c l/2 and c; about its fixed end it needs the angular impulse (J + m l^2/4)
// c, and l m v/4 for the other. Round-off of one solution.
#[test]
fn the_impulse_on_a_free_link_is_that_of_a_struck_bar() {
    let model = chain(2, Turning::Angle(ramp().into()));
    let after = model.conditions_at(BEGIN);
    let (state, impulse) = after_impulse(&model.system, &model.system.rest(), &after).unwrap();
    let [driven, free] = [&state.nodes[0], &state.nodes[1]];
    let v = SPEED * 2.0 * HALF;
    for (found, expected) in [
        (driven.velocity, Vector3::y() * v / 2.0),
        (driven.angular_velocity, Vector3::z() * SPEED),
        (free.velocity, Vector3::y() * v / 4.0),
        (free.angular_velocity, -1.5 * SPEED * Vector3::z()),
        (free.momentum, Vector3::y() * MASS * v / 4.0),
        (free.angular_momentum, -1.5 * INERTIA * SPEED * Vector3::z()),
    ] {
        assert!((found - expected).amax() < 1e-12, "{found} {expected}");
    }
    let energy = model.system.energy(&state, &after).kinetic;
    let about_end = INERTIA + MASS * HALF * HALF;
    let expected = 0.5 * about_end * SPEED * SPEED + MASS * v * v / 8.0;
    assert!((energy - expected).abs() < 1e-12, "{energy} {expected}");
    // The drive's work is half its angular impulse times the speed that it reaches.
    let angular = about_end * SPEED + 2.0 * HALF * MASS * v / 4.0;
    assert!((0.5 * angular * SPEED - expected).abs() < 1e-12);
    let force = MASS * v / 2.0 + MASS * v / 4.0;
    for expected in [angular, force] {
        let mut found = impulse[..6].iter();
        let is_there = found.any(|one| (one.abs() - expected).abs() < 1e-12);
        assert!(is_there, "{expected} {impulse:?}");
    }
}

// The same in a run: just after the corner, when both bars are still in line. A step after it the
// free bar has turned by 1.5 c h = 0.03 out of line, and its rates change by c^2 times that.
#[test]
fn a_chain_continues_from_its_impulse() {
    for settings in all_settings() {
        let model = chain(2, Turning::Angle(ramp().into()));
        let (kept, outcome) = run(&model, &settings);
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let behind = kept.times.iter().position(|time| *time > BEGIN).unwrap();
        let free = &kept.states[behind].nodes[1];
        let off = (free.angular_velocity.z + 1.5 * SPEED).abs();
        assert!(off < 0.1 * SPEED, "{} {off}", kept.times[behind]);
        let off = (free.velocity.y - SPEED * HALF / 2.0).abs();
        assert!(off < 0.1 * SPEED * HALF, "{off}");
    }
}

// The velocity of a point that is imposed on a body along x: constant after each jump, and no
// force. The constraint is a constraint of velocities, fulfilled to the iteration's 1e-9 m per
// step.
#[test]
fn a_step_of_a_velocity_is_an_impulse() {
    for settings in all_settings() {
        let (nodes, mut elements) = bars(1);
        let ends = JointEnds {
            a: None,
            b: (0, &nodes[0]),
        };
        let at = Placing::at(&nodes[0].position, &Matrix3::identity());
        let rates = [Some(speed().into()), None, None, None, None, None];
        let rates = ConstraintJoint::velocity("belt", &ends, &at, rates);
        elements.push(Box::new(rates));
        let model = Model::new("belt", System::new(nodes, elements));
        let (kept, outcome) = run(&model, &settings);
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        assert!(outcome.remarks.iter().any(|r| r.contains("\"belt\"")));
        for (time, state) in kept.times.iter().zip(&kept.states) {
            let expected = if *time > BEGIN && *time <= END {
                SPEED
            } else {
                0.0
            };
            let off = (state.nodes[0].velocity.x - expected).abs();
            assert!(off < 1e-7, "{settings:?} {time} {off:e}");
            assert!(state.multipliers[0].abs() < 1e-5 * MASS * SPEED / STEP);
        }
    }
}

// The first recorded state at or after the corner has the motion before it. The state of a corner
// is the state before it, and so are all recorded quantities: else a row of the table would show a
// speed of 2 rad/s for a bar at rest.
#[test]
fn what_acts_at_a_corner_is_reported_as_before_it() {
    for settings in all_settings() {
        let (kept, outcome) = run(&chain(2, Turning::Speed(speed().into())), &settings);
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let (drive, mut corners) = (speed(), 0);
        for ((time, seen), state) in kept.times.iter().zip(&kept.seen).zip(&kept.states) {
            assert!(
                seen <= time && time - seen <= 4.0 * f64::EPSILON,
                "{time} {seen}"
            );
            corners += usize::from(seen < time);
            let found = state.nodes[0].angular_velocity.z;
            assert!(
                (found - drive.at(*seen).value).abs() < 1e-6,
                "{time}: {found}"
            );
        }
        assert_eq!(corners, 2);
    }
}

#[test]
fn nothing_is_renewed_where_nothing_jumps() {
    // A ramp of the load itself: no constraint of the bar has a corner there.
    let smooth = Drive::Ramp(Ramp {
        from: 0.0,
        to: 1.0,
        start: BEGIN,
        end: END,
        smooth: true,
    });
    let (_, outcome) = run(
        &chain(2, Turning::Angle(smooth.into())),
        &TransientSettings::new(0.6, STEP),
    );
    assert!(outcome.failure.is_none());
    assert!(outcome.remarks.is_empty(), "{:?}", outcome.remarks);
    let found = states(
        &chain(1, Turning::Angle(ramp().into())),
        &TransientSettings::new(0.2, STEP),
    );
    let resting = found
        .iter()
        .filter(|state| state.nodes[0].angular_velocity.z.abs() < 1e-9);
    // Eleven on the grid up to 0.1 s, and the one at the corner.
    assert_eq!(resting.count(), 12);
}

// A step of an angle would need an infinite speed.
#[test]
fn a_step_of_an_angle_is_refused_before_the_run() {
    let jump = Drive::Step(Step {
        from: 0.0,
        to: 30_f64.to_radians(),
        time: 0.5,
    });
    let (kept, outcome) = run(
        &chain(1, Turning::Angle(jump.into())),
        &TransientSettings::new(1.0, STEP),
    );
    let failure = outcome.failure.unwrap();
    assert!(matches!(failure, TransientFailure::Jump { .. }));
    let expected = "the drive of \"hinge 0\" jumps at 0.5 s: its angle from 0 to 30 deg";
    assert_eq!(failure.to_string(), expected);
    assert!(failure.remedy().contains("ramp"));
    assert!(kept.states.is_empty());
}
