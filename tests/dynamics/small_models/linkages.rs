//! Mechanisms with redundant constraints: their motion is equal to the motion without them, and
//! their reactions are the smallest possible.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};

use super::models::{Kept, body, node, run};
use beam_dynamics::analysis::transient::transient;
use beam_dynamics::assembly::System;
use beam_dynamics::case::{Model, Redundant, TransientSettings};
use beam_dynamics::elements::Element;
use beam_dynamics::elements::joints::{
    ConstraintJoint, Freedom, JointEnds, Placing, Turning, axes_along,
};
use beam_dynamics::integrator::{StepControl, Stepping};
use beam_dynamics::model::{Drive, Node, Ramp};

/// Numbers between zero and one that follow from a seed.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        // Constants of Knuth's MMIX generator.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005);
        self.0 = self.0.wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// The two joints of the rocker of a four-bar.
#[derive(Clone, Copy, PartialEq)]
enum Rocker {
    /// Revolutes like the others: three constraints are redundant.
    Revolutes,
    /// Ball and cylinder: none is redundant.
    BallAndCylinder,
    /// Universal joint and ball: none is redundant.
    UniversalAndBall,
}

/// A plane four-bar somewhere in space.
struct FourBar {
    axes: Matrix3<f64>,
    /// Joints of its bars, from the drive to the foot.
    corners: [Vector3<f64>; 4],
    nodes: Vec<Node>,
}

impl FourBar {
    /// Of random lengths with which its crank turns (Grashof: crank and longest bar are
    /// shorter together than the other two).
    fn new(seed: u64) -> Self {
        let mut numbers = Numbers(seed);
        for _ in 0..5 {
            numbers.next();
        }
        let axes = Vector3::from_fn(|_, _| numbers.between(-2.0, 2.0));
        let axes = shared_geom::rotation::vector::to_rotation(&axes);
        let origin = Vector3::from_fn(|_, _| numbers.between(-3.0, 3.0));
        let (crank, coupler) = (numbers.between(0.15, 0.3), numbers.between(0.8, 1.1));
        let (last, angle) = (numbers.between(0.7, 1.0), numbers.between(0.0, 6.0));
        let position = |[x, y]: [f64; 2]| origin + axes * Vector3::new(x, y, 0.0);
        let a = [crank * angle.cos(), crank * angle.sin()];
        // Where circles about the end of the crank and about (1, 0) meet.
        let apart = (1.0 - a[0]).hypot(a[1]);
        let along = (apart * apart + coupler * coupler - last * last) / (2.0 * apart);
        let across = (coupler * coupler - along * along).sqrt();
        let unit = [(1.0 - a[0]) / apart, -a[1] / apart];
        let b = [
            a[0] + along * unit[0] - across * unit[1],
            a[1] + along * unit[1] + across * unit[0],
        ];
        let corners = [[0.0, 0.0], a, b, [1.0, 0.0]].map(position);
        let names = ["crank", "coupler", "rocker"].into_iter();
        let middle =
            |(label, ends): (&str, &[Vector3<f64>])| node(label, 0.5 * (ends[0] + ends[1]), axes);
        let nodes = names.zip(corners.windows(2)).map(middle).collect();
        Self {
            axes,
            corners,
            nodes,
        }
    }

    /// The joint of this number, from the drive to the foot: one turn per second.
    fn joint(&self, number: usize, rocker: Rocker) -> ConstraintJoint {
        let [p, q, r, s] = self.corners;
        let z: Vector3<f64> = self.axes.column(2).into_owned();
        let ends = |a: Option<usize>, b: usize| JointEnds {
            a: a.map(|a| (a, &self.nodes[a])),
            b: (b, &self.nodes[b]),
        };
        let along_z = |at: &Vector3<f64>| Placing::at(at, &axes_along(&z));
        let revolute = |name: &str, a, b, at: &Vector3<f64>, turning| {
            ConstraintJoint::revolute(name, &ends(a, b), &along_z(at), turning)
        };
        match (number, rocker) {
            (0, _) => revolute("drive", None, 0, &p, Some(Turning::Angle(turn().into()))),
            (1, _) => revolute("pin", Some(0), 1, &q, None),
            (2, Rocker::Revolutes) => revolute("far pin", Some(1), 2, &r, None),
            (2, _) => ConstraintJoint::spherical("ball", &ends(Some(1), 2), &along_z(&r)),
            (_, Rocker::Revolutes) => revolute("foot", None, 2, &s, None),
            (_, Rocker::BallAndCylinder) => {
                let (ends, at) = (ends(None, 2), along_z(&s));
                ConstraintJoint::cylindrical("foot", &ends, &at, Freedom::Free, None)
            }
            (_, Rocker::UniversalAndBall) => {
                // z of the frame and the normal of the rocker in the plane.
                let normal = z.cross(&(r - s));
                let at = Placing {
                    points: [s, s],
                    axes: [axes_along(&z), axes_along(&normal)],
                };
                ConstraintJoint::universal("foot", &ends(None, 2), &at)
            }
        }
    }
}

