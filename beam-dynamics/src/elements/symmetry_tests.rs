//! Forces that are gradients: the tangent of each element is symmetric except for half of its
//! moments on its nodes.
//!
//! For any function of positions and rotations, with its gradient `[g; m]` by spatial variations
//! and the derivatives H of the gradient,
//!
//! ```text
//! H - H^T = - blockdiag( 0, [m_j]x )
//! ```
//!
//! so that the tangent of a whole model is symmetric if the moments at each node are in balance.
//! Constraints are functions times their multipliers. Random states that fulfill no constraint;
//! round-off of products of numbers of order one.

use nalgebra::DMatrix;
use shared_geom::rotation::{skew, vector};

use super::jacobian_tests::{Random, nodes};
use super::joints::{Hinge, HingeSpring, clamped, rigid_connection, samples};
use super::laws::Law;
use super::springs::{Spring, SpringLaw};
use super::{Element, Level, Local, LocalJacobian, LocalResidual, LocalSize};
use crate::elements::Queries;
use crate::model::{Conditions, Equation, NODE_UNKNOWNS, Node, NodeMotion, Scalars, Variable};

const TOLERANCE: f64 = 1e-13;

/// Random positions and attitudes of `nodes`.
fn moved(nodes: &[Node], random: &mut Random) -> Vec<NodeMotion> {
    let moved = nodes.iter().map(|node| NodeMotion {
        position: node.position + random.vector(0.2),
        rotation: random.rotation(0.4) * node.rotation,
        ..NodeMotion::at_rest(node)
    });
    moved.collect()
}

/// H, `H - H^T + blockdiag([m_j]x)`, and the derivatives of the constraints and of the
/// forces by their multipliers, at a state of the nodes.
struct Tangents {
    tangent: DMatrix<f64>,
    rest: DMatrix<f64>,
    constraints: DMatrix<f64>,
    forces: DMatrix<f64>,
}

impl Tangents {
    /// The largest entry of the difference and of `d constraint - (d force)^T`, relative to
    /// the largest of H.
    fn defect(&self) -> f64 {
        // Of either sign, which is the sign of the multiplier.
        let pairs = self.constraints.iter().zip(self.forces.iter());
        let coupled = pairs.map(|(a, b)| (a.abs() - b.abs()).abs());
        self.rest.amax().max(coupled.fold(0.0, f64::max)) / self.tangent.amax().max(1.0)
    }

    /// The same for motions that keep the constraints.
    fn defect_of_motions(&self) -> f64 {
        let n = self.constraints.ncols();
        let squares = self.constraints.tr_mul(&self.constraints).symmetric_eigen();
        let values = squares
            .eigenvalues
            .iter()
            .zip(squares.eigenvectors.column_iter());
        let free: Vec<_> = values
            .filter(|(value, _)| **value < 1e-10)
            .map(|(_, column)| column.into_owned())
            .collect();
        assert_eq!(free.len(), n - self.constraints.nrows());
        let free = DMatrix::from_columns(&free);
        (free.transpose() * &self.rest * &free).amax() / self.tangent.amax().max(1.0)
    }
}

