//! Blades and cards of strips in the air, and sensors of them.

use nalgebra::DMatrix;

use super::{ModelBuilder, boxed};
use crate::elements::Reading;
use crate::elements::control::{Matrices, StateSpace};
use crate::input::aerodynamics::MachLimit;
use crate::model::Scalar;

/// A blade or a card of strips, undeformed.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::input) struct AirBlade {
    /// Its name.
    pub name: String,
    /// Name of its rotor, if it has one.
    pub rotor: Option<String>,
    /// Radius of its tip; without a rotor the length of its line \[m\].
    pub length: f64,
    /// Names of its strips from the root to the tip, and the radii of their quarter chords; without a
    /// rotor their positions on the line \[m\].
    pub strips: Vec<(String, f64)>,
    /// Airfoils with tables over the Mach number; none without a rotor.
    pub mach_limits: Vec<MachLimit>,
}

impl ModelBuilder {
    /// Blades and cards with strips so far.
    pub fn air_blades(&self) -> &[AirBlade] {
        &self.air_blades
    }

    /// Notes a blade or a card with strips.
    pub fn add_air_blade(&mut self, blade: AirBlade) {
        self.air_blades.push(blade);
    }

    /// Makes a scalar of the sum of readings of strips by their names, for the sensor `name`.
    pub fn watch_strips(
        &mut self,
        readings: impl Iterator<Item = (String, Reading)>,
        name: &str,
        scalar: &Scalar,
    ) {
        // The strips add their shares to this.
        let none = Matrices::gain(DMatrix::zeros(1, 0));
        let own = vec![scalar.clone()];
        self.add_control(boxed(StateSpace::new(name, none, Vec::new(), own, &[])));
        for (strip, reading) in readings {
            self.watch(strip, reading, scalar.clone());
        }
    }
}
