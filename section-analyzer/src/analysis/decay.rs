//! How far the ends of the beam are felt in it: the decaying solutions in meters.

use super::Analysis;
use crate::failure::Failure;
use crate::solution::{DecayingMode, EndEffects};
use crate::solve::DecayRates;

impl Analysis<'_> {
    /// The `wanted` slowest decaying solutions. Not converging is a status of the
    /// result.
    ///
    /// # Errors
    /// [`Failure::OutOfMemory`].
    pub fn end_effects(&self, wanted: usize) -> Result<EndEffects, Failure> {
        let domain = self.domain();
        let unknowns = domain.unknowns();
        let face = &self.central().face;
        let found = DecayRates::find(domain, self.systems.steady(), face, wanted)
            .ok_or(Failure::OutOfMemory { unknowns })?;
        let per_meter = 1.0 / domain.scaling.length;
        let modes = found.rates.iter().map(|rate| DecayingMode {
            rate: per_meter * rate.re,
            wave_number: per_meter * rate.im,
        });
        Ok(EndEffects {
            modes: modes.collect(),
            wanted,
            change: found.change,
            is_converged: found.is_converged,
            vectors: found.vectors,
        })
    }
}
