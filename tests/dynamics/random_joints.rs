//! Joints of every kind between two bodies at random positions with random loads: the constraints
//! are fulfilled, and the reactions balance and do no work.
//!
//! Constraints are checked by their meaning, in terms of the reported relative motion: d from the
//! point of a to the point of b and R the attitude of b, both in the axes of a. Newton's method
//! ends at round-off: the violation of constraints of order one is far below 1e-9, and reactions,
//! about 100 N at arms of some meters, balance to 1e-9 as well.

use beam_dynamics::elements::{JointState, Observations, Reaction};
use nalgebra::{Matrix3, Unit, Vector3};
use proptest::prelude::{Strategy, prop};
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};
use shared_geom::rotation::vector;

use crate::effort::cases;
use crate::joint_runs::{Mechanism, find};
use crate::record;

const HELD: f64 = 1e-9;
const STEP: f64 = 2e-3;
const STEPS: f64 = 50.0;
const CASES: usize = 6;

/// Two bodies, with their random loads and velocities.
#[derive(Debug, Clone)]
struct Setting {
    positions: [Vector3<f64>; 2],
    turns: [Vector3<f64>; 2],
    spins: [Vector3<f64>; 2],
    forces: [Vector3<f64>; 2],
    moments: [Vector3<f64>; 2],
    /// Point and axis of the joint.
    point: Vector3<f64>,
    axis: Vector3<f64>,
    /// Axis on b of a universal joint, across the axis of a and tilted.
    across: Vector3<f64>,
}

fn vector_of(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-size..size).prop_map(Vector3::from)
}

fn direction() -> impl Strategy<Value = Vector3<f64>> {
    let long = vector_of(1.0).prop_filter("too short", |v| v.norm() > 0.2);
    long.prop_map(|v| v.normalize())
}

fn pair(size: f64) -> impl Strategy<Value = [Vector3<f64>; 2]> {
    [vector_of(size), vector_of(size)]
}

fn setting() -> impl Strategy<Value = Setting> {
    let thrown = (pair(1.0), pair(1.5), pair(2.0), pair(20.0), pair(10.0));
    let joint = (vector_of(1.0), direction(), direction());
    let apart = |s: &Setting| s.axis.cross(&s.across).norm() > 0.5;
    let made = (thrown, joint).prop_map(|(thrown, (point, axis, across))| {
        let (mut positions, turns, spins, forces, moments) = thrown;
        // The distance joint runs from node to node.
        positions[1] += Vector3::new(3.0, 0.0, 0.0);
        Setting {
            positions,
            turns,
            spins,
            forces,
            moments,
            point,
            axis,
            across,
        }
    });
    made.prop_filter("axes nearly parallel", apart)
}

fn list(v: &Vector3<f64>) -> String {
    format!("[{:?}, {:?}, {:?}]", v.x, v.y, v.z)
}

impl Setting {
    /// Cards of the bodies and their loads, and of the joint.
    fn cards(&self, kind: &str, keys: &str) -> String {
        let mut cards = String::new();
        for (i, name) in ["a", "b"].into_iter().enumerate() {
            let [position, turn, spin, force, moment] = [
                &self.positions[i],
                &self.turns[i],
                &self.spins[i],
                &self.forces[i],
                &self.moments[i],
            ]
            .map(list);
            cards += &format!(
                "[[node]]\nname = \"{name}\"\nposition = {position}\norientation = {turn}\n\
                 angular_velocity = {spin}\n\
                 [[body]]\nname = \"{name}\"\nnode = \"{name}\"\nmass = 1.5\n\
                 offset = [0.1, -0.2, 0.15]\ninertia = [0.5, 0.7, 0.9]\n\
                 [[load]]\nnode = \"{name}\"\nforce = {force}\nmoment = {moment}\n\
                 drive = \"= cos(20*t + {i})\"\n"
            );
        }
        let axis = list(&self.axis);
        let keys = keys.replace("AXIS", &axis);
        let keys = keys.replace("ACROSS", &list(&self.across));
        let keys = keys.replace("POINT", &list(&self.point));
        cards
            + &format!(
                "[[joint]]\nname = \"joint\"\nkind = \"{kind}\"\nnodes = [\"a\", \"b\"]\n{keys}\n"
            )
    }
}

