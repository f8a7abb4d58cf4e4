//! Every constraint's rates against differences in time.
//!
//! The nodes follow polynomial motions whose velocities and accelerations are known. The first
//! derivative of a constraint over a step h = 1e-3 s is taken by differences of fourth order, the
//! second by differences of fourth order of the first: truncation 1e-12 times fifth derivatives (up
//! to 1e3), round-off 1e-16/1e-6: 1e-8 has a margin.
#![allow(clippy::unwrap_used, reason = "test helpers")]

use nalgebra::{Matrix3, Vector3};
use shared_geom::rotation::vector;

use super::jacobian_tests::{Random, nodes};
use super::joints::{Hinge, HingeSpring, partly_clamped, rigid_connection, samples};
use super::loads::{ImposedMotion, LoadFactor, imposed};
use super::{ConstraintRates, Element, Level, Local, LocalJacobian, LocalResidual, LocalSize};
use crate::elements::Queries;
use crate::model::{Conditions, NODE_UNKNOWNS, Node, NodeMotion, Scalars, Variable};

const STEP: f64 = 1e-3;
const TOLERANCE: f64 = 1e-8;

/// A motion of a node: `x0 + v t + a t^2/2`, and `exp(w t + s t^2/2) R0`.
struct Path {
    start: Node,
    velocity: Vector3<f64>,
    acceleration: Vector3<f64>,
    omega: Vector3<f64>,
    alpha: Vector3<f64>,
}

impl Path {
    fn new(node: &Node, random: &mut Random) -> Self {
        let start = Node {
            label: String::new(),
            position: node.position + random.vector(0.2),
            rotation: random.rotation(0.4) * node.rotation,
        };
        Self {
            start,
            velocity: random.vector(1.0),
            acceleration: random.vector(1.0),
            omega: random.vector(1.0),
            alpha: random.vector(1.0),
        }
    }

    /// At t; the angular velocity is `T(phi) phi'`.
    fn at(&self, t: f64) -> NodeMotion {
        let phi = self.omega * t + 0.5 * t * t * self.alpha;
        NodeMotion {
            position: self.start.position + self.velocity * t + 0.5 * t * t * self.acceleration,
            rotation: vector::to_rotation(&phi) * self.start.rotation,
            velocity: self.velocity + t * self.acceleration,
            angular_velocity: vector::tangent(&phi) * (self.omega + t * self.alpha),
            ..NodeMotion::at_rest(&self.start)
        }
    }
}

/// The constraints of an element at a time, and `Phi_y` by the variables of a level.
struct Found {
    values: Vec<f64>,
    by_positions: Vec<f64>,
    by_velocities: Vec<f64>,
    by_time: Vec<f64>,
    convective: Vec<f64>,
}

/// At time `t` after 0.3 s; the products are of the derivatives with `rates`, velocity and angular
/// velocity of each node.
fn found(
    element: &dyn Element,
    paths: &[Path],
    t: f64,
    [rates, second]: [&[[Vector3<f64>; 2]]; 2],
) -> Found {
    let motions: Vec<_> = paths.iter().map(|path| path.at(t)).collect();
    let mut conditions = Conditions::at_rest();
    conditions.loading.time = 0.3 + t;
    conditions.loading.constant = 0.7;
    conditions.loading.proportional = 1.3;
    let count = element.multipliers();
    let [values, scalar_rates] = scalars(element, t);
    let at = Local {
        nodes: &motions,
        multipliers: &vec![0.0; count],
        scalars: Scalars {
            values: &values,
            rates: &scalar_rates,
        },
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    };
    let mut residual = LocalResidual::new(LocalSize::of(element));
    element.residual(&at, &mut residual);
    let mut jacobian = LocalJacobian::new(LocalSize::of(element));
    element.jacobian(&at, &mut jacobian);
    let first = NODE_UNKNOWNS * motions.len();
    let product = |row: usize, of_rates: bool, with: &[[Vector3<f64>; 2]]| {
        let matrix = [jacobian.by_unknowns(), jacobian.by_rates()][usize::from(of_rates)];
        let mut sum = 0.0;
        for (node, pair) in with.iter().enumerate() {
            for (variable, rate) in [Variable::Position, Variable::Rotation].iter().zip(pair) {
                for axis in 0..3 {
                    let index = (first + row, NODE_UNKNOWNS * node + variable.column() + axis);
                    sum += rate[axis] * matrix[index];
                }
            }
        }
        sum
    };
    let (mut by_time, mut convective) = (vec![0.0; count], vec![0.0; count]);
    let mut out = ConstraintRates {
        by_time: &mut by_time,
        convective: &mut convective,
    };
    assert!(element.constraint_rates(&at, &mut out));
    let by = |row: usize| match element.level(row) {
        Level::Position => product(row, false, second),
        Level::Velocity => product(row, true, second),
    };
    Found {
        values: residual.values()[first..first + count].to_vec(),
        by_positions: (0..count).map(|row| product(row, false, rates)).collect(),
        by_velocities: (0..count).map(by).collect(),
        by_time,
        convective,
    }
}

