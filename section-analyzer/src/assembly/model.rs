//! What the solver asks of a section, wherever its matrices come from.

use super::domain::Domain;
use super::matrices::SectionMatrices;
use super::pattern::Pattern;
use super::stress::{SectionForces, State};
use crate::element::Line;
use crate::failure::Failure;
use nalgebra::Complex;

/// A section in the units of the solver.
pub trait Model {
    /// Places (y, z) of the nodes, in units of length \[-\].
    fn nodes(&self) -> &[[f64; 2]];

    /// The line of the beam through the origin, in its unit of length.
    fn line(&self) -> &Line;

    /// Replaces `forces` by those of `state`.
    fn measure(&self, state: State<'_>, forces: &mut SectionForces);

    /// E and R of solutions that vary along the beam as `exp(lambda x)` (S-73).
    ///
    /// # Errors
    /// As [`SectionMatrices::assemble`].
    fn wave(
        &self,
        pattern: &Pattern,
        lambda: Complex<f64>,
    ) -> Result<SectionMatrices<Complex<f64>>, Failure>;

    /// Number of warping unknowns: ux, uy, uz of each node, in this order.
    fn unknowns(&self) -> usize {
        3 * self.nodes().len()
    }
}

impl Model for Domain {
    fn nodes(&self) -> &[[f64; 2]] {
        &self.nodes
    }

    fn line(&self) -> &Line {
        &self.line
    }

    fn measure(&self, state: State<'_>, forces: &mut SectionForces) {
        forces.measure(self, state);
    }

    fn wave(
        &self,
        pattern: &Pattern,
        lambda: Complex<f64>,
    ) -> Result<SectionMatrices<Complex<f64>>, Failure> {
        SectionMatrices::of_wave(self, pattern, lambda)
    }
}