/// Relative motions that a joint permits: directions of b's point and axes of b's rotation, in the
/// axes of a.
type Free = (Vec<Vector3<f64>>, Vec<Vector3<f64>>);

/// A kind: its name, its keys, the quantities that must be zero, and its free motions.
struct Kind {
    name: &'static str,
    keys: &'static str,
    held: fn(&JointState) -> Vec<f64>,
    free: fn(&JointState) -> Free,
}

fn unit(axis: usize) -> Vector3<f64> {
    Vector3::ith(axis, 1.0)
}

fn all() -> Vec<Vector3<f64>> {
    vec![unit(0), unit(1), unit(2)]
}

/// Attitude of b in the axes of a.
fn attitude(state: &JointState) -> Matrix3<f64> {
    state.axes[0].transpose() * state.axes[1]
}

fn together(state: &JointState) -> Vec<f64> {
    state.displacement.iter().copied().collect()
}

fn across(state: &JointState) -> Vec<f64> {
    vec![state.displacement.y, state.displacement.z]
}

/// Off the shared first axis.
fn one_axis(state: &JointState) -> Vec<f64> {
    let axis = attitude(state).column(0).into_owned();
    vec![axis.y, axis.z]
}

fn not_turned(state: &JointState) -> Vec<f64> {
    let turned = vector::from_rotation(&attitude(state));
    turned.iter().copied().collect()
}

fn both(first: Vec<f64>, second: Vec<f64>) -> Vec<f64> {
    first.into_iter().chain(second).collect()
}

/// Directions across a vector.
fn around(d: &Vector3<f64>) -> Vec<Vector3<f64>> {
    let n = Unit::new_normalize(*d);
    let side = n.cross(&unit(n.iamin()));
    vec![side, n.cross(&side)]
}

const KINDS: &[Kind] = &[
    Kind {
        name: "clamp",
        keys: "at = POINT",
        held: |s| both(together(s), not_turned(s)),
        free: |_| (vec![], vec![]),
    },
    Kind {
        name: "spherical",
        keys: "at = POINT",
        held: together,
        free: |_| (vec![], all()),
    },
    Kind {
        name: "revolute",
        keys: "at = POINT\naxis = AXIS",
        held: |s| both(together(s), one_axis(s)),
        free: |_| (vec![], vec![unit(0)]),
    },
    Kind {
        name: "cylindrical",
        keys: "at = POINT\naxis = AXIS",
        held: |s| both(across(s), one_axis(s)),
        free: |_| (vec![unit(0)], vec![unit(0)]),
    },
    Kind {
        name: "universal",
        keys: "at = POINT\naxes = [AXIS, ACROSS]",
        // The setting contains the angle of the axes.
        held: together,
        free: |s| (vec![], vec![unit(0), attitude(s).column(0).into_owned()]),
    },
    Kind {
        name: "prismatic",
        keys: "at = POINT\naxis = AXIS",
        held: |s| both(across(s), not_turned(s)),
        free: |_| (vec![unit(0)], vec![]),
    },
    Kind {
        name: "in-line",
        keys: "at = POINT\naxis = AXIS",
        held: across,
        free: |_| (vec![unit(0)], all()),
    },
    Kind {
        name: "in-plane",
        keys: "at = POINT\naxis = AXIS",
        held: |s| vec![s.displacement.x],
        free: |_| (vec![unit(1), unit(2)], all()),
    },
    Kind {
        name: "plane-rotation",
        keys: "at = POINT\naxis = AXIS",
        held: one_axis,
        free: |_| (all(), vec![unit(0)]),
    },
    Kind {
        name: "distance",
        keys: "",
        held: |_| vec![],
        free: |s| (around(&s.displacement), all()),
    },
    Kind {
        name: "position",
        keys: "at = POINT\ndisplacement = { x = 0, z = 0 }",
        held: |s| vec![s.displacement.x, s.displacement.z],
        free: |_| (vec![unit(1)], all()),
    },
    Kind {
        name: "rotation",
        keys: "at = POINT\nrotation = { x = 0, y = 0, z = 0 }",
        held: not_turned,
        free: |_| (all(), vec![]),
    },
    Kind {
        name: "velocity",
        keys: "at = POINT\nvelocity = { y = 0.2 }\nangular_velocity = { x = 0, z = -0.3 }",
        held: |s| {
            vec![
                s.velocity.y - 0.2,
                s.angular_velocity.x,
                s.angular_velocity.z + 0.3,
            ]
        },
        free: |_| (vec![unit(0), unit(2)], vec![unit(1)]),
    },
    Kind {
        name: "spin",
        keys: "at = POINT\naxis = AXIS\nspeed = 0.4",
        held: |s| vec![s.angular_velocity.x - 0.4],
        free: |_| (all(), vec![unit(1), unit(2)]),
    },
    Kind {
        name: "total",
        keys: "at = POINT\nlocked = [\"y\", \"about x\", \"about z\"]",
        // About the free axis y: the axis of b coincides with the axis of a.
        held: |s| {
            let axis = attitude(s).column(1).into_owned();
            vec![s.displacement.y, axis.x, axis.z]
        },
        free: |_| (vec![unit(0), unit(2)], vec![unit(1)]),
    },
];

