//! How far the ends of a beam are felt in it.

/// A solution that decays along the beam: what it adds to the stress of the internal
/// force falls as `exp(-rate x) cos(wave_number x)` with the distance from an end, a
/// joint or a jump of the load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DecayingMode {
    /// Real part of lambda: its inverse is the distance in which it falls by the factor
    /// e \[1/m\].
    pub rate: f64,
    /// Imaginary part of lambda; zero where nothing oscillates \[1/m\].
    pub wave_number: f64,
}

/// The slowest decaying solutions of a section, or as many as were found.
#[derive(Debug, Clone, PartialEq)]
pub struct EndEffects {
    /// Those of equal rates once, the slowest first.
    pub modes: Vec<DecayingMode>,
    /// Number of modes that were asked for.
    pub wanted: usize,
    /// Change by the last vectors of the search of their rates and of those that may be
    /// as slow, relative \[-\].
    pub change: f64,
    /// Whether that is small enough.
    pub is_converged: bool,
    /// Vectors that the search took.
    pub vectors: usize,
}

impl DecayingMode {
    /// Distance from which on the mode is less than `part` of its value at the end,
    /// `0 < part < 1` \[m\].
    pub fn distance(&self, part: f64) -> f64 {
        -part.ln() / self.rate
    }

    /// Length of its waves \[m\]; `None` where nothing oscillates.
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
