//! A turned Jacobian against the Jacobian of the turned model.

use std::sync::Arc;

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use shared_geom::rotation::vector;

use super::super::Multibody;
use crate::analysis::transient::tests::models::{Random, body, node};
use crate::assembly::{Combination, Sparse, System};
use crate::case::Model;
use crate::elements::beams::{Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong};
use crate::elements::joints::{ConstraintJoint, JointEnds, Placing, axes_along};
use crate::integrator::Dae;
use crate::model::State;

/// A beam, and on its end by a revolute joint along fixed axes a body, which is slender: its angular
/// momentum is integrated in axes of its own.
fn model(random: &mut Random) -> Model {
    let nodes: Vec<_> = (0..4)
        .map(|i| {
            let position = Vector3::new(f64::from(i.min(2)), 0.1 * f64::from(i * i), 0.0);
            node(
                &format!("n{i}"),
                position,
                vector::to_rotation(&random.vector()),
            )
        })
        .collect();
    let on = [0, 1, 2];
    let undeformed = [&nodes[0], &nodes[1], &nodes[2]];
    let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
    let stiffness = Matrix6::from_diagonal(&Vector6::new(9.0, 8.0, 7.0, 3.0, 2.0, 4.0));
    let mass = |_| Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, 1.0, 0.3, 0.1, 0.2));
    let mass = MassAlong::smooth(&mass);
    let ends = JointEnds {
        a: Some((2, &nodes[2])),
        b: (3, &nodes[3]),
    };
    let placing = Placing::at(&nodes[2].position, &axes_along(&random.vector()));
    let elements: Vec<Box<dyn crate::elements::Element>> = vec![
        Box::new(Beam::elastic(
            "beam",
            on,
            geometry,
            undeformed,
            [stiffness; 2],
        )),
        Box::new(BeamInertia::new("beam", on, geometry, undeformed, &mass)),
        Box::new(ConstraintJoint::revolute("joint", &ends, &placing, None)),
        body(3, 0.4, random.vector(), [1e-3, 0.2, 0.2]),
    ];
    Model::new("turned", System::new(nodes, elements))
}

/// A state with random motion and multipliers.
fn moving(system: &System, random: &mut Random) -> State {
    let mut state = system.rest();
    for node in &mut state.nodes {
        node.position += 0.2 * random.vector();
        node.rotation = vector::to_rotation(&(0.4 * random.vector())) * node.rotation;
        node.velocity = random.vector();
        node.angular_velocity = random.vector();
        node.momentum = random.vector();
        node.angular_momentum = random.vector();
        node.momentum_rate = random.vector();
        node.angular_momentum_rate = random.vector();
    }
    state
        .multipliers
        .iter_mut()
        .for_each(|it| *it = random.number());
    state
}

/// The state turned about the origin, except its multipliers.
fn turned(state: &State, q: &Matrix3<f64>) -> State {
    let mut state = state.clone();
    for node in &mut state.nodes {
        node.rotation = q * node.rotation;
        for vector in [
            &mut node.position,
            &mut node.velocity,
            &mut node.angular_velocity,
            &mut node.momentum,
            &mut node.angular_momentum,
            &mut node.momentum_rate,
            &mut node.angular_momentum_rate,
        ] {
            *vector = q * *vector;
        }
    }
    state
}

/// Turns the multipliers of a turned state: forces of the joint are along fixed axes.
fn turn_multipliers(of: &Multibody<'_>, q: &Matrix3<f64>, state: &mut State) {
    let first = of.model.system.numbering().first_multiplier();
    let mut numbers = vec![0.0; first];
    numbers.extend(&state.multipliers);
    of.turned.turn_own(&state.nodes, |_| *q, &mut numbers);
    state.multipliers.copy_from_slice(&numbers[first..]);
}

/// The Jacobian of a step from a state, without corrections.
fn jacobian(of: &mut Multibody<'_>) -> Sparse {
    let n = of.pattern().size();
    let (mut y, mut rates) = (vec![0.0; n], vec![0.0; n]);
    of.past(0.0, &mut y, &mut rates);
    of.predict(0, [0.0; 2], &y, &rates);
    let mut matrix = Sparse::zero(Arc::clone(of.pattern()));
    let mut out = [Combination {
        by_unknowns: 0.3,
        by_rates: 1.0,
        by_algebraic: 1.0,
        matrix: &mut matrix,
    }];
    of.jacobian(0, &mut out, None);
    matrix
}

/// `T^T J_turned T y = J y` for random models, states, turns and y, to round-off: some hundred terms of
/// size ten.
#[test]
fn the_jacobian_of_a_turned_model_is_the_turned_jacobian() {
    let mut random = Random(7);
    for case in 0..300 {
        let model = model(&mut random);
        let state = moving(&model.system, &mut random);
        let q = vector::to_rotation(&(3.0 * random.vector()));
        let mut later = turned(&state, &q);
        let mut first = Multibody::new(&model, [state.clone(), state], (1, false));
        turn_multipliers(&first, &q, &mut later);
        let mut second = Multibody::new(&model, [later.clone(), later], (1, false));
        let (held, now) = (jacobian(&mut first), jacobian(&mut second));
        first.hold();
        second.trials[0].held.clone_from(&first.trials[0].held);
        let y: Vec<f64> = (0..first.pattern().size())
            .map(|_| random.number())
            .collect();
        let mut expected = vec![0.0; y.len()];
        held.multiply_add(&y, &mut expected);
        let mut unknowns = y;
        second.turn_forth(0, &mut unknowns);
        let mut found = vec![0.0; unknowns.len()];
        now.multiply_add(&unknowns, &mut found);
        second.turn_back(0, &mut found);
        for (i, (found, expected)) in found.iter().zip(&expected).enumerate() {
            assert!(
                (found - expected).abs() < 1e-12,
                "{case} {i} {found} {expected}"
            );
        }
        assert!(expected.iter().any(|it| it.abs() > 1.0));
    }
}
