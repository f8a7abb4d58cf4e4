//! Decay of end effects along a beam.

/// A solution that decays along the beam: its stress decreases as
/// `exp(-rate x) cos(wave_number x)` with the distance from an end, a joint or a jump of
/// the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DecayingMode {
    /// Real part of lambda: its inverse is the distance of a decrease by the factor e
    /// \[1/m\].
    pub rate: f64,
    /// Imaginary part of lambda; zero without oscillation \[1/m\].
    pub wave_number: f64,
}

/// The slowest decaying solutions of a section, as far as found.
#[derive(Debug, Clone, PartialEq)]
pub struct EndEffects {
    /// The modes, each rate once, the slowest first.
    pub modes: Vec<DecayingMode>,
    /// Number of requested modes.
    pub wanted: usize,
    /// Relative change of their rates, and of other rates that may be as slow, by the last
    /// vectors of the search \[-\].
    pub change: f64,
    /// Whether the change is small enough.
    pub is_converged: bool,
    /// Number of vectors of the search.
    pub vectors: usize,
}

impl DecayingMode {
    /// Distance beyond which the mode is less than `part` of its value at the end,
    /// `0 < part < 1` \[m\].
    pub fn distance(&self, part: f64) -> f64 {
        -part.ln() / self.rate
    }

    /// Wavelength \[m\]; `None` without oscillation.
    pub fn wave_length(&self) -> Option<f64> {
        (self.wave_number > 0.0).then(|| std::f64::consts::TAU / self.wave_number)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_an_exponential() {
        let mode = DecayingMode {
            rate: 4.0,
            wave_number: 0.0,
        };
        assert_eq!(mode.distance((-1.0_f64).exp()), 0.25);
        assert!((mode.distance(0.01) - 100_f64.ln() / 4.0).abs() < 1e-15);
        assert_eq!(mode.wave_length(), None);
        let wave = DecayingMode {
            wave_number: std::f64::consts::PI,
            ..mode
        };
        assert_eq!(wave.wave_length(), Some(2.0));
    }
}
