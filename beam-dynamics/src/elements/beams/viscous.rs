//! Viscous forces of the three-node beam: what its material adds in motion.
//!
//! Beside the elastic law of [`super::ElasticBeam`], at the same evaluation points, in
//! section axes,
//!
//! ```text
//! [F~; M~] = D [nu.; kappa.]              F = R F~,  M = R M~
//! ```
//!
//! so that both together are the law of Kelvin and Voigt, `K eps + D eps.`. The forces
//! on the nodes and their variations are those of [`super::LawBeam`].
//!
//! In steady rotation nothing moves in the frame, and all of this vanishes.
//!
//! References: [Masarati], the three-node finite-volume beam.

use nalgebra::{Matrix6, Vector6};

use super::constitutive::LawBeam;
use super::geometry::BeamGeometry;
use crate::elements::laws::LawKind;
use crate::elements::{Element, Local, LocalJacobian, LocalResidual};
use crate::model::{Node, NodeMotion};

/// Internal damping of a beam through three nodes: a beam of a viscous law, which is
/// neither a beam of its own to results nor what joins nodes.
#[derive(Debug, Clone)]
pub struct ViscousBeam {
    beam: LawBeam,
}

impl ViscousBeam {
    /// The damping of a beam on nodes number `nodes`, undeformed at `undeformed`, with the
    /// viscosity given at the evaluation points xi = -1/sqrt 3 and 1/sqrt 3.
    pub fn new(
        label: impl Into<String>,
        nodes: [usize; 3],
        geometry: BeamGeometry,
        undeformed: [&Node; 3],
        damping: [Matrix6<f64>; 2],
    ) -> Self {
        let laws = damping.map(|viscosity| LawKind::Viscous { viscosity }.into());
        Self {
            beam: LawBeam::new(label, nodes, geometry, undeformed, laws),
        }
    }

    /// Rates of the generalized strains at the two evaluation points, section axes, for
    /// the given motion of the three nodes [1/s, 1/(m s)].
    pub fn strain_rates(&self, nodes: &[NodeMotion]) -> [Vector6<f64>; 2] {
        self.beam.strain_rates(nodes)
    }
}

impl Element for ViscousBeam {
    fn label(&self) -> &str {
        self.beam.label()
    }

    fn nodes(&self) -> &[usize] {
        self.beam.nodes()
    }

    fn residual(&self, at: &Local<'_>, out: &mut LocalResidual) {
        self.beam.residual(at, out);
    }

    fn jacobian(&self, at: &Local<'_>, out: &mut LocalJacobian) {
        self.beam.jacobian(at, out);
    }
}
