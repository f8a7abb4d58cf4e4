//! Interface between the solver and a section, for any source of its matrices.

use super::domain::Domain;
use super::forces::{SectionForces, State};
use super::matrices::SectionMatrices;
use super::pattern::Pattern;
use crate::element::Line;
use crate::failure::Failure;
use nalgebra::Complex;

/// A section in the units of the solver.
pub trait Model {
    /// Positions (y, z) of the nodes, in units of length \[-\].
    fn nodes(&self) -> &[[f64; 2]];

    /// The line of the beam through the origin, in its unit of length.
    fn line(&self) -> &Line;

    /// Replaces `forces` by the forces of `state`.
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

    /// Number of potentials: they follow the displacements among the unknowns.
    fn potentials(&self) -> usize {
        0
    }

    /// Unknowns that are held at zero in addition to those that remove rigid motions.
    fn held(&self) -> Vec<usize> {
        Vec::new()
    }

    /// Whether a node has stiffness.
    fn is_structural(&self, _node: usize) -> bool {
        true
    }

    /// Number of unknowns: ux, uy, uz of each node, in this order, then the potentials.
    fn unknowns(&self) -> usize {
        3 * self.nodes().len() + self.potentials()
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

    fn potentials(&self) -> usize {
        self.electric.potentials()
    }

    fn held(&self) -> Vec<usize> {
        let of_nodes = 3 * self.nodes.len();
        let electrodes = self.electric.electrodes.iter();
        let on_conductors = electrodes.flat_map(|electrode| electrode.nodes.iter());
        let potentials = on_conductors.filter_map(|&node| self.electric.potential(node as usize));
        let without = (0..self.nodes.len()).filter(|&node| !self.electric.is_structural(node));
        let displacements = without.flat_map(|node| 3 * node..3 * node + 3);
        displacements
            .chain(potentials.map(|potential| of_nodes + potential))
            .collect()
    }

    fn is_structural(&self, node: usize) -> bool {
        self.electric.is_structural(node)
    }

    fn wave(
        &self,
        pattern: &Pattern,
        lambda: Complex<f64>,
    ) -> Result<SectionMatrices<Complex<f64>>, Failure> {
        SectionMatrices::of_wave(self, pattern, lambda)
    }
}