/// Force, and moment about the origin, of the reactions on both nodes: their sum.
fn unbalanced(reactions: &[Reaction], positions: &[Vector3<f64>]) -> f64 {
    let force: Vector3<f64> = reactions.iter().map(|r| r.force).sum();
    let about = |r: &Reaction| r.moment + positions[r.node].cross(&r.force);
    let moment: Vector3<f64> = reactions.iter().map(about).sum();
    force.amax().max(moment.amax())
}

/// Work of the reaction in the motions that the joint permits.
fn work(state: &JointState, (slides, turns): &Free) -> f64 {
    let back = state.axes[0].transpose();
    let [force, moment] = [back * state.force, back * state.moment];
    let slides = slides.iter().map(|d| d.dot(&force).abs());
    let turns = turns.iter().map(|r| r.dot(&moment).abs());
    slides.chain(turns).fold(0.0, f64::max)
}

/// The largest of the quantities that must be zero: constraints, balance, work.
fn errors(kind: &Kind, setting: &Setting) -> [f64; 3] {
    let run = Mechanism::new(&setting.cards(kind.name, kind.keys), STEPS * STEP, STEP);
    let start = (setting.positions[1] - setting.positions[0]).norm();
    let cosine = setting.axis.dot(&setting.across);
    let held = |state: &JointState| {
        let of_kind = match kind.name {
            "distance" => vec![state.displacement.norm() - start],
            "universal" => vec![attitude(state)[(0, 0)] - cosine],
            _ => vec![],
        };
        both((kind.held)(state), of_kind)
    };
    let constraint = run.most_of("joint", |_, state| {
        held(state).iter().fold(0.0, |most, c| most.max(c.abs()))
    });
    let work = run.most_of("joint", |_, state| work(state, &(kind.free)(state)));
    let balance = run.run.instants.iter().map(|(time, state)| {
        let model = &run.run.model;
        let observed: Observations = model.system.observe(state, &model.conditions_at(*time));
        let positions: Vec<_> = state.nodes.iter().map(|node| node.position).collect();
        assert_eq!(find(&observed, "joint").nodes, [Some(0), Some(1)]);
        unbalanced(&observed.reactions, &positions)
    });
    [constraint, balance.fold(0.0, f64::max), work]
}

fn check(kind: &Kind) {
    let config = Config {
        cases: cases(CASES) as u32,
        failure_persistence: None,
        max_shrink_iters: 20,
        ..Config::default()
    };
    let seed = TestRng::deterministic_rng(RngAlgorithm::ChaCha);
    let worst = std::cell::Cell::new([0.0_f64; 3]);
    let outcome = TestRunner::new_with_rng(config, seed).run(&setting(), |setting| {
        let found = errors(kind, &setting);
        let before = worst.get();
        worst.set([0, 1, 2].map(|i| before[i].max(found[i])));
        if found.iter().all(|error| *error < HELD) {
            Ok(())
        } else {
            Err(TestCaseError::fail(format!("{}: {found:?}", kind.name)))
        }
    });
    let quantities = ["constraint", "balance of reactions", "work of reactions"];
    for (quantity, error) in quantities.iter().zip(worst.get()) {
        let case = format!("{} joint, random bodies and loads", kind.name);
        record::largest("definition of the joint", &case, quantity, error, HELD);
    }
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

#[test]
fn joints_hold_and_balance_whatever_throws_them() {
    KINDS.iter().for_each(check);
}