/// One turn per second.
fn turn() -> Drive {
    Drive::Ramp(Ramp {
        from: -TAU,
        to: 2.0 * TAU,
        start: -1.0,
        end: 2.0,
        smooth: false,
    })
}

/// A four-bar with its joints in some order, under gravity.
fn four_bar(seed: u64, rocker: Rocker, order: [usize; 4]) -> Model {
    let bars = FourBar::new(seed);
    let mut elements: Vec<Box<dyn Element>> = (0..3)
        .map(|i| body(i, 1.0 + i as f64, Vector3::zeros(), [0.02, 0.03, 0.04]))
        .collect();
    let joint = |number| Box::new(bars.joint(number, rocker)) as Box<dyn Element>;
    elements.extend(order.map(joint));
    let mut model = Model::new("four-bar", System::new(bars.nodes.clone(), elements));
    model.gravity = Vector3::new(1.0, -2.0, -9.81);
    model
}

const IN_ORDER: [usize; 4] = [0, 1, 2, 3];

fn settings(to: f64, step: f64) -> TransientSettings {
    TransientSettings {
        redundant: Redundant::Remove,
        ..TransientSettings::new(to, step)
    }
}

fn kept(model: &Model, settings: &TransientSettings) -> (Kept, Vec<String>) {
    let (kept, outcome) = run(model, settings);
    if let Some(failure) = outcome.failure {
        panic!("{failure}");
    }
    (kept, outcome.remarks)
}

// The crank turns once in 200 steps. Positions follow from the constraints, which are fulfilled to
// the tolerance of the iteration, 1e-9 at most; the moment of the drive, the fourth multiplier of
// its joint, follows from the power, independently of the others.
#[test]
fn random_four_bars_move_as_those_without_redundant_constraints() {
    for seed in 1..=8 {
        let settings = settings(1.0, 5e-3);
        let (four, remarks) = kept(&four_bar(seed, Rocker::Revolutes, IN_ORDER), &settings);
        assert_eq!(remarks.len(), 3, "{remarks:?}");
        for rocker in [Rocker::BallAndCylinder, Rocker::UniversalAndBall] {
            let (other, remarks) = kept(&four_bar(seed, rocker, IN_ORDER), &settings);
            assert_eq!(remarks, [""; 0], "{seed}");
            assert_eq!(four.states.len(), other.states.len());
            for (a, b) in four.states.iter().zip(&other.states) {
                for (a, b) in a.nodes.iter().zip(&b.nodes) {
                    let off = (a.position - b.position).amax();
                    let turned = (a.rotation - b.rotation).amax();
                    assert!(off < 1e-9 && turned < 1e-9, "{seed}: {off:e} {turned:e}");
                }
                let (moment, same) = (a.multipliers[3], b.multipliers[3]);
                let error = (moment - same).abs();
                assert!(error < 1e-5 * (1.0 + same.abs()), "{seed}: {moment} {same}");
            }
        }
    }
}

// The reactions do not depend on the order of the joints: each joint has six or five multipliers,
// the drive six.
#[test]
fn reactions_do_not_hang_on_the_order_of_the_joints() {
    let order = [3, 1, 0, 2];
    let settings = settings(0.4, 5e-3);
    let (one, _) = kept(&four_bar(3, Rocker::Revolutes, IN_ORDER), &settings);
    let (other, _) = kept(&four_bar(3, Rocker::Revolutes, order), &settings);
    let firsts = |order: [usize; 4]| {
        let mut firsts = [0; 4];
        let mut next = 0;
        for number in order {
            firsts[number] = next;
            next += if number == 0 { 6 } else { 5 };
        }
        firsts
    };
    let (of_one, of_other) = (firsts(IN_ORDER), firsts(order));
    for (a, b) in one.states.iter().zip(&other.states) {
        for number in 0..4 {
            for i in 0..5 {
                let a = a.multipliers[of_one[number] + i];
                let b = b.multipliers[of_other[number] + i];
                assert!((a - b).abs() < 1e-6, "joint {number}, {i}: {a} {b}");
            }
        }
    }
}

/// A door on hinges at the given heights, pushed by gravity across its axis.
fn door(hinges: &[f64]) -> Model {
    let door = node("door", Vector3::new(0.5, 0.0, 1.0), Matrix3::identity());
    let mut elements = vec![body(0, 1.0, Vector3::zeros(), [0.3, 0.4, 0.1])];
    for height in hinges {
        let at = Placing::at(&Vector3::new(0.0, 0.0, *height), &axes_along(&Vector3::z()));
        let ends = JointEnds {
            a: None,
            b: (0, &door),
        };
        let hinge = ConstraintJoint::revolute(format!("hinge at {height}"), &ends, &at, None);
        elements.push(Box::new(hinge));
    }
    let mut model = Model::new("door", System::new(vec![door.clone()], elements));
    model.gravity = Vector3::new(0.0, -9.81, 0.0);
    model
}

