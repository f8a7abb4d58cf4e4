//! Frequencies and damping of the motions in a record: Prony's sum, moving block, and logarithmic
//! decrement, independent of each other and of the modes of the model.
//!
//! References: [HuaSarkar1990], [HammondDoggett1975].

use crate::result::{IdentificationMethod, IdentifiedMode};

mod decrement;
mod line;
mod moving_block;
mod prony;
mod record;

pub use record::{Record, RecordProblem};

/// Samples that the methods take: longer records are filtered and thinned.
const SAMPLES: usize = 600;

/// Settings of an identification.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IdentificationSettings {
    /// Largest number of modes.
    pub count: usize,
    /// Singular values below this part of the largest are noise \[-\].
    pub noise: f64,
}

/// The modes of a record, and the rest of Prony's sum (see
/// [`crate::result::Identification`]).
///
/// The moving block is taken at the frequencies of Prony's modes; the decrement belongs to the
/// largest of them, and is absent if the extremes do not belong to one oscillation.
///
/// # Errors
/// [`RecordProblem`]: a record without oscillations.
pub fn identify(
    record: &Record,
    settings: &IdentificationSettings,
) -> Result<(Vec<IdentifiedMode>, f64), RecordProblem> {
    let thin = record.thinned(SAMPLES);
    let sum = prony::sum(&thin, settings.noise).ok_or(RecordProblem::NoSum)?;
    let mut modes: Vec<_> = sum.modes.into_iter().take(settings.count).collect();
    let Some(first) = modes.first().copied() else {
        return Err(RecordProblem::NoOscillation);
    };
    let blocks: Vec<_> = modes
        .iter()
        .filter_map(|mode| moving_block::mode(&thin.record, mode.frequency))
        .collect();
    modes.extend(blocks);
    modes.extend(decrement::mode(&thin.record, first.frequency));
    Ok((modes, sum.residual))
}

/// A mode of a method that has no amplitudes, of the slope of the logarithm of its amplitude.
fn of_logarithm(
    method: IdentificationMethod,
    frequency: f64,
    line: line::Line,
) -> Option<IdentifiedMode> {
    (frequency > 0.0).then_some(IdentifiedMode {
        method,
        frequency,
        growth: line.slope,
        amplitude: None,
        share: None,
        scatter: Some(line.scatter),
    })
}

#[cfg(test)]
mod tests;
