//! The largest rotation in a run, for its summary: an angle in the wrong unit is seen there.

use std::f64::consts::TAU;
use std::fmt;

use nalgebra::Vector3;

use crate::assembly::System;
use crate::integrator::Scheme;
use crate::model::State;

/// Rotation below which nothing is reported \[rad\]: round-off of positions that are held.
const VISIBLE: f64 = 1e-9;
/// Rotation of a node in a step, relative to the axes in which it is integrated, above which a remark
/// is given \[rad\]: the relative error of the rotation formula is then half a percent.
const FAR_TURN: f64 = 0.3;

/// Rotation of a node in a step above which a remark is given \[rad\]: with two steps of a radius
/// near one, also a rotation whose square exceeds the decay of alternating errors from step to
/// step.
pub(super) fn farthest_turn(scheme: &Scheme) -> f64 {
    match *scheme {
        Scheme::TwoStep { radius } if radius < 1.0 => FAR_TURN.min((1.0 - radius).sqrt()),
        _ => FAR_TURN,
    }
}

/// The largest rotation of a node.
#[derive(Debug, Clone, PartialEq)]
pub struct LargestTurn {
    /// Name of the node.
    pub node: String,
    /// The rotation since the first step of the run \[rad\].
    pub angle: f64,
    /// Time at which it is reached \[s\].
    pub time: f64,
}

impl fmt::Display for LargestTurn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let degrees = self.angle.to_degrees();
        let rounded = format!("{degrees:.3e}").parse().unwrap_or(degrees);
        write!(f, "largest rotation: {rounded} deg")?;
        if self.angle >= 0.5 * TAU {
            write!(f, " ({:.2} turns)", self.angle / TAU)?;
        }
        write!(f, " of node \"{}\" at {:.4} s", self.node, self.time)
    }
}

/// Integrals of the angular velocities of all nodes.
#[derive(Debug)]
pub(super) struct Turns {
    /// The integrals, model's axes \[rad\].
    turned: Vec<Vector3<f64>>,
    /// Node, square of the angle \[rad^2\] and time \[s\] of the largest magnitude so far.
    largest: Option<(usize, f64, f64)>,
}

impl Turns {
    /// Of `nodes` nodes, before the first step.
    pub fn new(nodes: usize) -> Self {
        Self {
            turned: vec![Vector3::zeros(); nodes],
            largest: None,
        }
    }

    /// Adds a step to `time` of `length` \[s\] between the first two states, the latest first:
    /// the trapezoidal rule.
    pub fn add(&mut self, states: &[State], (time, length): (f64, f64)) {
        let [now, before, ..] = states else {
            return;
        };
        let nodes = now.nodes.iter().zip(&before.nodes);
        for (i, ((now, before), turned)) in nodes.zip(&mut self.turned).enumerate() {
            *turned += 0.5 * length * (now.angular_velocity + before.angular_velocity);
            let square = turned.norm_squared();
            if self.largest.is_none_or(|largest| square > largest.1) {
                self.largest = Some((i, square, time));
            }
        }
    }

    /// The largest rotation of a node of `system`, if it is visible.
    pub fn largest(&self, system: &System) -> Option<LargestTurn> {
        let (node, square, time) = self.largest?;
        let angle = square.sqrt();
        (angle > VISIBLE).then_some(())?;
        Some(LargestTurn {
            node: system.nodes().get(node)?.label.clone(),
            angle,
            time,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // 2.5 turns of a body that turns at a constant speed: the rule is exact.
    #[test]
    fn the_rotation_of_a_constant_speed() {
        let system = System::new(
            vec![crate::model::Node {
                label: "hub".to_owned(),
                position: Vector3::zeros(),
                rotation: nalgebra::Matrix3::identity(),
            }],
            Vec::new(),
        );
        let mut state = system.rest();
        state.nodes[0].angular_velocity = Vector3::new(0.0, 0.0, TAU);
        let mut turns = Turns::new(1);
        assert_eq!(turns.largest(&system), None);
        for step in 1..=25 {
            let states = [state.clone(), state.clone()];
            turns.add(&states, (0.1 * f64::from(step), 0.1));
        }
        let largest = turns.largest(&system).map(|turn| turn.to_string());
        let expected = "largest rotation: 900 deg (2.50 turns) of node \"hub\" at 2.5000 s";
        assert_eq!(largest.as_deref(), Some(expected));
    }
}
