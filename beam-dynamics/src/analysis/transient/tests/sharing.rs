//! Loads that balance each other in a long loop are the smallest possible.

use std::f64::consts::TAU;

use nalgebra::{Matrix3, Vector3};

use super::models::{Kept, body, node};
use crate::analysis::transient::{redundant, transient};
use crate::assembly::{Sharing, System};
use crate::case::{Model, Redundant, TransientSettings};
use crate::elements::joints::{ConstraintJoint, JointEnds, Placing, axes_along};

fn settings(to: f64, step: f64) -> TransientSettings {
    TransientSettings {
        redundant: Redundant::Remove,
        ..TransientSettings::new(to, step)
    }
}

/// A plane ring of `count` pins with the frame, a polygon of sides of one.
fn ring(count: usize) -> Model {
    let step = TAU / count as f64;
    let radius = 0.5 / (0.5 * step).sin();
    let corner = |i: usize| {
        let angle = (i as f64 - 0.5) * step;
        radius * Vector3::new(angle.sin(), 0.0, -angle.cos())
    };
    let middle = |i: usize| 0.5 * (corner(i + 1) + corner(i + 2));
    let bar = |i: usize| node(&format!("bar {i}"), middle(i), Matrix3::identity());
    let nodes: Vec<_> = (0..count - 1).map(bar).collect();
    let moments = [0.02, 0.03, 0.04];
    let bodies = (0..nodes.len()).map(|i| body(i, 1.0, Vector3::zeros(), moments));
    let mut elements: Vec<_> = bodies.collect();
    for i in 0..count {
        let before = i.checked_sub(1).filter(|_| i + 1 < count);
        let own = i.min(count - 2);
        let ends = JointEnds {
            a: before.map(|a| (a, &nodes[a])),
            b: (own, &nodes[own]),
        };
        let at = Placing::at(&corner(i + 1), &axes_along(&Vector3::y()));
        let pin = ConstraintJoint::revolute(format!("pin {i}"), &ends, &at, None);
        elements.push(Box::new(pin));
    }
    let mut model = Model::new("ring", System::new(nodes, elements));
    model.gravity = Vector3::new(1.0, -2.0, -9.81);
    model
}

// Three of the hundred constraints of twenty pins are redundant. The loads across the plane and
// their moments, all self-equilibrated ones, are the smallest possible: their self-equilibrated
// part at the positions of each state is zero, except for the error of the prediction.
#[test]
fn a_long_ring_shares_its_loads_and_is_continued_bit_for_bit() {
    let model = ring(20);
    let settings = settings(0.2, 5e-3);
    let mut whole = Kept {
        wanted: Some(20),
        ..Kept::default()
    };
    let outcome = transient(&model, &settings, None, &mut whole, &|| 0.0);
    assert!(outcome.failure.is_none(), "{:?}", outcome.failure);
    assert_eq!(outcome.remarks.len(), 3);
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
    let shared = redundant::independent(&model, &settings).unwrap().unwrap();
    let conditions = model.conditions_at(0.0);
    for state in &whole.states {
        let mut sharing = Sharing::new(&shared.model.system, state, &conditions);
        let mut smallest = state.multipliers.clone();
        sharing.take_surplus(&mut smallest);
        let pairs = state.multipliers.iter().zip(&smallest);
        let taken = pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        let largest = smallest.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
        assert!(taken <= 1e-4 * largest, "{taken:e} of {largest}");
    }
}
