//! Decay of end effects along the beam: the decaying solutions in meters.

use super::Analysis;
use crate::assembly::Model;
use crate::failure::Failure;
use crate::solution::{DecayingMode, EndEffects};
use crate::solve::{CentralSystems, DecayRates};
use nalgebra::DMatrix;

impl Analysis<'_> {
    /// The `wanted` slowest decaying solutions. Non-convergence is reported in the result.
    ///
    /// # Errors
    /// [`Failure::OutOfMemory`].
    pub fn end_effects(&self, wanted: usize) -> Result<EndEffects, Failure> {
        let domain = self.domain();
        let solved = (&self.systems, &self.central().face);
        end_effects(domain, solved, domain.scaling.length, wanted)
    }
}

/// The `wanted` slowest decaying solutions of a model whose unit of length is `length`
/// \[m\], from its systems and the face forces of its central solutions.
pub(super) fn end_effects(
    model: &impl Model,
    (systems, face): (&CentralSystems, &DMatrix<f64>),
    length: f64,
    wanted: usize,
) -> Result<EndEffects, Failure> {
    let unknowns = model.unknowns();
    let found = DecayRates::find(model, systems.steady(), face, wanted)
        .ok_or(Failure::OutOfMemory { unknowns })?;
    let modes = found.rates.iter().map(|rate| DecayingMode {
        rate: rate.re / length,
        wave_number: rate.im / length,
    });
    Ok(EndEffects {
        modes: modes.collect(),
        wanted,
        change: found.change,
        is_converged: found.is_converged,
        vectors: found.vectors,
    })
}
