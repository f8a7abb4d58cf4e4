//! Blades and cards of strips in the air, and sensors of them.

use nalgebra::{DMatrix, Vector3};
use rotor_aero::wind::{Extent, WindFrame};

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
    /// Whether its rotor has an inflow, whose name is the one of the rotor.
    pub has_inflow: bool,
    /// Radius of its tip; without a rotor the length of its line \[m\].
    pub length: f64,
    /// Names of its strips from the root to the tip, and the radii of their quarter chords; without a
    /// rotor their positions on the line \[m\].
    pub strips: Vec<(String, f64)>,
    /// Points of its strips \[m\].
    pub points: Vec<Vector3<f64>>,
    /// A point and the unit vector of its shaft, if it has one \[m\].
    pub shaft: Option<[Vector3<f64>; 2]>,
    /// Number of blades of its card; a card of strips has none.
    pub siblings: Option<usize>,
    /// Airfoils with tables over the Mach number; none without a rotor.
    pub mach_limits: Vec<MachLimit>,
}

impl AirBlade {
    /// The least and the largest radius of its strips, if it has any \[m\].
    pub fn radii(&self) -> Option<[f64; 2]> {
        let radii = self.strips.iter().map(|strip| [strip.1; 2]);
        radii.reduce(|[a, b], [low, high]| [a.min(low), b.max(high)])
    }

    /// The space in which its strips are in axes of the wind: the ball of a rotor in any attitude about
    /// the point of the shaft at their mean height, and without a rotor their points at the start.
    pub fn extent(&self, frame: &WindFrame) -> Option<Extent> {
        let user = match self.siblings {
            Some(_) => "the rotor".to_owned(),
            None => format!("strip \"{}\"", self.name),
        };
        let points = self.points.iter();
        let Some([center, axis]) = self.shaft else {
            return Extent::of_points(&user, points.map(|at| frame.point(&(*at).into())));
        };
        let height: f64 = points.map(|at| axis.dot(&(at - center))).sum();
        let center = center + axis * (height / self.points.len().max(1) as f64);
        Some(Extent::ball(
            &user,
            frame.point(&center.into()),
            self.length,
        ))
    }
}

impl ModelBuilder {
    /// Blades and cards with strips so far.
    pub fn air_blades(&self) -> &[AirBlade] {
        &self.air_blades
    }

    /// Points of the shafts of blades and cards with strips \[m\].
    pub fn rotor_centers(&self) -> Vec<Vector3<f64>> {
        let shafts = self.air_blades.iter().filter_map(|blade| blade.shaft);
        shafts.map(|[center, _]| center).collect()
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