fn tangents(element: &dyn Element, motion: &[NodeMotion], random: &mut Random) -> Tangents {
    let nodes = motion;
    let multipliers: Vec<_> = (0..element.multipliers())
        .map(|_| random.number())
        .collect();
    let conditions = Conditions::at_rest();
    let at = Local {
        nodes: motion,
        multipliers: &multipliers,
        scalars: Scalars::NONE,
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    };
    let mut residual =
        LocalResidual::new(LocalSize::without_scalars(nodes.len(), multipliers.len()));
    let mut jacobian =
        LocalJacobian::new(LocalSize::without_scalars(nodes.len(), multipliers.len()));
    element.residual(&at, &mut residual);
    element.jacobian(&at, &mut jacobian);
    let size = 6 * nodes.len();
    let row = |i: usize| NODE_UNKNOWNS * (i / 6) + Equation::Force.row() + i % 6;
    let column = |j: usize| NODE_UNKNOWNS * (j / 6) + Variable::Position.column() + j % 6;
    let values = jacobian.by_unknowns();
    // Forces are minus gradients.
    let tangent = DMatrix::from_fn(size, size, |i, j| -values[(row(i), column(j))]);
    let mut rest = &tangent - tangent.transpose();
    for node in 0..nodes.len() {
        let moment = -residual.of(node, Equation::Moment);
        let mut block = rest.fixed_view_mut::<3, 3>(6 * node + 3, 6 * node + 3);
        block += skew(&moment);
    }
    let first = NODE_UNKNOWNS * nodes.len();
    let count = multipliers.len();
    Tangents {
        constraints: DMatrix::from_fn(count, size, |k, i| values[(first + k, column(i))]),
        forces: DMatrix::from_fn(count, size, |k, i| values[(row(i), first + k)]),
        tangent,
        rest,
    }
}

fn check(element: &dyn Element, nodes: &[Node], random: &mut Random) {
    for _ in 0..5 {
        let motion = moved(nodes, random);
        let defect = tangents(element, &motion, random).defect();
        assert!(defect < TOLERANCE, "{}: {defect:e}", element.label());
    }
}

#[test]
fn joints_of_positions() {
    let mut random = Random::new(31);
    let nodes = nodes(&mut random, 2);
    let mut checked = 0;
    for setting in &samples::settings(&nodes, || random.vector(1.0)) {
        let count = 1 + usize::from(setting.ends.a.is_some());
        for joint in samples::all(setting) {
            let mut levels = (0..joint.multipliers()).map(|k| joint.level(k));
            if levels.all(|level| level == Level::Position) {
                check(&joint, &nodes[..count], &mut Random::new(32));
                checked += 1;
            }
        }
    }
    assert!(checked > 250, "{checked}");
}

/// The moment of the spring of a hinge is about its axis: a gradient in motions that the hinge
/// permits, if its constraint is fulfilled.
#[test]
fn hinges_with_springs() {
    let mut random = Random::new(35);
    for _ in 0..20 {
        let nodes = nodes(&mut random, 2);
        let (position, axis) = (
            random.vector(1.0),
            random.rotation(3.0).column(0).into_owned(),
        );
        let spring = HingeSpring {
            stiffness: 3.0 + random.number(),
            ..HingeSpring::default()
        };
        let on = [&nodes[0], &nodes[1]];
        let hinge = Hinge::new("hinge", [0, 1], on, &position, &axis, spring);
        let mut motion = moved(&nodes, &mut random);
        let rigid = motion[0].rotation * nodes[0].rotation.transpose();
        let turn = vector::to_rotation(&(random.number() * axis));
        let hung = rigid * turn;
        motion[1].rotation = hung * nodes[1].rotation;
        motion[1].position = motion[0].position
            + rigid * (position - nodes[0].position)
            + hung * (nodes[1].position - position);
        let defect = tangents(&hinge, &motion, &mut random).defect_of_motions();
        assert!(defect < TOLERANCE, "{defect:e}");
    }
}

#[test]
fn clamps_rigid_connections_and_springs() {
    let mut random = Random::new(33);
    let nodes = nodes(&mut random, 2);
    let ends = [&nodes[0], &nodes[1]];
    let position = random.vector(1.0);
    check(
        &rigid_connection("rigid", [0, 1], ends),
        &nodes,
        &mut random,
    );
    check(&clamped("clamp", 0, &nodes[0]), &nodes[..1], &mut random);
    let axes = random.rotation(1.0);
    let law: SpringLaw = Law::linear(random.stiffness()).into();
    let spring = Spring::new("spring", (&[0, 1], &nodes), &position, &axes, law);
    check(&spring, &nodes, &mut random);
}
