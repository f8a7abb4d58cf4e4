//! Section properties along a beam, in the form that its elements use.

use nalgebra::Matrix6;
use shared_geom::section::{CubicTable, Piezo, among_six};

use super::beam_section::{Acting, Heat, Properties};
use super::curved::Curved;
use crate::elements::beams::MassAlong;
use crate::elements::laws::{Imposed, Law, LawKind};

/// Stiffness and mass per length along one beam, by xi from -1 to 1.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct BeamProperties {
    /// 6x6 stiffness at the two evaluation points \[N, N m, N m^2\].
    pub stiffness: [Matrix6<f64>; 2],
    /// 6x6 viscosity there; `None` without internal damping \[N s, N m s, N m^2 s\].
    pub damping: Option<[Matrix6<f64>; 2]>,
    /// Law in place of stiffness and viscosity; `None` for these.
    pub law: Option<Law<6>>,
    /// Effect of prestress on the stiffness there; `None` if it is not requested.
    prestress: Option<[CubicTable; 2]>,
    /// States of heat and imposed strains that add to the forces there.
    heat: Vec<Acting>,
    /// Electrodes along the whole beam; `None` without.
    pub piezo: Option<Piezo>,
    /// Curvature for which the section was solved; `None` for a straight beam, and if a
    /// blade file has compared it with its line.
    pub curved: Option<Curved>,
    /// xi and 6x6 mass per length \[kg/m, kg, kg m\], in the order of xi; linear between
    /// them; a single entry applies everywhere.
    mass: Vec<(f64, Matrix6<f64>)>,
    /// Values of xi of the mass between the ends.
    breaks: Vec<f64>,
    /// Length of the line that the beam represents; `None` for the line through its nodes
    /// \[m\].
    length: Option<f64>,
}

impl BeamProperties {
    /// The same properties everywhere.
    pub fn constant(properties: &Properties) -> Self {
        Self {
            stiffness: [properties.stiffness; 2],
            damping: properties.damping.map(|damping| [damping; 2]),
            law: properties.law.clone(),
            prestress: properties.prestress.map(|third| [third; 2]),
            heat: properties.heat.acting().to_vec(),
            piezo: properties.piezo.clone(),
            curved: properties.curved.clone(),
            mass: vec![(0.0, properties.mass)],
            breaks: Vec::new(),
            length: None,
        }
    }

    /// Stiffness at the evaluation points, and a mass that is linear between the given
    /// values of xi, of which the first is -1 and the last 1, on a line of the given length.
    pub fn varying(
        stiffness: [Matrix6<f64>; 2],
        mass: Vec<(f64, Matrix6<f64>)>,
        length: f64,
    ) -> Self {
        let inside = mass.iter().map(|position| position.0);
        Self {
            stiffness,
            damping: None,
            law: None,
            prestress: None,
            heat: Vec::new(),
            piezo: None,
            curved: None,
            breaks: inside.filter(|xi| xi.abs() < 1.0).collect(),
            mass,
            length: Some(length),
        }
    }

