//! A rigid motion causes no strain in the beam, and its nodal forces balance.

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use shared_geom::rotation::vector;

use super::{Beam, BeamGeometry, BeamNode};
use crate::elements::{Local, LocalResidual, LocalSize, Queries};
use crate::model::{Conditions, Equation, NODE_UNKNOWNS, Node, NodeMotion, Scalars};

/// A curved, twisted beam with offsets.
fn beam() -> (Beam, [Node; 3]) {
    let nodes = std::array::from_fn(|i| {
        let x = i as f64;
        Node {
            label: format!("n{i}"),
            position: Vector3::new(x, 0.1 * x * x, -0.05 * x),
            rotation: vector::to_rotation(&Vector3::new(0.2 * x, 0.1, 0.3 * x)),
        }
    });
    let geometry = BeamGeometry::new(std::array::from_fn(|i| BeamNode {
        offset: Vector3::new(0.0, 0.1, 0.02 * i as f64),
        orientation: vector::to_rotation(&Vector3::new(0.1, 0.0, -0.1 * i as f64)),
    }));
    let stiffness = Matrix6::from_diagonal(&Vector6::new(5.0, 2.0, 3.0, 1.0, 1.5, 2.5));
    let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
    let beam = Beam::elastic("beam", [0, 1, 2], geometry, undeformed, [stiffness; 2]);
    (beam, nodes)
}

fn deformed(nodes: &[Node; 3]) -> Vec<NodeMotion> {
    let turn = |i: usize| vector::to_rotation(&Vector3::new(0.1 * i as f64, -0.2, 0.15 * i as f64));
    let mut motion: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    for (i, node) in motion.iter_mut().enumerate() {
        node.position += Vector3::new(0.02, 0.1 * i as f64, -0.03);
        node.rotation = turn(i) * node.rotation;
    }
    motion
}

fn turned(motion: &[NodeMotion], by: &Matrix3<f64>, shift: &Vector3<f64>) -> Vec<NodeMotion> {
    let mut moved = motion.to_vec();
    for node in &mut moved {
        node.position = by * node.position + shift;
        node.rotation = by * node.rotation;
    }
    moved
}

/// Round-off of the composition of rotations: 1e-14 of strains of order 0.1 to 1.
#[test]
fn a_rigid_motion_changes_no_strain() {
    let (beam, nodes) = beam();
    let rest: Vec<_> = nodes.iter().map(NodeMotion::at_rest).collect();
    let motion = deformed(&nodes);
    let by = vector::to_rotation(&Vector3::new(1.0, -2.0, 0.7));
    let shift = Vector3::new(3.0, -1.0, 2.0);
    for (motion, expected) in [
        (rest, [Vector6::zeros(); 2]),
        (motion.clone(), beam.strains(&motion)),
    ] {
        let found = beam.strains(&turned(&motion, &by, &shift));
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).amax() < 1e-14);
        }
    }
}

/// Forces on the three nodes have no resultant, and no moment about any point.
#[test]
fn nodal_forces_balance() {
    let (beam, nodes) = beam();
    let motion = deformed(&nodes);
    let mut out = LocalResidual::new(LocalSize::without_scalars(3, 0));
    let conditions = Conditions::at_rest();
    let at = Local {
        nodes: &motion,
        multipliers: &[],
        scalars: Scalars::NONE,
        memory: &[],
        frame: &conditions.frame,
        loading: &conditions.loading,
    };
    beam.residual(&at, &mut out);
    let part = |node: usize, equation: Equation| {
        let first = NODE_UNKNOWNS * node + equation.row();
        Vector3::from_column_slice(&out.values()[first..first + 3])
    };
    let mut force = Vector3::zeros();
    let mut moment = Vector3::zeros();
    for (i, node) in motion.iter().enumerate() {
        force += part(i, Equation::Force);
        moment += part(i, Equation::Moment) + node.position.cross(&part(i, Equation::Force));
    }
    assert!(part(0, Equation::Force).norm() > 0.1);
    assert!(
        force.norm() < 1e-14 && moment.norm() < 1e-14,
        "{force} {moment}"
    );
}

/// Rates of order one; the canceling terms are as large.
#[test]
fn a_rigid_velocity_strains_nothing() {
    let (beam, nodes) = beam();
    let mut motion = deformed(&nodes);
    let omega = Vector3::new(0.7, -1.1, 0.4);
    for node in &mut motion {
        node.angular_velocity = omega;
        node.velocity = Vector3::new(1.0, 2.0, -0.5) + omega.cross(&node.position);
    }
    for rate in beam.strain_rates(&motion) {
        assert!(rate.amax() < 1e-14, "{rate}");
    }
}

/// Central difference with h = 1e-5: truncation h^2 of rates of order one.
#[test]
fn the_strain_rate_is_the_derivative_of_the_strain() {
    let (beam, nodes) = beam();
    let mut motion = deformed(&nodes);
    for (i, node) in motion.iter_mut().enumerate() {
        let i = i as f64;
        node.velocity = Vector3::new(0.3 * i, -0.5, 0.2 * i * i);
        node.angular_velocity = Vector3::new(0.4, 0.6 * i, -0.7 + 0.2 * i);
    }
    let after = |time: f64| {
        let mut moved = motion.clone();
        for node in &mut moved {
            node.position += time * node.velocity;
            node.rotation = vector::to_rotation(&(time * node.angular_velocity)) * node.rotation;
        }
        beam.strains(&moved)
    };
    let (later, sooner) = (after(1e-5), after(-1e-5));
    for (i, rate) in beam.strain_rates(&motion).iter().enumerate() {
        let difference = (later[i] - sooner[i]) / 2e-5;
        assert!(rate.norm() > 0.1);
        assert!((rate - difference).amax() < 1e-9, "{rate} {difference}");
    }
}
