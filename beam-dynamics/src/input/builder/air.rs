//! Blades in the air, and sensors of their rotors.

use nalgebra::DMatrix;

use super::{ModelBuilder, boxed};
use crate::elements::control::{Matrices, StateSpace};
use crate::elements::{Reading, RotorSum};
use crate::model::Scalar;

/// A blade with strips, undeformed.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::input) struct AirBlade {
    /// Its name.
    pub name: String,
    /// Name of its rotor.
    pub rotor: String,
    /// Radius of its tip \[m\].
    pub tip_radius: f64,
    /// Names and radii of the quarter chords of its strips, from the root to the tip \[m\].
    pub strips: Vec<(String, f64)>,
}

impl ModelBuilder {
    /// Blades with strips so far.
    pub fn air_blades(&self) -> &[AirBlade] {
        &self.air_blades
    }

    /// Notes a blade with strips.
    pub fn add_air_blade(&mut self, blade: AirBlade) {
        self.air_blades.push(blade);
    }

    /// Makes a scalar of a sum over strips, for the sensor `name`.
    pub fn watch_rotor(&mut self, sum: RotorSum, strips: &[String], name: &str, scalar: &Scalar) {
        // The strips add their shares to this.
        let none = Matrices::gain(DMatrix::zeros(1, 0));
        let own = vec![scalar.clone()];
        self.add_control(boxed(StateSpace::new(name, none, Vec::new(), own, &[])));
        for strip in strips {
            self.watch(strip.clone(), Reading::Rotor(sum), scalar.clone());
        }
    }
}
