//! Every kind of joint: constraints against its relative motions.
//!
//! Positions of order one: constraints and sums of forces are zero to round-off, 1e-13.
#![allow(clippy::unwrap_used, reason = "test helpers")]

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::samples::{Setting, all, settings};
use super::{ConstraintJoint, Freedom, JointEnds, Placing, Turning, axes_along};
use crate::elements::jacobian_tests::{Random, nodes};
use crate::elements::{
    Element, JointState, Local, LocalJacobian, LocalResidual, LocalSize, Observations, Queries,
    ReactionAxes,
};
use crate::model::{Conditions, Drive, NODE_UNKNOWNS, Node, NodeMotion, Scalars};

const ROUNDING: f64 = 1e-13;

fn seen<T>(
    joint: &ConstraintJoint,
    motions: &[NodeMotion],
    multipliers: &[f64],
    call: impl FnOnce(&ConstraintJoint, &Local<'_>) -> T,
) -> T {
    let conditions = Conditions::at_rest();
    let mut loading = conditions.loading;
    loading.time = 0.3;
    call(
        joint,
        &Local {
            nodes: motions,
            multipliers,
            scalars: Scalars::NONE,
            memory: &[],
            frame: &conditions.frame,
            loading: &loading,
        },
    )
}

fn constraints(joint: &ConstraintJoint, motions: &[NodeMotion]) -> Vec<f64> {
    let count = joint.multipliers();
    seen(joint, motions, &vec![0.0; count], |joint, at| {
        let mut out = LocalResidual::new(LocalSize::without_scalars(motions.len(), count));
        joint.residual(at, &mut out);
        out.values()[NODE_UNKNOWNS * motions.len()..].to_vec()
    })
}

fn observed(joint: &ConstraintJoint, motions: &[NodeMotion], multipliers: &[f64]) -> Observations {
    seen(joint, motions, multipliers, |joint, at| {
        let mut out = Observations::default();
        joint.observe(at, &mut out);
        out
    })
}

fn state(joint: &ConstraintJoint, motions: &[NodeMotion]) -> JointState {
    let multipliers = vec![0.0; joint.multipliers()];
    observed(joint, motions, &multipliers).joints.remove(0)
}

/// Moves b so that its point is at `d` from the point of a, in the axes of a, and its axes are
/// turned by `r` relative to the axes of a.
fn motion_of_b(
    setting: &Setting<'_>,
    at: &Placing,
    a: Option<&NodeMotion>,
    (d, r): (Vector3<f64>, Matrix3<f64>),
) -> NodeMotion {
    let (point, axes) = match (setting.ends.a, a) {
        (Some((_, node)), Some(moved)) => {
            let turn = moved.rotation * node.rotation.transpose();
            let point = moved.position + turn * (at.points[0] - node.position);
            (point, turn * at.axes[0])
        }
        _ => (at.points[0], at.axes[0]),
    };
    let node = setting.ends.b.1;
    let turn = axes * r * at.axes[1].transpose();
    NodeMotion {
        position: point + axes * d - turn * (at.points[1] - node.position),
        rotation: turn * node.rotation,
        ..NodeMotion::at_rest(node)
    }
}

fn about(axis: usize, angle: f64) -> Matrix3<f64> {
    let mut phi = Vector3::zeros();
    phi[axis] = angle;
    vector::to_rotation(&phi)
}

/// Both settings with a at a random position.
fn check_everywhere(mut check: impl FnMut(&Setting<'_>, Option<NodeMotion>, &mut Random)) {
    let mut random = Random::new(11);
    let nodes = nodes(&mut random, 2);
    for setting in &settings(&nodes, || random.vector(1.0)) {
        let a = setting.ends.a.map(|(_, node)| NodeMotion {
            position: node.position + Vector3::new(0.3, -0.8, 1.4),
            rotation: vector::to_rotation(&Vector3::new(0.5, 1.9, -0.7)) * node.rotation,
            ..NodeMotion::at_rest(node)
        });
        check(setting, a, &mut Random::new(5));
    }
}

fn motions(a: Option<NodeMotion>, b: NodeMotion) -> Vec<NodeMotion> {
    a.into_iter().chain([b]).collect()
}

/// A joint, its geometry, and a relative motion (d, R) that it permits.
type Allowed = (ConstraintJoint, Placing, Vector3<f64>, Matrix3<f64>);

/// A joint of each kind with a random motion that it permits.
fn allowed(setting: &Setting<'_>, random: &mut Random) -> Vec<Allowed> {
    use ConstraintJoint as Joint;
    let ends = &setting.ends;
    let (at, zero, one) = (setting.placing(), Vector3::zeros(), Matrix3::identity());
    let universal = setting.universal();
    let seven = Drive::Constant(7.0);
    let angle = || Turning::Angle(seven.clone().into());
    let [x, y, z] = random.vector(2.0).into();
    let (turn, any) = (about(0, 4.0 * x), random.rotation(2.0));
    let (along, across) = (Vector3::new(x, 0.0, 0.0), Vector3::new(0.0, y, z));
    let (free, of_seven) = (|| Freedom::Free, about(0, 7.0));
    // The axes of a and b have their angle when b is turned about both.
    let between = universal.axes[0].transpose() * universal.axes[1];
    let cross = about(0, x) * between * about(0, y);
    let length = Drive::Constant(across.norm());
    let anywhere = random.vector(1.0);
    let joints = [
        (Joint::clamp("clamp", ends, &at), zero, one),
        (Joint::spherical("spherical", ends, &at), zero, any),
        (Joint::revolute("revolute", ends, &at, None), zero, turn),
        (
            Joint::revolute("driven", ends, &at, Some(angle())),
            zero,
            of_seven,
        ),
        (
            Joint::cylindrical("cylindrical", ends, &at, free(), None),
            along,
            turn,
        ),
        (Joint::prismatic("prismatic", ends, &at, free()), along, one),
        (Joint::in_line("in-line", ends, &at), along, any),
        (Joint::in_plane("in-plane", ends, &at, None), across, any),
        (
            Joint::plane_rotation("plane", ends, &at, None),
            anywhere,
            turn,
        ),
        (Joint::distance("distance", ends, &at, length), across, any),
        (Joint::spin("spin", ends, &at, angle()), along, of_seven),
    ];
    let all = joints.into_iter().map(|(joint, d, r)| (joint, at, d, r));
    let joint = Joint::universal("universal", ends, &universal);
    all.chain([(joint, universal, zero, cross)]).collect()
}

// Relative motions (d, R) that a joint permits leave its constraints at zero.
#[test]
fn allowed_motions_keep_the_constraints() {
    check_everywhere(|setting, a, random| {
        for _ in 0..5 {
            for (joint, at, d, r) in allowed(setting, random) {
                let motions = motions(a, motion_of_b(setting, &at, a.as_ref(), (d, r)));
                let found = constraints(&joint, &motions);
                let error = found.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
                assert!(error < ROUNDING, "{}: {found:?}", joint.label());
            }
        }
    });
}

// Of a total joint: held components follow their drives, free ones are random. Rotations are the
// driven one first, then the free ones about an axis of a and one of b.
#[test]
fn total_joints_hold_what_they_name() {
    check_everywhere(|setting, a, random| {
        let at = setting.placing();
        for bits in 0..64_u32 {
            let held = |i: usize| bits >> i & 1 == 1;
            let now: [f64; 6] = std::array::from_fn(|_| 1.5 * random.number());
            let freedoms = std::array::from_fn(|i| {
                if held(i) {
                    Freedom::Driven(Drive::Constant(now[i]).into())
                } else {
                    Freedom::Free
                }
            });
            let d = Vector3::new(now[0], now[1], now[2]);
            let driven = Vector3::from_fn(|i, _| if held(3 + i) { now[3 + i] } else { 0.0 });
            let turn = vector::to_rotation(&driven);
            let free: Vec<_> = (0..3).filter(|i| !held(3 + i)).collect();
            let r = match free[..] {
                [] => turn,
                [i] => turn * about(i, 3.0 * now[3 + i]),
                // Held k: i = k + 2 stays on a, j = k + 1 on b.
                [i, j] => {
                    let k = 3 - i - j;
                    let (on_a, on_b) = ((k + 2) % 3, (k + 1) % 3);
                    turn * about(on_a, 3.0 * now[3 + on_a]) * about(on_b, 3.0 * now[3 + on_b])
                }
                _ => random.rotation(2.0),
            };
            let joint = ConstraintJoint::total("total", &setting.ends, &at, freedoms);
            assert_eq!(joint.multipliers(), bits.count_ones() as usize);
            let moved = motions(a, motion_of_b(setting, &at, a.as_ref(), (d, r)));
            let found = constraints(&joint, &moved);
            let error = found.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
            assert!(error < ROUNDING, "{bits:b}: {found:?}");
            // Away from the held values the constraint is violated.
            if bits & 0b111_000 != 0 && bits.count_ones() > 0 {
                let off = r * vector::to_rotation(&Vector3::new(0.2, 0.3, -0.25));
                let moved = motions(a, motion_of_b(setting, &at, a.as_ref(), (d, off)));
                let felt = constraints(&joint, &moved);
                assert!(felt.iter().any(|c| c.abs() > 1e-3), "{bits:b}: {felt:?}");
            }
        }
    });
}

// Points apart, axes turned: locked components keep their undeformed values in any common motion of
// both ends, and are violated by other motions of b. Distances are of order one.
#[test]
fn locked_freedoms_stay_as_they_are_undeformed() {
    check_everywhere(|setting, a, random| {
        let at = setting.apart();
        let [first, second] = at.points;
        let now = at.axes[0].tr_mul(&(second - first));
        assert!(now.amin() > 1e-3, "{now}");
        for bits in 1..64_u32 {
            let freedoms = std::array::from_fn(|i| match bits >> i & 1 {
                1 => Freedom::Locked,
                _ => Freedom::Free,
            });
            let joint = ConstraintJoint::total("total", &setting.ends, &at, freedoms);
            let nodes = setting.ends.a.iter().map(|a| a.1).chain([setting.ends.b.1]);
            let undeformed: Vec<_> = nodes.map(NodeMotion::at_rest).collect();
            let moved = motions(
                a,
                motion_of_b(setting, &at, a.as_ref(), (now, Matrix3::identity())),
            );
            for motions in [undeformed, moved] {
                let found = constraints(&joint, &motions);
                let error = found.iter().fold(0.0_f64, |most, c| most.max(c.abs()));
                assert!(error < ROUNDING, "{bits:b}: {found:?}");
            }
            let off = (
                now + random.vector(0.5),
                vector::to_rotation(&random.vector(0.5)),
            );
            let found = constraints(
                &joint,
                &motions(a, motion_of_b(setting, &at, a.as_ref(), off)),
            );
            assert!(found.iter().all(|c| c.abs() > 1e-6), "{bits:b}: {found:?}");
        }
    });
}

// Six relative freedoms: those that are free on purpose and the rows of positions.
#[test]
fn what_is_not_held_is_free_on_purpose() {
    check_everywhere(|setting, _, _| {
        for joint in all(setting) {
            let positions = (0..joint.multipliers())
                .filter(|&row| joint.level(row) == crate::elements::Level::Position)
                .count();
            assert_eq!(joint.motions().len(), 6 - positions, "{}", joint.label());
        }
    });
}

// Columns of multipliers are the rows of the constraints with the other sign: the power of the
// reactions is -lambda . Phi_y q', zero if Phi does not change in time. Reactions on two nodes
// balance if the constraints are fulfilled.
#[test]
fn reactions_do_no_work_and_balance() {
    check_everywhere(|setting, _, random| {
        let undeformed: Vec<Node> = setting.ends.a.iter().map(|a| a.1.clone()).collect();
        let undeformed: Vec<_> = undeformed
            .into_iter()
            .chain([setting.ends.b.1.clone()])
            .collect();
        let moved: Vec<_> = undeformed.iter().map(NodeMotion::at_rest).collect();
        for joint in all(setting) {
            let count = joint.multipliers();
            let multipliers: Vec<_> = (0..count).map(|_| random.number()).collect();
            let jacobian = seen(&joint, &moved, &multipliers, |joint, at| {
                let mut out = LocalJacobian::new(LocalSize::without_scalars(moved.len(), count));
                joint.jacobian(at, &mut out);
                out
            });
            let first = NODE_UNKNOWNS * moved.len();
            let of_rates = |row| joint.level(row) == crate::elements::Level::Velocity;
            for node in 0..moved.len() {
                for i in 0..6 {
                    for row in 0..count {
                        let column = NODE_UNKNOWNS * node + i;
                        let force = jacobian.by_unknowns()[(column + 6, first + row)];
                        let index = (first + row, column);
                        let slope = if of_rates(row) {
                            jacobian.by_rates()[index]
                        } else {
                            jacobian.by_unknowns()[index]
                        };
                        assert_eq!(force, -slope, "{} {row}", joint.label());
                    }
                }
            }
            let observations = observed(&joint, &moved, &multipliers);
            assert_eq!(observations.reactions.len(), moved.len());
            let on_b = observations.reactions.last().unwrap();
            assert_eq!(on_b.force, observations.joints[0].force);
            if moved.len() == 2 {
                let [a, b] = [&observations.reactions[0], on_b];
                let turning = |of: &crate::elements::Reaction, node: usize| {
                    of.moment + moved[node].position.cross(&of.force)
                };
                assert!((a.force + b.force).amax() < ROUNDING, "{}", joint.label());
                let sum = turning(a, 0) + turning(b, 1);
                assert!(sum.amax() < ROUNDING, "{}: {sum}", joint.label());
            }
        }
    });
}

// A common motion changes no constraint between two nodes, at any distance of the points; points
// that a joint holds together coincide.
#[test]
fn a_superposed_rigid_motion_changes_no_constraint() {
    check_everywhere(|setting, a, random| {
        let Some(a) = a else {
            return;
        };
        let turn = random.rotation(2.0);
        let shift = random.vector(3.0);
        let with = |node: &NodeMotion| NodeMotion {
            position: turn * node.position + shift,
            rotation: turn * node.rotation,
            ..*node
        };
        let at = setting.placing();
        let b = motion_of_b(
            setting,
            &at,
            Some(&a),
            (Vector3::zeros(), random.rotation(1.0)),
        );
        for joint in all(setting) {
            let before = constraints(&joint, &[a, b]);
            let after = constraints(&joint, &[with(&a), with(&b)]);
            for (before, after) in before.iter().zip(&after) {
                assert!((before - after).abs() < 1e-12, "{}", joint.label());
            }
        }
    });
}

// A link of length 2 along x, held by a revolute about z at its left end, with a weight of
// 3 N at its right end, 2 m away, and a distance joint as a prop from (0, -2) to the right
// end: moments about the hinge, 3 * 2 = 2 N sin(45 deg), N = 3 sqrt(2), pressure; the hinge
// takes N cos(45 deg) = 3 along x, nothing along y.
#[test]
fn a_prop_carries_a_weight() {
    let node = Node {
        label: "link".to_owned(),
        position: Vector3::new(1.0, 0.0, 0.0),
        rotation: Matrix3::identity(),
    };
    let ends = JointEnds {
        a: None,
        b: (0, &node),
    };
    let placing = |from: Vector3<f64>, at: Vector3<f64>| Placing {
        points: [from, at],
        axes: [axes_along(&Vector3::z()); 2],
    };
    let tip = Vector3::new(2.0, 0.0, 0.0);
    let hinge = placing(Vector3::zeros(), Vector3::zeros());
    let hinge = ConstraintJoint::revolute("hinge", &ends, &hinge, None);
    let prop = placing(Vector3::new(0.0, -2.0, 0.0), tip);
    let length = Drive::Constant(8.0_f64.sqrt());
    let prop = ConstraintJoint::distance("prop", &ends, &prop, length);
    let motion = [NodeMotion::at_rest(&node)];
    // Tension positive: the multiplier of the prop is -3 sqrt(2).
    let pressed = observed(&prop, &motion, &[-3.0 * 2.0_f64.sqrt()]);
    assert_eq!(constraints(&prop, &motion).len(), 1);
    assert!(constraints(&prop, &motion)[0].abs() < ROUNDING);
    let of_prop = &pressed.reactions[0];
    assert!((of_prop.force - Vector3::new(3.0, 3.0, 0.0)).amax() < ROUNDING);
    // The hinge balances force and moment: along its axes h = z, u, v the force (-3, 0, 0).
    let axes = axes_along(&Vector3::z());
    let lambda = axes.transpose() * Vector3::new(3.0, 0.0, 0.0);
    let of_hinge = observed(&hinge, &motion, &[lambda.x, lambda.y, lambda.z, 0.0, 0.0]);
    let weight = Vector3::new(0.0, -3.0, 0.0);
    let arm = tip - node.position;
    let force = of_prop.force + of_hinge.reactions[0].force + weight;
    let moment = of_prop.moment + of_hinge.reactions[0].moment + arm.cross(&weight);
    assert!(
        force.amax() < ROUNDING && moment.amax() < ROUNDING,
        "{force} {moment}"
    );
    // At its point the hinge has no moment; in its own axes the force is across h.
    let seen = &of_hinge.joints[0];
    assert!(seen.moment.amax() < ROUNDING);
    assert_eq!(seen.nodes, [None, Some(0)]);
    let [own, _] = seen.reaction(ReactionAxes::Second);
    assert!((own - axes.transpose() * Vector3::new(-3.0, 0.0, 0.0)).amax() < ROUNDING);
}

// The reported relative motion of a joint: the given one, and rates by central differences over h =
// 1e-5: truncation 1e-10, round-off 1e-11.
#[test]
fn relative_motion_is_reported_in_the_axes_of_a() {
    check_everywhere(|setting, a, random| {
        let at = setting.placing();
        let joint = ConstraintJoint::cylindrical("c", &setting.ends, &at, Freedom::Free, None);
        for turns in [-0.4, 0.2, 0.45] {
            let angle = turns * std::f64::consts::TAU;
            let d = Vector3::new(0.7, 0.0, 0.0);
            let b = motion_of_b(setting, &at, a.as_ref(), (d, about(0, angle)));
            let reported = state(&joint, &motions(a, b));
            assert!((reported.displacement - d).amax() < ROUNDING);
            assert!((reported.rotation - Vector3::new(angle, 0.0, 0.0)).amax() < 1e-12);
            assert!((reported.angle.unwrap() - angle).abs() < 1e-12);
            let before = angle + 3.0 * std::f64::consts::TAU - 0.1;
            let unwrapped = reported.unwrapped(before).unwrap();
            assert!((unwrapped - before - 0.1).abs() < 1e-12);
        }
        let b = motion_of_b(
            setting,
            &at,
            a.as_ref(),
            (random.vector(1.0), random.rotation(1.0)),
        );
        let rates: Vec<_> = (0..4).map(|_| random.vector(1.0)).collect();
        let moved = |t: f64| {
            let at = |node: NodeMotion, i: usize| NodeMotion {
                position: node.position + t * rates[2 * i],
                rotation: vector::to_rotation(&(t * rates[2 * i + 1])) * node.rotation,
                velocity: rates[2 * i],
                angular_velocity: rates[2 * i + 1],
                ..node
            };
            motions(a.map(|a| at(a, 0)), at(b, 1))
        };
        let h = 1e-5;
        let [before, now, after] = [-h, 0.0, h].map(|t| state(&joint, &moved(t)));
        let velocity = (after.displacement - before.displacement) / (2.0 * h);
        assert!((velocity - now.velocity).amax() < 1e-9);
        let [r_before, r_after] = [before, after].map(|s| s.axes[0].transpose() * s.axes[1]);
        let r = now.axes[0].transpose() * now.axes[1];
        let spin =
            shared_geom::rotation::axial(&((r_after - r_before) / (2.0 * h) * r.transpose()));
        assert!((spin - now.angular_velocity).amax() < 1e-9);
    });
}
