//! Distributed loads: tractions on curves and forces in volumes, each a distribution over
//! the section times a polynomial along the beam.
//!
//! ```text
//! q(x) = c0 + c1 x + c2 x^2 + ...      x from the section, along the beam          (S-100)
//! ```

use crate::mesh::CurveSide;
use nalgebra::Vector3;

/// All distributed loads of one load case.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DistributedLoad {
    /// Its parts, which are added.
    pub parts: Vec<DistributedForce>,
}

/// A distribution over the section, and its variation along the beam.
#[derive(Debug, Clone, PartialEq)]
pub struct DistributedForce {
    /// Its location, and its magnitude at q = 1.
    pub action: Action,
    /// c0, c1, ...: coefficients of q(x) \[-, 1/m, 1/m^2, ...\].
    pub along: Vec<f64>,
}

/// A distribution over the section.
#[derive(Debug, Clone, PartialEq)]
pub enum Action {
    /// Force per area of the surface that the sides make along the beam.
    Traction {
        /// The loaded sides.
        sides: Vec<CurveSide>,
        /// The force.
        traction: Traction,
    },
    /// Force per volume.
    Volume {
        /// Loaded physical surface, an index in [`crate::mesh::SectionMesh::groups`]; the
        /// whole section if `None`.
        group: Option<usize>,
        /// The force.
        force: VolumeForce,
    },
}

/// Force per area, constant along a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Traction {
    /// Components in section axes \[Pa\].
    Force(Vector3<f64>),
    /// Pressure on the surface, against its outward normal \[Pa\].
    Pressure(f64),
    /// In the section, along the direction of the curve \[Pa\].
    Tangential(f64),
}

/// Force per volume.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum VolumeForce {
    /// Components in section axes \[N/m^3\].
    Force(Vector3<f64>),
    /// The density of each material times this acceleration, in section axes \[m/s^2\]:
    /// for weight the acceleration of gravity, for a rotating blade the centrifugal
    /// acceleration, outward.
    Acceleration(Vector3<f64>),
}

impl Traction {
    /// Its magnitude \[Pa\].
    pub fn size(&self) -> f64 {
        match self {
            Self::Force(force) => force.norm(),
            Self::Pressure(size) | Self::Tangential(size) => size.abs(),
        }
    }
}

impl VolumeForce {
    /// Its magnitude in a material of the given density \[kg/m^3\] \[N/m^3\].
    pub fn size(&self, density: f64) -> f64 {
        match self {
            Self::Force(force) => force.norm(),
            Self::Acceleration(acceleration) => density * acceleration.norm(),
        }
    }
}

impl DistributedForce {
    /// Magnitude of its force per area, at the section and within `length` \[m\] of it; a
    /// volume force acts in a material of the given density \[kg/m^3\] with this depth
    /// \[Pa\].
    pub fn pressure(&self, density: f64, length: f64) -> f64 {
        let size = match &self.action {
            Action::Traction { traction, .. } => traction.size(),
            Action::Volume { force, .. } => length * force.size(density),
        };
        let terms = (0..).zip(&self.along);
        let along: f64 = terms.map(|(power, c)| (c * length.powi(power)).abs()).sum();
        size * along
    }
}

impl DistributedLoad {
    /// Whether no load is distributed.
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// Number of coefficients of the longest polynomial.
    pub fn terms(&self) -> usize {
        let terms = self.parts.iter().map(|part| part.along.len());
        terms.max().unwrap_or(0)
    }
}

impl DistributedForce {
    /// The `order`-th derivative of q at x = 0 \[1/m^order\].
    pub fn derivative(&self, order: usize) -> f64 {
        let factorial: f64 = (1..=order).map(|i| i as f64).product();
        self.along.get(order).map_or(0.0, |c| factorial * c)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coefficients_are_those_of_a_plain_polynomial() {
        let force = DistributedForce {
            action: Action::Volume {
                group: None,
                force: VolumeForce::Force(Vector3::x()),
            },
            along: vec![2.0, 0.0, 5.0, 7.0],
        };
        let derivatives: Vec<_> = (0..5).map(|order| force.derivative(order)).collect();
        assert_eq!(derivatives, [2.0, 0.0, 10.0, 42.0, 0.0]);
        let load = DistributedLoad { parts: vec![force] };
        assert_eq!((load.terms(), DistributedLoad::default().terms()), (4, 0));
    }
}