/// Scalars of an element that move as polynomials, and their rates.
fn scalars(element: &dyn Element, t: f64) -> [Vec<f64>; 2] {
    let all = element.scalars();
    let mut found = [vec![0.0; all.len()], vec![0.0; all.len()]];
    for (i, scalar) in all.iter().enumerate() {
        let Some(rate) = &scalar.rate else { continue };
        let rate = all.iter().position(|own| own == rate).unwrap();
        let speed = 0.7 - 0.5 * t;
        found[0][i] = 0.3 + 0.1 * i as f64 + 0.7 * t - 0.25 * t * t;
        (found[1][i], found[0][rate], found[1][rate]) = (speed, speed, -0.5);
    }
    found
}

/// Checks Phi' and Phi'' of a position, Phi' of a velocity.
pub(super) fn check(element: &dyn Element, undeformed: &[Node], random: &mut Random) {
    for _ in 0..3 {
        let paths: Vec<_> = undeformed
            .iter()
            .map(|node| Path::new(node, random))
            .collect();
        let velocities = |t: f64| -> Vec<_> {
            let moved = paths.iter().map(|path| path.at(t));
            moved.map(|m| [m.velocity, m.angular_velocity]).collect()
        };
        let accelerations: Vec<_> = paths.iter().map(|p| [p.acceleration, p.alpha]).collect();
        let all: Vec<_> = [-2.0, -1.0, 0.0, 1.0, 2.0]
            .iter()
            .map(|i| {
                found(
                    element,
                    &paths,
                    i * STEP,
                    [&velocities(i * STEP), &accelerations],
                )
            })
            .collect();
        let slope = |of: &dyn Fn(&Found) -> f64| {
            let [b, a, _, c, d] = [0, 1, 2, 3, 4].map(|i| of(&all[i]));
            (8.0 * (c - a) - (d - b)) / (12.0 * STEP)
        };
        let now = &all[2];
        for row in 0..element.multipliers() {
            let label = element.label();
            let value = slope(&|found| found.values[row]);
            let convective = now.convective[row] + now.by_velocities[row];
            if element.level(row) == Level::Velocity {
                assert!((value - convective).abs() < TOLERANCE, "{label} {row}");
                assert_eq!(now.by_time[row], 0.0, "{label} {row}");
                continue;
            }
            let rate = |found: &Found| found.by_positions[row] + found.by_time[row];
            let error = (value - rate(now)).abs();
            assert!(error < TOLERANCE, "{label} {row}: Phi' {error:e}");
            let error = (slope(&rate) - convective).abs();
            assert!(error < TOLERANCE, "{label} {row}: Phi'' {error:e}");
        }
    }
}

#[test]
fn clamps_and_rigid_connections() {
    let mut random = Random::new(1);
    let nodes = nodes(&mut random, 2);
    for bits in 0..64_u32 {
        let held = std::array::from_fn(|i| bits >> i & 1 == 1);
        let axes = random.rotation(1.0);
        let clamp = partly_clamped("clamp", 0, &nodes[0], &axes, held);
        check(&clamp, &nodes[..1], &mut random);
    }
    let rigid = rigid_connection("rigid", [0, 1], [&nodes[0], &nodes[1]]);
    check(&rigid, &nodes, &mut random);
}

#[test]
fn hinges() {
    let mut random = Random::new(2);
    let nodes = nodes(&mut random, 2);
    let (position, axis) = (random.vector(1.0), random.vector(1.0));
    let ends = [&nodes[0], &nodes[1]];
    let spring = HingeSpring::default();
    let hinge = Hinge::new("hinge", [0, 1], ends, &position, &axis, spring);
    check(&hinge, &nodes, &mut random);
}

#[test]
fn imposed_motions() {
    let mut random = Random::new(3);
    let nodes = nodes(&mut random, 1);
    for mask in 1..64_u32 {
        let mut some = |i: u32| (mask >> i & 1 == 1).then(|| random.number());
        let motion = ImposedMotion {
            displacement: [some(0), some(1), some(2)],
            rotation: [some(3), some(4), some(5)],
            axes: Matrix3::identity(),
            factor: LoadFactor::Proportional,
        };
        let imposed = imposed("imposed", 0, &nodes[0], motion);
        check(
            &imposed.clone().scaled_by(samples::drive(0.8)),
            &nodes,
            &mut random,
        );
        check(&imposed, &nodes, &mut random);
    }
}

#[test]
fn joints_of_every_kind() {
    let mut random = Random::new(4);
    let nodes = nodes(&mut random, 2);
    for setting in &samples::settings(&nodes, || random.vector(1.0)) {
        let count = 1 + usize::from(setting.ends.a.is_some());
        for joint in samples::all(setting) {
            check(&joint, &nodes[..count], &mut Random::new(5));
        }
    }
}

#[test]
fn joints_that_follow_scalars() {
    let mut random = Random::new(6);
    let nodes = nodes(&mut random, 2);
    for mut setting in samples::settings(&nodes, || random.vector(1.0)) {
        setting.drive = samples::signal;
        let count = 1 + usize::from(setting.ends.a.is_some());
        for joint in samples::all(&setting) {
            check(&joint, &nodes[..count], &mut Random::new(7));
        }
    }
    let motion = ImposedMotion {
        displacement: [Some(0.3), None, Some(-0.2)],
        rotation: [Some(0.4), Some(-0.5), Some(0.2)],
        axes: random.rotation(1.0),
        factor: LoadFactor::Proportional,
    };
    let imposed = imposed("imposed", 0, &nodes[0], motion);
    let imposed = imposed.scaled_by(samples::signal(0.8));
    check(&imposed, &nodes[..1], &mut random);
}
