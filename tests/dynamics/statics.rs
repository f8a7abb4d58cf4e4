//! Large deflections of beams against exact solutions.
//!
//! Sources: `tests/reference/dynamics/beam_static.json` and `exact_static_beams.json`
//! (shooting on the same rod at round-off; elliptic integrals), see the README there.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use nalgebra::{Matrix3, Rotation3, Vector3, Vector6};
use serde_json::Value;

use crate::chain::{Chain, DEAD};
use crate::record;
use beam_dynamics::elements::loads::{NodalForce, Turning};

fn reference(name: &str) -> Value {
    let file = format!(
        "{}/tests/reference/dynamics/{name}",
        env!("CARGO_MANIFEST_DIR")
    );
    serde_json::from_str(&std::fs::read_to_string(file).unwrap()).unwrap()
}

fn vector(value: &Value) -> Vector3<f64> {
    Vector3::from_fn(|i, _| value[i].as_f64().unwrap_or(0.0))
}

fn cantilever(elements: usize, length: f64, stiffness: &Vector6<f64>) -> (Chain, usize) {
    let mut chain = Chain::new();
    let ends = [Vector3::zeros(), Vector3::x() * length];
    let on = chain.straight(None, elements, stiffness, ends, Vector3::z());
    chain.clamp(0);
    (chain, on[2 * elements])
}

/// Tip of a beam bent by the moment `moment` about z.
fn rolled(elements: usize, moment: f64, turning: Turning) -> (Vector3<f64>, Matrix3<f64>) {
    let stiffness = Vector6::new(1e4, 1e4, 1e4, 1.0, 1.0, 1.0);
    let (mut chain, tip) = cantilever(elements, 1.0, &stiffness);
    chain.load(
        tip,
        NodalForce {
            moment: Vector3::z() * moment,
            turning,
            ..DEAD
        },
    );
    let last = chain.last();
    (last.positions[tip], last.rotations[tip])
}

#[test]
fn debug_values() {
    for elements in [2, 4, 8] {
        println!(
            "{elements} {:?}",
            rolled(elements, 2.0 * PI, Turning::Dead).0
        );
    }
    for elements in [1, 2, 4, 8] {
        let (x, r) = rolled(elements, FRAC_PI_2, Turning::Follower);
        println!(
            "{elements} {:?} {}",
            x - Vector3::new(2.0 / PI, 2.0 / PI, 0.0),
            r[(1, 0)].atan2(r[(0, 0)]) - FRAC_PI_2
        );
    }
    for force in [300.0, 600.0] {
        for elements in [1, 2, 4, 8, 16] {
            println!("{force} {elements} {:?}", bent(elements, force));
        }
    }
}

/// The 45-degree bend of Bathe and Bolourchi: tip under a force along z.
fn bent(elements: usize, force: f64) -> Vector3<f64> {
    let stiffness = Vector6::new(1e7, 5e6, 5e6, 5e6 / 6.0, 1e7 / 12.0, 1e7 / 12.0);
    let mut chain = Chain::new();
    let on = chain.line(None, elements, &stiffness, |part| {
        let angle = FRAC_PI_4 * part;
        let position = 100.0 * Vector3::new(angle.sin(), 1.0 - angle.cos(), 0.0);
        (
            position,
            *Rotation3::from_axis_angle(&Vector3::z_axis(), angle).matrix(),
        )
    });
    let tip = on[2 * elements];
    chain.clamp(0);
    chain.load(
        tip,
        NodalForce {
            force: Vector3::z() * force,
            ..DEAD
        },
    );
    let result = chain.solve();
    println!(
        "{:?}",
        result
            .steps
            .iter()
            .map(|s| (s.factor, s.iterations))
            .collect::<Vec<_>>()
    );
    result.steps.last().unwrap().positions[tip]
}
