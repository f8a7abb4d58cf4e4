//! Sums in parts against the sum in one part, to the last bit.

use std::sync::Arc;

use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use shared_geom::rotation::vector;

use super::*;
use crate::assembly::Sparse;
use crate::effort::cases;
use crate::elements::Element;
use crate::elements::beams::{Beam, BeamGeometry, BeamInertia, BeamNode, MassAlong};
use crate::elements::joints::{ConstraintJoint, JointEnds, Placing, clamped};
use crate::model::{Node, TurningFrame};

/// Pseudorandom numbers between -1 and 1.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector(&mut self) -> Vector3<f64> {
        Vector3::from_fn(|_, _| self.next())
    }

    fn below(&mut self, count: usize) -> usize {
        (0.5 * (self.next() + 1.0) * count as f64) as usize % count
    }
}

/// An irregular chain of beams; some nodes are clamped and some are joined.
fn system(numbers: &mut Numbers) -> System {
    let beams = 1 + numbers.below(6);
    let nodes: Vec<_> = (0..=2 * beams)
        .map(|i| Node {
            label: format!("n{i}"),
            position: Vector3::new(i as f64, 0.0, 0.0) + 0.2 * numbers.vector(),
            rotation: vector::to_rotation(&numbers.vector()),
        })
        .collect();
    let mut elements: Vec<Box<dyn Element>> = Vec::new();
    let stiffness = Matrix6::from_diagonal(&Vector6::new(9.0, 8.0, 7.0, 3.0, 2.0, 4.0));
    let mass = Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, 1.0, 0.3, 0.1, 0.2));
    for beam in 0..beams {
        let on = [0, 1, 2].map(|i| 2 * beam + i);
        let at = on.map(|i| &nodes[i]);
        let geometry = BeamGeometry::new([BeamNode::aligned(); 3]);
        let beam = Beam::elastic("beam", on, geometry, at, [stiffness; 2]);
        let inertia = BeamInertia::new("beam", on, geometry, at, &MassAlong::smooth(&|_| mass));
        elements.push(Box::new(beam));
        elements.push(Box::new(inertia));
    }
    for _ in 0..numbers.below(4) {
        let (a, b) = (numbers.below(nodes.len()), numbers.below(nodes.len()));
        if a == b {
            elements.push(Box::new(clamped("clamp", a, &nodes[a])));
        } else {
            let ends = JointEnds {
                a: Some((a, &nodes[a])),
                b: (b, &nodes[b]),
            };
            let at = Placing::at(&nodes[b].position, &Matrix3::identity());
            elements.push(Box::new(ConstraintJoint::spherical("joint", &ends, &at)));
        }
    }
    System::new(nodes, elements)
}

fn moving(system: &System, numbers: &mut Numbers) -> (State, Conditions) {
    let mut state = system.rest();
    let count = system.numbering().unknowns();
    let change: Vec<_> = (0..count).map(|_| 0.2 * numbers.next()).collect();
    state.correct(&change);
    for node in &mut state.nodes {
        node.velocity = numbers.vector();
        node.angular_velocity = numbers.vector();
    }
    let frame = TurningFrame {
        angular_velocity: numbers.vector(),
        ..TurningFrame::at_rest()
    };
    (state, Conditions::turning(frame))
}

/// Values and sizes of the residual, and two sums of derivatives.
fn sums(
    system: &System,
    (state, conditions): (&State, &Conditions),
    variations: &[Variation],
    parts: usize,
) -> [Vec<f64>; 5] {
    let mut work = Workspace::in_parts(system, parts);
    let [mut first, mut second] = [(); 2].map(|()| Sparse::zero(Arc::clone(system.pattern())));
    let mut residual = Residual::default();
    let mut alone = Residual::default();
    // The second evaluation reuses the buffers.
    for _ in 0..2 {
        let mut out = [
            Combination {
                by_unknowns: 0.7,
                by_rates: 2.0,
                by_algebraic: 3.0,
                matrix: &mut first,
            },
            Combination::by_rates(&mut second),
        ];
        let out = (&mut out[..], Some(&mut residual));
        system.combine(state, conditions, variations, out, &mut work);
        system.residual_into(state, conditions, &mut alone, &mut work);
    }
    assert_eq!(residual.sizes.len(), alone.sizes.len());
    let matrices = [first, second].map(|matrix| matrix.values().to_vec());
    let [first, second] = matrices;
    [residual.values, residual.sizes, alone.values, first, second]
}

#[test]
fn sums_are_the_same_to_the_last_bit_for_any_number_of_parts() {
    let mut numbers = Numbers(17);
    for case in 0..cases(40) {
        let system = system(&mut numbers);
        let (state, conditions) = moving(&system, &mut numbers);
        let variation = |_: &_| Variation {
            turn: vector::to_rotation(&numbers.vector()),
            rate_by_turn: 0.3 * vector::to_rotation(&numbers.vector()),
            axes: None,
        };
        let variations: Vec<_> = system.nodes().iter().map(variation).collect();
        let at = (&state, &conditions);
        let one = sums(&system, at, &variations, 1);
        assert!(one.iter().all(|sum| sum.iter().any(|value| *value != 0.0)));
        for parts in [2, 3 + case % 5].map(|parts| parts.min(system.nodes().len())) {
            let found = sums(&system, at, &variations, parts);
            let bits = |sums: &[Vec<f64>; 5]| -> Vec<u64> {
                sums.iter().flatten().map(|value| value.to_bits()).collect()
            };
            assert!(bits(&found) == bits(&one), "case {case}, {parts} parts");
        }
    }
}