// Two hinges at the same distance from the center each carry one half of the load of a single one
// in the middle.
#[test]
fn two_hinges_carry_half_of_a_door_each() {
    let settings = settings(0.5, 5e-3);
    let (two, _) = kept(&door(&[0.2, 1.8]), &settings);
    let (one, _) = kept(&door(&[1.0]), &settings);
    for (two, one) in two.states.iter().zip(&one.states) {
        let (low, high) = two.multipliers.split_at(5);
        for i in 0..5 {
            let half = 0.5 * one.multipliers[i];
            assert!((low[i] - half).abs() < 1e-6, "{i}: {} {half}", low[i]);
            assert!((high[i] - half).abs() < 1e-6, "{i}: {} {half}", high[i]);
        }
    }
}

// A run continued from a snapshot has the same states to the last bit.
#[test]
fn a_run_with_redundant_constraints_is_continued_bit_for_bit() {
    let model = four_bar(5, Rocker::Revolutes, IN_ORDER);
    let variable = Stepping::Variable(StepControl {
        first: 1e-3,
        least: 1e-9,
        most: 0.01,
        tolerance: 1e-6,
    });
    for stepping in [Stepping::Constant { step: 5e-3 }, variable] {
        let settings = TransientSettings {
            stepping,
            ..settings(0.3, 5e-3)
        };
        let mut whole = Kept {
            wanted: Some(20),
            ..Kept::default()
        };
        let outcome = transient(&model, &settings, None, &mut whole, &|| 0.0);
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        let mut rest = Kept::default();
        let outcome = transient(
            &model,
            &settings,
            whole.snapshot.as_ref(),
            &mut rest,
            &|| 0.0,
        );
        assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
        assert_eq!(rest.states[..], whole.states[21..]);
    }
}

// Hinges out of line by 1 mm hold a door: four of their ten constraints are redundant, and it does
// not move.
#[test]
fn hinges_out_of_line_hold_a_door() {
    let nodes: Vec<Node> = door(&[]).system.nodes().to_vec();
    let ends = JointEnds {
        a: None,
        b: (0, &nodes[0]),
    };
    let mut elements = vec![body(0, 1.0, Vector3::zeros(), [0.3, 0.4, 0.1])];
    for (x, z) in [(0.0, 0.2), (1e-3, 1.8)] {
        let at = Placing::at(&Vector3::new(x, 0.0, z), &axes_along(&Vector3::z()));
        let hinge = ConstraintJoint::revolute(format!("hinge {z}"), &ends, &at, None);
        elements.push(Box::new(hinge));
    }
    let mut model = Model::new("door", System::new(nodes.clone(), elements));
    model.gravity = Vector3::new(0.0, -9.81, 0.0);
    let (kept, outcome) = run(&model, &settings(0.2, 5e-3));
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    assert_eq!((outcome.remarks.len(), kept.states.len()), (4, 41));
    for state in &kept.states {
        assert!((state.nodes[0].position - nodes[0].position).amax() < 1e-9);
    }
}

// A parallelogram whose bars are in one line after a quarter of a turn: there they can
// continue as an antiparallelogram too, and the reactions of their joints are undetermined.
#[test]
fn steps_that_end_in_a_singular_position_are_reported() {
    let corners = [[0.0, 0.0], [0.0, 1.0], [2.0, 1.0], [2.0, 0.0]];
    let corners = corners.map(|[x, y]| Vector3::new(x, y, 0.0));
    let names = ["crank", "coupler", "rocker"].into_iter();
    let bars = FourBar {
        axes: Matrix3::identity(),
        nodes: names
            .zip(corners.windows(2))
            .map(|(label, ends)| node(label, 0.5 * (ends[0] + ends[1]), Matrix3::identity()))
            .collect(),
        corners,
    };
    let mut elements: Vec<Box<dyn Element>> = (0..3)
        .map(|i| body(i, 1.0, Vector3::zeros(), [0.02, 0.03, 0.04]))
        .collect();
    let joint = |number| Box::new(bars.joint(number, Rocker::Revolutes)) as Box<dyn Element>;
    elements.extend(IN_ORDER.map(joint));
    let model = Model::new("parallelogram", System::new(bars.nodes.clone(), elements));
    let singular = |to: f64| {
        let (_, remarks) = kept(&model, &settings(to, 5e-3));
        let found = remarks.into_iter().filter(|text| text.contains("singular"));
        found.collect::<Vec<_>>()
    };
    assert_eq!(singular(0.24), [""; 0]);
    let [reported] = &singular(0.3)[..] else {
        panic!("one remark")
    };
    assert!(reported.starts_with("at t = 0.25 s the constraints are in a singular position"));
}