    /// The mirror image, by the one of a stiffness; or the part of the section that has none, as text.
    pub fn mirrored(
        &self,
        image: &dyn Fn(&Matrix6<f64>) -> Matrix6<f64>,
    ) -> Result<Self, &'static str> {
        let others = [
            (self.law.is_some(), "a law"),
            (self.prestress.is_some(), "a table of prestress"),
            (!self.heat.is_empty(), "imposed strains"),
            (self.piezo.is_some(), "electrodes"),
            (self.curved.is_some(), "a curvature"),
        ];
        if let Some((_, found)) = others.iter().find(|other| other.0) {
            return Err(found);
        }
        let mass = self.mass.iter().map(|(xi, own)| (*xi, image(own)));
        Ok(Self {
            stiffness: self.stiffness.map(|own| image(&own)),
            damping: self.damping.map(|both| both.map(|own| image(&own))),
            mass: mass.collect(),
            ..self.clone()
        })
    }

    /// The same with internal damping at the evaluation points.
    pub fn damped(self, damping: Option<[Matrix6<f64>; 2]>) -> Self {
        Self { damping, ..self }
    }

    /// A law, and the mass of the properties; no mass without them.
    pub fn of_law(law: Law<6>, properties: Option<&Properties>) -> Self {
        let zero = Matrix6::zeros();
        let of_mass = properties.cloned().unwrap_or(Properties {
            stiffness: zero,
            mass: zero,
            damping: None,
            law: None,
            heat: Heat::default(),
            prestress: None,
            torsional_buckling: None,
            piezo: None,
            curved: None,
        });
        Self {
            law: Some(law),
            ..Self::constant(&of_mass)
        }
    }

    /// The laws at the evaluation points, which share the terms of the law `last` where they
    /// are the same, as along a uniform blade.
    pub fn laws_like(&self, last: &mut Option<Law<6>>) -> [Law<6>; 2] {
        self.laws()
            .map(|law| match last.as_ref().filter(|known| **known == law) {
                Some(known) => known.clone(),
                None => last.insert(law).clone(),
            })
    }

    /// The laws at the evaluation points.
    ///
    /// ```text
    /// f = K e + D e' + sum theta_i c_i + 1/2 T q q + sum c_i T_i q ,
    /// q = e - sum c_i psi_i ,  psi_i = - K^-1 theta_i        (D-241), (D-250), (D-252)
    /// ```
    pub fn laws(&self) -> [Law<6>; 2] {
        let forces = || self.heat.iter().map(|state| state.force.clone());
        std::array::from_fn(|point| self.law_at(point).prestressed(forces()))
    }

    /// The law at an evaluation point without the forces of heat.
    fn law_at(&self, point: usize) -> Law<6> {
        if let Some(law) = &self.law {
            return law.clone();
        }
        let stiffness = self.stiffness[point];
        let linear = match self.damping {
            None => LawKind::Linear { stiffness },
            Some(damping) => LawKind::Viscoelastic {
                stiffness,
                viscosity: damping[point],
            },
        };
        let quadratic = self.prestress.as_ref();
        let quadratic = quadratic
            .map(|third| LawKind::quadratic(&third[point], self.imposed(&stiffness)).into());
        Law::sum(std::iter::once(linear.into()).chain(quadratic).collect())
    }

    /// The acting states as terms of a quadratic force.
    fn imposed(&self, stiffness: &Matrix6<f64>) -> Vec<Imposed<6>> {
        // A stiffness that is not positive definite has been refused.
        let Some(factors) = stiffness.cholesky() else {
            return Vec::new();
        };
        let of_state = |state: &Acting| Imposed {
            free_strain: -factors.solve(&state.force.vector),
            change: state
                .stiffness
                .map_or_else(Matrix6::zeros, |four| among_six(&four)),
            signal: state.force.signal.clone(),
        };
        self.heat.iter().map(of_state).collect()
    }

    /// The acting states of heat and imposed strains.
    pub fn heat(&self) -> &[Acting] {
        &self.heat
    }

    /// Whether a table of prestress is used, or a law that replaces it.
    pub fn knows_prestress(&self) -> bool {
        self.prestress.is_some() || self.law.is_some()
    }

    /// Calls `user` with the mass along the beam.
    pub fn with_mass<T>(&self, user: impl FnOnce(&MassAlong<'_>) -> T) -> T {
        user(&MassAlong {
            at: &|xi| self.mass_at(xi),
            breaks: &self.breaks,
            length: self.length,
        })
    }

    fn mass_at(&self, xi: f64) -> Matrix6<f64> {
        let after = self.mass.partition_point(|position| position.0 < xi);
        let inner = self.mass[after.saturating_sub(1)];
        let Some(outer) = self.mass.get(after.max(1)) else {
            return inner.1;
        };
        let part = (xi - inner.0) / (outer.0 - inner.0);
        inner.1 + (outer.1 - inner.1) * part
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mass_is_linear_between_its_positions() {
        let unit = Matrix6::identity();
        let mass = vec![(-1.0, unit), (0.5, 4.0 * unit), (1.0, 2.0 * unit)];
        let beam_properties = BeamProperties::varying([unit; 2], mass, 3.0);
        for (xi, expected) in [
            (-1.0, 1.0),
            (-0.5, 2.0),
            (0.5, 4.0),
            (0.75, 3.0),
            (1.0, 2.0),
        ] {
            assert!(
                (beam_properties.mass_at(xi) - unit * expected).amax() < 1e-15,
                "{xi}"
            );
        }
        assert_eq!(
            beam_properties.with_mass(|mass| mass.breaks.to_vec()),
            [0.5]
        );
        let properties = Properties {
            stiffness: unit,
            mass: 7.0 * unit,
            damping: None,
            law: None,
            heat: Heat::default(),
            prestress: None,
            torsional_buckling: None,
            piezo: None,
            curved: None,
        };
        let constant = BeamProperties::constant(&properties);
        for xi in [-1.0, 0.0, 0.3, 1.0] {
            assert_eq!(constant.mass_at(xi), 7.0 * unit);
        }
    }
}
