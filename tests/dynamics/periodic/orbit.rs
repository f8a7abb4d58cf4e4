//! The first state of the motion of unequal blades under gravity, against minimal coordinates.
//!
//! Source: `theory-periodic/shooting_rotor.json`, the ordinary differential equations of the hub and three lag
//! angles z by an independent integration (relative tolerance 1e-11): positions and velocities at the first
//! instant. The momenta that belong to these coordinates are, with the blades of mass m, their centers at d
//! from the hinges at e, and u the unit vector across an azimuth,
//!
//! ```text
//! v_k = v + W e u(psi) + ( W + z' ) d u(psi + z)
//! p = M v + sum m v_k ,      p_z = I ( W + z' ) + m d u(psi + z) . v_k
//! ```

use std::f64::consts::TAU;

use beam_dynamics::model::State;
use nalgebra::Vector2;

use super::analyzed;
use super::rotor::{Blades, turning};
use crate::effort::is_long;
use crate::record;
use crate::trim::{numbers, reference};

const SPEED: f64 = 32.0;
/// Distance of the hinges from the axis \[m\].
const HINGE: f64 = 0.35;
/// Distance of the centers of the blades from the hinges \[m\].
const CENTER: f64 = 2.4;
/// Masses of the blades \[kg\].
const MASSES: [f64; 3] = [40.0, 41.0, 39.5];
/// Moment of inertia about the center, over the mass \[m^2\].
const INERTIA: f64 = 300.0 / 40.0 - CENTER * CENTER;
/// Mass and moment of inertia by which momenta become velocities \[kg, kg m^2\].
const SIZES: [f64; 2] = [3320.5, 300.0];

/// The unit vector across an azimuth.
fn across(azimuth: f64) -> Vector2<f64> {
    Vector2::new(-azimuth.sin(), azimuth.cos())
}

/// Momenta of the coordinates as velocities, from velocities of the blades' centers and of the hub, and
/// angular velocities of the blades.
fn momenta(angles: &[f64], all: Vector2<f64>, blades: [(Vector2<f64>, f64); 3]) -> [f64; 5] {
    let own = [0, 1, 2].map(|k| {
        let (momentum, spin) = blades[k];
        let azimuth = TAU * k as f64 / 3.0 + angles[k];
        (spin + CENTER * across(azimuth).dot(&momentum)) / SIZES[1]
    });
    [all.x / SIZES[0], all.y / SIZES[0], own[0], own[1], own[2]]
}

/// Positions and momenta of the reference.
fn expected(minimal: &[f64]) -> [[f64; 5]; 2] {
    let hub = Vector2::new(minimal[5], minimal[6]);
    let blades = [0, 1, 2].map(|k| {
        let azimuth = TAU * k as f64 / 3.0;
        let rate = SPEED + minimal[7 + k];
        let velocity = hub
            + across(azimuth) * (SPEED * HINGE)
            + across(azimuth + minimal[2 + k]) * (rate * CENTER);
        (velocity * MASSES[k], INERTIA * MASSES[k] * rate)
    });
    let all = blades.iter().fold(hub * 3200.0, |sum, own| sum + own.0);
    let positions = std::array::from_fn(|i| minimal[i]);
    [positions, momenta(&minimal[2..5], all, blades)]
}

/// The same of a state: of the mast, the hub and the blades.
fn found(state: &State) -> [[f64; 5]; 2] {
    let nodes = &state.nodes;
    let angle = |k: usize| {
        let turn = nodes[2 + k].rotation;
        turn[(1, 0)].atan2(turn[(0, 0)])
    };
    let angles = [0, 1, 2].map(angle);
    let blades = [0, 1, 2].map(|k| {
        let node = &nodes[2 + k];
        (node.momentum.xy(), node.angular_momentum.z)
    });
    let sum = |sum: Vector2<f64>, node: &beam_dynamics::model::NodeMotion| sum + node.momentum.xy();
    let all = nodes.iter().fold(Vector2::zeros(), sum);
    let mast = nodes[0].position;
    let positions = [mast.x, mast.y, angles[0], angles[1], angles[2]];
    [positions, momenta(&angles, all, blades)]
}

/// Largest errors of positions and momenta in steps of a number of stages.
fn errors(stages: &str, steps: usize) -> [f64; 2] {
    let it = reference("theory-periodic/shooting_rotor.json")["dissimilar"].clone();
    let blades = Blades {
        masses: MASSES,
        dampers: numbers(&it["blades"]["cz"]).try_into().unwrap(),
        springs: [0.0; 3],
    };
    let settings = format!(
        "stages = \"{stages}\"\nsteps = {steps}\n[gravity]\nacceleration = [0, -9.81, 0]\n"
    );
    let support = [1.1e6, 2.0e6, 3000.0, 3800.0];
    let (_, kept) = analyzed(&turning(support, &blades, SPEED, &settings));
    let found = found(&kept.0[0].1);
    let expected = expected(&numbers(&it["initial_state_minimal"]));
    [0, 1].map(|part| {
        let pairs = found[part].iter().zip(&expected[part]);
        let off = pairs.map(|(found, expected)| (found - expected).abs());
        off.fold(0.0, f64::max)
    })
}

// 1e-6 is required; three stages in 96 steps have the digits of the reference.
#[test]
fn the_motion_of_unequal_blades() {
    let found = errors("three", 96);
    println!("{found:?}");
    let source = "Rotor in minimal coordinates by an independent integration";
    for (name, off) in ["positions [m, rad]", "momenta [m/s, rad/s]"]
        .into_iter()
        .zip(found)
    {
        record::largest(source, "unequal blades under gravity", name, off, 1e-6);
        assert!(off < 1e-6, "{name}: {off:e}");
    }
}

// Positions are of the order 2 s - 1 with s stages, although the complete state is of the order s. The short
// form has three stages.
#[test]
fn orders_of_positions() {
    let all = [("three", [24, 48], 5.0), ("two", [48, 96], 3.0)];
    let count = if is_long() { 2 } else { 1 };
    for (stages, steps, order) in &all[..count] {
        let [coarse, fine] = steps.map(|steps| errors(stages, steps)[0]);
        let observed = (coarse / fine).log2();
        println!("{stages}: {coarse:e} {fine:e} {observed}");
        assert!((observed - order).abs() < 0.4, "{stages}: {observed}");
    }
}
